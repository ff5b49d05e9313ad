#include "shot/frame_developer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <utility>

#include "core/error.h"
#include "film/cryptomatte.h"
#include "shot/pixel_tile.h"

namespace overfly {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

// Less of a pixel than this shows no surface that anything could be said of: with filters that weigh some of it
// negatively the rest may be rounding.
constexpr float kLeastCoverage = 1e-5F;

Vector<Scene> vector_of(Float4 v) { return {v[0], v[1], v[2]}; }
double angle_deg(Vector<Scene> a, Vector<Scene> b) { return kDegrees * std::atan2(length(cross(a, b)), dot(a, b)); }

// A layer that is an average: the numbers of a quantity from `first` on, over all of the pixel or over what of it shows
// a surface.
enum class Over : std::uint8_t { Whole, Surfaces };
struct Average {
    Layer layer;
    Quantity quantity;
    std::size_t first = 0;
    Over over = Over::Whole;
};
constexpr Average kAverages[] = {
    {Layer::Mean, Quantity::Surface, 1, Over::Surfaces},
    {Layer::Coverage, Quantity::Surface},
    {Layer::Normal, Quantity::Normal, 0, Over::Surfaces},
    {Layer::Position, Quantity::Position, 0, Over::Surfaces},
    {Layer::Motion, Quantity::Motion},
    {Layer::Albedo, Quantity::Albedo},
    {Layer::Direct, Quantity::Direct},
    {Layer::Shadow, Quantity::Shadow},
    {Layer::Sky, Quantity::Sky},
    {Layer::Haze, Quantity::Haze},
    {Layer::Background, Quantity::Background},
    {Layer::Reflection, Quantity::Reflection},
    {Layer::Elevation, Quantity::Geodetic, 2, Over::Surfaces},
    {Layer::Density, Quantity::Effort, 0},
    {Layer::Cost, Quantity::Effort, 1},
};

// The layers of one frame, made of what lines have told.
class LayerMaker {
  public:
    LayerMaker(const FilmFacts& facts, const Stage& stage, Vector<Scene> to_sun,
               const std::vector<std::uint32_t>& object_ids, double tan_half_fov, Frame& frame)
        : facts_(facts),
          stage_(stage),
          to_sun_(to_sun),
          object_ids_(object_ids),
          tan_half_fov_(tan_half_fov),
          frame_(frame) {}

    void add(Layer layer) {
        if (layer == Layer::Cryptomatte) return add_cryptomatte();
        for (const Average& average : kAverages) {
            if (average.layer == layer) return add_average(average);
        }
        const auto derived = std::ranges::find(kDerived, layer, &Derived::layer);
        check(derived != std::end(kDerived), "every layer is known how to be made");
        add_channels(layer, [&](std::size_t i, std::size_t) { return (this->*derived->value)(i); });
    }

  private:
    // value(pixel, which of the layer's channels)
    template <class Value>
    void add_channels(Layer layer, const Value& value) {
        const LayerKind& kind = kind_of(layer);
        for (std::size_t c = 0; c < kind.channels.size(); ++c) {
            LayerChannel& channel = frame_.layers.emplace_back();
            channel.name = kind.channels[c];
            channel.type = kind.type;
            channel.group = kind.group;
            channel.values.resize(frame_.rgba.size());
            for (std::size_t i = 0; i < channel.values.size(); ++i) channel.values[i] = value(i, c);
        }
    }
    void add_average(const Average& average) {
        add_channels(average.layer, [&](std::size_t i, std::size_t c) {
            const bool is_whole = average.over == Over::Whole;
            return (is_whole ? facts_.value(i, average.quantity) : of_surface(i, average.quantity))[average.first + c];
        });
    }
    void add_cryptomatte() {
        const LayerKind& kind = kind_of(Layer::Cryptomatte);
        add_channels(Layer::Cryptomatte, [](std::size_t, std::size_t) { return 0.0F; });
        const auto channels = std::span(frame_.layers).last(kind.channels.size());
        for (std::size_t i = 0; i < frame_.rgba.size(); ++i) {
            const ObjectShares::Pixel ranked = facts_.objects().ranked(i);
            for (std::size_t rank = 0; 2 * rank < channels.size(); ++rank) {
                if (ranked[rank].object == 0 || ranked[rank].weight <= 0.0F) continue;
                channels[2 * rank].values[i] = cryptomatte_number(object_ids_[ranked[rank].object]);
                channels[2 * rank + 1].values[i] = ranked[rank].weight;
            }
        }
    }

    [[nodiscard]] float coverage(std::size_t i) const { return facts_.value(i, Quantity::Surface)[0]; }
    [[nodiscard]] bool shows_surface(std::size_t i) const { return coverage(i) > kLeastCoverage; }
    [[nodiscard]] Float4 of_surface(std::size_t i, Quantity q) const {
        return shows_surface(i) ? facts_.value(i, q) / coverage(i) : Float4{};
    }
    // Where a pixel's middle looks: all of it is as far from the camera's axis, up to some parts in a thousand.
    [[nodiscard]] float range_m(std::size_t i) const {
        const float depth_m = frame_.depth_m[i];
        if (depth_m >= Frame::kNoDepth) return Frame::kNoDepth;
        const PictureSize size = {frame_.width, frame_.height};
        const auto width = static_cast<std::size_t>(frame_.width);
        const std::size_t column = i % width, row = i / width;
        const double x = size.film_x(static_cast<double>(column) + 0.5);
        const double y = size.film_y(static_cast<double>(row) + 0.5);
        const double across = tan_half_fov_ * std::hypot(x, y);
        return static_cast<float>(static_cast<double>(depth_m) * std::hypot(1.0, across));
    }
    [[nodiscard]] float lon_deg(std::size_t i) const {
        return shows_surface(i) ? static_cast<float>(place_of(i).lon.degrees()) : 0.0F;
    }
    [[nodiscard]] float lat_deg(std::size_t i) const {
        return shows_surface(i) ? static_cast<float>(place_of(i).lat.degrees()) : 0.0F;
    }
    [[nodiscard]] Geodetic place_of(std::size_t i) const {
        const Float4 v = of_surface(i, Quantity::Geodetic);
        const Geodetic& origin = stage_.frame().origin();
        const double lon_deg = std::remainder(origin.lon.degrees() + static_cast<double>(v[0]), 360.0);
        return {Angle::degrees(lon_deg), Angle::degrees(origin.lat.degrees() + static_cast<double>(v[1])), v[2]};
    }
    [[nodiscard]] Vector<Scene> normal(std::size_t i) const { return vector_of(of_surface(i, Quantity::Normal)); }
    [[nodiscard]] float slope_deg(std::size_t i) const {
        if (!shows_surface(i)) return 0.0F;
        return static_cast<float>(angle_deg(normal(i), stage_.frame().local_axes(place_of(i)).z));
    }
    [[nodiscard]] float aspect_deg(std::size_t i) const {
        if (!shows_surface(i)) return 0.0F;
        const auto axes = stage_.frame().local_axes(place_of(i));
        const Vector<Scene> n = normal(i);
        const double clockwise = kDegrees * std::atan2(dot(n, axes.x), dot(n, axes.y));
        return static_cast<float>(clockwise < 0.0 ? clockwise + 360.0 : clockwise);
    }
    [[nodiscard]] float sun_incidence_deg(std::size_t i) const {
        return shows_surface(i) ? static_cast<float>(angle_deg(normal(i), to_sun_)) : 0.0F;
    }
    [[nodiscard]] float most_seen(std::size_t i) const {
        const ObjectShares::Share most = facts_.objects().ranked(i).front();
        return most.object == 0 ? 0.0F : cryptomatte_number(object_ids_[most.object]);
    }

    // The layers that are worked out of averages.
    struct Derived {
        Layer layer;
        float (LayerMaker::*value)(std::size_t) const;
    };
    static constexpr Derived kDerived[] = {
        {Layer::Range, &LayerMaker::range_m},     {Layer::Longitude, &LayerMaker::lon_deg},
        {Layer::Latitude, &LayerMaker::lat_deg},  {Layer::Slope, &LayerMaker::slope_deg},
        {Layer::Aspect, &LayerMaker::aspect_deg}, {Layer::SunIncidence, &LayerMaker::sun_incidence_deg},
        {Layer::Id, &LayerMaker::most_seen},
    };

    const FilmFacts& facts_;
    const Stage& stage_;
    Vector<Scene> to_sun_;
    const std::vector<std::uint32_t>& object_ids_;
    double tan_half_fov_;
    Frame& frame_;
};

}  // namespace

FrameDeveloper::FrameDeveloper(const ShotDocument& shot, const Stage& stage, const Daylight& day,
                               std::span<const std::string> objects)
    : layers_(shot.layers), stage_(&stage), to_sun_(day.to_sun()) {
    object_ids_.push_back(0);
    for (const std::string& name : objects) object_ids_.push_back(cryptomatte_id(name));
}

Frame FrameDeveloper::develop(FilmFrame film, double tan_half_fov) const {
    auto [frame, facts] = std::move(film).develop();
    LayerMaker maker(facts, *stage_, to_sun_, object_ids_, tan_half_fov, frame);
    for (const LayerKind& kind : kinds_of(layers_)) maker.add(kind.layer);
    return std::move(frame);
}

}  // namespace overfly
