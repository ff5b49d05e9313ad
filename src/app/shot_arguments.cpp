#include "app/shot_arguments.h"

#include <CLI/CLI.hpp>

#include "config/read.h"
#include "core/error.h"

namespace overfly {
namespace {

// Read as a shot, a document of another kind would be a list of unknown keys.
void refuse_other_kind(const std::string& file) {
    DocumentKind kind = DocumentKind::Shot;
    try {
        kind = document_kind(file);
    } catch (const UserError&) {
        return;  // reading it as a shot says what is wrong with it
    }
    const char* const wanted = "a shot document is wanted here, configs/NAME.yaml";
    if (kind == DocumentKind::Terrain) throw UserError({file}, std::string("this is a terrain document; ") + wanted);
    if (kind == DocumentKind::Flight) throw UserError({file}, std::string("this is a flight document; ") + wanted);
    if (kind == DocumentKind::Batch) throw UserError({file}, "this is a batch document; render it with overfly batch");
}

}  // namespace

void ShotArguments::add_to(CLI::App& verb) {
    verb.add_option("--set", set, "put a value into the document: image.width=480")->expected(1)->take_all();
    verb.add_option("--tracer", tracer, "kinetic, interval, discrete or hybrid");
    verb.add_option("--lines", lines, "lines per pixel: kinetic, interval, hybrid");
    verb.add_option("--samples", samples, "samples per pixel: discrete, hybrid");
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

ShotDocument ShotArguments::read(const std::string& file) const {
    refuse_other_kind(file);
    return read_shot_document(file, assignments());
}

}  // namespace overfly
