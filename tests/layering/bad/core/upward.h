#pragma once

#include <vector>

#include "geo/frames.h"
