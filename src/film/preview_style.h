#pragma once

#include <filesystem>
#include <string>

namespace overfly {

// What is written over the pictures of a preview. Never over a frame.
struct BurnIn {
    bool frame = false;  // its number
    bool place = false;  // the camera's latitude, longitude and height above sea level
    bool time = false;   // of the flight, in seconds

    friend bool operator==(const BurnIn&, const BurnIn&) = default;
};

// Which of OpenColorIO's views previews show. What is empty is the configuration's own default; without a configuration
// here $OCIO counts, and without that the one that OpenColorIO has built in.
struct ViewChoice {
    std::filesystem::path config = {};
    std::string colour_space = {};  // the configuration's name for our linear light with Rec. 709 primaries
    std::string display = {}, view = {};

    friend bool operator==(const ViewChoice&, const ViewChoice&) = default;
};

// How previews show the frames of a shot.
struct PreviewStyle {
    BurnIn burn_in = {};
    ViewChoice view = {};
};

}  // namespace overfly
