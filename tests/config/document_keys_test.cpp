// The references for people and the readers must name the same keys: a table row of a reference starts with
// "| `key` |".

#include "config/document_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "config/sample_documents.h"

namespace overfly {
namespace {

using namespace config_tests;
using Keys = std::vector<std::string>;

// The keys of the tables below the heading `## heading`, up to the next such heading.
Keys keys_of_reference(const std::filesystem::path& file, const std::string& heading) {
    std::istringstream lines(text_of(file));
    Keys keys;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("## ")) inside = line == "## " + heading;
        if (!inside || !line.starts_with("| `")) continue;
        keys.push_back(line.substr(3, line.find('`', 3) - 3));
    }
    std::ranges::sort(keys);
    return keys;
}

TEST(DocumentKeys, AreThoseOfTheTerrainReference) {
    EXPECT_EQ(document_keys(DocumentKind::Terrain),
              keys_of_reference(source_folder / "docs/terrain_document.md", "Keys"));
}

TEST(DocumentKeys, AreThoseOfTheFlightReference) {
    EXPECT_EQ(document_keys(DocumentKind::Flight), keys_of_reference(source_folder / "camera_paths/README.md", "Keys"));
}

TEST(DocumentKeys, AreThoseOfTheShotReference) {
    EXPECT_EQ(document_keys(DocumentKind::Shot),
              keys_of_reference(source_folder / "configs/README.md", "Keys of a shot"));
}

TEST(DocumentKeys, AreThoseOfTheBatchReference) {
    EXPECT_EQ(document_keys(DocumentKind::Batch),
              keys_of_reference(source_folder / "configs/README.md", "Keys of a batch"));
    EXPECT_EQ(document_keys(DocumentKind::Batch), (Keys{"description", "name", "shots"}));
}

TEST(DocumentKeys, IncludeWhatIsInsideListsAndSections) {
    const Keys keys = document_keys(DocumentKind::Flight);
    EXPECT_TRUE(std::ranges::binary_search(keys, "keyframes.N.look_at.lon_deg"));
    EXPECT_TRUE(std::ranges::binary_search(keys, "lens.focal_length_mm"));
}

}  // namespace
}  // namespace overfly
