/// A picture on a surface of its own size, whose edges the GPU finds.
#pragma once

#include <cstring>
#include <stdexcept>
#include <vector>

#include "render_core/draw/drawers/edge_pass.hpp"
#include "render_core/effects/device.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::bench {

class GpuEdges {
public:
    /// RGBA, the first row is the highest.
    GpuEdges(const std::uint8_t* rgba, std::uint32_t width, std::uint32_t height)
        : session_("egl", "desktop", width, height), triangle_(session_.gl) {
        line_.bytes = std::uint64_t{4} * width * height;
        auto texture =
            gl::make_texture(session_.gl, line_, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, width, height});
        texture_ = static_cast<gl::Texture&&>(texture.value());
        std::vector<std::uint8_t> rows(line_.bytes);
        const std::size_t row = std::size_t{4} * width;
        for (std::uint32_t y = 0; y < height; ++y) std::memcpy(rows.data() + (height - 1 - y) * row, rgba + y * row, row);
        if (!pass_.start(session_.gl, session_.device.budget, width, height, false).message.empty() ||
            !texture_.upload(session_.gl, {0, 0, width, height}, rows.data()))
            throw std::runtime_error("edges cannot be found on this device");
        session_.gl.seal();
        gl::bind_surface(session_.gl, *session_.surface);
        triangle_.copy(session_.gl, texture_);
        session_.gl->Finish();
    }
    ~GpuEdges() {
        session_.gl.retire();
        pass_.destroy(session_.gl);
        texture_.destroy(session_.gl);
        triangle_.destroy(session_.gl);
    }
    GpuEdges(const GpuEdges&) = delete;
    GpuEdges& operator=(const GpuEdges&) = delete;

    /// Until the GPU has done it.
    void measure() {
        pass_.measure(session_.gl, *session_.surface);
        session_.gl->Finish();
    }
    [[nodiscard]] effects::ClutterMap densities() { return pass_.densities(session_.gl, *session_.surface); }

private:
    test_support::GlSession session_;
    test_support::ScreenTriangle triangle_;
    base::BudgetLine line_;
    gl::Texture texture_;
    draw::EdgePass pass_;
};

}  // namespace tedavis::bench
