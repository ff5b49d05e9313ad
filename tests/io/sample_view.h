#pragma once

#include <filesystem>
#include <fstream>

namespace overfly {

// A configuration of OpenColorIO with two displays and views that are easy to foretell. `rec709` is what it calls
// linear light with Rec. 709 primaries.
inline std::filesystem::path write_sample_view(const std::filesystem::path& file,
                                               const char* rec709 = "lin_rec709_scene") {
    std::ofstream(file) << "ocio_profile_version: 2\n"
                           "roles: {default: raw, scene_linear: "
                        << rec709
                        << "}\n"
                           "file_rules: [!<Rule> {name: Default, colorspace: default}]\n"
                           "displays:\n"
                           "  Monitor:\n"
                           "    - !<View> {name: Half, colorspace: half}\n"
                           "    - !<View> {name: Plain, colorspace: raw}\n"
                           "  Projector:\n"
                           "    - !<View> {name: Quarter, colorspace: quarter}\n"
                           "colorspaces:\n"
                           "  - !<ColorSpace> {name: raw, isdata: false}\n"
                           "  - !<ColorSpace> {name: "
                        << rec709
                        << "}\n"
                           "  - !<ColorSpace>\n"
                           "    name: half\n"
                           "    from_scene_reference: !<MatrixTransform>\n"
                           "      {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}\n"
                           "  - !<ColorSpace>\n"
                           "    name: quarter\n"
                           "    from_scene_reference: !<MatrixTransform>\n"
                           "      {matrix: [0.25, 0, 0, 0, 0, 0.25, 0, 0, 0, 0, 0.25, 0, 0, 0, 0, 1]}\n";
    return file;
}

}  // namespace overfly
