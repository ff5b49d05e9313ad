#pragma once

#include <filesystem>
#include <string>

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

namespace overfly {

// A text of a file's header; empty where there is none.
inline std::string text_attribute(const std::filesystem::path& file, const std::string& name) {
    const Imf::InputFile input(file.c_str());
    const auto* const found = input.header().findTypedAttribute<Imf::StringAttribute>(name);
    return found == nullptr ? "" : found->value();
}

}  // namespace overfly
