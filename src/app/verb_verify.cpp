#include <algorithm>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/verbs.h"
#include "shot/verify_folder.h"

namespace overfly {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
    std::string folder, frames;
};

std::size_t bad_count(const std::vector<SequenceVerdict>& verdicts) {
    std::size_t count = 0;
    for (const SequenceVerdict& v : verdicts) count += v.bad.size();
    return count;
}

void list_bad_frames(Console& console, const SequenceVerdict& verdict) {
    for (const BadFrame& bad : verdict.bad) console.warn(fmt::format("{}: {}", bad.file.string(), bad.message));
    for (const std::filesystem::path& foreign : verdict.foreign)
        console.say(fmt::format("note: {}: the sequence has no such frame", foreign.string()));
    if (!verdict.has_manifest) {
        console.say(
            fmt::format("note: no manifest lists {}.*.exr: frames after the last, other pixels than were "
                        "rendered and mixed versions can't be found",
                        verdict.name));
    }
}

std::string summary(const SequenceVerdict& v) {
    const std::string frames =
        fmt::format("{}: {} of {} frames are ", v.name, static_cast<std::size_t>(v.frames) - v.bad.size(), v.frames);
    return frames + (v.has_manifest ? "sound and as the manifest lists them\n" : "sound by themselves\n");
}

Json verdict_json(const SequenceVerdict& v) {
    Json bad = Json::array();
    for (const BadFrame& b : v.bad) {
        bad.push_back(
            {{"file", b.file.string()}, {"number", b.number}, {"fault", name_of(b.fault)}, {"message", b.message}});
    }
    Json foreign = Json::array();
    for (const std::filesystem::path& file : v.foreign) foreign.push_back(file.string());
    return {{"name", v.name}, {"manifest", v.has_manifest}, {"frames", v.frames}, {"bad", bad}, {"foreign", foreign}};
}

int run_verify(const Arguments& arguments, const CommonOptions& common) {
    Console console(common);
    const auto verdicts = verify_folder(arguments.folder, {arguments.frames, console.progress()});
    std::string text;
    Json sequences = Json::array();
    for (const SequenceVerdict& verdict : verdicts) {
        list_bad_frames(console, verdict);
        text += summary(verdict);
        sequences.push_back(verdict_json(verdict));
    }
    const bool is_sound = bad_count(verdicts) == 0;
    console.result(text, {{"folder", arguments.folder}, {"sound", is_sound}, {"sequences", sequences}});
    return is_sound ? kDone : kUserCanFix;
}

}  // namespace

RunVerb add_verify(CLI::App& verb) {
    const auto arguments = std::make_shared<Arguments>();
    verb.add_option("folder", arguments->folder, "where the frames are")->required();
    verb.add_option("--frames", arguments->frames, "which frames: 10-20, 1-100:5, 1,5,9 (all)");
    return [arguments](const CommonOptions& common) { return run_verify(*arguments, common); };
}

}  // namespace overfly
