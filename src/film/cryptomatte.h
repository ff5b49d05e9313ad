#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace overfly {

// How Cryptomatte 1.2 calls an object in a picture. Nothing, such as the sky, is 0: no object's number is.

// The object's number: MurmurHash3_x86_32 of its name in UTF-8 with seed 0, and one bit flipped where the same bits as
// a float would be infinite, no number, or too small to keep.
[[nodiscard]] std::uint32_t cryptomatte_id(std::string_view name);

// As the layer's channels hold it. A finite and normal number.
[[nodiscard]] constexpr float cryptomatte_number(std::uint32_t id) { return std::bit_cast<float>(id); }

// As the manifest spells it: 8 hexadecimal digits.
[[nodiscard]] std::string cryptomatte_hex(std::uint32_t id);

// What the layer is called, in its channels (CryptoObject00.r) and in the header.
inline constexpr std::string_view kCryptomatteType = "CryptoObject";

// By which the header's attributes belong together: the first 7 digits of the hash of the layer's name.
[[nodiscard]] std::string cryptomatte_key();

}  // namespace overfly
