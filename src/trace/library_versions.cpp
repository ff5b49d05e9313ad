#include "trace/library_versions.h"

#include <embree3/rtcore.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

#include <bit>

namespace overfly {
namespace {

std::string embree_version() {
    RTCDevice device = rtcNewDevice(nullptr);
    const auto number = [&](RTCDeviceProperty property) {
        return std::to_string(rtcGetDeviceProperty(device, property));
    };
    std::string version = number(RTC_DEVICE_PROPERTY_VERSION_MAJOR) + '.' + number(RTC_DEVICE_PROPERTY_VERSION_MINOR) +
                          '.' + number(RTC_DEVICE_PROPERTY_VERSION_PATCH);
    rtcReleaseDevice(device);
    return version;
}

// Better targets have lower bits; dynamic dispatch takes the best.
std::string highway_version() {
    const std::int64_t targets = hwy::SupportedTargets();
    return std::to_string(HWY_MAJOR) + '.' + std::to_string(HWY_MINOR) + '.' + std::to_string(HWY_PATCH) + " (" +
           hwy::TargetName(targets & -targets) + ')';
}

}  // namespace

std::vector<LibraryVersion> trace_library_versions() {
    return {{"Embree", embree_version()}, {"Highway", highway_version()}};
}

}  // namespace overfly
