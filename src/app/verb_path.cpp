#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/verbs.h"
#include "config/read.h"
#include "core/error.h"
#include "flight/path_report.h"
#include "shot/frame_plan.h"
#include "shot/shot_motion.h"
#include "shot/stage.h"

namespace overfly {
namespace {

// Often enough that the fastest flights move no farther between two samples than a post of their terrain.
constexpr double kSamplesPerSecond = 100.0;

struct Arguments {
    std::string document, terrain;
    std::vector<std::string> set;
};

struct FlightOverTerrain {
    FlightDocument flight;
    TerrainDocument terrain;
    std::optional<ShotDocument> shot;
};

FlightOverTerrain read_documents(const Arguments& arguments) {
    const DocumentKind kind = document_kind(arguments.document);
    if (kind == DocumentKind::Shot) {
        ShotDocument shot = read_shot_document(arguments.document, arguments.set);
        FlightOverTerrain both = {shot.flight, shot.terrain, std::nullopt};
        if (!arguments.terrain.empty()) both.terrain = read_terrain_document(arguments.terrain);
        both.shot = std::move(shot);
        return both;
    }
    if (kind != DocumentKind::Flight) {
        throw UserError({arguments.document}, "a flight or a shot document is wanted here");
    }
    if (arguments.terrain.empty()) {
        throw UserError({arguments.document},
                        "a flight is checked over a terrain: add --terrain terrain/NAME.yaml, or name "
                        "the shot that joins the two");
    }
    return {read_flight_document(arguments.document, arguments.set), read_terrain_document(arguments.terrain),
            std::nullopt};
}

std::string line(const char* what, const std::string& value) { return fmt::format("{:<22}{}\n", what, value); }

std::string report_text(const PathReport& r) {
    std::string text;
    const auto add = [&](const char* what, const std::string& value) { text += line(what, value); };
    const auto extreme = [](const Extreme& e, const char* unit) {
        return fmt::format("{:.1f} {} at {:.2f} s", e.value, unit, e.time_s);
    };
    add("duration", fmt::format("{:.3f} s", r.duration_s));
    add("length", fmt::format("{:.1f} m", r.length_m));
    add("climb", fmt::format("{:.1f} m", r.climb_m));
    add("speed, mean", fmt::format("{:.1f} m/s", r.mean_m_per_s));
    add("speed, slowest", extreme(r.slowest_m_per_s, "m/s"));
    add("speed, fastest", extreme(r.fastest_m_per_s, "m/s"));
    add("hardest acceleration", extreme(r.hardest_g, "g"));
    add("fastest turn", extreme(r.fastest_turn_deg_per_s, "deg/s"));
    add("  heading", extreme(r.fastest_heading_deg_per_s, "deg/s"));
    add("  pitch", extreme(r.fastest_pitch_deg_per_s, "deg/s"));
    add("  roll", extreme(r.fastest_roll_deg_per_s, "deg/s"));
    if (r.lowest) {
        add("lowest clearance", fmt::format("{:.1f} m at {:.2f} s, lon {:.5f} lat {:.5f}", r.lowest->clearance_m,
                                            r.lowest->time_s, r.lowest->lon.degrees(), r.lowest->lat.degrees()));
    } else {
        add("lowest clearance", "no ground under the flight");
    }
    if (r.off_terrain_share > 0.0)
        add("off the terrain", fmt::format("{:.1f} % of the time", 100.0 * r.off_terrain_share));
    return text;
}

nlohmann::ordered_json extreme_json(const Extreme& e) { return {{"value", e.value}, {"time_s", e.time_s}}; }

nlohmann::ordered_json report_json(const PathReport& r) {
    nlohmann::ordered_json json = {{"duration_s", r.duration_s},
                                   {"length_m", r.length_m},
                                   {"climb_m", r.climb_m},
                                   {"mean_m_per_s", r.mean_m_per_s},
                                   {"slowest_m_per_s", extreme_json(r.slowest_m_per_s)},
                                   {"fastest_m_per_s", extreme_json(r.fastest_m_per_s)},
                                   {"hardest_g", extreme_json(r.hardest_g)},
                                   {"fastest_turn_deg_per_s", extreme_json(r.fastest_turn_deg_per_s)},
                                   {"fastest_heading_deg_per_s", extreme_json(r.fastest_heading_deg_per_s)},
                                   {"fastest_pitch_deg_per_s", extreme_json(r.fastest_pitch_deg_per_s)},
                                   {"fastest_roll_deg_per_s", extreme_json(r.fastest_roll_deg_per_s)},
                                   {"off_terrain_share", r.off_terrain_share}};
    if (r.lowest) {
        json["lowest_clearance"] = {{"clearance_m", r.lowest->clearance_m},
                                    {"time_s", r.lowest->time_s},
                                    {"lon_deg", r.lowest->lon.degrees()},
                                    {"lat_deg", r.lowest->lat.degrees()}};
    }
    return json;
}

int run_path(const Arguments& arguments, const CommonOptions& common) {
    Console console(common);
    const FlightOverTerrain both = read_documents(arguments);
    const Stage stage(prepare_terrain(both.terrain, default_cache_folder(), console.progress()),
                      middle_of(both.flight));
    const CameraPath path = make_path(both.flight, stage);
    const PathReport report = report_path(path, stage.surroundings(), kSamplesPerSecond);
    nlohmann::ordered_json json = report_json(report);
    std::string text = report_text(report);
    if (both.shot) {
        const Motion motion = shot_motion(*both.shot, path, plan_frames(*both.shot, path.times()), stage);
        json["motion"] = {{"pieces", motion.pieces.size()},
                          {"bound_px", motion.bound_px},
                          {"largest_error_px", motion.largest_error_px}};
        text += line("motion", fmt::format("{} pieces, {:.4f} px from the exact path at most (bound {} px)",
                                           motion.pieces.size(), motion.largest_error_px, motion.bound_px));
    }
    console.result(text, json);
    if (!report.goes_below_ground()) return kDone;
    throw UserError({both.flight.file},
                    fmt::format("the flight goes {:.1f} m below the ground at {:.2f} s, between its keyframes; "
                                "raise or add a keyframe there",
                                -report.lowest->clearance_m, report.lowest->time_s));
}

}  // namespace

RunVerb add_path(CLI::App& verb) {
    const auto arguments = std::make_shared<Arguments>();
    verb.add_option("document", arguments->document, "a flight, camera_paths/NAME.yaml, or a shot")->required();
    verb.add_option("--terrain", arguments->terrain, "the terrain to fly over, terrain/NAME.yaml");
    verb.add_option("--set", arguments->set, "put a value into the document: keyframes.2.time_s=4")
        ->expected(1)
        ->take_all();
    return [arguments](const CommonOptions& common) { return run_path(*arguments, common); };
}

}  // namespace overfly
