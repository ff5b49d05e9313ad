#pragma once

#include <cstddef>

#include "flight/exposure.h"
#include "shot/light_deposits.h"
#include "shot/line_deposits.h"
#include "shot/line_pattern.h"
#include "shot/pixel_tile.h"
#include "shot/run_shares.h"

namespace overfly {

// The pixels of a tile, and what each of them gets of lines that drift over it during an exposure. Rows run along the
// drift: they are columns of the picture where that is along y.
class DriftPixels {
  public:
    struct Stretch {
        int begin, end;  // the latter excluded
    };

    // margin_px: how far around itself a pixel looks.
    DriftPixels(const PixelTile& tile, DriftAxis axis, double px_per_s, double margin_px, const RunWeighing& weighing);

    // The film: its first pixel in the picture, and how wide it is.
    void set_film(int left, int top, int width);
    void set_exposure(const Exposure& exposure, int lines_per_pixel);

    [[nodiscard]] const Exposure& exposure() const { return exposure_; }
    // Of the picture: the tile, with the rows around it of which it gets light, and likewise along them.
    [[nodiscard]] Stretch rows_around() const { return {rows_.begin - margin_rows_, rows_.end + margin_rows_}; }
    [[nodiscard]] double begin_px() const { return from_px_; }
    [[nodiscard]] double end_px() const { return to_px_; }
    // The tile's size in the picture.
    [[nodiscard]] int width() const { return is_x_ ? along_.end - along_.begin : rows_.end - rows_.begin; }
    [[nodiscard]] int height() const { return is_x_ ? rows_.end - rows_.begin : along_.end - along_.begin; }

    // When lines whose homes are between these are in the tile, or so near that it gets light of them.
    [[nodiscard]] TimeRange time_near(double first_home_px, double last_home_px) const;
    // What the pixels get of a line meanwhile, until the next call. REQUIRES: it is near.
    [[nodiscard]] PixelRun run_of(const DriftingLine& line, TimeRange stretch);
    // The same, for what isn't smooth: some looks, each for a part of it. to: run_of().
    void look_often(const DriftingLine& line, const SceneShader::Sighting& sighting, TimeRange stretch,
                    const PixelRun& to, LightDeposits& looks) const;

  private:
    [[nodiscard]] PixelRun passed_by(const DriftingLine& line, TimeRange stretch) const;
    [[nodiscard]] PixelRun weighed(const DriftingLine& line, TimeRange stretch);
    void look_by_pixels(const DriftingLine& line, const SceneShader::Sighting& sighting, TimeRange stretch,
                        LightDeposits& looks) const;
    [[nodiscard]] std::size_t pixel(int row, int along) const;

    bool is_x_;
    double px_per_s_;
    Stretch rows_, along_;
    double from_px_, to_px_;  // along_, and as far around as pixels look
    int margin_rows_;         // as far around rows_
    RunWeighing weighing_;
    Exposure exposure_;
    int lines_per_pixel_ = 1;
    double weight_per_s_ = 0.0;  // of each line
    int film_left_ = 0, film_top_ = 0, film_width_ = 0;
};

}  // namespace overfly
