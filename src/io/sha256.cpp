#include "io/sha256.h"

#include <string_view>

#include <openssl/evp.h>

#include "core/error.h"

namespace overfly {
namespace {

EVP_MD_CTX* evp(const auto& context) { return static_cast<EVP_MD_CTX*>(context.get()); }

}  // namespace

void Sha256::Free::operator()(void* context) const { EVP_MD_CTX_free(static_cast<EVP_MD_CTX*>(context)); }

Sha256::Sha256() : context_(EVP_MD_CTX_new()) {
    check(context_ && EVP_DigestInit_ex(evp(context_), EVP_sha256(), nullptr) == 1, "libcrypto has SHA-256");
}

void Sha256::add(std::span<const std::byte> bytes) {
    check(EVP_DigestUpdate(evp(context_), bytes.data(), bytes.size()) == 1, "SHA-256 takes bytes before its digest");
}

Sha256Digest Sha256::digest() {
    Sha256Digest digest{};
    check(EVP_DigestFinal_ex(evp(context_), reinterpret_cast<unsigned char*>(digest.data()), nullptr) == 1,
          "SHA-256 gives one digest");
    return digest;
}

Sha256Digest sha256(std::span<const std::byte> bytes) {
    Sha256 hash;
    hash.add(bytes);
    return hash.digest();
}

std::string hex(const Sha256Digest& digest) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (const std::byte b : digest) {
        text += kDigits[std::to_integer<unsigned>(b >> 4)];
        text += kDigits[std::to_integer<unsigned>(b & std::byte{15})];
    }
    return text;
}

}  // namespace overfly
