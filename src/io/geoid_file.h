#pragma once

#include "geo/geoid.h"

namespace overfly {

// The EGM96 geoid from PROJ's own data folders. (Asking PROJ to convert heights is not enough: without the grid it
// converts nothing and says nothing.) Throws UserError where no such file is installed or it can't be read.
[[nodiscard]] Geoid read_egm96();

}  // namespace overfly
