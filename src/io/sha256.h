#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace overfly {

using Sha256Digest = std::array<std::byte, 32>;

// FIPS 180-4 SHA-256 of bytes that come in pieces.
class Sha256 {
  public:
    Sha256();
    void add(std::span<const std::byte> bytes);
    // Nothing may be added after it.
    [[nodiscard]] Sha256Digest digest();

  private:
    struct Free {
        void operator()(void* context) const;
    };
    std::unique_ptr<void, Free> context_;
};

[[nodiscard]] Sha256Digest sha256(std::span<const std::byte> bytes);

// 64 lower-case hexadecimal digits.
[[nodiscard]] std::string hex(const Sha256Digest& digest);

}  // namespace overfly
