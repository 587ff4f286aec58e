/// A picture on a surface of its own size, whose edges are found as a display finds those of its own picture.
#pragma once

#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

#include "render_core/draw/drawers/picture_edges.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::bench {

class SurfaceEdges {
public:
    /// RGBA, the first row is the highest.
    SurfaceEdges(const std::uint8_t* rgba, std::uint32_t width, std::uint32_t height)
        : session_("egl", "desktop", width, height), triangle_(session_.gl), memory_(draw::PictureEdges::bytes(width, height)) {
        line_.bytes = std::uint64_t{4} * width * height;
        auto texture =
            gl::make_texture(session_.gl, line_, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, width, height});
        texture_ = std::move(texture.value());
        std::vector<std::uint8_t> rows(line_.bytes);
        const std::size_t row = std::size_t{4} * width;
        for (std::uint32_t y = 0; y < height; ++y) std::memcpy(rows.data() + (height - 1 - y) * row, rgba + y * row, row);
        base::Arena arena(memory_.data(), memory_.size());
        if (!edges_.start(session_.gl, session_.device.budget, arena, width, height, false).message.empty() ||
            !texture_.upload(session_.gl, {0, 0, width, height}, rows.data()))
            throw std::runtime_error("edges cannot be found on this device");
        session_.gl.seal();
        gl::bind_surface(session_.gl, *session_.surface);
        triangle_.copy(session_.gl, texture_);
        session_.gl->Finish();
    }
    ~SurfaceEdges() {
        session_.gl.retire();
        edges_.destroy(session_.gl);
        texture_.destroy(session_.gl);
        triangle_.destroy(session_.gl);
    }
    SurfaceEdges(const SurfaceEdges&) = delete;
    SurfaceEdges& operator=(const SurfaceEdges&) = delete;

    /// Reads the picture back and finds its edges.
    effects::ClutterMap measure() { return edges_.measure(session_.gl, *session_.surface); }

private:
    test_support::GlSession session_;
    test_support::ScreenTriangle triangle_;
    std::vector<unsigned char> memory_;
    base::BudgetLine line_;
    gl::Texture texture_;
    draw::PictureEdges edges_;
};

}  // namespace tedavis::bench
