#include "platform/configuration/sha256.hpp"

#include <sodium.h>

#include <algorithm>

namespace tedavis::platform {
namespace {

using SodiumState = crypto_hash_sha256_state;
static_assert(sizeof(SodiumState) <= 128 && alignof(SodiumState) <= 16);
constexpr std::size_t kBlockBytes = 1 << 16;

SodiumState& sodium_state(std::array<std::uint8_t, 128>& bytes) { return *reinterpret_cast<SodiumState*>(bytes.data()); }

}  // namespace

Sha256::Sha256() { crypto_hash_sha256_init(&sodium_state(state_)); }

void Sha256::add(const void* bytes, std::size_t count) {
    crypto_hash_sha256_update(&sodium_state(state_), static_cast<const unsigned char*>(bytes), count);
}

Sha256Digest Sha256::digest() {
    Sha256Digest digest{};
    crypto_hash_sha256_final(&sodium_state(state_), digest.data());
    return digest;
}

bool hash_source(base::ByteSource& source, Sha256Digest& digest) {
    Sha256 sha;
    std::array<std::uint8_t, kBlockBytes> block;
    const std::uint64_t size = source.size();
    for (std::uint64_t at = 0; at < size;) {
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), size - at));
        if (!source.read(at, block.data(), count)) return false;
        sha.add(block.data(), count);
        at += count;
    }
    digest = sha.digest();
    return true;
}

base::FixedString<64> hex_of(const Sha256Digest& digest) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    base::FixedString<64> text;
    for (const std::uint8_t byte : digest) {
        text.append(kDigits.substr(byte >> 4, 1));
        text.append(kDigits.substr(byte & 15, 1));
    }
    return text;
}

}  // namespace tedavis::platform
