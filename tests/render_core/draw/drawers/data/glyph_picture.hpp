/// Glyphs on a plain background, as a shipped device draws them.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "render_core/draw/drawers/data/glyph_drawer.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::test_support {

inline constexpr design::Color kGlyphBackground{60, 90, 120};

struct GlyphPicture {
    GlyphPicture(const std::string& device, std::uint32_t width, std::uint32_t height, const std::string& backend = "egl")
        : session(backend, device, width, height) {
        base::BudgetLine& line = *session.device.budget.find(effects::kSceneGlyphVertices);
        block.resize(draw::glyph_drawer_bytes(draw::GlyphDrawer::has_instances(session.gl), line.bytes));
        base::Arena arena(block.data(), block.size());
        const base::Error error = drawer.start(session.gl, line, arena);
        EXPECT_EQ(error.message.view(), "");
        session.gl.seal();
    }
    ~GlyphPicture() {
        session.gl.retire();
        drawer.destroy(session.gl);
    }
    GlyphPicture(const GlyphPicture&) = delete;
    GlyphPicture& operator=(const GlyphPicture&) = delete;

    /// RGBA8, bottom row first.
    std::vector<std::uint8_t> picture(const draw::GlyphBatch& batch, const draw::DataFrame& frame,
                                      const draw::DepthRange& range) {
        clear();
        drawer.upload(session.gl, batch);
        draws = drawer.draw(session.gl, frame, range);
        EXPECT_EQ(session.gl.denied().total, 0u);
        EXPECT_EQ(session.gl.take_error(), 0u);
        return session.pixels();
    }
    void clear() {
        gl::bind_surface(session.gl, *session.surface);
        session.gl->ClearColor(kGlyphBackground.red / 255.0f, kGlyphBackground.green / 255.0f, kGlyphBackground.blue / 255.0f, 1);
        session.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }

    GlSession session;
    std::vector<unsigned char> block;
    draw::GlyphDrawer drawer;
    std::uint32_t draws = 0;
};

/// Pixels that differ from the background.
inline int glyph_pixels(const std::vector<std::uint8_t>& rgba) {
    int count = 0;
    for (std::size_t n = 0; n < rgba.size(); n += 4)
        count += rgba[n] != kGlyphBackground.red || rgba[n + 1] != kGlyphBackground.green || rgba[n + 2] != kGlyphBackground.blue;
    return count;
}

}  // namespace tedavis::test_support
