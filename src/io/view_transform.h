#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>

#include "film/preview_style.h"

namespace overfly {

// From linear light to what a screen shows: one of OpenColorIO's views, or sRGB. A value; copies share what it has
// loaded, and any number of threads may use it.
class ViewTransform {
  public:
    // sRGB: linear light as it is up to a soft shoulder, through the sRGB transfer.
    ViewTransform() = default;
    // What the user chose. A choice that can't be had is a UserError that says what is allowed. Of what the user did
    // not choose, sRGB stands in for a configuration that is not there or can't be used.
    explicit ViewTransform(const ViewChoice& choice);

    // "sRGB", or the display and the view.
    [[nodiscard]] const std::string& name() const { return name_; }
    // The name, and where it is from or why it is sRGB: for the log.
    [[nodiscard]] const std::string& story() const { return story_; }

    // Pixels of linear Rec. 709 light and alpha become pixels of what the display is sent, in place: 0 black, 1 white;
    // a view may go beyond.
    void apply(std::span<std::array<float, 4>> pixels) const;

  private:
    struct Processor;

    void load(const std::string& config, const ViewChoice& choice);

    std::string name_ = "sRGB", story_ = "sRGB";
    std::shared_ptr<const Processor> processor_;  // none: sRGB
};

// Linear light as it is up to 0.8; above that highlights approach 1 instead of being cut off.
// GUARANTEES: monotonous, below or at 1, with a continuous slope; what is negative becomes 0.
[[nodiscard]] float soft_highlight(float linear);

}  // namespace overfly
