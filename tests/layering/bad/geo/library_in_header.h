#pragma once

#include <fmt/format.h>
#include <unistd.h>
