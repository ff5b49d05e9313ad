#pragma once

#include <string>

#include "film/preview_style.h"
#include "io/view_transform.h"

namespace overfly {

// How contact sheets and movies show frames.
struct PreviewLook {
    ViewTransform view = {};
    BurnIn burn_in = {};

    // A remark for the file that is made: it tells a preview of this look from those of others.
    [[nodiscard]] std::string remark() const;
};

// Whether a picture or movie that was written with this remark is there.
[[nodiscard]] bool carries_remark(const std::filesystem::path& file, const std::string& remark);

}  // namespace overfly
