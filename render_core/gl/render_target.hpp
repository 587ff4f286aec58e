/// An off-screen picture that a pass draws into and a later one reads: an RGBA8 texture and, if asked, 24-bit depth.
///
/// Memory    4 bytes a pixel of the line, 8 with depth. Thread  the GL thread. Lifetime  as Buffer.
#pragma once

#include <cstdint>

#include "render_core/base/ports/surface.hpp"
#include "render_core/gl/texture.hpp"

namespace tedavis::gl {

enum class TargetDepth : std::uint8_t { none, bits24 };

class RenderTarget {
public:
    RenderTarget() = default;
    RenderTarget(RenderTarget&& other) noexcept { *this = static_cast<RenderTarget&&>(other); }
    RenderTarget& operator=(RenderTarget&& other) noexcept;

    [[nodiscard]] bool valid() const { return framebuffer_ != 0; }
    [[nodiscard]] const Texture& color() const { return color_; }
    /// Draws go here, over the whole target.
    void bind(Gl& gl) const;
    void destroy(Gl& gl);

private:
    friend base::Result<RenderTarget, base::Error> make_render_target(Gl&, base::BudgetLine&, const TextureSettings&,
                                                                      TargetDepth);
    void attach(Gl& gl) const;
    [[nodiscard]] bool make_depth(Gl& gl, base::BudgetLine& line);
    Texture color_;
    GLuint depth_ = 0;
    GLuint framebuffer_ = 0;
    std::uint64_t depth_bytes_ = 0;
    base::BudgetLine* line_ = nullptr;
};

/// Start stage only. `color.format` must be rgba8. A device whose call list has no 24-bit depth format (sc2) is refused
/// when depth is asked for.
[[nodiscard]] base::Result<RenderTarget, base::Error> make_render_target(Gl& gl, base::BudgetLine& line,
                                                                         const TextureSettings& color, TargetDepth depth);

/// Draws go to the surface, over the whole of it.
void bind_surface(Gl& gl, const base::Surface& surface);

/// Where a pass leaves its picture: the surface or a target. Refers to it.
class DrawPlace {
public:
    DrawPlace(const base::Surface& surface) : surface_(&surface) {}  // NOLINT(google-explicit-constructor): it is one
    DrawPlace(const RenderTarget& target) : target_(&target) {}      // NOLINT(google-explicit-constructor)
    void bind(Gl& gl) const;

private:
    const base::Surface* surface_ = nullptr;
    const RenderTarget* target_ = nullptr;
};

}  // namespace tedavis::gl
