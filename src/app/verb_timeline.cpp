#include <span>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/shot_arguments.h"
#include "app/verbs.h"
#include "io/output_file.h"
#include "shot/pixel_timeline.h"
#include "shot/prepare_scene.h"
#include "shot/timeline_svg.h"

namespace overfly {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
    std::string shot, output;
    PixelQuestion question;
    ShotArguments overrides;
};

Json range_json(TimeRange when) { return {{"begin_s", when.begin_s}, {"end_s", when.end_s}}; }

Json records_json(std::span<const SightRecord> records, std::span<const std::string> surfaces) {
    Json list = Json::array();
    for (const SightRecord& r : records) {
        Json record = {{"surface", surfaces[r.what.surface]},
                       {"triangle", r.what.triangle},
                       {"begin_s", r.when.begin_s},
                       {"end_s", r.when.end_s}};
        record["begin_depth_m"] = r.depth.empty() ? Json() : Json(r.depth.front().depth_m);
        record["end_depth_m"] = r.depth.empty() ? Json() : Json(r.depth.back().depth_m);
        list.push_back(record);
    }
    return list;
}

Json timeline_json(const PixelTimeline& pixel) {
    Json frames = Json::array();
    for (const PlannedFrame& f : pixel.frames) {
        frames.push_back({{"frame", f.number}, {"open_s", f.exposure.begin_s}, {"closed_s", f.exposure.end_s}});
    }
    Json pieces = Json::array();
    for (const TimeRange& piece : pixel.timeline.pieces) pieces.push_back(range_json(piece));
    return {{"shot", pixel.shot},
            {"pixel", {pixel.x_px, pixel.y_px}},
            {"begin_s", pixel.timeline.when.begin_s},
            {"end_s", pixel.timeline.when.end_s},
            {"frames", frames},
            {"pieces", pieces},
            {"passed", records_json(pixel.timeline.passed, pixel.surfaces)},
            {"seen", records_json(pixel.timeline.seen, pixel.surfaces)}};
}

std::string timeline_text(const PixelTimeline& pixel) {
    const Timeline& t = pixel.timeline;
    std::string text =
        fmt::format("{:>12}{:>12}{:>12}{:>14}{:>14}   {}\n", "triangle", "from, s", "to, s", "depth, m", "to, m", "of");
    for (const SightRecord& r : t.seen) {
        if (r.depth.empty()) continue;
        text +=
            fmt::format("{:>12}{:>12.6f}{:>12.6f}{:>14.2f}{:>14.2f}   {}\n", r.what.triangle, r.when.begin_s,
                        r.when.end_s, r.depth.front().depth_m, r.depth.back().depth_m, pixel.surfaces[r.what.surface]);
    }
    return text + fmt::format("{} records seen of {} passed, {:.6f} to {:.6f} s\n", t.seen.size(), t.passed.size(),
                              t.when.begin_s, t.when.end_s);
}

void save(const std::string& file, const std::string& document) {
    OutputFile out(file);
    out.write(std::as_bytes(std::span(document)));
    out.commit();
}

int run_timeline(Arguments arguments, const CommonOptions& common) {
    Console console(common);
    arguments.question.cache_folder = default_cache_folder();
    arguments.question.progress = console.progress();
    const PixelTimeline pixel = pixel_timeline(arguments.overrides.read(arguments.shot), arguments.question);
    if (!arguments.output.empty()) save(arguments.output, timeline_svg(pixel));
    console.result(timeline_text(pixel), timeline_json(pixel));
    return kDone;
}

}  // namespace

RunVerb add_timeline(CLI::App& verb) {
    const auto arguments = std::make_shared<Arguments>();
    PixelQuestion& question = arguments->question;
    verb.add_option("shot", arguments->shot, "the shot document, configs/NAME.yaml")->required();
    verb.add_option("--pixel", question.pixel, "X,Y: its column and row, from 0,0 at the upper left")->required();
    auto* const frames = verb.add_option("--frames", question.frames, "from one frame's exposure to another's: 59-62");
    verb.add_option("--time", question.time, "seconds of the flight: 2.4-2.6 (a piece of motion in the middle)")
        ->excludes(frames);
    verb.add_option("--triangle", question.triangle, "whose curve of intersection (those that are seen longest)");
    verb.add_option("-o,--output", arguments->output, "draw it there, as SVG");
    verb.add_option("--set", arguments->overrides.set, "put a value into the document: image.width=480")
        ->expected(1)
        ->take_all();
    return [arguments](const CommonOptions& common) { return run_timeline(*arguments, common); };
}

}  // namespace overfly
