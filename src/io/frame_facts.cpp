#include "io/frame_facts.h"

#include <cmath>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfRationalAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTimeCodeAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <fmt/format.h>

#include "core/error.h"
#include "flight/attitude.h"
#include "geo/scene_frame.h"
#include "io/exr_complaint.h"
#include "io/frame_attributes.h"
#include "io/layer_attributes.h"

namespace overfly {
namespace {

// Attributes by name; nothing where there is none of that name and type.
class Attributes {
  public:
    explicit Attributes(const Imf::Header& header) : header_(&header) {}

    template <class Attribute>
    [[nodiscard]] auto value(const std::string& name) const {
        const auto* const attribute = header_->findTypedAttribute<Attribute>(name);
        return attribute == nullptr ? std::nullopt : std::optional(attribute->value());
    }
    [[nodiscard]] std::string text(const std::string& name) const {
        return value<Imf::StringAttribute>(name).value_or("");
    }
    // Those of single precision as well.
    [[nodiscard]] std::optional<double> number(const std::string& name) const {
        if (const auto single = value<Imf::FloatAttribute>(name)) return *single;
        return value<Imf::DoubleAttribute>(name);
    }
    [[nodiscard]] std::optional<FrameRate> rate(const std::string& name) const {
        const auto v = value<Imf::RationalAttribute>(name);
        if (!v || v->n <= 0 || v->d == 0) return std::nullopt;
        return FrameRate{v->n, static_cast<std::int32_t>(v->d)};
    }
    [[nodiscard]] std::optional<Geodetic> place(const std::string& name) const {
        const auto v = value<Imf::V3dAttribute>(name);
        if (!v) return std::nullopt;
        return Geodetic{Angle::degrees(v->x), Angle::degrees(v->y), v->z};
    }
    [[nodiscard]] NamedDocument document(const std::string& kind) const {
        return {text("overfly:" + kind), text("overfly:" + kind + "Sha256")};
    }

  private:
    const Imf::Header* header_;
};

template <class Matrix>
RowMatrix rows_of(const Matrix& m) {
    RowMatrix rows{};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
            rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = m[row][column];
    }
    return rows;
}

void take_time(const Attributes& attributes, FrameFacts& facts) {
    facts.number = attributes.value<Imf::IntAttribute>("imageCounter");
    facts.time_s = attributes.number("overfly:time");
    facts.rate = attributes.rate("framesPerSecond");
    facts.capture_rate = attributes.rate("captureRate");
    facts.exposure_s = attributes.number("expTime");
    facts.shutter_angle_deg = attributes.number("shutterAngle");
    if (const auto code = attributes.value<Imf::TimeCodeAttribute>("timeCode")) {
        facts.time_code = {code->hours(), code->minutes(), code->seconds(), code->frame(), code->fieldPhase()};
    }
    facts.date = attributes.text("overfly:date");
    if (facts.date.empty()) facts.date = attributes.text("capDate");
}

void take_camera(const Attributes& attributes, FrameFacts& facts) {
    if (const auto exact = attributes.value<Imf::M44dAttribute>("overfly:cameraMatrix")) {
        facts.world_to_camera = rows_of(*exact);
    } else if (const auto single = attributes.value<Imf::M44fAttribute>("worldToCamera")) {
        facts.world_to_camera = rows_of(*single);
    }
    facts.focal_length_mm = attributes.number("pinholeFocalLength");
    if (const auto sensor = attributes.value<Imf::V2fAttribute>("sensorOverallDimensions"))
        facts.sensor_width_mm = sensor->x;
    facts.camera_place = attributes.place("overfly:cameraPlace");
    facts.scene_origin = attributes.place("overfly:sceneOrigin");
    facts.altitude_m = attributes.number("altitude");
}

void take_origin(const Attributes& attributes, FrameFacts& facts) {
    std::istringstream files(attributes.text(kLayerFilesAttribute));
    facts.layer_files = layers_of(std::vector(std::istream_iterator<std::string>(files), {}));
    facts.objects = attributes.text(kObjectsAttribute);
    facts.software = attributes.text("Software");
    facts.inputs = attributes.text(kInputsAttribute);
    facts.shot = attributes.document("shot");
    facts.terrain = attributes.document("terrain");
    facts.flight = attributes.document("flight");
}

}  // namespace

FrameFacts read_frame_facts(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) throw UserError(Place{file}, "no such frame");
    try {
        const Imf::MultiPartInputFile input(file.c_str(), 0);
        const Imf::Header& header = input.header(0);
        FrameFacts facts;
        facts.width = header.dataWindow().max.x - header.dataWindow().min.x + 1;
        facts.height = header.dataWindow().max.y - header.dataWindow().min.y + 1;
        facts.screen_window_width = header.screenWindowWidth();
        const Attributes attributes(header);
        take_time(attributes, facts);
        take_camera(attributes, facts);
        take_origin(attributes, facts);
        return facts;
    } catch (const std::exception& e) {
        throw UserError(Place{file}, fmt::format("can't be read as a frame: {}", exr_complaint(e)));
    }
}

std::optional<Attitude> camera_attitude(const FrameFacts& facts) {
    if (!facts.world_to_camera || !facts.camera_place || !facts.scene_origin) return std::nullopt;
    const RowMatrix& m = *facts.world_to_camera;
    const auto axis = [&](std::size_t column) { return Vector<Scene>{m[0][column], m[1][column], m[2][column]}; };
    const Rotation<Scene, Scene> local = SceneFrame(*facts.scene_origin).local_axes(*facts.camera_place);
    Attitude attitude = attitude_towards(axis(2), local);
    const Rotation<Scene, Camera> level = orientation(attitude, local);
    attitude.roll = Angle::radians(std::atan2(dot(axis(0), level.y), dot(axis(0), level.x)));
    attitude.heading = nearest_turn(attitude.heading, Angle::degrees(180.0));
    return attitude;
}

}  // namespace overfly
