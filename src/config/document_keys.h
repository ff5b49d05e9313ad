#pragma once

#include <string>
#include <vector>

#include "config/read.h"

namespace overfly {

// Every key that a kind of document may have, as the readers themselves ask for them: dotted, sections before their
// contents, `N` for the index in a list (`keyframes.N.time_s`).
[[nodiscard]] std::vector<std::string> document_keys(DocumentKind kind);

}  // namespace overfly
