// Good documents changed at random: every outcome is a document or a UserError whose problems are one line each.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "config/read.h"
#include "config/sample_documents.h"

namespace overfly {
namespace {

using namespace config_tests;

constexpr unsigned seed = 1991;
constexpr int mutations_per_document = 7'000;

// Bytes and words that mean something to YAML or to a reader.
const std::vector<std::string> snippets = {
    ":",    ": ",     "- ",         "[",  "]",    "{",    "}",    ",",    "\n",  "\t",    "  ",           "#",
    "'",    "\"",     "&a ",        "*a", "!!",   "!t ",  "| ",   "> ",   "? ",  "---\n", "...\n",        "%YAML",
    "~",    "null",   "0",          "-1", "1e99", ".nan", ".inf", "true", "1/0", "../..", "\xEF\xBB\xBF", "\xFF",
    "<<: ", "lens: ", "keyframes: "};

std::string mutated(std::string text, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
    for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
        const std::size_t at = below(text.size() + 1);
        const std::size_t length = below(12);
        switch (below(5)) {
            case 0:
                text.insert(at, snippets[below(snippets.size())]);
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(below(text.size() + 1), 4 * length));
                break;
            case 3:
                text.insert(at, 1, static_cast<char>(below(256)));
                break;
            default:
                text.resize(at == 0 ? text.size() : std::max(at, text.size() / 2));
        }
    }
    return text;
}

// A good document that can stand in any folder.
std::string with_absolute_dem(const std::string& name) {
    const std::string relative = "../../../terrain";
    std::string text = text_of(good_folder / name);
    const std::size_t at = text.find(relative);
    return at == std::string::npos ? text : text.replace(at, relative.size(), (source_folder / "terrain").string());
}

class MutatedDocument : public testing::TestWithParam<const char*> {};

TEST_P(MutatedDocument, IsReadOrRefused) {
    const std::string name = GetParam();
    const TemporaryFolder folder;
    const std::string good = with_absolute_dem(name);
    for (const char* other : {"terrain.yaml", "flight.yaml", "shot.yaml", "triangle.obj"})
        folder.write(other, with_absolute_dem(other));

    std::mt19937 random(seed);
    int read = 0, refused = 0;
    for (int i = 0; i < mutations_per_document; ++i) {
        const auto file = folder.write("mutated.yaml", mutated(good, random));
        try {
            if (name == "terrain.yaml") (void)read_terrain_document(file);
            if (name == "flight.yaml") (void)read_flight_document(file);
            if (name == "shot.yaml") (void)read_shot_document(file);
            ++read;
        } catch (const UserError& e) {
            ++refused;
            for (const Problem& problem : e.problems()) {
                ASSERT_EQ(problem.message.find('\n'), std::string::npos) << problem.message;
                ASSERT_FALSE(problem.place.file.empty()) << problem.message;
            }
        } catch (const std::exception& e) {
            FAIL() << "seed " << seed << ", mutation " << i << " of " << name << ": " << e.what() << '\n'
                   << text_of(file);
        }
    }
    // Both ways are well travelled, or the mutations would test little.
    EXPECT_GT(read, mutations_per_document / 100) << "seed " << seed;
    EXPECT_GT(refused, mutations_per_document / 4) << "seed " << seed;
}

INSTANTIATE_TEST_SUITE_P(Config, MutatedDocument, testing::Values("terrain.yaml", "flight.yaml", "shot.yaml"),
                         [](const auto& test) {
                             return std::string(test.param).substr(0, std::string(test.param).find('.'));
                         });

}  // namespace
}  // namespace overfly
