// One file per bad input: each KIND_WHAT.yaml of tests/bad_input/documents stands beside KIND_WHAT.txt, the exact lines
// that the program prints for it, with paths relative to that folder.

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <set>
#include <vector>

#include "config/read.h"
#include "config/sample_documents.h"

namespace overfly {
namespace {

using namespace config_tests;

const std::filesystem::path bad_folder = source_folder / "tests/bad_input/documents";

std::vector<std::string> bad_names(const std::string& extension) {
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(bad_folder)) {
        if (file.path().extension() == extension) names.push_back(file.path().stem().string());
    }
    std::ranges::sort(names);
    return names;
}

void read_by_name(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    if (name.starts_with("terrain_")) return static_cast<void>(read_terrain_document(file));
    if (name.starts_with("flight_")) return static_cast<void>(read_flight_document(file));
    if (name.starts_with("shot_")) return static_cast<void>(read_shot_document(file));
    if (name.starts_with("batch_")) return static_cast<void>(read_batch_document(file));
    FAIL() << "what kind of document is " << name << '?';
}

std::string without(std::string text, const std::string& folder) {
    for (std::size_t at = 0; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
    return text;
}

class BadDocument : public testing::TestWithParam<std::string> {};

TEST_P(BadDocument, SaysAllThatIsWrongWithIt) {
    const std::string expected = text_of(bad_folder / (GetParam() + ".txt"));
    ASSERT_FALSE(expected.empty());
    std::string said = error_text([] { read_by_name(bad_folder / (GetParam() + ".yaml")); });
    said = without(said, bad_folder.string() + '/') + '\n';
    EXPECT_EQ(without(said, (source_folder / "tests").string() + '/'), expected);
}

INSTANTIATE_TEST_SUITE_P(Config, BadDocument, testing::ValuesIn(bad_names(".yaml")),
                         [](const auto& test) { return test.param; });

TEST(BadDocuments, HaveAMessageEachAndNoneIsLeftOver) { EXPECT_EQ(bad_names(".yaml"), bad_names(".txt")); }

TEST(BadDocuments, AreReadableFiles) {
    const TemporaryFolder folder;
    const std::string missing = (folder.path() / "nowhere.yaml").string();
    EXPECT_EQ(error_text([&] { (void)read_terrain_document(missing); }), missing + ": no such file");
    const std::string directory = folder.path().string();
    EXPECT_EQ(error_text([&] { (void)read_flight_document(directory); }),
              directory + ": got a folder, allowed a YAML file");
}

TEST(BadDocuments, MayBeRasters) {
    const std::filesystem::path raster = source_folder / "terrain/blanca_peak_utm13n_75m.tif";
    const std::string said = error_text([&] { (void)read_terrain_document(raster); });
    EXPECT_TRUE(said.starts_with(raster.string() + ":1:")) << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 0) << said;
}

}  // namespace
}  // namespace overfly
