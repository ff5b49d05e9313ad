#include "shot/shot_objects.h"

#include <limits>
#include <map>

#include <fmt/format.h>

#include "core/error.h"
#include "io/class_raster.h"
#include "shade/parallel_blocks.h"

namespace overfly {

ShotObjects::ShotObjects(const ShotDocument& shot, const Stage& stage, const Progress& progress) {
    of_surfaces_.push_back(number_of("terrain"));
    for (const BodyDocument& body : shot.bodies) of_surfaces_.push_back(number_of(body.name));
    if (shot.classes && shot.layers.has_any({Layer::Id, Layer::Cryptomatte}))
        add_classes(*shot.classes, stage, progress);
}

ObjectNumber ShotObjects::number_of(const std::string& name) {
    const auto [entry, is_new] = numbers_.try_emplace(name, static_cast<ObjectNumber>(names_.size() + 1));
    if (is_new) names_.push_back(name);
    return entry->second;
}

void ShotObjects::add_classes(const ClassesDocument& classes, const Stage& stage, const Progress& progress) {
    const std::vector<Point<Scene>>& vertices = stage.full_mesh().positions;
    std::vector<Geodetic> places(vertices.size());
    parallel_blocks(vertices.size(), "finding classes of the ground", progress,
                    [&](std::size_t v) { places[v] = stage.frame().geodetic(vertices[v]); });
    const std::vector<int> values = classes_at(classes.raster, classes.band, places);
    std::map<int, ObjectNumber> numbers;
    for (const int value : values) numbers.try_emplace(value, 0);
    numbers.erase(kNoClass);
    if (numbers.size() + names_.size() > std::numeric_limits<ObjectNumber>::max())
        throw UserError(
            Place{classes.raster},
            fmt::format("{} different values in band {} within the terrain; at most {} classes can be told apart",
                        numbers.size(), classes.band, std::numeric_limits<ObjectNumber>::max() - names_.size()));
    for (auto& [value, number] : numbers) {
        const auto named = classes.names.find(value);
        number = number_of(named == classes.names.end() ? std::to_string(value) : named->second);
    }
    numbers[kNoClass] = 0;
    of_vertices_.reserve(values.size());
    for (const int value : values) of_vertices_.push_back(numbers.at(value));
}

}  // namespace overfly
