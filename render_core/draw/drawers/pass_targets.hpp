/// Creates the render targets of a pass and stores the first error.
#pragma once

#include "render_core/gl/render_target.hpp"

namespace tedavis::draw {

class PassTargets {
public:
    PassTargets(gl::Gl& gl, base::BudgetLine& line) : gl_(gl), line_(line) {}

    /// Creates a target with four bytes per texel and without depth. Does nothing after a failure.
    void make(gl::RenderTarget& to, std::uint32_t width_px, std::uint32_t height_px,
              gl::TextureFilter filter = gl::TextureFilter::nearest) {
        if (error_) return;
        auto made =
            gl::make_render_target(gl_, line_, {gl::TextureFormat::rgba8, filter, width_px, height_px}, gl::TargetDepth::none);
        if (made.ok())
            to = static_cast<gl::RenderTarget&&>(made.value());
        else
            error_ = made.error();
    }
    /// The first error; empty if all were created.
    [[nodiscard]] const base::Error& error() const { return error_; }

private:
    gl::Gl& gl_;
    base::BudgetLine& line_;
    base::Error error_;
};

}  // namespace tedavis::draw
