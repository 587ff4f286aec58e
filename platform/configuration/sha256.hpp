/// SHA-256 (FIPS 180-4), of libsodium.
///
/// Memory  none beyond the object.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/ports/byte_source.hpp"

namespace tedavis::platform {

using Sha256Digest = std::array<std::uint8_t, 32>;

class Sha256 {
public:
    Sha256();
    void add(const void* bytes, std::size_t count);
    /// Of all bytes that were added; ends the work of this object.
    [[nodiscard]] Sha256Digest digest();

private:
    alignas(16) std::array<std::uint8_t, 128> state_{};
};

/// Reads the source from beginning to end. False where a part of it cannot be read.
[[nodiscard]] bool hash_source(base::ByteSource& source, Sha256Digest& digest);

/// 64 lower-case digits.
[[nodiscard]] base::FixedString<64> hex_of(const Sha256Digest& digest);

}  // namespace tedavis::platform
