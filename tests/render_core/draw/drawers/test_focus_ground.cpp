#include "render_core/draw/drawers/focus_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/draw/focus_grounds.hpp"

namespace tedavis::draw::test_focus_ground {
namespace {

using scene::FocusRegions;
using test_support::ask_for;
using test_support::make_path;
using test_support::RasterScene;
using test_support::region_over;
using test_support::white_design;

TEST(FocusGround, ChunksKnowWhichPartsMatter) {
    RasterScene scene(test_support::make_rough_raster(257, 257));
    FocusRegions regions;
    for (const double i : {60.0, 200.0}) ASSERT_TRUE(regions.try_push_back(region_over(scene, i, 128)));
    make_path(regions[1], 16);
    design::DesignSettings design = white_design();
    ask_for(design, regions);
    GroundFocus focus;
    focus.set(&regions, design.foci, true);
    const terrain::View view = scene.view(128, 190, 5200, 10, -42);
    int in_focus = 0, in_context = 0, partly = 0, few = 0;
    for (const terrain::ChunkKey& key : scene.built.chunks()) {
        const terrain::ChunkEntry entry = scene.built.entry(key);
        const FocusOfChunk chunk = focus.of_chunk(entry, view);
        (chunk.is_in_focus ? in_focus : chunk.count[0] + chunk.count[1] == 0 ? in_context : partly) += 1;
        few += chunk.count[1] > 0 && chunk.count[1] < 15 ? 1 : 0;
        for (const terrain::ChunkVertex& vertex : scene.built.vertices(entry)) {
            const glm::dvec3 place =
                glm::dvec3(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]) + glm::dvec3(vertex.x, vertex.y, vertex.z);
            double degree = chunk.least_degree;
            for (std::size_t n = 0; n < regions.size(); ++n) {
                const glm::dvec2 ground = in_focus_plane(regions[n], place);
                double nearest_m = 1e9;
                for (std::uint32_t part = chunk.first[n]; part < chunk.first[n] + chunk.count[n]; ++part)
                    nearest_m = std::fmin(nearest_m, focus_part_distance_m(regions[n], part, ground));
                degree = std::fmax(degree, nearest_m > 0 ? degree_at_distance(regions[n].context, nearest_m) : 1);
            }
            if (chunk.is_in_focus) degree = 1;
            ASSERT_EQ(degree, ground_focus_degree(regions, place));
        }
    }
    EXPECT_GT(in_context, 0);
    EXPECT_GT(partly, 0);
    EXPECT_GT(few, 0);
    regions[0].radius_m = 20'000;
    focus.set(&regions, design.foci, true);
    for (const terrain::ChunkKey& key : scene.built.chunks())
        in_focus += focus.of_chunk(scene.built.entry(key), view).is_in_focus;
    EXPECT_GT(in_focus, 0);
}

TEST(FocusGround, NumbersOfTheTableAreExactToAUnit) {
    std::mt19937 random(1);
    for (const double reach_m : {1000.0, 100'000.0, 2'000'000.0}) {
        FocusRegions regions;
        ASSERT_TRUE(regions.try_push_back(scene::focus_region_at(0.8, 0.2)));
        make_path(regions[0], 16);
        std::uniform_real_distribution<double> any(-reach_m, reach_m);
        for (glm::dvec2& point : regions[0].points) point = {any(random), any(random)};
        design::DesignSettings design = white_design();
        ask_for(design, regions);
        GroundFocus focus;
        focus.set(&regions, design.foci, true);
        EXPECT_LE(focus.unit_m(), std::fmax(1.0 / 64, reach_m / 4e6));
        for (std::uint32_t n = 0; n < 16; ++n) {
            EXPECT_NEAR(focus.number_at(5 + 2 * n), regions[0].points[n].x, 0.51 * focus.unit_m());
            EXPECT_NEAR(focus.number_at(6 + 2 * n), regions[0].points[n].y, 0.51 * focus.unit_m());
        }
        EXPECT_NEAR(focus.number_at(0), regions[0].radius_m, focus.unit_m());
    }
}

TEST(FocusGround, SharpGroundHasTheSharpDistancesCode) {
    EXPECT_NEAR(distance_code(sharp_distance_m()), kSharpCode / 255, 1e-12);
    EXPECT_NEAR(sharp_distance_m() / 50, 1.0273678, 1e-7);  // shaders/focus.frag
}

TEST(FocusGround, GridsHaveRoundSpacing) {
    for (const auto& [radius_m, spacing_m] : {std::pair{1000.0, 500.0}, {999.0, 200.0}, {399.0, 100.0}, {50'000.0, 20'000.0}})
        EXPECT_DOUBLE_EQ(focus_grid_spacing_m(radius_m), spacing_m) << radius_m;
}

}  // namespace
}  // namespace tedavis::draw::test_focus_ground
