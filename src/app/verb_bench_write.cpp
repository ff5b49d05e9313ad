#include "app/verb_bench_write.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/shot_arguments.h"
#include "core/error.h"
#include "shot/bench_write.h"

namespace overfly {
namespace {

struct Arguments {
    std::vector<std::string> inputs;
    int runs = WriteBenchOptions{}.runs;
    ShotArguments overrides;
};

constexpr std::size_t kMostFramesOfShot = 4;
constexpr double kMegabyte = 1e6, kMillisecond = 1e-3;

const char* name_of(LayerGroup group) { return group == LayerGroup::Beauty ? "beauty" : "data"; }

std::string name_of(const GroupCost& cost) {
    switch (cost.compression) {
        case Compression::Zip:
            return "zip";
        case Compression::Zips:
            return "zips";
        case Compression::Piz:
            return "piz";
        case Compression::Dwaa:
            return fmt::format("dwaa {:g}", cost.quality);
    }
    throw InternalError("a compression has a name");
}

// Of those that the shot has rendered, some, evenly spread.
std::vector<std::filesystem::path> frames_of_shot(const ShotDocument& shot) {
    std::vector<std::filesystem::path> all;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(shot.output.folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::filesystem::path& file = entry->path();
        if (file.extension() == ".exr" && file.filename().string().starts_with(shot.output.name + '.'))
            all.push_back(file);
    }
    if (all.empty()) {
        throw UserError({shot.file}, fmt::format("no frames in {}; render some first: overfly render {}",
                                                 shot.output.folder.string(), shot.file.string()));
    }
    std::ranges::sort(all);
    const std::size_t count = std::min(all.size(), kMostFramesOfShot);
    std::vector<std::filesystem::path> some;
    for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * all.size() / count]);
    return some;
}

std::vector<std::filesystem::path> frames_of(const Arguments& arguments) {
    std::vector<std::filesystem::path> frames;
    for (const std::string& input : arguments.inputs) {
        const bool is_shot = std::filesystem::path(input).extension() != ".exr";
        const auto of_input =
            is_shot ? frames_of_shot(arguments.overrides.read(input)) : std::vector<std::filesystem::path>{input};
        frames.insert(frames.end(), of_input.begin(), of_input.end());
    }
    return frames;
}

nlohmann::ordered_json bench_json(const WriteBench& b) {
    nlohmann::ordered_json costs = nlohmann::ordered_json::array();
    for (const GroupCost& c : b.costs) {
        nlohmann::ordered_json cost = {{"layers", name_of(c.group)}, {"compression", name_of(c)},    {"bytes", c.bytes},
                                       {"wall_seconds", c.wall_s},   {"cpu_seconds", c.processor_s}, {"rmse", c.rmse}};
        costs.push_back(std::move(cost));
    }
    const WritingTime& w = b.writing;
    return {{"frames", b.frames},
            {"width", b.width},
            {"height", b.height},
            {"beauty_bytes", b.beauty_bytes},
            {"data_bytes", b.data_bytes},
            {"costs", costs},
            {"take",
             {{"beauty", name_of(b.best_lossless(LayerGroup::Beauty))},
              {"data", name_of(b.best_lossless(LayerGroup::Data))},
              {"lossy_beauty", name_of(b.best_lossy())}}},
            {"write_frame",
             {{"wall_seconds", w.wall_s},
              {"cpu_seconds", w.processor_s},
              {"compression_wall_seconds", w.compression_wall_s},
              {"compression_cpu_seconds", w.compression_processor_s},
              {"ratio", w.ratio()}}}};
}

std::string advice(const WriteBench& b) {
    const GroupCost& beauty = b.best_lossless(LayerGroup::Beauty);
    const GroupCost& data = b.best_lossless(LayerGroup::Data);
    const GroupCost& lossy = b.best_lossy();
    const double lossless_bytes = beauty.bytes + data.bytes;
    const std::string without_loss = beauty.compression == data.compression
                                         ? name_of(beauty)
                                         : fmt::format("{{beauty: {}, data: {}}}", name_of(beauty), name_of(data));
    return fmt::format("take, without loss             output.compression: {}: {:.2f} MB\n", without_loss,
                       lossless_bytes / kMegabyte) +
           fmt::format("or, where colours may lose     output.compression: {{beauty: dwaa, data: {}}}: {:.2f} MB\n",
                       name_of(data), (lossy.bytes + data.bytes) / kMegabyte);
}

std::string bench_text(const WriteBench& b) {
    std::string text =
        fmt::format("{} x {}, {} frames, one thread; each frame on average\n\n", b.width, b.height, b.frames);
    text += fmt::format("{:<20}{:>8}{:>9}{:>10}{:>10}{:>11}\n", "", "MB", "of raw", "ms", "CPU ms", "RMSE");
    for (const GroupCost& c : b.costs) {
        const double raw_bytes = c.group == LayerGroup::Beauty ? b.beauty_bytes : b.data_bytes;
        text += fmt::format("{:<8}{:<12}{:>8.2f}{:>7.0f} %{:>10.1f}{:>10.1f}{:>11}\n", name_of(c.group), name_of(c),
                            c.bytes / kMegabyte, 100.0 * c.bytes / raw_bytes, c.wall_s / kMillisecond,
                            c.processor_s / kMillisecond,
                            is_lossy(c.compression) ? fmt::format("{:.5f}", c.rmse) : "lossless");
    }
    const WritingTime& w = b.writing;
    text +=
        fmt::format("\nwriting a frame with zip takes {:.1f} ms, compression alone {:.1f} ms: {:.2f} times as long\n\n",
                    w.wall_s / kMillisecond, w.compression_wall_s / kMillisecond, w.ratio());
    return text + advice(b);
}

}  // namespace

RunVerb add_bench_write(CLI::App& bench) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* write = bench.add_subcommand("write", "size and time of frames in each compression, and of writing them");
    write->fallthrough();
    write->add_option("frames", arguments->inputs, "frames, or a shot document whose frames are rendered")->required();
    write->add_option("--runs", arguments->runs, "of each; the quickest counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    arguments->overrides.add_to(*write);
    return [arguments](const CommonOptions& common) {
        Console console(common);
        WriteBenchOptions options;
        options.runs = arguments->runs;
        options.progress = console.progress();
        const WriteBench result = bench_write(frames_of(*arguments), options);
        console.result(bench_text(result), bench_json(result));
        return kDone;
    };
}

}  // namespace overfly
