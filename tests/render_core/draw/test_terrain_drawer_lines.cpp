// The lines of drawn terrain lie where its shape puts them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "render_core/base/units.hpp"
#include "tests/support/terrain/chunk_drawing.hpp"

namespace tedavis::draw::test_terrain_drawer_lines {
namespace {

using test_support::ChunkDrawing;
using test_support::ChunkPicture;
using test_support::clear_design;
using test_support::lit_from_above;
using test_support::pixel_of;
using test_support::RasterScene;

/// Waves across the view. Where a slope falls away from the eye and turns from bending down to bending up, the line of the next
/// contour would begin if the eye sank (DeCarlo et al. 2003); on slopes towards the eye nothing does.
TEST(TerrainDrawer, SuggestiveContoursLieWhereSlopesAwayFromTheEyeTurnBack) {
    constexpr std::uint32_t kPeriod = 20;
    RasterScene scene(test_support::make_raster(257, 257, [](std::uint32_t, std::uint32_t j) {
        return 1000.0f + 112.0f * std::sin(static_cast<float>(2 * base::kPi * j / kPeriod));
    }));
    design::DesignSettings design = clear_design();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = {255, 255, 255};
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.terrain.style.sketch.suggestive_contours = 1;
    const TerrainDrawInput input = lit_from_above(scene.view(128, 230, 4000, 0, -32));
    ChunkDrawing drawing(scene, design);
    const ChunkPicture picture = drawing.draw(input, 0.5);
    const auto is_ink = [&](double x, double y) { return picture.at(x, y).red < 128; };
    std::set<std::uint32_t> on_lines;  // rows of pixels
    int lines = 0;
    for (std::uint32_t j = kPeriod; j < 230; j += kPeriod) {
        const auto at = pixel_of(input.view, scene.post(128, j));
        if (!at || at->y < 4 || at->y > RasterScene::kHeight - 5) continue;
        const glm::dvec3 normal =
            glm::normalize(glm::cross(scene.post(129, j) - scene.post(127, j), scene.post(128, j - 1) - scene.post(128, j + 1)));
        const double facing = glm::dot(normal, glm::normalize(input.view.eye - scene.post(128, j)));
        if (facing < 0.05 || facing > 0.3) continue;  // hidden, or lines have faded
        ++lines;
        for (int y = -2; y <= 2; ++y) on_lines.insert(static_cast<std::uint32_t>(at->y + y));
        int inked = 0;
        for (double x = 20; x < RasterScene::kWidth - 20; ++x) {
            bool here = false;
            for (int y = -2; y <= 2; ++y) here = here || is_ink(x, at->y + y);
            inked += here ? 1 : 0;
        }
        EXPECT_GT(inked, 0.95 * (RasterScene::kWidth - 40)) << "line of posts " << j;
    }
    EXPECT_GE(lines, 2);
    int elsewhere = 0;
    for (std::uint32_t y = 2; y + 2 < RasterScene::kHeight; ++y)
        for (std::uint32_t x = 20; x + 20 < RasterScene::kWidth; ++x) elsewhere += is_ink(x, y) && on_lines.count(y) == 0 ? 1 : 0;
    EXPECT_EQ(elsewhere, 0) << "blots";
}

/// On level ground seen from above: lines of the grid every so many metres along meridians and parallels, and nothing in between.
TEST(TerrainDrawer, TheSurfaceGridHasItsSpacing) {
    RasterScene scene(test_support::make_raster(257, 257, [](std::uint32_t, std::uint32_t) { return 1000.0f; }));
    constexpr double kPosts = 6.5;
    const glm::dvec3 middle = scene.post(128, 128);
    const double east_m = glm::distance(scene.post(129, 128), middle), north_m = glm::distance(scene.post(128, 129), middle);
    design::DesignSettings design = clear_design();
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.plain = {255, 255, 255};
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.terrain.style.grid = {kPosts * east_m, 0, {200, 0, 0}, 1.0};
    const TerrainDrawInput input = lit_from_above(scene.view(128, 128, 4000, 0, -90));
    ChunkDrawing drawing(scene, design);
    const ChunkPicture picture = drawing.draw(input, 0.5);
    const auto least_green = [&](double i, double j) {
        const auto i0 = static_cast<std::uint32_t>(i), j0 = static_cast<std::uint32_t>(j);
        const glm::dvec3 at = scene.post(i0, j0) + (i - i0) * (scene.post(i0 + 1, j0) - scene.post(i0, j0)) +
                              (j - j0) * (scene.post(i0, j0 + 1) - scene.post(i0, j0));
        const auto pixel = pixel_of(input.view, at);
        if (!pixel || pixel->x < 3 || pixel->y < 3 || pixel->x > RasterScene::kWidth - 4 || pixel->y > RasterScene::kHeight - 4)
            return -1;
        int least = 255;
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) least = std::min(least, int{picture.at(pixel->x + x, pixel->y + y).green});
        return least;
    };
    const double row_posts = kPosts * east_m / north_m;
    int lines = 0;
    for (int k = 1; k < 35; ++k) {
        const double column = k * kPosts, row = k * row_posts;
        const double between_rows = row_posts * (std::floor(128 / row_posts) + 0.5);
        const double between_columns = kPosts * (std::floor(128 / kPosts) + 0.5);
        if (const int green = least_green(column, between_rows); green >= 0) {
            EXPECT_LT(green, 120) << "meridian " << k;
            EXPECT_GT(least_green(column + 0.5 * kPosts, between_rows), 250) << "beside it";
            ++lines;
        }
        if (const int green = least_green(between_columns, row); green >= 0) {
            EXPECT_LT(green, 120) << "parallel " << k;
            EXPECT_GT(least_green(between_columns, row + 0.5 * row_posts), 250) << "beside it";
            ++lines;
        }
    }
    EXPECT_GE(lines, 8);
}

}  // namespace
}  // namespace tedavis::draw::test_terrain_drawer_lines
