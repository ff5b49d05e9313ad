#include "terrain/terrain_mesh.h"
