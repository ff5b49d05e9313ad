#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/render_json.h"
#include "app/shot_arguments.h"
#include "app/verb_bench_hybrid.h"
#include "app/verb_bench_paper.h"
#include "app/verb_bench_write.h"
#include "app/verbs.h"
#include "shot/bench_flight.h"
#include "shot/prepare_scene.h"

namespace overfly {
namespace {

struct Arguments {
    std::string shot;
    long pairs = BenchOptions{}.agreement_pairs;
    ShotArguments overrides;
};

// Counts for each ray and piece, as the paper's table counts them.
nlohmann::ordered_json volume_json(const TraceCounters& c) {
    const double rays = static_cast<double>(c.rays);
    return {{"bv_tests", static_cast<double>(c.box_tests) / rays},
            {"bv_hits", static_cast<double>(c.box_hits) / rays},
            {"poly_tests", static_cast<double>(c.triangle_tests) / rays},
            {"poly_hits", static_cast<double>(c.triangle_hits) / rays}};
}

nlohmann::ordered_json volumes_json(const BenchResult& r) {
    const VolumeComparison& v = r.volumes;
    nlohmann::ordered_json swollen = nlohmann::ordered_json::array();
    for (const SwollenBoxes& s : r.swollen)
        swollen.push_back({{"pieces", s.pieces}, {"lasting_s", s.lasting_s}, {"boxes_per_line", s.per_line}});
    nlohmann::ordered_json inflated = volume_json(v.inflated);
    inflated["build_seconds_per_piece"] = v.inflated_build_s;
    nlohmann::ordered_json in_parts = volume_json(v.swept_in_parts);
    in_parts["cells_per_test"] = kVolumeParts;
    return {{"rays", v.swept.rays},       {"inflated", inflated}, {"swept", volume_json(v.swept)},
            {"swept_in_parts", in_parts}, {"swollen", swollen},   {"differing_rays", v.differing}};
}

nlohmann::ordered_json curve_json(const std::vector<ErrorPoint>& points) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const ErrorPoint& p : points)
        out.push_back({{"count", p.count}, {"drift_px", p.drift_px}, {"rmse", p.rmse}, {"seconds", p.seconds}});
    return out;
}

nlohmann::ordered_json equal_error_json(const ErrorBench& bench) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const EqualError& e : bench.equal)
        out.push_back({{"rmse", e.discrete.rmse},
                       {"discrete_samples", e.discrete.count},
                       {"discrete_seconds", e.discrete.seconds},
                       {"kinetic_lines", e.kinetic.count},
                       {"kinetic_drift_px", e.kinetic.drift_px},
                       {"kinetic_rmse", e.kinetic.rmse},
                       {"kinetic_seconds", e.kinetic.seconds},
                       {"ratio", e.ratio()}});
    return out;
}

double crossings_per_pixel_frame(const BenchResult& r) {
    const TraceCounters& c = r.kinetic.counters;
    const double pieces = static_cast<double>(r.frames) / static_cast<double>(r.timed_pieces);
    return static_cast<double>(c.crossings) / (static_cast<double>(c.rays) * pieces);
}

double same_share(const TraceCounters& c) {
    return c.checked > 0 ? 1.0 - static_cast<double>(c.differed) / static_cast<double>(c.checked) : 1.0;
}

nlohmann::ordered_json bench_json(const BenchResult& r) {
    nlohmann::ordered_json threads = nlohmann::ordered_json::array();
    for (const ThreadTiming& t : r.threads)
        threads.push_back(
            {{"threads", t.threads}, {"seconds", t.seconds}, {"ratio", r.threads.front().seconds / t.seconds}});
    nlohmann::ordered_json rates = nlohmann::ordered_json::array();
    for (const RateCost& c : r.frame_rate_cost)
        rates.push_back({{"factor", c.factor},
                         {"ns_per_pixel_second", c.ns_per_pixel_second},
                         {"ratio", c.ns_per_pixel_second / r.frame_rate_cost.front().ns_per_pixel_second}});
    return {{"width", r.width},
            {"height", r.height},
            {"frames", r.frames},
            {"full_triangles", r.full_triangles},
            {"triangles", r.triangles},
            {"visibility_ns_per_pixel_frame",
             {{"discrete", r.discrete.ns_per_sample},
              {"interval", r.interval.ns_per_sample},
              {"kinetic", r.kinetic.ns_per_sample}}},
            {"crossings_per_pixel_frame", crossings_per_pixel_frame(r)},
            {"discrete", counters_json(r.discrete.counters)},
            {"interval", counters_json(r.interval.counters)},
            {"kinetic", counters_json(r.kinetic.counters)},
            {"volumes", volumes_json(r)},
            {"agreement",
             {{"pairs", r.agreement.pairs},
              {"same_triangle_share", r.agreement.same_share()},
              {"same_depth", r.agreement.same_depth},
              {"near_edge", r.agreement.near_edge},
              {"unexplained", r.agreement.unexplained},
              {"kinetic",
               {{"pairs", r.kinetic_check.checked},
                {"same_triangle_share", same_share(r.kinetic_check)},
                {"near_edge", r.kinetic_check.differed_by_edge}}}}},
            {"reference_samples", r.error.reference_samples},
            {"equal_error", equal_error_json(r.error)},
            {"error_curves",
             {{"discrete", curve_json(r.error.discrete)},
              {"kinetic", curve_json(r.error.kinetic)},
              {"kinetic_other_drifts", curve_json(r.error.other_drifts)}}},
            {"threads", threads},
            {"frame_rate_cost", rates},
            {"end_to_end",
             {{"lines", r.end_to_end.lines},
              {"expose_seconds", r.end_to_end.expose_s},
              {"write_seconds", r.end_to_end.write_s},
              {"ratio", r.end_to_end.ratio()}}}};
}

std::string volumes_text(const BenchResult& r) {
    const VolumeComparison& v = r.volumes;
    std::string text = fmt::format("\nbounding volumes, per ray and piece   {:>9}{:>9}{:>7}{:>13}{:>7}\n", "inflated",
                                   "swept", "ratio", fmt::format("in {} parts", kVolumeParts), "ratio");
    const auto row = [&](const char* what, std::uint64_t TraceCounters::*count) {
        const auto per_ray = [&](const TraceCounters& c) {
            return static_cast<double>(c.*count) / static_cast<double>(c.rays);
        };
        const double inflated = per_ray(v.inflated);
        const double swept = per_ray(v.swept);
        const double in_parts = per_ray(v.swept_in_parts);
        text += fmt::format("  {:<36}{:>9.1f}{:>9.1f}{:>7.2f}{:>13.1f}{:>7.2f}\n", what, inflated, swept,
                            inflated / swept, in_parts, inflated / in_parts);
    };
    row("box tests", &TraceCounters::box_tests);
    row("boxes met", &TraceCounters::box_hits);
    row("triangle tests", &TraceCounters::triangle_tests);
    row("triangles met", &TraceCounters::triangle_hits);
    text +=
        fmt::format("  {} rays, {} of which see something else; inflated boxes take {:.2f} s to build for each piece\n",
                    v.swept.rays, v.differing, v.inflated_build_s);
    for (const SwollenBoxes& b : r.swollen) {
        text += fmt::format(
            "  inflated to last {:.2f} s (pieces: {}): {:.0f} boxes around triangles in the way of a line\n",
            b.lasting_s, b.pieces, b.per_line);
    }
    text += '\n';
    return text;
}

std::string speed_text(const BenchResult& r) {
    std::string text =
        fmt::format("\nerror against {} samples, one thread, light and film included\n", r.error.reference_samples);
    text += "  samples      RMSE  s a frame   lines  drift      RMSE  s a frame   ratio\n";
    for (const EqualError& e : r.error.equal)
        text += fmt::format("  {:>7}{:>10.5f}{:>11.2f}{:>8}{:>7}{:>10.5f}{:>11.2f}{:>8.1f}\n", e.discrete.count,
                            e.discrete.rmse, e.discrete.seconds, e.kinetic.count, e.kinetic.drift_px, e.kinetic.rmse,
                            e.kinetic.seconds, e.ratio());
    for (const RateCost& c : r.frame_rate_cost)
        text += fmt::format("  {:>2} times the frame rate: {:.2f} times the visibility time\n", c.factor,
                            c.ns_per_pixel_second / r.frame_rate_cost.front().ns_per_pixel_second);
    for (const ThreadTiming& t : r.threads)
        text += fmt::format("  {} threads: {:.2f} times as fast as one\n", t.threads,
                            r.threads.front().seconds / t.seconds);
    const EndToEnd& end = r.end_to_end;
    text += fmt::format("  a frame of {} lines: {:.2f} s, its file {:.3f} s, together {:.1f} times the file\n",
                        end.lines, end.expose_s, end.write_s, end.ratio());
    return text + "\n";
}

std::string bench_text(const BenchResult& r) {
    std::string text = fmt::format("{} x {}, {} frames, {} triangles of {}, one thread\n\n", r.width, r.height,
                                   r.frames, r.triangles, r.full_triangles);
    text +=
        fmt::format("visibility, ns per pixel and frame    discrete {:8.1f}    interval {:8.1f}    kinetic {:8.1f}\n",
                    r.discrete.ns_per_sample, r.interval.ns_per_sample, r.kinetic.ns_per_sample);
    const TraceCounters& c = r.interval.counters;
    const double rays = static_cast<double>(c.rays);
    text += fmt::format(
        "interval, per ray and piece           box tests {:.1f}, hits {:.1f}; triangle tests {:.1f}, hits {:.1f}; "
        "segments {:.1f}\n",
        static_cast<double>(c.box_tests) / rays, static_cast<double>(c.box_hits) / rays,
        static_cast<double>(c.triangle_tests) / rays, static_cast<double>(c.triangle_hits) / rays,
        static_cast<double>(c.segments) / rays);
    text += fmt::format("kinetic, per pixel and frame          crossings {:.2f}\n", crossings_per_pixel_frame(r));
    text += speed_text(r);
    text += volumes_text(r);
    text += fmt::format(
        "agreement at {} random pairs      interval {:.4f} % the same triangle; else {} the same depth, {} at an edge, "
        "{} neither\n",
        r.agreement.pairs, 100.0 * r.agreement.same_share(), r.agreement.same_depth, r.agreement.near_edge,
        r.agreement.unexplained);
    text += fmt::format("agreement at {} random pairs      kinetic  {:.4f} % the same triangle; else {} at an edge\n",
                        r.kinetic_check.checked, 100.0 * same_share(r.kinetic_check), r.kinetic_check.differed_by_edge);
    return text;
}

int run_flight(const Arguments& arguments, const CommonOptions& common) {
    Console console(common);
    BenchOptions options;
    options.agreement_pairs = arguments.pairs;
    options.cache_folder = default_cache_folder();
    options.progress = console.progress();
    const BenchResult result = bench_flight(arguments.overrides.read(arguments.shot), options);
    console.result(bench_text(result), bench_json(result));
    return kDone;
}

}  // namespace

RunVerb add_bench(CLI::App& verb) {
    const auto arguments = std::make_shared<Arguments>();
    verb.require_subcommand(1);
    CLI::App* flight = verb.add_subcommand("flight", "the tracers on one shot: time, error, and whether they agree");
    flight->fallthrough();
    flight->add_option("shot", arguments->shot, "the shot document, configs/NAME.yaml")->required();
    flight->add_option("--pairs", arguments->pairs, "random (sample, time) pairs to compare")
        ->check(CLI::Range(1L, 1'000'000'000L));
    arguments->overrides.add_to(*flight);
    const RunVerb run_paper = add_bench_paper(verb);
    const RunVerb run_hybrid = add_bench_hybrid(verb);
    const RunVerb run_write = add_bench_write(verb);
    return [arguments, run_paper, run_hybrid, run_write, &verb](const CommonOptions& common) {
        if (verb.got_subcommand("paper")) return run_paper(common);
        if (verb.got_subcommand("write")) return run_write(common);
        return verb.got_subcommand("hybrid") ? run_hybrid(common) : run_flight(*arguments, common);
    };
}

}  // namespace overfly
