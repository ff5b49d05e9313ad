#include "app/verb_bench_hybrid.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/shot_arguments.h"
#include "shot/bench_hybrid.h"
#include "shot/prepare_scene.h"

namespace overfly {
namespace {

struct Arguments {
    std::string shot;
    ShotArguments overrides;
};

constexpr std::array<const char*, 3> kNames = {"interval", "discrete", "hybrid"};

nlohmann::ordered_json bench_json(const HybridBench& b) {
    nlohmann::ordered_json json = {{"width", b.width},
                                   {"height", b.height},
                                   {"frames", b.frames},
                                   {"lines", b.lines},
                                   {"samples", b.samples},
                                   {"reference_samples", b.reference_samples},
                                   {"share_by_lines", b.share_by_lines}};
    for (std::size_t k = 0; k < kNames.size(); ++k) {
        json["tracers"][kNames[k]] = {{"ns_per_pixel_frame", b.tracers[k].ns_per_pixel_frame},
                                      {"rmse", b.tracers[k].rmse}};
    }
    return json;
}

std::string bench_text(const HybridBench& b) {
    std::string text =
        fmt::format("{} x {}, {} frames, {} lines or {} samples a pixel, one thread; error against {} samples\n\n",
                    b.width, b.height, b.frames, b.lines, b.samples, b.reference_samples);
    text += fmt::format("{:<10}{:>24}{:>12}\n", "", "ns per pixel and frame", "RMSE");
    for (std::size_t k = 0; k < kNames.size(); ++k) {
        text +=
            fmt::format("{:<10}{:>24.0f}{:>12.5f}\n", kNames[k], b.tracers[k].ns_per_pixel_frame, b.tracers[k].rmse);
    }
    text += fmt::format("\nthe hybrid follows lines in {:.1f} % of tiles\n", 100.0 * b.share_by_lines);
    return text;
}

}  // namespace

RunVerb add_bench_hybrid(CLI::App& bench) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* hybrid = bench.add_subcommand("hybrid", "the hybrid beside the two tracers that it chooses from");
    hybrid->fallthrough();
    hybrid->add_option("shot", arguments->shot, "the shot document, configs/NAME.yaml")->required();
    arguments->overrides.add_to(*hybrid);
    return [arguments](const CommonOptions& common) {
        Console console(common);
        BenchOptions options;
        options.cache_folder = default_cache_folder();
        options.progress = console.progress();
        const HybridBench bench_result = bench_hybrid(arguments->overrides.read(arguments->shot), options);
        console.result(bench_text(bench_result), bench_json(bench_result));
        return kDone;
    };
}

}  // namespace overfly
