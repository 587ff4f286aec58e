/// An off-screen render target: an RGBA8 texture and, on request, 24-bit depth.
///
/// Memory    4 bytes per pixel of the line, 8 with depth. Thread  the GL thread. Lifetime  as Buffer.
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
    /// Binds the target for drawing, with a viewport over the whole of it.
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

/// Creates a target; start stage only. `color.format` must be rgba8. Fails where depth is requested and the device's call list
/// has no 24-bit depth format (sc2).
[[nodiscard]] base::Result<RenderTarget, base::Error> make_render_target(Gl& gl, base::BudgetLine& line,
                                                                         const TextureSettings& color, TargetDepth depth);

/// Binds the surface for drawing, with a viewport over the whole of it.
void bind_surface(Gl& gl, const base::Surface& surface);

/// The destination of a pass: a reference to the surface or to a target.
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
