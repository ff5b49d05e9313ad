#include "film/layers.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace overfly {
namespace {

using Names = std::string_view;

template <std::size_t Count>
using Channels = std::array<Names, Count>;

constexpr Channels<1> kRange{"range"}, kCoverage{"coverage"}, kLongitude{"lon"}, kLatitude{"lat"}, kSlope{"slope"},
    kAspect{"aspect"}, kSunIncidence{"sun_incidence"}, kId{"id"}, kDensity{"density"}, kCost{"cost"};
constexpr Channels<2> kMean{"mean.Z", "mean.range"}, kElevation{"elevation.ellipsoid", "elevation.sea_level"};
constexpr Channels<3> kNormal{"N.X", "N.Y", "N.Z"}, kPosition{"P.X", "P.Y", "P.Z"};
constexpr Channels<4> kMotion{"forward.u", "forward.v", "backward.u", "backward.v"};
constexpr Channels<3> kAlbedo{"albedo.R", "albedo.G", "albedo.B"}, kDirect{"direct.R", "direct.G", "direct.B"},
    kShadow{"shadow.R", "shadow.G", "shadow.B"}, kSky{"sky.R", "sky.G", "sky.B"}, kHaze{"haze.R", "haze.G", "haze.B"},
    kBackground{"background.R", "background.G", "background.B"},
    kReflection{"reflection.R", "reflection.G", "reflection.B"};
constexpr Channels<12> kCryptomatte{"CryptoObject00.r", "CryptoObject00.g", "CryptoObject00.b", "CryptoObject00.a",
                                    "CryptoObject01.r", "CryptoObject01.g", "CryptoObject01.b", "CryptoObject01.a",
                                    "CryptoObject02.r", "CryptoObject02.g", "CryptoObject02.b", "CryptoObject02.a"};

constexpr LayerKind light(Layer layer, Names name, std::span<const Names> channels, Names meaning) {
    return {layer, name, StoredAs::Half, LayerGroup::Beauty, channels, meaning};
}
constexpr LayerKind data(Layer layer, Names name, std::span<const Names> channels, Names meaning,
                         StoredAs type = StoredAs::Float) {
    return {layer, name, type, LayerGroup::Data, channels, meaning};
}

constexpr std::array<LayerKind, kLayers> kKinds = {
    data(Layer::Range, "range", kRange, "distance of the nearest surface along the ray, metres; 1e10 where none is"),
    data(Layer::Mean, "mean", kMean,
         "planar depth and distance, metres, averaged over what of the pixel shows a surface"),
    data(Layer::Coverage, "coverage", kCoverage, "share of the pixel and the exposure in which a surface is seen"),
    data(Layer::Normal, "N", kNormal, "normal in the scene (east, north, up at its origin), averaged over surfaces",
         StoredAs::Half),
    data(Layer::Position, "P", kPosition, "scene metres (east, north, up from its origin), averaged over surfaces"),
    data(Layer::Motion, "motion", kMotion,
         "from where it is seen to where it is at the next frame (forward) and at the previous one (backward), pixels, "
         "x to the right, y downward; whatever the shutter"),
    light(Layer::Albedo, "albedo", kAlbedo, "share of light that surfaces reflect, times coverage"),
    light(Layer::Direct, "direct", kDirect,
          "light of the sun on surfaces if nothing threw shadows, seen through the air"),
    light(Layer::Shadow, "shadow", kShadow, "what shadows take of direct: not above 0"),
    light(Layer::Sky, "sky", kSky, "light of the sky and of the ground around on surfaces, seen through the air"),
    light(Layer::Haze, "haze", kHaze, "light that the air adds before surfaces and the Earth beyond the data"),
    light(Layer::Background, "background", kBackground,
          "the sky itself, and the Earth beyond the data seen through the air"),
    light(Layer::Reflection, "reflection", kReflection, "what mirrors send on, seen through the air"),
    data(Layer::Longitude, "lon", kLongitude, "degrees east (WGS84), averaged over surfaces"),
    data(Layer::Latitude, "lat", kLatitude, "degrees north (WGS84), averaged over surfaces"),
    data(Layer::Elevation, "elevation", kElevation,
         "metres above the ellipsoid (WGS84) and above sea level (EGM96), averaged over surfaces"),
    data(Layer::Slope, "slope", kSlope, "degrees from the vertical to the mean normal"),
    data(Layer::Aspect, "aspect", kAspect, "degrees clockwise from north to where the mean normal points"),
    data(Layer::SunIncidence, "sun_incidence", kSunIncidence, "degrees from the sun to the mean normal"),
    data(Layer::Id, "id", kId, "Cryptomatte's number of what is seen most; 0 is the sky", StoredAs::Uint),
    data(Layer::Cryptomatte, "cryptomatte", kCryptomatte, "Cryptomatte 1.2: six objects and the share that each has"),
    data(Layer::Density, "density", kDensity, "lines of sight, or samples, for each pixel"),
    data(Layer::Cost, "cost", kCost, "surfaces that lines of sight meet one after another, or samples, in the pixel"),
};

static_assert([] {
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        if (kKinds[i].layer != static_cast<Layer>(i)) return false;
    }
    return true;
}());

constexpr LayerSet kLight = {Layer::Direct, Layer::Shadow,     Layer::Sky,
                             Layer::Haze,   Layer::Background, Layer::Reflection};
constexpr LayerSet kGeo = {Layer::Longitude, Layer::Latitude, Layer::Elevation,
                           Layer::Slope,     Layer::Aspect,   Layer::SunIncidence};

}  // namespace

std::span<const LayerKind> layer_kinds() { return kKinds; }

std::vector<LayerKind> kinds_of(LayerSet layers) {
    std::vector<LayerKind> kinds;
    std::ranges::copy_if(layer_kinds(), std::back_inserter(kinds),
                         [&](const LayerKind& kind) { return layers.has(kind.layer); });
    return kinds;
}

std::vector<std::string> names_of(LayerSet layers) {
    std::vector<std::string> names;
    for (const LayerKind& kind : kinds_of(layers)) names.emplace_back(kind.name);
    return names;
}

LayerSet layers_of(std::span<const std::string> names) {
    LayerSet layers;
    for (const std::string& name : names) layers.add(layers_named(name).value_or(LayerSet{}));
    return layers;
}

std::optional<Layer> layer_of_channel(std::string_view channel) {
    const auto* const found = std::ranges::find_if(kKinds, [&](const LayerKind& kind) {
        return std::ranges::find(kind.channels, channel) != kind.channels.end();
    });
    return found == kKinds.end() ? std::nullopt : std::optional(found->layer);
}

std::optional<LayerSet> layers_named(std::string_view name) {
    if (name == "light") return kLight;
    if (name == "geo") return kGeo;
    LayerSet found;
    for (const LayerKind& kind : kKinds) {
        if (name == "all" || name == kind.name) found.add(kind.layer);
    }
    if (found.empty()) return std::nullopt;
    return found;
}

}  // namespace overfly
