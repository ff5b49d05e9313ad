#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/render_json.h"
#include "app/shot_arguments.h"
#include "app/verb_bench_paper.h"
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

nlohmann::ordered_json bench_json(const BenchResult& r) {
    return {{"width", r.width},
            {"height", r.height},
            {"frames", r.frames},
            {"triangles", r.triangles},
            {"visibility_ns_per_pixel_frame",
             {{"discrete", r.discrete.ns_per_sample}, {"interval", r.interval.ns_per_sample}}},
            {"discrete", counters_json(r.discrete.counters)},
            {"interval", counters_json(r.interval.counters)},
            {"agreement",
             {{"pairs", r.agreement.pairs},
              {"same_triangle_share", r.agreement.same_share()},
              {"same_depth", r.agreement.same_depth},
              {"near_edge", r.agreement.near_edge},
              {"unexplained", r.agreement.unexplained}}}};
}

std::string bench_text(const BenchResult& r) {
    std::string text =
        fmt::format("{} x {}, {} frames, {} triangles, one thread\n\n", r.width, r.height, r.frames, r.triangles);
    text += fmt::format("visibility, ns per pixel and frame    discrete {:8.1f}    interval {:8.1f}\n",
                        r.discrete.ns_per_sample, r.interval.ns_per_sample);
    const TraceCounters& c = r.interval.counters;
    const double rays = static_cast<double>(c.rays);
    text += fmt::format(
        "interval, per ray and piece           box tests {:.1f}, hits {:.1f}; triangle tests {:.1f}, hits {:.1f}; "
        "segments {:.1f}\n",
        static_cast<double>(c.box_tests) / rays, static_cast<double>(c.box_hits) / rays,
        static_cast<double>(c.triangle_tests) / rays, static_cast<double>(c.triangle_hits) / rays,
        static_cast<double>(c.segments) / rays);
    text += fmt::format(
        "agreement at {} random pairs      {:.4f} % the same triangle; else {} the same depth, {} at an edge, {} "
        "neither\n",
        r.agreement.pairs, 100.0 * r.agreement.same_share(), r.agreement.same_depth, r.agreement.near_edge,
        r.agreement.unexplained);
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
    CLI::App* flight =
        verb.add_subcommand("flight", "both tracers on one shot: time per sample, and whether they agree");
    flight->fallthrough();
    flight->add_option("shot", arguments->shot, "the shot document, configs/NAME.yaml")->required();
    flight->add_option("--pairs", arguments->pairs, "random (sample, time) pairs to compare")
        ->check(CLI::Range(1L, 1'000'000'000L));
    arguments->overrides.add_to(*flight);
    const RunVerb run_paper = add_bench_paper(verb);
    return [arguments, run_paper, &verb](const CommonOptions& common) {
        return verb.got_subcommand("paper") ? run_paper(common) : run_flight(*arguments, common);
    };
}

}  // namespace overfly
