#include <array>
#include <csignal>
#include <exception>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/console.h"
#include "app/stop_signal.h"
#include "app/verbs.h"
#include "config/nearest_word.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/version.h"
#include "shot/interrupted.h"
#include "shot/library_versions.h"

namespace overfly {
namespace {

struct Verb {
    const char* name;
    const char* description;
    AddVerb add;
};

constexpr std::array<Verb, 8> kVerbs = {{
    {"import", "inspect elevation data and prepare it as a scene", add_import},
    {"path", "check a flight: length, speed, clearance, angular rates", add_path},
    {"render", "render the frames of a shot", add_render},
    {"batch", "render many shots, one after another", add_batch},
    {"bench", "compare tracers on a shot, compressions of its frames", add_bench},
    {"timeline", "draw what a pixel sees when", add_timeline},
    {"verify", "check whether a folder of frames is complete and sound", add_verify},
    {"info", "tell what a frame holds", add_info},
}};

std::string version_text() {
    std::string text = fmt::format("overfly {}", kVersion);
    for (const LibraryVersion& v : all_library_versions()) text += fmt::format("\n{} {}", v.name, v.version);
    return text;
}

constexpr int kMostThreads = 4096;

// What to say where no verb was given.
std::string no_verb_text(const std::vector<std::string>& arguments) {
    std::vector<std::string> verbs;
    for (const Verb& verb : kVerbs) verbs.emplace_back(verb.name);
    const std::string known = fmt::format("{}", fmt::join(verbs, ", "));
    if (arguments.empty()) return fmt::format("a verb is missing; known: {}", known);
    const std::string& got = arguments.front();
    if (got.starts_with('-')) return fmt::format("unknown option '{}'; a verb comes first: {}", got, known);
    const auto meant = config::nearest_word(got, verbs);
    return fmt::format("unknown verb '{}'; {}known: {}", got, meant ? fmt::format("did you mean '{}'? ", *meant) : "",
                       known);
}

// Prints help and versions on standard output, and what is wrong with a command line in one line.
int end_parsing(const CLI::App& program, const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return program.exit(error);
    const auto verbs = program.get_subcommands();
    const std::string what = verbs.empty() ? no_verb_text(program.remaining()) : std::string(error.what());
    const std::string help = verbs.empty() ? "overfly --help" : fmt::format("overfly {} --help", verbs[0]->get_name());
    print_to_stderr(fmt::format("overfly: {} ({} tells more)\n", what, help));
    return kUserCanFix;
}

int run(int argc, char** argv) {
    CLI::App program("Overfly turns elevation data and a camera path into a terrain fly-by with exact motion blur.",
                     "overfly");
    program.set_version_flag("--version", version_text);
    program.require_subcommand(1);
    CommonOptions common;
    common.command = {"overfly"};
    common.command.insert(common.command.end(), argv + 1, argv + argc);
    std::function<int()> chosen;
    for (const Verb& verb : kVerbs) {
        CLI::App* sub = program.add_subcommand(verb.name, verb.description);
        sub->add_option("--threads", common.threads, "threads to use (all that the machine has)")
            ->check(CLI::Range(1, kMostThreads));
        sub->add_flag("--quiet", common.quiet, "say nothing but errors");
        sub->add_flag("--json", common.json, "the result as JSON on standard output");
        const RunVerb run_verb = verb.add(*sub);
        sub->callback([&common, &chosen, run_verb] { chosen = [&common, run_verb] { return run_verb(common); }; });
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return end_parsing(program, error);
    }
    if (common.threads > 0) limit_threads(common.threads);
    // A file beyond its limit is an error with a name, as a full disk is, and not the program's end.
    std::signal(SIGXFSZ, SIG_IGN);
    return chosen();
}

// The only place where errors end: a line for each problem, and the exit code.
int run_and_catch(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const UserError& error) {
        // Ctrl-C reaches the encoder as well, whose sudden end isn't what the user has to mend.
        if (stop_was_asked()) return tell_stopped();
        for (const Problem& problem : error.problems()) print_to_stderr(problem.text() + "\n");
        return kUserCanFix;
    } catch (const Interrupted&) {
        return tell_stopped();
    } catch (const std::bad_alloc&) {
        print_to_stderr("overfly: out of memory\n");
        return kUserCanFix;
    } catch (const std::exception& error) {
        print_to_stderr(fmt::format("overfly: internal error: {}\n", error.what()));
        return kOurFault;
    }
}

}  // namespace
}  // namespace overfly

int main(int argc, char** argv) { return overfly::run_and_catch(argc, argv); }
