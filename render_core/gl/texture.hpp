/// A two-dimensional texture with one level and fixed storage, charged to a budget line.
///
/// Memory    GPU bytes of the line. Thread  the GL thread. Lifetime  as Buffer: the line must outlive it.
/// Edges are clamped, which every lane allows at any size.
#pragma once

#include <cstdint>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/result.hpp"
#include "render_core/gl/gl.hpp"

namespace tedavis::gl {

/// `r8` is read in a shader as .r in every lane (ES 2.0 stores it as luminance; do not read the other components). `rgba16f`
/// (half floats, filtered) and `rgba32ui` (four words, not filtered) exist on ES 3 only. `rgb8` is for copies of a surface, with
/// or without alpha; it counts as four bytes per texel, as drivers store it.
enum class TextureFormat : std::uint8_t { r8, rgb8, rgba8, rgba16f, rgba32ui };
enum class TextureFilter : std::uint8_t { nearest, linear };

struct TextureSettings {
    TextureFormat format = TextureFormat::rgba8;
    TextureFilter filter = TextureFilter::nearest;
    std::uint32_t width_px = 0;
    std::uint32_t height_px = 0;
};

/// A rectangle of a texture, in texels from its first row.
struct TexelRect {
    std::uint32_t x = 0, y = 0, width = 0, height = 0;
};

[[nodiscard]] std::uint64_t texture_bytes(const TextureSettings& settings);

class Texture {
public:
    Texture() = default;
    Texture(Texture&& other) noexcept { *this = static_cast<Texture&&>(other); }
    Texture& operator=(Texture&& other) noexcept;

    [[nodiscard]] bool valid() const { return id_ != 0; }
    [[nodiscard]] GLuint id() const { return id_; }
    [[nodiscard]] const TextureSettings& settings() const { return settings_; }
    /// Binds to a texture unit, 0..max_texture_units-1.
    void bind(Gl& gl, std::uint32_t unit) const;
    /// Uploads tightly packed rows, the first one at y. Returns false, and does nothing, when the rectangle is not inside the
    /// texture. Leaves the texture bound to unit 0.
    [[nodiscard]] bool upload(Gl& gl, const TexelRect& part, const void* texels) const;
    /// Copies rows of the bound framebuffer, from its left edge, to rows of this texture from `to_row` on. Only where the
    /// device can copy.
    void copy_rows(Gl& gl, std::uint32_t to_row, std::uint32_t from_row, std::uint32_t rows) const;
    void destroy(Gl& gl);

private:
    friend base::Result<Texture, base::Error> make_texture(Gl&, base::BudgetLine&, const TextureSettings&);
    GLuint id_ = 0;
    TextureSettings settings_;
    base::BudgetLine* line_ = nullptr;
};

/// Creates a texture; start stage only. Its content is undefined until uploaded or drawn into.
[[nodiscard]] base::Result<Texture, base::Error> make_texture(Gl& gl, base::BudgetLine& line, const TextureSettings& settings);

}  // namespace tedavis::gl
