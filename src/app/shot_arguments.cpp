#include "app/shot_arguments.h"

#include <CLI/CLI.hpp>

namespace overfly {

void ShotArguments::add_to(CLI::App& verb) {
    verb.add_option("--set", set, "put a value into the document: image.width=480")->expected(1)->take_all();
    verb.add_option("--tracer", tracer, "interval or discrete");
    verb.add_option("--lines", lines, "lines per pixel of the interval tracer");
    verb.add_option("--samples", samples, "samples per pixel of the discrete tracer");
    verb.add_option("-o,--output", folder, "folder for the frames");
}

std::vector<std::string> ShotArguments::assignments() const {
    std::vector<std::string> all = set;
    const auto add = [&](const char* key, const std::optional<std::string>& value) {
        if (value) all.push_back(std::string(key) + '=' + *value);
    };
    add("sampling.tracer", tracer);
    add("sampling.lines", lines);
    add("sampling.samples", samples);
    add("output.folder", folder);
    return all;
}

}  // namespace overfly
