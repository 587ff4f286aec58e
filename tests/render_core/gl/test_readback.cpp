#include "render_core/gl/readback.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/programs/gl_session.hpp"

namespace tedavis::gl::test_readback {
namespace {

TEST(ReadPixels, GivesTheSameBytesThroughBothCalls) {
    for (const char* device : {"es2-small", "sc2"}) {  // ReadPixels, ReadnPixels
        test_support::GlSession at("egl", device, 33, 17);
        at.gl->ClearColor(0.2f, 0.4f, 0.6f, 0.8f);
        at.gl->Clear(GL_COLOR_BUFFER_BIT);
        const auto pixels = at.pixels();
        for (std::size_t i = 0; i < pixels.size(); i += 4) {
            ASSERT_EQ(pixels[i], 51);
            ASSERT_EQ(pixels[i + 1], 102);
            ASSERT_EQ(pixels[i + 2], 153);
            ASSERT_EQ(pixels[i + 3], 204);
        }
        EXPECT_EQ(at.gl.denied().total, 0u);
    }
}

/// The two lower rows are red, those above blue.
TEST(ReadPixels, RowsAreCountedFromTheBottom) {
    for (const char* device : {"es2-small", "sc2"}) {
        test_support::GlSession at("egl", device, 20, 17);
        at.gl->ClearColor(0, 0, 1, 1);
        at.gl->Clear(GL_COLOR_BUFFER_BIT);
        at.gl->Enable(GL_SCISSOR_TEST);
        at.gl->Scissor(0, 0, 20, 2);
        at.gl->ClearColor(1, 0, 0, 1);
        at.gl->Clear(GL_COLOR_BUFFER_BIT);
        std::vector<std::uint8_t> pixels(4 * 20 * 3);
        ASSERT_TRUE(read_rows(at.gl, 1, 20, 3, pixels));
        for (std::size_t i = 0; i < pixels.size(); i += 4) {
            EXPECT_EQ(pixels[i], i < 80 ? 255 : 0) << device << " " << i;
            EXPECT_EQ(pixels[i + 2], i < 80 ? 0 : 255) << device << " " << i;
        }
        EXPECT_FALSE(read_rows(at.gl, 1, 20, 4, pixels));
        EXPECT_EQ(at.gl.denied().total, 0u);
    }
}

TEST(ReadPixels, RefusesMemoryOfAnotherSize) {
    test_support::GlSession at("egl", "es3-mid");
    std::vector<std::uint8_t> pixels(64 * 48 * 4);
    EXPECT_TRUE(read_pixels(at.gl, 64, 48, pixels));
    EXPECT_FALSE(read_pixels(at.gl, 64, 47, pixels));
    EXPECT_FALSE(read_pixels(at.gl, 0, 48, base::Span<std::uint8_t>()));
}

}  // namespace
}  // namespace tedavis::gl::test_readback
