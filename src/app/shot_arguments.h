#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/documents.h"

namespace CLI {
class App;
}

namespace overfly {

// The options that change a shot document from the command line. All of them are spellings of --set.
struct ShotArguments {
    std::vector<std::string> set;
    std::optional<std::string> tracer, lines, samples, folder;

    void add_to(CLI::App& verb);
    // key=value, in the order in which they are to be put in.
    [[nodiscard]] std::vector<std::string> assignments() const;
    // The shot document with all of them put in. Throws UserError, also where the file is a document of another kind.
    [[nodiscard]] ShotDocument read(const std::string& file) const;
};

}  // namespace overfly
