#include "trace/paper_records.h"

#include <algorithm>

#include "core/polynomial_roots.h"

namespace overfly {

void PaperRecordList::add(const PaperRecord& record) {
    // By insertion: there is a handful.
    records_.push_back(record);
    std::size_t place = records_.size() - 1;
    for (; place > 0 && record.begin < records_[place - 1].begin; --place) records_[place] = records_[place - 1];
    records_[place] = record;
}

const std::vector<PaperRecord>& PaperOcclusion::nearest(const PaperRecordList& records) {
    const auto overlap = [](const PaperRecord& a, const PaperRecord& b) { return a.end > b.begin; };
    if (std::ranges::adjacent_find(records.get(), overlap) == records.get().end()) return records.get();
    seen_.clear();
    for (const PaperRecord& r : records.get()) add(r);
    return seen_;
}

// Adds a record that starts no earlier than any before it: only the last of those seen can overlap it.
void PaperOcclusion::add(const PaperRecord& record) {
    if (seen_.empty() || seen_.back().end <= record.begin) {
        seen_.push_back(record);
        return;
    }
    behind_.clear();
    while (!seen_.empty() && seen_.back().end > record.begin) {
        behind_.push_back(seen_.back());
        seen_.pop_back();
    }
    double reached = record.begin;
    for (; !behind_.empty(); behind_.pop_back()) {
        const PaperRecord other = behind_.back();
        show(other, other.begin, record.begin);
        show(record, reached, std::min(other.begin, record.end));
        const double begin = std::max(other.begin, record.begin);
        const double end = std::min(other.end, record.end);
        if (begin < end) add_contest(other, record, begin, end);
        show(other, std::max(other.begin, record.end), other.end);
        reached = std::max(reached, other.end);
    }
    show(record, reached, record.end);
}

// Both are there from `begin` to `end`: the one in front is seen.
void PaperOcclusion::add_contest(const PaperRecord& seen, const PaperRecord& record, double begin, double end) {
    const Bernstein<2> lead = {seen.depth[0] - record.depth[0], seen.depth[1] - record.depth[1],
                               seen.depth[2] - record.depth[2]};
    const auto show_front = [&](double lead_there, double from, double until) {
        const bool is_seen = lead_there < 0.0 || (lead_there == 0.0 && seen.polygon < record.polygon);
        show(is_seen ? seen : record, from, until);
    };
    if (sign_changes<2>(lead) == 0) {
        show_front(lead[0] + lead[1] + lead[2], begin, end);
        return;
    }
    double from = begin;
    const auto show_until = [&](double until) {
        if (from < until) show_front(value_at<2>(lead, 0.5 * (from + until)), from, until);
        from = std::max(from, until);
    };
    for (const double u : sign_change_roots<2>(lead)) show_until(std::min(u, end));
    show_until(end);
}

void PaperOcclusion::show(const PaperRecord& record, double begin, double end) {
    if (!(begin < end)) return;
    if (!seen_.empty() && seen_.back().polygon == record.polygon && seen_.back().end == begin) {
        seen_.back().end = end;
        return;
    }
    seen_.push_back({begin, end, record.depth, record.polygon});
}

}  // namespace overfly
