#include <fmt/format.h>

#include "core/upward.h"
