#include "film/quantities.h"

namespace overfly {
namespace {

struct Need {
    Quantity quantity;
    LayerSet of;
};

// Averages over surfaces are divided by their coverage, so they need it.
constexpr LayerSet kOverSurfaces = {Layer::Coverage,  Layer::Mean,        Layer::Normal,    Layer::Position,
                                    Layer::Longitude, Layer::Latitude,    Layer::Elevation, Layer::Slope,
                                    Layer::Aspect,    Layer::SunIncidence};
// Slopes are told from the vertical of the place.
constexpr LayerSet kGeodetic = {Layer::Longitude, Layer::Latitude, Layer::Elevation, Layer::Slope, Layer::Aspect};

constexpr std::array<Need, kQuantities> kNeeds = {{
    {Quantity::Surface, kOverSurfaces},
    {Quantity::Effort, {Layer::Density, Layer::Cost}},
    {Quantity::Position, {Layer::Position}},
    {Quantity::Normal, {Layer::Normal, Layer::Slope, Layer::Aspect, Layer::SunIncidence}},
    {Quantity::Geodetic, kGeodetic},
    {Quantity::Motion, {Layer::Motion}},
    {Quantity::Albedo, {Layer::Albedo}},
    {Quantity::Direct, {Layer::Direct}},
    {Quantity::Shadow, {Layer::Shadow}},
    {Quantity::Sky, {Layer::Sky}},
    {Quantity::Haze, {Layer::Haze}},
    {Quantity::Background, {Layer::Background}},
    {Quantity::Reflection, {Layer::Reflection}},
}};

}  // namespace

Quantities::Quantities(LayerSet layers) {
    for (const Need& need : kNeeds) {
        if (layers.has_any(need.of)) add(need.quantity);
    }
}

void Quantities::add(Quantity q) {
    wanted_[count_] = q;
    slots_[static_cast<std::size_t>(q)] = static_cast<std::int8_t>(++count_);
}

}  // namespace overfly
