#include "render_core/draw/drawers/page_atlas.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <random>
#include <vector>

#include "render_core/gl/render_target.hpp"
#include "render_core/terrain/attribute_map.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_page_atlas {
namespace {

using design::BakedMap;
using terrain::AttributePage;
using terrain::kAttributePosts;
using terrain::kHorizonPosts;
using test_support::GlSession;

constexpr std::uint32_t kSlots = 7;  // of a square of nine

design::TerrainStyle style_of_all_maps() {
    design::TerrainStyle style;
    style.shade.technique = design::TerrainShade::aperture;
    style.shade.cast_shadows = true;
    style.shade.openness = 1;
    style.shade.ambient_occlusion = 1;
    return style;
}

std::unique_ptr<AttributePage> noise_page(unsigned seed) {
    auto page = std::make_unique<AttributePage>();
    std::mt19937 random(seed);
    auto* bytes = reinterpret_cast<std::uint8_t*>(page.get());
    for (std::size_t n = 0; n < sizeof *page; ++n) bytes[n] = static_cast<std::uint8_t>(random());
    return page;
}

/// A picture of one page: its pixel (x, y) from the bottom left is the post (x, y), sampled as terrain.frag does.
constexpr const char* kPageFragment =
    "uniform sampler2D image;\nuniform vec2 first;\nuniform float scale;\nuniform vec2 step;\n"
    "void main() {\n    vec2 post = uv * 65.0 - 0.5;\n"
    "    vec2 at = floor((post + step.y) * step.x * 256.0 + 0.5) / 256.0;\n"
    "    FRAGMENT_COLOR = TEXTURE2D(image, (at + first) * scale);\n}\n";
constexpr const char* kPageUniforms[] = {"image", "first", "scale", "step"};

class PageAtlasTest : public testing::TestWithParam<const char*> {
protected:
    PageAtlasTest() : at_("egl", GetParam(), kAttributePosts, kAttributePosts) { line_.bytes = 4'000'000; }
    ~PageAtlasTest() override {
        at_.gl.retire();
        atlas_.destroy(at_.gl);
        triangle_.destroy(at_.gl);
    }
    /// `shift` of its posts.
    std::vector<std::uint8_t> picture(BakedMap map, std::uint32_t slot, float shift = 0) {
        gl::bind_surface(at_.gl, *at_.surface);
        const gl::Program& program = triangle_.program();
        program.use(at_.gl);
        atlas_.bind(at_.gl);
        at_.gl->Uniform1i(program.uniform(0), static_cast<int>(map) + 1);
        const bool horizon = map == BakedMap::horizon;
        const PageOrigin origin = atlas_.origin(slot);
        at_.gl->Uniform2f(program.uniform(1), horizon ? origin.horizon_x : origin.map_x,
                          horizon ? origin.horizon_y : origin.map_y);
        at_.gl->Uniform1f(program.uniform(2), horizon ? atlas_.horizon_scale() : atlas_.map_scale());
        at_.gl->Uniform2f(program.uniform(3), horizon ? 0.5f : 1.0f, shift);
        triangle_.draw(at_.gl);
        return at_.pixels();
    }
    /// The largest difference of a page's picture to the bytes of a page.
    int worst(BakedMap map, std::uint32_t slot, const AttributePage& page) {
        const std::vector<std::uint8_t> seen = picture(map, slot);
        const void* const maps[] = {page.form, page.light, page.aperture};
        const auto* texels = static_cast<const std::uint8_t*>(maps[static_cast<std::size_t>(map)]);
        int most = 0;
        for (std::size_t n = 0; n < seen.size(); ++n) most = std::max(most, std::abs(seen[n] - texels[n]));
        return most;
    }

    GlSession at_;
    base::BudgetLine line_;
    std::vector<std::uint8_t> memory_ = std::vector<std::uint8_t>(1 << 16);
    base::Arena staging_{memory_.data(), memory_.size()};
    test_support::ScreenTriangle triangle_{at_.gl, kPageFragment, kPageUniforms};
    PageAtlas atlas_;
};

TEST_P(PageAtlasTest, EveryTexelOfEveryPageIsFoundAndNeighboursNeverBleedIn) {
    ASSERT_EQ(atlas_.start(at_.gl, line_, style_of_all_maps(), false, kSlots, staging_).message.view(), "");
    std::vector<std::unique_ptr<AttributePage>> pages;
    for (std::uint32_t slot = 0; slot < kSlots; ++slot) {
        pages.push_back(noise_page(slot + 1));
        ASSERT_TRUE(atlas_.upload(at_.gl, slot, *pages.back(), false));
    }
    for (std::uint32_t slot = 0; slot < kSlots; ++slot)
        for (const BakedMap map : {BakedMap::form, BakedMap::light, BakedMap::aperture}) {
            EXPECT_LE(worst(map, slot, *pages[slot]), 2) << "slot " << slot;
            EXPECT_GT(worst(map, slot, *pages[(slot + 1) % kSlots]), 100) << "control: another page";
        }
    const auto fresh = noise_page(99);
    ASSERT_TRUE(atlas_.upload(at_.gl, 4, *fresh, false));
    EXPECT_LE(worst(BakedMap::form, 4, *fresh), 2) << "a slot is used again";
    EXPECT_LE(worst(BakedMap::form, 3, *pages[3]), 2);
}

// A frame must not depend on the frames before it, and those decide in which slot a page lies.
TEST_P(PageAtlasTest, APageLooksTheSameToTheLastBitInEverySlot) {
    ASSERT_EQ(atlas_.start(at_.gl, line_, style_of_all_maps(), false, kSlots, staging_).message.view(), "");
    const auto page = noise_page(8);
    for (std::uint32_t slot = 0; slot < kSlots; ++slot) {
        ASSERT_TRUE(atlas_.upload(at_.gl, slot, *page, false));
        ASSERT_TRUE(atlas_.upload_horizon(at_.gl, slot, *page, 1, 60, 90));
    }
    for (const BakedMap map : {BakedMap::form, BakedMap::horizon})
        for (const float shift : {0.0f, 0.171f, -0.43f}) {
            std::vector<std::uint8_t> first = picture(map, 0, shift);
            for (std::uint32_t slot = 1; slot < kSlots; ++slot) {
                std::vector<std::uint8_t> seen = picture(map, slot, shift);
                std::size_t different = 0;
                // Beyond the outermost posts lies a neighbour.
                for (std::uint32_t y = 1; y + 1 < kAttributePosts; ++y)
                    for (std::uint32_t x = 4; x < 4 * (kAttributePosts - 1); ++x)
                        different += seen[y * kAttributePosts * 4 + x] != first[y * kAttributePosts * 4 + x] ? 1 : 0;
                EXPECT_EQ(different, 0u) << "slot " << slot << " shifted by " << shift;
            }
        }
}

TEST_P(PageAtlasTest, TheHorizonIsMixedOfTheTwoNearestDirections) {
    ASSERT_EQ(atlas_.start(at_.gl, line_, style_of_all_maps(), false, kSlots, staging_).message.view(), "");
    const auto page = noise_page(5);
    const double east_m = 60, north_m = 90;
    for (int direction = 0; direction < terrain::kHorizonDirections; ++direction)
        for (const double share : {0.0, 0.25, 0.5}) {
            const int next = (direction + 1) % terrain::kHorizonDirections;
            const double begin = terrain::horizon_azimuth_rad(direction, east_m, north_m),
                         end = next == 0 ? 2 * base::kPi : terrain::horizon_azimuth_rad(next, east_m, north_m);
            ASSERT_TRUE(atlas_.upload_horizon(at_.gl, 5, *page, begin + share * (end - begin) + 1e-9, east_m, north_m));
            const std::vector<std::uint8_t> seen = picture(BakedMap::horizon, 5);
            for (std::uint32_t j = 0; j < kHorizonPosts; ++j)
                for (std::uint32_t i = 0; i < kHorizonPosts; ++i) {
                    const std::size_t n = std::size_t{j} * kHorizonPosts + i;
                    const double expected = page->horizon[direction][n] * (1 - share) + page->horizon[next][n] * share;
                    ASSERT_NEAR(seen[(std::size_t{2 * j} * kAttributePosts + 2 * i) * 4], expected, 2.5)
                        << direction << " and " << share << " at " << i << ", " << j;
                }
        }
}

TEST_P(PageAtlasTest, OnlyTheMapsOfTheStyleArePaidFor) {
    design::TerrainStyle style;
    style.shade.baked_normals = true;
    ASSERT_EQ(atlas_.start(at_.gl, line_, style, false, kSlots, staging_).message.view(), "");
    EXPECT_TRUE(atlas_.is_started());
    EXPECT_TRUE(atlas_.has(BakedMap::form));
    for (const BakedMap map : {BakedMap::light, BakedMap::aperture, BakedMap::horizon, BakedMap::drape})
        EXPECT_FALSE(atlas_.has(map));
    EXPECT_EQ(line_.use.in_use, PageAtlas::bytes_needed(style, false, kSlots));
    EXPECT_EQ(line_.use.in_use, 256u * 256u * 4) << "nine places of 65 posts";
    EXPECT_GT(PageAtlas::bytes_needed(style_of_all_maps(), false, kSlots), 2 * PageAtlas::bytes_needed(style, false, kSlots));
    const auto page = noise_page(1);
    EXPECT_TRUE(atlas_.upload(at_.gl, 0, *page, true)) << "what is not there is passed over";
    EXPECT_TRUE(atlas_.upload_horizon(at_.gl, 0, *page, 1, 60, 90));
}

TEST_P(PageAtlasTest, ACoastBringsTheMapThatTellsSeaFromLandAndOnlyItsPages) {
    design::TerrainStyle style;
    style.shade.baked_normals = true;
    ASSERT_EQ(atlas_.start(at_.gl, line_, style, true, kSlots, staging_).message.view(), "");
    EXPECT_TRUE(atlas_.has(BakedMap::light));
    EXPECT_FALSE(atlas_.has(BakedMap::aperture));
    EXPECT_EQ(line_.use.in_use, PageAtlas::bytes_needed(style, true, kSlots));
    const auto page = noise_page(1);
    const auto uploaded = [&](bool coast) {
        at_.gl.begin_frame();
        EXPECT_TRUE(atlas_.upload(at_.gl, 0, *page, coast));
        return at_.gl.frame().uploaded_bytes;
    };
    EXPECT_EQ(uploaded(true), 2 * uploaded(false));
}

TEST_P(PageAtlasTest, WithoutRoomItIsRefused) {
    line_.bytes = PageAtlas::bytes_needed(style_of_all_maps(), false, kSlots) - 1;
    EXPECT_NE(atlas_.start(at_.gl, line_, style_of_all_maps(), false, kSlots, staging_).message.view(), "");
    EXPECT_FALSE(atlas_.is_started());
    base::Arena none(memory_.data(), 100);
    PageAtlas other;
    EXPECT_NE(std::string(other.start(at_.gl, line_, {}, false, kSlots, none).message.view()).find("'staging'"),
              std::string::npos);
    other.destroy(at_.gl);
}

INSTANTIATE_TEST_SUITE_P(Lanes, PageAtlasTest, testing::Values("es2-small", "es3-mid"),
                         [](const auto& lane) { return std::string(lane.param).substr(0, 3); });

}  // namespace
}  // namespace tedavis::draw::test_page_atlas
