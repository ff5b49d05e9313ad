#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "config/documents.h"
#include "core/progress.h"
#include "film/object_shares.h"
#include "shot/stage.h"

namespace overfly {

// What a shot tells apart for the layers `id` and `cryptomatte`: the terrain, its bodies, and the classes of its
// ground, each with a number from 1 on. Things of one name are one object.
class ShotObjects {
  public:
    ShotObjects() = default;  // nothing
    // Reads the shot's class raster at all samples of the full mesh, where those layers are asked for. Throws
    // UserError: the raster's (io/class_raster.h), or more objects than there are numbers.
    // REQUIRES: the stage still has its full mesh; it is asked for it here only.
    ShotObjects(const ShotDocument& shot, const Stage& stage, const Progress& progress = {});

    // That of number n is names()[n - 1].
    [[nodiscard]] std::span<const std::string> names() const { return names_; }
    // Of the terrain where its class isn't known, and then of the bodies.
    [[nodiscard]] std::span<const ObjectNumber> of_surfaces() const { return of_surfaces_; }
    // Of the classes, of each vertex of the full mesh; 0 where there is none. Empty where no classes are told apart.
    [[nodiscard]] std::span<const ObjectNumber> of_vertices() const { return of_vertices_; }

  private:
    [[nodiscard]] ObjectNumber number_of(const std::string& name);
    void add_classes(const ClassesDocument& classes, const Stage& stage, const Progress& progress);

    std::vector<std::string> names_;
    std::map<std::string, ObjectNumber> numbers_;
    std::vector<ObjectNumber> of_surfaces_, of_vertices_;
};

}  // namespace overfly
