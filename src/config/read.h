#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "config/documents.h"

namespace overfly {

// Read and check a document whole. Each throws UserError with everything that is wrong with it at once: unreadable
// file, broken YAML, unknown key (with the nearest known one), duplicate, missing or misplaced key, wrong type, value
// not finite or out of range; `file:line:column: key: what came, what is allowed`.
//
// `overrides` are `key.subkey=value` in YAML, list items by index from 0 (`keyframes.2.time_s=4`), put in before the
// document is checked; a wrong one is reported as `--set key=value`.

[[nodiscard]] TerrainDocument read_terrain_document(const std::filesystem::path& file,
                                                    std::span<const std::string> overrides = {});
[[nodiscard]] FlightDocument read_flight_document(const std::filesystem::path& file,
                                                  std::span<const std::string> overrides = {});
// Reads the terrain and flight documents that the shot names as well; their problems are reported together with its
// own.
[[nodiscard]] ShotDocument read_shot_document(const std::filesystem::path& file,
                                              std::span<const std::string> overrides = {});
[[nodiscard]] BatchDocument read_batch_document(const std::filesystem::path& file);

// What a file is, by its keys, without checking it; throws UserError where it can't tell.
enum class DocumentKind { Terrain, Flight, Shot, Batch };
[[nodiscard]] DocumentKind document_kind(const std::filesystem::path& file);

// The text of a terrain document that says what `document` says, with paths relative to `folder`.
[[nodiscard]] std::string terrain_document_text(const TerrainDocument& document, const std::filesystem::path& folder);

}  // namespace overfly
