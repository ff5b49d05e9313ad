#include "app/verb_bench_paper.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "config/read.h"
#include "shot/bench_paper.h"

namespace overfly {
namespace {

using Json = nlohmann::ordered_json;

struct Arguments {
    std::string terrain = "terrain/blanca_peak.yaml";
    int runs = PaperBenchOptions{}.runs;
};

Json measurement_json(const PaperMeasurement& m, bool is_compared) {
    const PaperCounters& c = m.counters;
    Json json = {{"bv_tests", c.bv_tests},
                 {"bv_hits", c.bv_hits},
                 {"poly_tests", c.poly_tests},
                 {"poly_hits", c.poly_hits},
                 {"seconds", m.seconds}};
    if (is_compared) {
        json["differing_pixels"] = m.to_discrete.differing;
        json["differing_share"] = m.to_discrete.differing_share();
        json["differing_not_at_an_edge"] = m.to_discrete.unexplained;
    }
    return json;
}

// Embree does not say what it tests.
Json embree_json(const PaperMeasurement& m) {
    Json json = measurement_json(m, true);
    for (const char* key : {"bv_tests", "bv_hits", "poly_tests", "poly_hits"}) json[key] = nullptr;
    return json;
}

Json column_json(const PaperColumn& c) {
    const auto count = [](double thousands) { return static_cast<std::uint64_t>(thousands * 1000.0); };
    return {{"bv_tests", count(c.bv_tests)},
            {"bv_hits", count(c.bv_hits)},
            {"poly_tests", count(c.poly_tests)},
            {"poly_hits", count(c.poly_hits)},
            {"seconds", c.seconds}};
}

Json ratio_json(const PaperRatio& r) {
    return {{"bv_tests", r.bv_tests}, {"poly_tests", r.poly_tests}, {"seconds", r.seconds}};
}

Json bench_json(const PaperBench& bench) {
    Json cases = Json::array();
    for (const PaperCase& c : bench.cases) {
        cases.push_back({{"name", c.name},
                         {"discrete", measurement_json(c.discrete, false)},
                         {"continuous", measurement_json(c.continuous, true)},
                         {"continuous_inflated", measurement_json(c.inflated, true)},
                         {"embree", embree_json(c.embree)},
                         {"ratio", ratio_json(c.ratio())},
                         {"ratio_inflated", ratio_json(c.inflated_ratio())},
                         {"paper_discrete", column_json(c.paper_discrete)},
                         {"paper_continuous", column_json(c.paper_continuous)},
                         {"paper_ratio", ratio_json(c.paper_ratio())}});
    }
    return {{"rows", bench.rows}, {"columns", bench.columns}, {"frames", bench.frames}, {"cases", cases}};
}

// A row of the table: a count in thousands of the five columns.
std::string count_row(const char* what, const PaperCase& c, std::uint64_t PaperCounters::*ours,
                      double PaperColumn::*papers) {
    const auto thousands = [&](const PaperMeasurement& m) { return static_cast<double>(m.counters.*ours) / 1000.0; };
    return fmt::format("  {:<13}{:>12.0f}{:>10.0f}{:>14.0f}{:>10.0f}{:>12.0f}\n", what, thousands(c.discrete),
                       c.paper_discrete.*papers, thousands(c.continuous), c.paper_continuous.*papers,
                       thousands(c.inflated));
}

// A row of shares: what part of the tests of one kind succeeded.
std::string share_row(const PaperCase& c, std::uint64_t PaperCounters::*hits, std::uint64_t PaperCounters::*tests,
                      double PaperColumn::*paper_hits, double PaperColumn::*paper_tests) {
    const auto ours = [&](const PaperMeasurement& m) {
        return 100.0 * static_cast<double>(m.counters.*hits) / static_cast<double>(m.counters.*tests);
    };
    const auto papers = [&](const PaperColumn& p) { return 100.0 * (p.*paper_hits) / (p.*paper_tests); };
    return fmt::format("  {:<13}{:>12.0f}{:>10.0f}{:>14.0f}{:>10.0f}{:>12.0f}\n", "%", ours(c.discrete),
                       papers(c.paper_discrete), ours(c.continuous), papers(c.paper_continuous), ours(c.inflated));
}

std::string ratio_row(const char* what, double PaperRatio::*of, const PaperCase& c) {
    return fmt::format("  {:<13}{:>8.1f}   paper {:>6.1f}   inflated {:>6.1f}\n", what, c.ratio().*of,
                       c.paper_ratio().*of, c.inflated_ratio().*of);
}

std::string case_text(std::size_t number, const PaperCase& c) {
    std::string text = fmt::format("\n{}. {}\n", number, c.title);
    text += fmt::format("  {:<13}{:>12}{:>10}{:>14}{:>10}{:>12}{:>10}\n", "", "discrete", fmt::format("(A{})", number),
                        "continuous", fmt::format("(B{})", number), "inflated", "Embree");
    using C = PaperCounters;
    using P = PaperColumn;
    text += count_row("B.Vol. Test", c, &C::bv_tests, &P::bv_tests);
    text += count_row("B.Vol. Succ.", c, &C::bv_hits, &P::bv_hits);
    text += share_row(c, &C::bv_hits, &C::bv_tests, &P::bv_hits, &P::bv_tests);
    text += count_row("Poly. Test", c, &C::poly_tests, &P::poly_tests);
    text += count_row("Poly. Succ.", c, &C::poly_hits, &P::poly_hits);
    text += share_row(c, &C::poly_hits, &C::poly_tests, &P::poly_hits, &P::poly_tests);
    text += fmt::format("  {:<13}{:>12.3f}{:>10.0f}{:>14.3f}{:>10.0f}{:>12.3f}{:>10.3f}\n", "Seconds",
                        c.discrete.seconds, c.paper_discrete.seconds, c.continuous.seconds, c.paper_continuous.seconds,
                        c.inflated.seconds, c.embree.seconds);
    text += "  discrete / continuous\n";
    text += ratio_row("B.Vol. Test", &PaperRatio::bv_tests, c);
    text += ratio_row("Poly. Test", &PaperRatio::poly_tests, c);
    text += ratio_row("Seconds", &PaperRatio::seconds, c);
    text += fmt::format(
        "  pixels of all frames that differ from discrete: continuous {}, inflated {}, Embree {}; "
        "not at an edge: {}, {}, {}\n",
        c.continuous.to_discrete.differing, c.inflated.to_discrete.differing, c.embree.to_discrete.differing,
        c.continuous.to_discrete.unexplained, c.inflated.to_discrete.unexplained, c.embree.to_discrete.unexplained);
    return text;
}

std::string bench_text(const PaperBench& bench) {
    std::string text = fmt::format(
        "Chapman, Calvert and Dill 1991, Figure 5: {} rows x {} columns, {} frames, one ray per pixel, one thread.\n"
        "Tests in thousands; (A) and (B) are the paper's numbers. inflated: continuous, with the paper's boxes.\n",
        bench.rows, bench.columns, bench.frames);
    for (std::size_t i = 0; i < bench.cases.size(); ++i) text += case_text(i + 1, bench.cases[i]);
    return text;
}

int run_paper(const Arguments& arguments, const CommonOptions& common) {
    Console console(common);
    PaperBenchOptions options;
    options.runs = arguments.runs;
    options.progress = console.progress();
    const PaperBench bench = bench_paper(read_terrain_document(arguments.terrain), options);
    console.result(bench_text(bench), bench_json(bench));
    return kDone;
}

}  // namespace

RunVerb add_bench_paper(CLI::App& bench) {
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* paper = bench.add_subcommand("paper", "the table of Chapman, Calvert and Dill 1991, measured again");
    paper->fallthrough();
    paper->add_option("--terrain", arguments->terrain, "what the third animation flies over")->capture_default_str();
    paper->add_option("--runs", arguments->runs, "of each tracer; the quickest counts")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    return [arguments](const CommonOptions& common) { return run_paper(*arguments, common); };
}

}  // namespace overfly
