#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>

#include "config/documents.h"
#include "config/overrides.h"
#include "config/section.h"

namespace overfly::config {

// The mapping that a file holds, or nothing and one problem: no such file, a folder, unreadable, broken, empty, or not
// a mapping.
[[nodiscard]] std::optional<Node> load_document(const std::filesystem::path& file, std::vector<Problem>& problems);

// Reads the top of any document: `read` and the two keys that all documents have and the program ignores.
void read_top(Section& document, const std::function<void(Section&)>& read);

// Loads a file, applies the overrides and reads it; its problems are added in the order of the document.
void read_document(const std::filesystem::path& file, std::span<const Override> overrides, Findings& findings,
                   const std::function<void(Section&)>& read);

// Throws UserError where there are problems; each once, though a document that two bodies follow is read twice.
void finish(Findings& findings);

// The readers of the four kinds, one file each: terrain_document.cpp and so on. Each asks for every key of its kind.
void read_terrain(Section& document, TerrainDocument& terrain);
void read_flight(Section& document, FlightDocument& flight);
void read_shot(Section& document, ShotDocument& shot);
void read_batch(Section& document, BatchDocument& batch);

}  // namespace overfly::config
