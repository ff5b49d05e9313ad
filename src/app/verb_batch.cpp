#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/render_json.h"
#include "app/shot_arguments.h"
#include "app/stop_signal.h"
#include "app/verbs.h"
#include "config/read.h"
#include "shot/prepare_scene.h"
#include "shot/render_batch.h"

namespace overfly {
namespace {

struct Arguments {
    std::vector<std::string> documents;
    ShotArguments overrides;
};

// Shots as they are, batches by the shots that they list.
std::vector<std::filesystem::path> shots_of(const std::vector<std::string>& documents) {
    std::vector<std::filesystem::path> shots;
    for (const std::string& document : documents) {
        // A file that can't be told is left to the batch, which reports it and goes on.
        bool is_batch = false;
        try {
            is_batch = document_kind(document) == DocumentKind::Batch;
        } catch (const UserError&) {
            is_batch = false;
        }
        if (!is_batch) {
            shots.emplace_back(document);
            continue;
        }
        for (const std::filesystem::path& shot : read_batch_document(document).shots) shots.push_back(shot);
    }
    return shots;
}

int report(Console& console, const std::vector<ShotOutcome>& outcomes) {
    int exit_code = kDone;
    console.say(fmt::format("batch of {} shots:", outcomes.size()));
    for (const ShotOutcome& o : outcomes) {
        if (o.result) {
            console.say(fmt::format("  done    {}: {} frames rendered, {} kept, {:.1f} s", o.shot.string(),
                                    o.result->frames_rendered, o.result->frames_kept, o.result->total_s));
            continue;
        }
        exit_code = o.our_fault || exit_code == kOurFault ? kOurFault : kUserCanFix;
        console.warn(fmt::format("  FAILED  {}", o.shot.string()));
        for (const Problem& p : o.problems) console.warn("          " + p.text());
    }
    return exit_code;
}

nlohmann::ordered_json batch_json(const std::vector<ShotOutcome>& outcomes) {
    nlohmann::ordered_json shots = nlohmann::ordered_json::array();
    for (const ShotOutcome& o : outcomes) {
        nlohmann::ordered_json shot = {{"shot", o.shot.string()}, {"done", o.result.has_value()}};
        if (o.result) shot["result"] = render_json(*o.result);
        for (const Problem& p : o.problems) shot["problems"].push_back(p.text());
        shots.push_back(std::move(shot));
    }
    return {{"shots", std::move(shots)}};
}

int run_batch(const Arguments& arguments, const CommonOptions& common) {
    const StopSignals stop_signals;
    Console console(common);
    RenderOptions options;
    options.cache_folder = default_cache_folder();
    options.progress = console.progress();
    options.say = [&](const std::string& line) { console.say(line); };
    options.should_stop = stop_was_asked;
    options.command = common.command;
    const auto outcomes = render_batch(shots_of(arguments.documents), arguments.overrides.assignments(), options);
    const int exit_code = report(console, outcomes);
    console.result("", batch_json(outcomes));
    return exit_code;
}

}  // namespace

RunVerb add_batch(CLI::App& verb) {
    const auto arguments = std::make_shared<Arguments>();
    verb.add_option("documents", arguments->documents, "shot documents, or batch documents that list them")->required();
    arguments->overrides.add_to(verb);
    return [arguments](const CommonOptions& common) { return run_batch(*arguments, common); };
}

}  // namespace overfly
