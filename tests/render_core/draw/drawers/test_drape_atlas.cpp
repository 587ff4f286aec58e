#include "render_core/draw/drawers/drape_atlas.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <random>
#include <vector>

#include "render_core/gl/render_target.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_drape_atlas {
namespace {

using terrain::DrapePage;
using terrain::kDrapePosts;
using test_support::GlSession;

constexpr std::uint32_t kSlots = 7;  // of a square of nine

std::unique_ptr<DrapePage> noise_page(unsigned seed) {
    auto page = std::make_unique<DrapePage>();
    std::mt19937 random(seed);
    for (auto& texel : page->rgba)
        for (std::uint8_t& channel : texel) channel = static_cast<std::uint8_t>(random());
    return page;
}

/// A picture of one page: its pixel (x, y) from the bottom left is the texel (x, y), sampled as terrain.frag does.
constexpr const char* kPageFragment =
    "uniform sampler2D image;\nuniform vec3 first;\nuniform vec2 shift;\n"
    "void main() {\n    vec2 texel = uv * 129.0 - 0.5;\n"
    "    vec2 at = floor(clamp(texel * shift.y + shift.x, 0.0, 128.0) * 256.0 + 0.5) / 256.0;\n"
    "    FRAGMENT_COLOR = TEXTURE2D(image, (at + first.xy) * first.z);\n}\n";
constexpr const char* kPageUniforms[] = {"image", "first", "shift"};

class DrapeAtlasTest : public testing::TestWithParam<const char*> {
protected:
    DrapeAtlasTest() : at_("egl", GetParam(), kDrapePosts, kDrapePosts) { line_.bytes = 4'000'000; }
    ~DrapeAtlasTest() override {
        at_.gl.retire();
        atlas_.destroy(at_.gl);
        triangle_.destroy(at_.gl);
    }
    /// `scale` 0 reads the one place `origin`.
    std::vector<std::uint8_t> picture(const DrapeOrigin& origin, float shift = 0, float scale = 1) {
        gl::bind_surface(at_.gl, *at_.surface);
        const gl::Program& program = triangle_.program();
        program.use(at_.gl);
        atlas_.bind(at_.gl, 5);
        at_.gl->Uniform1i(program.uniform(0), 5);
        at_.gl->Uniform3f(program.uniform(1), origin.x, origin.y, atlas_.scale());
        at_.gl->Uniform2f(program.uniform(2), shift, scale);
        triangle_.draw(at_.gl);
        return at_.pixels();
    }
    int worst(std::uint32_t slot, const DrapePage& page) {
        const std::vector<std::uint8_t> seen = picture(atlas_.origin(slot));
        const auto* texels = reinterpret_cast<const std::uint8_t*>(&page);
        int most = 0;
        for (std::size_t n = 0; n < seen.size(); ++n) most = std::max(most, std::abs(seen[n] - texels[n]));
        return most;
    }

    GlSession at_;
    base::BudgetLine line_;
    test_support::ScreenTriangle triangle_{at_.gl, kPageFragment, kPageUniforms};
    DrapeAtlas atlas_;
};

TEST_P(DrapeAtlasTest, EveryTexelOfEveryPageIsFoundAndNeighboursNeverBleedIn) {
    ASSERT_EQ(atlas_.start(at_.gl, line_, kSlots).message.view(), "");
    std::vector<std::unique_ptr<DrapePage>> pages;
    for (std::uint32_t slot = 0; slot < kSlots; ++slot) {
        pages.push_back(noise_page(slot + 1));
        ASSERT_TRUE(atlas_.upload(at_.gl, slot, *pages.back()));
    }
    for (std::uint32_t slot = 0; slot < kSlots; ++slot) {
        EXPECT_LE(worst(slot, *pages[slot]), 2) << "slot " << slot;
        EXPECT_GT(worst(slot, *pages[(slot + 1) % kSlots]), 100) << "control: another page";
    }
    const auto fresh = noise_page(99);
    ASSERT_TRUE(atlas_.upload(at_.gl, 4, *fresh));
    EXPECT_LE(worst(4, *fresh), 2) << "a slot is used again";
    EXPECT_LE(worst(3, *pages[3]), 2);
}

// A frame must not depend on the frames before it, and those decide in which slot a page lies.
TEST_P(DrapeAtlasTest, APageLooksTheSameToTheLastBitInEverySlot) {
    ASSERT_EQ(atlas_.start(at_.gl, line_, kSlots).message.view(), "");
    const auto page = noise_page(8);
    for (std::uint32_t slot = 0; slot < kSlots; ++slot) ASSERT_TRUE(atlas_.upload(at_.gl, slot, *page));
    for (const float shift : {0.0f, 0.171f, -0.43f, 3.5f}) {
        const std::vector<std::uint8_t> first = picture(atlas_.origin(0), shift);
        for (std::uint32_t slot = 1; slot < kSlots; ++slot)
            EXPECT_EQ(picture(atlas_.origin(slot), shift), first) << "slot " << slot << " shifted by " << shift;
    }
}

TEST_P(DrapeAtlasTest, NowhereIsTransparentWhateverThePagesHold) {
    ASSERT_EQ(atlas_.start(at_.gl, line_, kSlots).message.view(), "");
    DrapePage white;
    for (auto& texel : white.rgba)
        for (std::uint8_t& channel : texel) channel = 255;
    for (std::uint32_t slot = 0; slot < kSlots; ++slot) ASSERT_TRUE(atlas_.upload(at_.gl, slot, white));
    // Steep ground reads some texels beside the place: before it is clamped to it, beyond it to the atlas's edge.
    for (const float shift : {0.0f, -3.4f, 3.4f})
        for (const std::uint8_t byte : picture(atlas_.nowhere(), shift, 0)) ASSERT_EQ(byte, 0) << shift;
    for (const std::uint8_t byte : picture(atlas_.origin(6), 0, 0)) ASSERT_EQ(byte, 255) << "control";
}

TEST_P(DrapeAtlasTest, WhatItTakesIsWhatItSays) {
    ASSERT_EQ(atlas_.start(at_.gl, line_, kSlots).message.view(), "");
    EXPECT_EQ(line_.use.in_use, DrapeAtlas::bytes_needed(kSlots));
    EXPECT_EQ(DrapeAtlas::bytes_needed(kSlots), 512u * 512u * 4);
    EXPECT_EQ(DrapeAtlas::bytes_needed(49), 1024u * 1024u * 4) << "what device files with 49 pages state";
    EXPECT_EQ(DrapeAtlas::bytes_needed(225), 2048u * 2048u * 4);
}

TEST_P(DrapeAtlasTest, WithoutRoomItIsRefused) {
    line_.bytes = DrapeAtlas::bytes_needed(kSlots) - 1;
    EXPECT_NE(atlas_.start(at_.gl, line_, kSlots).message.view(), "");
    EXPECT_FALSE(atlas_.is_started());
}

INSTANTIATE_TEST_SUITE_P(Lanes, DrapeAtlasTest, testing::Values("es2-small", "es3-mid"),
                         [](const auto& lane) { return std::string(lane.param).substr(0, 3); });

}  // namespace
}  // namespace tedavis::draw::test_drape_atlas
