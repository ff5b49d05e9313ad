#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/render_json.h"
#include "app/shot_arguments.h"
#include "app/stop_signal.h"
#include "app/verbs.h"
#include "shot/prepare_scene.h"
#include "shot/render_shot.h"

namespace overfly {
namespace {

struct Arguments {
    std::string shot, frames;
    std::uint64_t check_every = 0;
    bool repair = false;
    ShotArguments overrides;
};

// As one would type it from here: a document's folder may be said by way of the document's own.
std::string from_here(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path shorter = std::filesystem::proximate(path, error);
    return error || shorter.string().size() >= path.string().size() ? path.string() : shorter.string();
}

void summarise(Console& console, const RenderResult& r) {
    console.say(fmt::format("{}: {} of {} frames rendered, {} kept, in {:.1f} s", from_here(r.folder),
                            r.frames_rendered, r.frames_wanted, r.frames_kept, r.total_s));
    const TraceCounters& c = r.counters;
    if (c.checked > 0)
        console.say(fmt::format(
            "checked: {} of {} answers differ from a discrete ray's, {:.4f} %; {} of them at an edge", c.differed,
            c.checked, 100.0 * static_cast<double>(c.differed) / static_cast<double>(c.checked), c.differed_by_edge));
    if (!r.previews.contact_sheet.empty())
        console.say(fmt::format("contact sheet: {}", from_here(r.previews.contact_sheet)));
    if (!r.previews.movie.empty()) console.say(fmt::format("preview movie: {}", from_here(r.previews.movie)));
}

int run_render(const Arguments& arguments, const CommonOptions& common) {
    const StopSignals stop_signals;
    Console console(common);
    const ShotDocument shot = arguments.overrides.read(arguments.shot);
    RenderOptions options;
    options.frames = arguments.frames;
    options.cache_folder = default_cache_folder();
    options.progress = console.progress();
    options.say = [&](const std::string& line) { console.say(line); };
    options.should_stop = stop_was_asked;
    options.check_every = arguments.check_every;
    options.repair = arguments.repair;
    options.command = common.command;
    const RenderResult result = render_shot(shot, options);
    summarise(console, result);
    console.result("", render_json(result));
    return kDone;
}

}  // namespace

RunVerb add_render(CLI::App& verb) {
    const auto arguments = std::make_shared<Arguments>();
    verb.add_option("shot", arguments->shot, "the shot document, configs/NAME.yaml")->required();
    verb.add_option("--frames", arguments->frames, "which frames: 10-20, 1-100:5, 1,5,9 (all)");
    verb.add_option("--check-every", arguments->check_every,
                    "debugging: ask rays again what every so many-th line of the kinetic tracer sees (0: none)");
    verb.add_flag("--repair", arguments->repair,
                  "render again what overfly verify finds bad, not only what is missing or incomplete");
    arguments->overrides.add_to(verb);
    return [arguments](const CommonOptions& common) { return run_render(*arguments, common); };
}

}  // namespace overfly
