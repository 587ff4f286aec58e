/// The shaders of render_core/draw/shaders/ as text, embedded at build time.
#pragma once

#include <cstddef>
#include <string_view>

#include "render_core/draw/shader_bytes.hpp"

namespace tedavis::draw {

inline constexpr std::size_t kMaxShaderText = 20479;

/// Embedded files end with a zero that is not part of the text.
template <std::size_t N>
[[nodiscard]] std::string_view shader_text(const unsigned char (&bytes)[N]) {
    static_assert(N - 1 <= kMaxShaderText);
    return {reinterpret_cast<const char*>(bytes), N - 1};
}

}  // namespace tedavis::draw
