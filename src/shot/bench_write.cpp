#include "shot/bench_write.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "core/error.h"
#include "core/stopwatch.h"
#include "film/frame_error.h"
#include "io/frame_encoding.h"
#include "io/frame_file.h"
#include "shot/processor_time.h"
#include "shot/scratch_folder.h"

namespace overfly {
namespace {

// Everything that a group may be compressed with.
constexpr std::array<GroupCost, 8> kCandidates = {{{LayerGroup::Beauty, Compression::Zip},
                                                   {LayerGroup::Beauty, Compression::Zips},
                                                   {LayerGroup::Beauty, Compression::Piz},
                                                   {LayerGroup::Beauty, Compression::Dwaa, 45.0},
                                                   {LayerGroup::Beauty, Compression::Dwaa, 100.0},
                                                   {LayerGroup::Data, Compression::Zip},
                                                   {LayerGroup::Data, Compression::Zips},
                                                   {LayerGroup::Data, Compression::Piz}}};

class MemorySink : public ByteSink {
  public:
    void write(std::span<const std::byte> bytes) override {
        const std::size_t end = position_ + bytes.size();
        if (end > bytes_.size()) bytes_.resize(end);
        std::ranges::copy(bytes, bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
        position_ = end;
    }
    void seek(std::uint64_t offset) override { position_ = offset; }
    [[nodiscard]] std::uint64_t position() const override { return position_; }

    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    // Keeps the memory: what asking the system for it takes is no part of compressing.
    void clear() {
        bytes_.clear();
        position_ = 0;
    }

  private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

struct Time {
    double wall_s = 0.0, processor_s = 0.0;
};

template <class Job>
Time time_of(const Job& job) {
    const Stopwatch watch;
    const double before_s = processor_seconds();
    job();
    return {watch.seconds(), processor_seconds() - before_s};
}

void keep_least(Time& least, const Time& t) {
    least.wall_s = std::min(least.wall_s, t.wall_s);
    least.processor_s = std::min(least.processor_s, t.processor_s);
}

constexpr Time kNever = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

FrameStorage storage_of(const GroupCost& candidate) {
    FrameStorage storage;
    (candidate.group == LayerGroup::Beauty ? storage.beauty : storage.data) = candidate.compression;
    if (is_lossy(candidate.compression)) storage.quality = candidate.quality;
    return storage;
}

// One frame at a time.
class FrameBench {
  public:
    FrameBench(const Frame& frame, const WriteBenchOptions& options, const ScratchFolder& scratch)
        : frame_(frame), pixels_(frame), options_(options), scratch_(scratch) {
        header_.camera.tan_half_fov = 0.5;  // as the header must have one
    }

    // Not compressed.
    [[nodiscard]] double bytes_of(LayerGroup group) const {
        double bytes_per_pixel = 0.0;
        for (const StoredChannel& channel : pixels_.of(group).channels)
            bytes_per_pixel += channel.type == ChannelType::Half ? 2.0 : 4.0;
        return bytes_per_pixel * static_cast<double>(frame_.rgba.size());
    }

    [[nodiscard]] GroupCost cost(GroupCost candidate) {
        const FrameStorage storage = storage_of(candidate);
        Time least = kNever;
        for (int run = 0; run < options_.runs; ++run) keep_least(least, compress(candidate.group, storage));
        candidate.bytes = static_cast<double>(sink_.size());
        candidate.wall_s = least.wall_s;
        candidate.processor_s = least.processor_s;
        if (is_lossy(candidate.compression)) {
            write_frame(scratch_.file(), frame_, header_, storage);
            candidate.rmse = root_mean_square(read_frame(scratch_.file()), frame_);
        }
        return candidate;
    }

    // By turns, so that a change of the machine's speed meets both.
    [[nodiscard]] WritingTime writing_time() {
        Time whole = kNever, beauty = kNever, data = kNever;
        for (int run = 0; run < options_.runs; ++run) {
            keep_least(whole, time_of([&] { write_frame(scratch_.file(), frame_, header_); }));
            keep_least(beauty, compress(LayerGroup::Beauty, {}));
            keep_least(data, compress(LayerGroup::Data, {}));
        }
        return {whole.wall_s, whole.processor_s, beauty.wall_s + data.wall_s, beauty.processor_s + data.processor_s};
    }

  private:
    Time compress(LayerGroup group, const FrameStorage& storage) {
        sink_.clear();
        return time_of([&] { encode_frame(pixels_.of(group), header_, storage, sink_); });
    }

    const Frame& frame_;
    StoredPixels pixels_;
    const WriteBenchOptions& options_;
    const ScratchFolder& scratch_;
    FrameHeader header_;
    MemorySink sink_;
};

void add(GroupCost& sum, const GroupCost& cost) {
    sum.bytes += cost.bytes;
    sum.wall_s += cost.wall_s;
    sum.processor_s += cost.processor_s;
    sum.rmse += cost.rmse;
}

void add(WritingTime& sum, const WritingTime& time) {
    sum.wall_s += time.wall_s;
    sum.processor_s += time.processor_s;
    sum.compression_wall_s += time.compression_wall_s;
    sum.compression_processor_s += time.compression_processor_s;
}

void divide(WriteBench& sums, double frames) {
    for (double* value : {&sums.beauty_bytes, &sums.data_bytes, &sums.writing.wall_s, &sums.writing.processor_s,
                          &sums.writing.compression_wall_s, &sums.writing.compression_processor_s})
        *value /= frames;
    for (GroupCost& cost : sums.costs)
        for (double* value : {&cost.bytes, &cost.wall_s, &cost.processor_s, &cost.rmse}) *value /= frames;
}

}  // namespace

WriteBench bench_write(std::span<const std::filesystem::path> frames, const WriteBenchOptions& options) {
    check(!frames.empty(), "a bench of frames has frames");
    const ScratchFolder scratch;
    WriteBench result;
    result.frames = static_cast<int>(frames.size());
    result.costs.assign(kCandidates.begin(), kCandidates.end());
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (options.progress)
            options.progress("compressing frames", static_cast<double>(f), static_cast<double>(frames.size()));
        const Frame frame = read_frame_with_layers(frames[f]);
        if (f == 0) {
            result.width = frame.width;
            result.height = frame.height;
        }
        FrameBench bench(frame, options, scratch);
        result.beauty_bytes += bench.bytes_of(LayerGroup::Beauty);
        result.data_bytes += bench.bytes_of(LayerGroup::Data);
        for (std::size_t c = 0; c < kCandidates.size(); ++c) add(result.costs[c], bench.cost(kCandidates[c]));
        add(result.writing, bench.writing_time());
    }
    divide(result, static_cast<double>(frames.size()));
    return result;
}

const GroupCost& WriteBench::best_lossless(LayerGroup group) const {
    const auto is_candidate = [&](const GroupCost& c) { return c.group == group && !is_lossy(c.compression); };
    double least_bytes = std::numeric_limits<double>::infinity();
    for (const GroupCost& c : costs) {
        if (is_candidate(c)) least_bytes = std::min(least_bytes, c.bytes);
    }
    const GroupCost* best = nullptr;
    for (const GroupCost& c : costs) {
        if (!is_candidate(c) || c.bytes > kAlmost * least_bytes) continue;
        if (best == nullptr || c.processor_s < best->processor_s) best = &c;
    }
    check(best != nullptr, "a group has lossless compressions");
    return *best;
}

const GroupCost& WriteBench::best_lossy() const {
    const GroupCost* best = nullptr;
    for (const GroupCost& c : costs) {
        if (is_lossy(c.compression) && (best == nullptr || c.rmse < best->rmse)) best = &c;
    }
    check(best != nullptr, "colours have lossy compressions");
    return *best;
}

}  // namespace overfly
