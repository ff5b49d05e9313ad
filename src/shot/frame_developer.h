#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "config/documents.h"
#include "film/film_frame.h"
#include "film/frame.h"
#include "shade/daylight.h"
#include "shot/stage.h"

namespace overfly {

// Makes finished frames of film: what lines have told becomes the layers that the shot asks for (film/layers.h).
class FrameDeveloper {
  public:
    // The stage must outlive it. objects: ShotObjects::names of the shot.
    FrameDeveloper(const ShotDocument& shot, const Stage& stage, const Daylight& day,
                   std::span<const std::string> objects);

    // tan_half_fov: of the camera in the middle of the exposure.
    [[nodiscard]] Frame develop(FilmFrame film, double tan_half_fov) const;

  private:
    LayerSet layers_;
    const Stage* stage_;
    Vector<Scene> to_sun_;
    std::vector<std::uint32_t> object_ids_;  // Cryptomatte's, by object number
};

}  // namespace overfly
