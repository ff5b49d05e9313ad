#include "film/cryptomatte.h"

#include <cstddef>

namespace overfly {
namespace {

// A. Appleby's MurmurHash3_x86_32 (public domain), for a machine of either byte order.

std::uint32_t scrambled(std::uint32_t block) { return std::rotl(block * 0xcc9e2d51U, 15) * 0x1b873593U; }

// Up to four bytes, the first of which is the lowest.
std::uint32_t block_of(std::string_view bytes) {
    std::uint32_t block = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) block = block << 8U | static_cast<unsigned char>(bytes[i]);
    return block;
}

std::uint32_t murmur_hash(std::string_view text) {
    constexpr std::size_t kBlock = 4;
    const auto length = static_cast<std::uint32_t>(text.size());
    std::uint32_t hash = 0;
    for (; text.size() >= kBlock; text.remove_prefix(kBlock)) {
        hash = std::rotl(hash ^ scrambled(block_of(text.substr(0, kBlock))), 13) * 5 + 0xe6546b64U;
    }
    hash ^= scrambled(block_of(text));
    hash ^= length;
    hash = (hash ^ hash >> 16U) * 0x85ebca6bU;
    hash = (hash ^ hash >> 13U) * 0xc2b2ae35U;
    return hash ^ hash >> 16U;
}

}  // namespace

std::uint32_t cryptomatte_id(std::string_view name) {
    const std::uint32_t hash = murmur_hash(name);
    const std::uint32_t exponent = hash >> 23U & 0xffU;
    return exponent == 0 || exponent == 0xff ? hash ^ 1U << 23U : hash;
}

std::string cryptomatte_hex(std::uint32_t id) {
    std::string digits(8, '0');
    for (std::size_t i = digits.size(); i-- > 0; id >>= 4U) digits[i] = "0123456789abcdef"[id & 0xfU];
    return digits;
}

std::string cryptomatte_key() { return cryptomatte_hex(murmur_hash(kCryptomatteType)).substr(0, 7); }

}  // namespace overfly
