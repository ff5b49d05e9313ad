#pragma once

#include <vector>

#include "core/bernstein.h"
#include "trace/paper_scene.h"

namespace overfly {

// The paper's intersection record: from `begin` to `end` (times u) a ray passes through a polygon, at a depth that is a
// polynomial of u over the whole animation, in lengths of the ray's direction.
struct PaperRecord {
    double begin = 0.0, end = 1.0;
    Bernstein<2> depth{};
    std::uint32_t polygon = kNone;

    friend bool operator==(const PaperRecord&, const PaperRecord&) = default;
};

// The records of one ray, in order of their start.
class PaperRecordList {
  public:
    void clear() { records_.clear(); }
    void add(const PaperRecord& record);
    [[nodiscard]] const std::vector<PaperRecord>& get() const { return records_; }

  private:
    std::vector<PaperRecord> records_;
};

// Leaves of a ray's records what is nearest when: in order of time, without overlap. A record that another occludes in
// part is truncated or split there, at the exact time where their depths cross if they do. Of two equally deep, the
// polygon with the lower number. Memory is used again from ray to ray.
class PaperOcclusion {
  public:
    // The answer, which may be that of `records`, is valid until the next call or a change of the records.
    const std::vector<PaperRecord>& nearest(const PaperRecordList& records);

  private:
    void add(const PaperRecord& record);
    void add_contest(const PaperRecord& seen, const PaperRecord& record, double begin, double end);
    void show(const PaperRecord& record, double begin, double end);

    std::vector<PaperRecord> seen_, behind_;
};

}  // namespace overfly
