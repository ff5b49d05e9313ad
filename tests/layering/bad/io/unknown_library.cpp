#include <boost/any.hpp>

#include "shot/render.h"
