#include "io/png_file.h"

#include <memory>
#include <span>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "core/error.h"
#include "io/output_file.h"

namespace overfly {

void write_png(const std::filesystem::path& file, const DisplayImage& image, const std::string& remark) {
    check(image.width > 0 && image.height > 0, "a picture has pixels");
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    if (!remark.empty()) spec.attribute("ImageDescription", remark);

    // Encoded in memory: what can go wrong with the file is then OutputFile's to find.
    OIIO::Filesystem::IOVecOutput encoded;
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("png", &encoded);
    check(output && output->open("png", spec) && output->write_image(OIIO::TypeDesc::UINT8, image.rgb.data()) &&
              output->close(),
          "a PNG can be encoded in memory");

    OutputFile target(file);
    target.write(std::as_bytes(std::span(encoded.buffer())));
    target.commit();
}

}  // namespace overfly
