#include "io/scene_facts.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace overfly {
namespace {

static_assert(std::endian::native == std::endian::little, "scene files are written as numbers lie in memory");

template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class Writer {
  public:
    template <Number T>
    void operator()(const T& number) {
        const auto raw = std::as_bytes(std::span(&number, 1));
        bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    }
    void operator()(const std::string& text) {
        (*this)(std::uint64_t{text.size()});
        const auto raw = std::as_bytes(std::span(text));
        bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    }
    void operator()(const Angle& angle) { (*this)(angle.radians()); }
    void operator()(const std::optional<double>& number) {
        (*this)(std::uint8_t{number.has_value()});
        (*this)(number.value_or(0.0));
    }
    void operator()(const std::vector<std::filesystem::path>& files) {
        (*this)(std::uint64_t{files.size()});
        for (const std::filesystem::path& file : files) (*this)(file.string());
    }
    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    std::vector<std::byte> bytes_;
};

class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

    template <Number T>
    void operator()(T& number) {
        if (const auto raw = take(sizeof(T)); !raw.empty()) std::memcpy(&number, raw.data(), sizeof(T));
    }
    void operator()(std::string& text) {
        std::uint64_t size = 0;
        (*this)(size);
        const auto raw = take(size);
        text.assign(reinterpret_cast<const char*>(raw.data()), raw.size());
    }
    void operator()(Angle& angle) {
        double rad = 0.0;
        (*this)(rad);
        angle = Angle::radians(rad);
    }
    void operator()(std::optional<double>& number) {
        std::uint8_t has_value = 0;
        double value = 0.0;
        (*this)(has_value);
        (*this)(value);
        if (has_value != 0) number = value;
    }
    void operator()(std::vector<std::filesystem::path>& files) {
        std::uint64_t count = 0;
        (*this)(count);
        for (std::uint64_t i = 0; i < count && is_good_; ++i) {
            std::string name;
            (*this)(name);
            files.emplace_back(name);
        }
    }
    [[nodiscard]] bool is_complete() const { return is_good_ && rest_.empty(); }

  private:
    std::span<const std::byte> take(std::uint64_t size) {
        if (size > rest_.size()) is_good_ = false;
        if (!is_good_) return {};
        const auto taken = rest_.first(size);
        rest_ = rest_.subspan(size);
        return taken;
    }

    std::span<const std::byte> rest_;
    bool is_good_ = true;
};

// The one list of fields, for both ways.
template <class Visitor, class Scene>
void visit(Visitor& field, Scene& scene) {
    field(scene.content_hash);
    field(scene.origin.lon), field(scene.origin.lat), field(scene.origin.height_m);
    field(scene.largest_error_px);
    auto& r = scene.report;
    field(r.files), field(r.driver), field(r.crs_name), field(r.crs_authority);
    field(r.columns), field(r.rows), field(r.column_spacing), field(r.row_spacing), field(r.spacing_unit);
    field(r.vertical_unit.name), field(r.vertical_unit.metres), field(r.vertical_unit_provenance);
    field(r.vertical.datum), field(r.vertical.offset_m), field(r.vertical.name), field(r.vertical.provenance);
    field(r.no_data), field(r.valid_count), field(r.no_data_share), field(r.lowest_m), field(r.highest_m);
    field(r.extent.west_deg), field(r.extent.south_deg), field(r.extent.east_deg), field(r.extent.north_deg);
}

}  // namespace

std::vector<std::byte> scene_facts(const PreparedScene& scene) {
    Writer writer;
    visit(writer, scene);
    return writer.take();
}

bool read_scene_facts(std::span<const std::byte> bytes, PreparedScene& scene) {
    Reader reader(bytes);
    visit(reader, scene);
    return reader.is_complete();
}

}  // namespace overfly
