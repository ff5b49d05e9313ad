#include "io/output_file.h"

#include <cerrno>
#include <system_error>

#include <sys/types.h>

#include <fmt/format.h>

#include "core/error.h"

namespace overfly {

OutputFile::OutputFile(const std::filesystem::path& file)
    : temporary_(file), stream_(std::fopen(temporary_.path().c_str(), "wbxe")) {
    if (!stream_) fail(errno);
}

void OutputFile::write(std::span<const std::byte> bytes) {
    refuse_if_failed();
    if (std::fwrite(bytes.data(), 1, bytes.size(), stream_.get()) != bytes.size()) fail(errno);
    position_ += bytes.size();
}

void OutputFile::seek(std::uint64_t offset) {
    refuse_if_failed();
    if (fseeko(stream_.get(), static_cast<off_t>(offset), SEEK_SET) != 0) fail(errno);
    position_ = offset;
}

void OutputFile::close() {
    refuse_if_failed();
    // A full disk often shows only here: fclose writes the last buffer, and network file systems report late.
    if (std::fclose(stream_.release()) != 0) fail(errno);
}

void OutputFile::commit() {
    refuse_if_failed();
    if (stream_) close();
    temporary_.commit();
}

void OutputFile::fail(int error_number) {
    error_number_ = error_number;
    throw UserError(Place{temporary_.target()},
                    fmt::format("can't be written: {}", std::generic_category().message(error_number)));
}

void OutputFile::refuse_if_failed() {
    if (error_number_ != 0) fail(error_number_);
}

}  // namespace overfly
