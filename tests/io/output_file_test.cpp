#include "io/output_file.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

std::span<const std::byte> bytes(const std::string& text) { return std::as_bytes(std::span(text)); }

std::string content(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(OutputFile, AppearsWhenCommitted) {
    const TemporaryFolder folder;
    OutputFile file(folder / "a.txt");
    file.write(bytes("hello"));
    EXPECT_EQ(file.position(), 5U);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
    file.commit();
    EXPECT_EQ(content(folder / "a.txt"), "hello");
    EXPECT_EQ(folder.file_count(), 1U);
}

TEST(OutputFile, ReplacesAnOlderFile) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.txt") << "an older and longer text";
    OutputFile file(folder / "a.txt");
    file.write(bytes("new"));
    file.commit();
    EXPECT_EQ(content(folder / "a.txt"), "new");
}

TEST(OutputFile, SeeksBack) {
    const TemporaryFolder folder;
    OutputFile file(folder / "a.txt");
    file.write(bytes("0123456789"));
    file.seek(3);
    file.write(bytes("xyz"));
    file.seek(10);
    file.write(bytes("!"));
    file.commit();
    EXPECT_EQ(content(folder / "a.txt"), "012xyz6789!");
}

// In a process of its own, which never leaves the lock.
TEST(OutputFileDeathTest, LeavesNothingWhenTheProcessEndsAtOnce) {
    const TemporaryFolder folder;
    EXPECT_EXIT(
        {
            OutputFile finished(folder / "a.txt");
            finished.commit();
            OutputFile file(folder / "b.txt");
            file.write(bytes("half a"));
            remove_unfinished_files();
            std::_Exit(3);
        },
        ::testing::ExitedWithCode(3), "");
    EXPECT_TRUE(std::filesystem::exists(folder / "a.txt"));
    EXPECT_EQ(folder.file_count(), 1U);
}

TEST(OutputFile, LeavesNothingWithoutCommit) {
    const TemporaryFolder folder;
    {
        OutputFile file(folder / "a.txt");
        file.write(bytes("half a"));
        EXPECT_EQ(folder.file_count(), 1U);
    }
    EXPECT_EQ(folder.file_count(), 0U);
}

TEST(OutputFile, KeepsTwoWritersOfOneFileApart) {
    const TemporaryFolder folder;
    OutputFile first(folder / "a.txt"), second(folder / "a.txt");
    first.write(bytes("first"));
    second.write(bytes("second"));
    first.commit();
    second.commit();
    EXPECT_EQ(content(folder / "a.txt"), "second");
}

TEST(OutputFile, SaysWhyItCannotBeWritten) {
    const TemporaryFolder folder;
    std::ofstream(folder / "file") << "not a folder";
    std::filesystem::create_directory(folder / "folder");
    const auto complaint = [](const std::filesystem::path& path) -> std::string {
        try {
            OutputFile(path).commit();
            return "none";
        } catch (const UserError& e) {
            return e.what();
        }
    };
    EXPECT_EQ(complaint(folder / "missing/a"),
              (folder / "missing/a").string() + ": can't be written: No such file or directory");
    EXPECT_EQ(complaint(folder / "file/a"), (folder / "file/a").string() + ": can't be written: Not a directory");
    EXPECT_EQ(complaint(folder / "folder"), (folder / "folder").string() + ": can't be written: Is a directory");
    EXPECT_EQ(folder.file_count(), 2U);
}

}  // namespace
}  // namespace overfly
