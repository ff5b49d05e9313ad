#include <embree3/rtcore.h>
#include <gdal_priv.h>
#include <oneapi/tbb/task_group.h>
