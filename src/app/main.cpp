#include <array>
#include <exception>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/console.h"
#include "app/stop_signal.h"
#include "app/verbs.h"
#include "config/library_versions.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/version.h"
#include "geo/library_versions.h"
#include "io/library_versions.h"
#include "shot/interrupted.h"
#include "trace/library_versions.h"

namespace overfly {
namespace {

struct Verb {
    const char* name;
    const char* description;
    AddVerb add;
};

constexpr std::array<Verb, 5> kVerbs = {{
    {"import", "inspect elevation data and prepare it as a scene", add_import},
    {"path", "check a flight: length, speed, clearance, angular rates", add_path},
    {"render", "render the frames of a shot", add_render},
    {"batch", "render many shots, one after another", add_batch},
    {"bench", "compare the tracers on a shot", add_bench},
}};

std::string version_text() {
    std::string text = fmt::format("overfly {}", kVersion);
    for (const auto& versions : {core_library_versions(), geo_library_versions(), trace_library_versions(),
                                 io_library_versions(), config_library_versions()}) {
        for (const LibraryVersion& v : versions) text += fmt::format("\n{} {}", v.name, v.version);
    }
    return text;
}

int run(int argc, char** argv) {
    CLI::App program("Overfly turns elevation data and a camera path into a terrain fly-by with exact motion blur.",
                     "overfly");
    program.set_version_flag("--version", version_text);
    program.require_subcommand(1);
    CommonOptions common;
    std::function<int()> chosen;
    for (const Verb& verb : kVerbs) {
        CLI::App* sub = program.add_subcommand(verb.name, verb.description);
        sub->add_option("--threads", common.threads, "threads to use (all that the machine has)")
            ->check(CLI::PositiveNumber);
        sub->add_flag("--quiet", common.quiet, "say nothing but errors");
        sub->add_flag("--json", common.json, "the result as JSON on standard output");
        const RunVerb run_verb = verb.add(*sub);
        sub->callback([&common, &chosen, run_verb] { chosen = [&common, run_verb] { return run_verb(common); }; });
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? kDone : kUserCanFix;
    }
    if (common.threads > 0) limit_threads(common.threads);
    catch_stop_signals();
    return chosen();
}

// The only place where errors end: a line for each problem, and the exit code.
int run_and_catch(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const UserError& error) {
        for (const Problem& problem : error.problems()) fmt::print(stderr, "{}\n", problem.text());
        return kUserCanFix;
    } catch (const Interrupted&) {
        fmt::print(stderr, "\nstopped; what was finished is complete, and a second run goes on from there\n");
        return kInterrupted;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "overfly: out of memory\n");
        return kUserCanFix;
    } catch (const std::exception& error) {
        fmt::print(stderr, "overfly: internal error: {}\n", error.what());
        return kOurFault;
    }
}

}  // namespace
}  // namespace overfly

int main(int argc, char** argv) { return overfly::run_and_catch(argc, argv); }
