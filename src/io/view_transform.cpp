#include "io/view_transform.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

#include <OpenColorIO/OpenColorIO.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/colour.h"
#include "core/error.h"

namespace overfly {

namespace ocio = OCIO_NAMESPACE;

struct ViewTransform::Processor {
    ocio::ConstCPUProcessorRcPtr processor;
};

namespace {

constexpr const char* kBuiltIn = "ocio://default";
constexpr int kFirstWithBuiltIn = 0x02020000;

// What the configurations that are in use call linear light with Rec. 709 primaries: the interop name, those of the
// ACES configurations for OpenColorIO 2 and 1, Blender's.
constexpr std::array<const char*, 6> kUsualNames = {"lin_rec709_scene",        "lin_rec709",
                                                    "lin_rec709_srgb",         "Linear Rec.709 (sRGB)",
                                                    "Utility - Linear - sRGB", "Linear Rec.709"};

std::vector<std::string> displays_of(const ocio::Config& config) {
    std::vector<std::string> names;
    for (int i = 0; i < config.getNumDisplays(); ++i) names.emplace_back(config.getDisplay(i));
    return names;
}

std::vector<std::string> views_of(const ocio::Config& config, const std::string& display) {
    std::vector<std::string> names;
    for (int i = 0; i < config.getNumViews(display.c_str()); ++i)
        names.emplace_back(config.getView(display.c_str(), i));
    return names;
}

std::vector<std::string> colour_spaces_of(const ocio::Config& config) {
    std::vector<std::string> names;
    for (int i = 0; i < config.getNumColorSpaces(); ++i) names.emplace_back(config.getColorSpaceNameByIndex(i));
    return names;
}

// The user's choice where there is one, else the configuration's own. Throws std::invalid_argument for a name that
// the configuration does not have.
std::string chosen(const char* key, const std::string& choice, const char* otherwise,
                   const std::vector<std::string>& allowed) {
    if (choice.empty()) return otherwise;
    if (std::ranges::find(allowed, choice) != allowed.end()) return choice;
    throw std::invalid_argument(
        fmt::format("output.preview.{}: got '{}', allowed {}", key, choice, fmt::join(allowed, ", ")));
}

std::string our_colour_space(const ocio::Config& config, const std::string& choice) {
    if (!choice.empty()) {
        // By its name, an alias or a role.
        if (config.getColorSpace(choice.c_str())) return choice;
        return chosen("colour_space", choice, "", colour_spaces_of(config));
    }
    for (const char* name : kUsualNames) {
        if (config.getColorSpace(name)) return name;
    }
    throw std::invalid_argument(
        fmt::format("no colour space has a usual name for linear light with Rec. 709 primaries; say with "
                    "output.preview.colour_space which one it is: {}",
                    fmt::join(colour_spaces_of(config), ", ")));
}

bool is_empty(const ViewChoice& choice) { return choice == ViewChoice{}; }

}  // namespace

ViewTransform::ViewTransform(const ViewChoice& choice) {
    const char* const environment = std::getenv("OCIO");  // NOLINT(concurrency-mt-unsafe): nobody sets it
    const bool has_environment = environment != nullptr && *environment != '\0';
    const bool has_built_in = ocio::GetVersionHex() >= kFirstWithBuiltIn;
    std::string config = choice.config.string();
    if (config.empty()) config = has_environment ? environment : has_built_in ? kBuiltIn : "";
    if (config.empty()) {
        const std::string why = fmt::format("OpenColorIO {} has no built-in configuration", ocio::GetVersion());
        if (!is_empty(choice))
            throw UserError(Place{},
                            fmt::format("output.preview: {}; name one with output.preview.ocio_config or $OCIO", why));
        story_ = "sRGB; " + why;
        return;
    }
    try {
        load(config, choice);
    } catch (const std::exception& error) {
        if (!is_empty(choice)) throw UserError(Place{config}, error.what());
        *this = ViewTransform();
        story_ = fmt::format("sRGB; {}: {}", config, error.what());
    }
}

void ViewTransform::load(const std::string& config_name, const ViewChoice& choice) {
    const ocio::ConstConfigRcPtr config = ocio::Config::CreateFromFile(config_name.c_str());
    const std::string display = chosen("display", choice.display, config->getDefaultDisplay(), displays_of(*config));
    const std::string view =
        chosen("view", choice.view, config->getDefaultView(display.c_str()), views_of(*config, display));
    const ocio::DisplayViewTransformRcPtr transform = ocio::DisplayViewTransform::Create();
    transform->setSrc(our_colour_space(*config, choice.colour_space).c_str());
    transform->setDisplay(display.c_str());
    transform->setView(view.c_str());
    processor_ = std::make_shared<Processor>(Processor{config->getProcessor(transform)->getDefaultCPUProcessor()});
    name_ = fmt::format("{}, {}", display, view);
    story_ = fmt::format("{}, by OpenColorIO's {}", name_, config_name);
}

void ViewTransform::apply(std::span<std::array<float, 4>> pixels) const {
    if (processor_) {
        ocio::PackedImageDesc image(pixels.data(), static_cast<long>(pixels.size()), 1, 4);
        processor_->processor->apply(image);
        return;
    }
    for (auto& pixel : pixels) {
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = srgb_from_linear(soft_highlight(pixel[c]));
    }
}

float soft_highlight(float linear) {
    constexpr float kShoulder = 0.8F;
    constexpr float kRoom = 1.0F - kShoulder;
    if (linear <= kShoulder) return std::max(linear, 0.0F);
    // The exponential has slope 1 at the shoulder.
    return kShoulder + kRoom * (1.0F - std::exp((kShoulder - linear) / kRoom));
}

}  // namespace overfly
