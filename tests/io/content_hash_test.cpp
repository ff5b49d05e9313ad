#include "io/content_hash.h"

#include <fstream>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/sha256.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

std::string hex_of(std::string_view text) { return hex(sha256(std::as_bytes(std::span(text)))); }

// FIPS 180-4's examples.
TEST(Sha256, AgreesWithTheStandard) {
    EXPECT_EQ(hex_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(hex_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, TakesBytesInPieces) {
    const std::string text = "abc";
    Sha256 hash;
    for (const char& c : text) hash.add(std::as_bytes(std::span(&c, 1)));
    EXPECT_EQ(hex(hash.digest()), hex_of("abc"));
}

class ContentHash : public testing::Test {
  protected:
    std::filesystem::path file(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }
    TemporaryFolder folder_;
};

TEST_F(ContentHash, IsOfContentsNotOfNames) {
    const std::vector a = {file("a", "hello"), file("b", "world")};
    const std::vector renamed = {file("c", "hello"), file("d", "world")};
    EXPECT_EQ(content_hash(a, "x"), content_hash(renamed, "x"));
    EXPECT_EQ(content_hash(a, "x").size(), 64U);
}

TEST_F(ContentHash, ChangesWithAnyPart) {
    const std::vector a = {file("a", "hello"), file("b", "world")};
    const std::string hash = content_hash(a, "x");
    EXPECT_NE(content_hash(a, "y"), hash);
    EXPECT_NE(content_hash(std::vector{a[1], a[0]}, "x"), hash);
    EXPECT_NE(content_hash(std::vector{a[0]}, "x"), hash);
    EXPECT_NE(content_hash(std::vector{file("c", "hellow"), file("d", "orld")}, "x"), hash) << "bytes that moved over";
}

TEST_F(ContentHash, NamesAFileThatCantBeRead) {
    try {
        (void)content_hash(std::vector{folder_ / "no"}, "");
        FAIL();
    } catch (const UserError& error) {
        EXPECT_EQ(std::string(error.what()), (folder_ / "no").string() + ": can't be read: No such file or directory");
    }
}

}  // namespace
}  // namespace overfly
