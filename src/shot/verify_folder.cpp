#include "shot/verify_folder.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "config/frame_range.h"
#include "core/error.h"
#include "io/layer_files.h"
#include "shot/frame_plan.h"

namespace overfly {
namespace {

struct NumberedName {
    std::string name;
    int number = 0;
};

// NAME.0001.exr, the only spelling of that number.
std::optional<NumberedName> numbered_name(const std::filesystem::path& file) {
    if (file.extension() != ".exr" || !file.stem().has_extension()) return std::nullopt;
    NumberedName result{file.stem().stem().string(), 0};
    const std::string digits = file.stem().extension().string().substr(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), result.number);
    const bool is_whole = error == std::errc() && end == digits.data() + digits.size();
    if (!is_whole || frame_file_name(result.name, result.number) != file.filename()) return std::nullopt;
    return result;
}

using Numbers = std::vector<int>;

std::map<std::string, Numbers> frames_on_disk(const std::filesystem::path& folder) {
    std::error_code error;
    std::map<std::string, Numbers> found;
    std::filesystem::directory_iterator entry(folder, error);
    for (const std::filesystem::directory_iterator end; !error && entry != end; entry.increment(error)) {
        const auto frame = numbered_name(entry->path());
        if (frame) found[frame->name].push_back(frame->number);
    }
    if (error) throw UserError({folder}, fmt::format("can't be read as a folder: {}", error.message()));
    for (auto& [name, numbers] : found) std::ranges::sort(numbers);
    return found;
}

struct LayerOnDisk {
    Layer layer = Layer::Range;
    int number = 0;
    std::filesystem::path file;
};

// One sequence: what the manifest says of it, if anything, and which of its files there are.
struct Sequence {
    std::string name;
    std::optional<ManifestSequence> listed;
    Numbers on_disk;
    std::vector<LayerOnDisk> layers_on_disk;

    [[nodiscard]] FrameSpan numbers() const {
        if (listed) return {listed->first, listed->first + listed->count - 1};
        return {on_disk.front(), on_disk.back()};
    }
};

std::vector<FrameExpectation> expectations(const Sequence& sequence, const std::filesystem::path& folder,
                                           const Numbers& numbers) {
    std::vector<FrameExpectation> expected;
    for (const int number : numbers) {
        FrameExpectation& e = expected.emplace_back();
        e.number = number;
        e.file = folder / frame_file_name(sequence.name, number);
        if (!sequence.listed) continue;
        e.inputs = sequence.listed->inputs;
        e.width = sequence.listed->width;
        e.height = sequence.listed->height;
        if (const ManifestFrame* const listed = sequence.listed->find(number)) e.listed = *listed;
    }
    return expected;
}

// Without a manifest the size that most frames have is that of all.
void find_odd_sizes(std::vector<CheckedFrame>& frames) {
    std::map<std::pair<int, int>, int> counts;
    for (const CheckedFrame& f : frames) {
        if (f.digest) ++counts[{f.digest->width, f.digest->height}];
    }
    if (counts.size() < 2) return;
    const auto usual = std::ranges::max_element(counts, {}, [](const auto& count) { return count.second; })->first;
    for (CheckedFrame& f : frames) {
        if (f.fault || !f.digest || std::pair(f.digest->width, f.digest->height) == usual) continue;
        f.fault = FrameFault::Size;
        f.message = fmt::format("it has {} x {} pixels instead of {} x {} as most others", f.digest->width,
                                f.digest->height, usual.first, usual.second);
    }
}

// Files of layers are looked at with the frames that have them, and belong to these for the rest as well: they are
// given to the sequence of the frames, but for what the manifest has as a sequence of its own.
void assign_layer_files(std::map<std::string, Sequence>& sequences, const std::filesystem::path& folder) {
    for (auto it = sequences.begin(); it != sequences.end();) {
        const auto layer = layer_sequence(it->first);
        const auto frames = layer ? sequences.find(layer->frames) : sequences.end();
        if (it->second.listed || frames == sequences.end()) {
            ++it;
            continue;
        }
        for (const int number : it->second.on_disk)
            frames->second.layers_on_disk.push_back(
                {layer->layer, number, folder / frame_file_name(it->first, number)});
        it = sequences.erase(it);
    }
}

SequenceVerdict verify(const Sequence& sequence, const std::filesystem::path& folder, const VerifyOptions& options) {
    const FrameSpan span = sequence.numbers();
    const Numbers numbers =
        parse_frame_range(options.frames.empty() ? fmt::format("{}-{}", span.first, span.last) : options.frames, span);
    const std::vector<FrameExpectation> expected = expectations(sequence, folder, numbers);
    std::vector<CheckedFrame> frames = check_frames(expected, options.progress);
    SequenceVerdict verdict{sequence.name, sequence.listed.has_value(), static_cast<int>(numbers.size()), {}, {}};
    if (!sequence.listed) find_odd_sizes(frames);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        CheckedFrame& frame = frames[i];
        if (!frame.fault && sequence.listed && !expected[i].listed) {
            frame.fault = FrameFault::Unlisted;
            frame.message = "the manifest does not list it";
        }
        if (frame.fault) verdict.bad.push_back({expected[i].file, numbers[i], *frame.fault, frame.message});
    }
    for (const int number : sequence.on_disk) {
        if (number < span.first || number > span.last)
            verdict.foreign.push_back(folder / frame_file_name(sequence.name, number));
    }
    for (const LayerOnDisk& l : sequence.layers_on_disk) {
        const bool is_of_shot = !sequence.listed || sequence.listed->layer_files.has(l.layer);
        if (!is_of_shot || l.number < span.first || l.number > span.last) verdict.foreign.push_back(l.file);
    }
    return verdict;
}

}  // namespace

std::vector<SequenceVerdict> verify_folder(const std::filesystem::path& folder, const VerifyOptions& options) {
    std::map<std::string, Numbers> on_disk = frames_on_disk(folder);
    Manifest manifest = read_manifest(folder).value_or(Manifest{});
    std::map<std::string, Sequence> sequences;
    for (auto& [name, listed] : manifest.sequences) sequences[name] = {name, std::move(listed), {}, {}};
    for (auto& [name, numbers] : on_disk) {
        sequences.try_emplace(name, Sequence{name, std::nullopt, {}, {}}).first->second.on_disk = std::move(numbers);
    }
    assign_layer_files(sequences, folder);
    if (sequences.empty()) throw UserError({folder}, "has no frames, NAME.0001.exr, and no manifest.json");
    std::vector<SequenceVerdict> verdicts;
    for (const auto& [name, sequence] : sequences) verdicts.push_back(verify(sequence, folder, options));
    return verdicts;
}

}  // namespace overfly
