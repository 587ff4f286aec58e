// Degrees, looks and rims on drawn ground, against the same in double: the pixel's ray meets the ground, and the place is judged
// by scene/focus_region.
#include "render_core/draw/drawers/focus_ground.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "tests/support/draw/focus_grounds.hpp"

namespace tedavis::draw::test_focus_ground_pictures {
namespace {

using design::FocusBorderKind;
using scene::FocusDistance;
using scene::FocusRegion;
using scene::FocusRegions;
using test_support::ask_for;
using test_support::ChunkDrawing;
using test_support::ChunkPicture;
using test_support::clear_design;
using test_support::kFocusGround_m;
using test_support::lit_from_above;
using test_support::make_path;
using test_support::RasterScene;
using test_support::region_over;
using test_support::white_design;

constexpr int kEdge_px = 2;  // of the picture

host_sim::Raster level_ground() {
    return test_support::make_raster(257, 257, [](std::uint32_t, std::uint32_t) { return float{kFocusGround_m}; });
}

/// Where the pixel's ray meets the level ground; height above the ellipsoid is found by secants.
glm::dvec3 ground_at(const RasterScene& scene, const terrain::View& view, double x, double y) {
    const glm::dvec3 ray = glm::normalize(view.forward + (x + 0.5 - 0.5 * view.width) / view.focal_px * view.right +
                                          (y + 0.5 - 0.5 * view.height) / view.focal_px * view.down);
    const auto over_m = [&](double along_m) {
        const earth::Geodetic at = earth::from_ecef(view.eye + along_m * ray);
        return at.height.m - scene.built.database.undulation(at.latitude_rad, at.longitude_rad).m - kFocusGround_m;
    };
    double near_m = 0, far_m = 0, over_near = over_m(0);
    for (far_m = 500; far_m < 1e5 && over_m(far_m) > 0; far_m += 500) near_m = far_m;
    over_near = over_m(near_m);
    for (int n = 0; n < 40; ++n) {
        const double middle = 0.5 * (near_m + far_m);
        (over_m(middle) > 0) == (over_near > 0) ? near_m = middle : far_m = middle;
    }
    return view.eye + near_m * ray;
}

struct Shape {
    const char* name;
    std::function<void(FocusRegion&)> make;
};
void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

const Shape kShapes[] = {
    {"circle", [](FocusRegion&) {}},
    {"circle_by_chebyshev", [](FocusRegion& r) { r.context.distance = FocusDistance::chebyshev; }},
    {"square", [](FocusRegion& r) { r.is_square = true; }},
    {"square_by_chebyshev",
     [](FocusRegion& r) {
         r.is_square = true;
         r.context.distance = FocusDistance::chebyshev;
     }},
    {"path", [](FocusRegion& r) { make_path(r, 16); }},
    {"path_by_chebyshev",
     [](FocusRegion& r) {
         make_path(r, 3);
         r.context.distance = FocusDistance::chebyshev;
     }},
    {"places",
     [](FocusRegion& r) {
         r.point_count = 5;
         r.radius_m = 400;
         for (std::uint32_t n = 1; n < 5; ++n) r.points[n] = {900.0 * n - 2000, n % 2 == 0 ? 1800.0 : -1500.0};
     }},
    {"evenly", [](FocusRegion& r) { r.context.levels = 0; }},
    {"in_four_steps", [](FocusRegion& r) { r.context.levels = 4; }},
    {"without_intermediate_context", [](FocusRegion& r) { r.context.width_m = 0; }},
    {"far_anchor",
     [](FocusRegion& r) {
         // The same place, seen from a plane that touches the ground 90 km away.
         const glm::dvec3 place = r.anchor;
         const earth::Geodetic at = earth::from_ecef(place);
         FocusRegion far = scene::focus_region_at(at.latitude_rad + 0.01, at.longitude_rad + 0.015);
         far.point_count = 1;
         far.radius_m = r.radius_m;
         far.context = r.context;
         far.points[0] = in_focus_plane(far, place);
         r = far;
     }},
};

struct Compared {
    int judged = 0, wrong = 0;
    bool has_inside = false, has_between = false, has_outside = false;
};

/// Pixels round which the degree changes are edges of steps, and left out.
Compared compare(const RasterScene& scene, const TerrainDrawInput& input, const ChunkPicture& picture,
                 const FocusRegions& regions) {
    Compared compared;
    const auto degree = [&](double x, double y) { return ground_focus_degree(regions, ground_at(scene, input.view, x, y)); };
    for (std::uint32_t y = kEdge_px; y + kEdge_px < RasterScene::kHeight; y += 9)
        for (std::uint32_t x = kEdge_px; x + kEdge_px < RasterScene::kWidth; x += 9) {
            if (picture.at(x, y) == test_support::kDrawingBackground) continue;
            const double here = degree(x, y);
            bool is_edge = false;
            for (const double across : {-1.5, 0.0, 1.5})
                for (const double down : {-1.5, 0.0, 1.5})
                    is_edge = is_edge || std::fabs(degree(x + across, y + down) - here) > 0.05;
            if (is_edge) continue;
            ++compared.judged;
            const double expected = 255 * (0.25 + 0.75 * here);
            compared.wrong += std::fabs(picture.at(x, y).green - expected) > 2.5 ? 1 : 0;
            compared.has_inside = compared.has_inside || here == 1;
            compared.has_between = compared.has_between || (here > 0 && here < 1);
            compared.has_outside = compared.has_outside || here == 0;
        }
    return compared;
}

class FocusGroundShapes : public testing::TestWithParam<std::tuple<const char*, Shape>> {};

TEST_P(FocusGroundShapes, DegreesAreThoseOfThePlace) {
    const auto& [device, shape] = GetParam();
    RasterScene scene(level_ground());
    FocusRegions regions;
    ASSERT_TRUE(regions.try_push_back(region_over(scene, 128, 128)));
    shape.make(regions[0]);
    design::DesignSettings design = white_design();
    ask_for(design, regions);
    TerrainDrawInput input = lit_from_above(scene.view(128, 190, 5200, 10, -42));
    input.foci = &regions;
    ChunkDrawing drawing(scene, design, "egl", device);
    const ChunkPicture picture = drawing.draw(input, 0.5);
    const Compared compared = compare(scene, input, picture, regions);
    EXPECT_GT(compared.judged, 250);
    EXPECT_EQ(compared.wrong, 0) << "of " << compared.judged;
    EXPECT_TRUE(compared.has_inside && compared.has_outside);
    EXPECT_EQ(compared.has_between, regions[0].context.width_m > 0);
    FocusRegions others = regions;  // control
    others[0].radius_m *= 1.2;
    EXPECT_GT(compare(scene, input, picture, others).wrong, 2);
}

INSTANTIATE_TEST_SUITE_P(Lanes, FocusGroundShapes,
                         testing::Combine(testing::Values("es2-small", "es3-mid"), testing::ValuesIn(kShapes)),
                         [](const auto& with) {
                             return std::string(std::get<0>(with.param)).substr(0, 3) + "_" + std::get<1>(with.param).name;
                         });

class FocusGround : public testing::TestWithParam<const char*> {
protected:
    RasterScene scene_{level_ground()};
    FocusRegions regions_;
    TerrainDrawInput input_ = lit_from_above(scene_.view(128, 190, 5200, 10, -42));

    void add(double i, double j, double radius_m) {
        FocusRegion region = region_over(scene_, i, j);
        region.radius_m = radius_m;
        ASSERT_TRUE(regions_.try_push_back(region));
        input_.foci = &regions_;
    }
};

TEST_P(FocusGround, OfSeveralFociTheGreatestDegreeCounts) {
    add(100, 120, 900);
    add(150, 130, 600);
    add(128, 100, 1200);
    add(120, 160, 300);
    regions_[1].is_square = true;
    regions_[2].is_valid = false;
    make_path(regions_[3], 4);
    design::DesignSettings design = white_design();
    ask_for(design, regions_);
    ChunkDrawing drawing(scene_, design, "egl", GetParam());
    const ChunkPicture picture = drawing.draw(input_, 0.5);
    EXPECT_EQ(compare(scene_, input_, picture, regions_).wrong, 0);
    regions_[2].is_valid = true;
    EXPECT_GT(compare(scene_, input_, picture, regions_).wrong, 2);  // control
}

/// Chunks in focus are drawn by the program without foci, and where none is anywhere all are.
TEST_P(FocusGround, WhatIsInFocusIsAsWithoutIt) {
    RasterScene scene(test_support::make_rough_raster(257, 257));
    design::DesignSettings design = clear_design();
    design.terrain.style.shade.technique = design::TerrainShade::lambert;
    design.terrain.style.sketch.contours = 1;
    TerrainDrawInput input = lit_from_above(scene.view(128, 190, 5200, 10, -42));
    const ChunkPicture without = ChunkDrawing(scene, design, "egl", GetParam()).draw(input, 1);
    add(128, 128, 1500);
    ask_for(design, regions_);
    design.foci[0].terrain.sketch_outside = true;
    design.foci[0].terrain.saturation = 0;
    input.foci = &regions_;
    ChunkDrawing drawing(scene, design, "egl", GetParam());
    const ChunkPicture with = drawing.draw(input, 1);
    EXPECT_NE(with.rgba, without.rgba);
    std::size_t same = 0, inside = 0;
    for (std::uint32_t y = 0; y < RasterScene::kHeight; ++y)
        for (std::uint32_t x = 0; x < RasterScene::kWidth; ++x) {
            // However high the ground is, so near the middle of the focus it is in it.
            FocusRegion small = regions_[0];
            small.radius_m = 900;
            FocusRegions near;
            ASSERT_TRUE(near.try_push_back(small));
            if (without.at(x, y) == test_support::kDrawingBackground ||
                ground_focus_degree(near, ground_at(scene_, input.view, x, y)) < 1)
                continue;
            ++inside;
            same += with.at(x, y) == without.at(x, y) ? 1 : 0;
        }
    EXPECT_GT(inside, 500u);
    EXPECT_EQ(same, inside);
    regions_[0].radius_m = 50'000;
    EXPECT_EQ(drawing.draw(input, 1).rgba, without.rgba) << "all is in focus";
    regions_[0].is_valid = false;
    EXPECT_EQ(drawing.draw(input, 1).rgba, without.rgba) << "it is nowhere";
    input.foci = nullptr;
    EXPECT_EQ(drawing.draw(input, 1).rgba, without.rgba) << "nobody said where it is";
}

/// Warning colours, and the sign of ground without data, in the context.
TEST_P(FocusGround, WhatSpeaksByItsColorKeepsIt) {
    host_sim::Raster cliff =
        test_support::make_raster(257, 257, [](std::uint32_t i, std::uint32_t) { return 1000 + (i > 128 ? 1900.0f : 0.0f); });
    host_sim::Raster unknown = level_ground();
    for (std::uint32_t j = 110; j < 146; ++j)
        for (std::uint32_t i = 70; i < 100; ++i) unknown.post_class[unknown.at(i, j)] = terrain::PostClass::void_;
    design::DesignSettings plain = clear_design();
    plain.terrain.style.shade.technique = design::TerrainShade::lambert;
    add(10, 10, 20);
    design::DesignSettings design = plain;
    ask_for(design, regions_);
    design.foci[0].terrain.sketch_outside = true;
    design.foci[0].terrain.saturation = 0.3;
    for (const host_sim::Raster* raster : {&cliff, &unknown}) {
        RasterScene scene(*raster);
        TerrainDrawInput input = lit_from_above(scene.view(128, 128, 9000, 0, -90));
        input.warning_colors = true;
        input.aircraft_msl_m = 3000;
        const ChunkPicture without = ChunkDrawing(scene, plain, "egl", GetParam()).draw(input, 0.5);
        input.foci = &regions_;
        const ChunkPicture with = ChunkDrawing(scene, design, "egl", GetParam()).draw(input, 0.5);
        const auto changed = [&](double i, double j, double msl_m) {
            const auto at = test_support::pixel_of(input.view, earth::to_ecef(scene.place(i, j, msl_m)));
            EXPECT_TRUE(at.has_value());
            return !(with.at(at->x, at->y) == without.at(at->x, at->y));
        };
        for (double j = 102; j < 155; j += 5) {
            EXPECT_TRUE(changed(112, j, 1000) || raster == &unknown) << "plain ground";
            EXPECT_FALSE(changed(150, j, 2900) && raster == &cliff) << "a warning";
            EXPECT_FALSE(changed(85, std::min(std::max(j, 115.0), 140.0), 1000) && raster == &unknown) << "without data";
        }
    }
}

/// Of a row of pixels through the rim: what a border takes of each.
std::vector<double> cover_across(const ChunkPicture& picture, std::uint32_t y) {
    std::vector<double> cover;
    for (std::uint32_t x = 0; x < RasterScene::kWidth; ++x) cover.push_back(1 - picture.at(x, y).green / 255.0);
    return cover;
}

TEST_P(FocusGround, RimsAreSoManyPixelsWideWhereTheFocusEnds) {
    input_ = lit_from_above(scene_.view(128, 128, 6000, 0, -90));
    add(128, 128, 1500);
    design::DesignSettings design = white_design();
    ask_for(design, regions_);
    design.foci[0].terrain = {};
    design.foci[0].border = {FocusBorderKind::line, {255, 0, 0}, 3};
    ChunkDrawing drawing(scene_, design, "egl", GetParam());
    const ChunkPicture picture = drawing.draw(input_, 0.5);
    for (const std::uint32_t y : {100u, 119u, 130u}) {
        const std::vector<double> cover = cover_across(picture, y);
        // The line crosses the row aslant, so it is wider along it.
        double rim_x = 0;
        for (double x = 160; x < 319; x += 0.01)
            if (focus_distance_m(regions_[0], in_focus_plane(regions_[0], ground_at(scene_, input_.view, x, y))) > 0) {
                rim_x = x;
                break;
            }
        const double aslant = std::fabs(y + 0.5 - 120) / (rim_x + 0.5 - 160);
        double sum = 0, middle = 0;
        for (std::size_t x = 165; x < cover.size(); ++x) {
            sum += cover[x];
            middle += cover[x] * static_cast<double>(x);
        }
        // Beside the middle of the view pixels see the ground under a smaller angle than lines reckon with.
        const double off_px = std::hypot(rim_x + 0.5 - 160, y + 0.5 - 120), focal_px = input_.view.focal_px;
        const double wider = 1 + off_px * off_px / (focal_px * focal_px);
        EXPECT_NEAR(sum, 3 * wider * std::sqrt(1 + aslant * aslant), 0.1) << y;
        EXPECT_NEAR(middle / sum, rim_x, 0.25) << y;
    }
    EXPECT_EQ(picture.at(160, 120).green, 255) << "in focus";
    EXPECT_EQ(picture.at(310, 120).green, 255) << "beyond";
}

TEST_P(FocusGround, HalosFadeOutwards) {
    input_ = lit_from_above(scene_.view(128, 128, 6000, 0, -90));
    add(128, 128, 1500);
    design::DesignSettings design = white_design();
    ask_for(design, regions_);
    design.foci[0].terrain = {};
    design.foci[0].border = {FocusBorderKind::halo, {255, 0, 0}, 15};
    ChunkDrawing drawing(scene_, design, "egl", GetParam());
    const std::vector<double> cover = cover_across(drawing.draw(input_, 0.5), 120);
    std::size_t first = 161;
    while (first < cover.size() && cover[first] < 0.5) ++first;
    ASSERT_LT(first, cover.size() - 20);
    for (std::size_t x = 161; x + 2 < first; ++x) EXPECT_EQ(cover[x], 0) << "in focus";
    for (std::size_t x = first + 1; x < first + 15; ++x) EXPECT_LT(cover[x + 1], cover[x] + 1e-9);
    EXPECT_GT(cover[first + 3], 0.4);
    EXPECT_LT(cover[first + 3], 0.85);
    for (std::size_t x = first + 16; x < cover.size() - 1; ++x) EXPECT_EQ(cover[x], 0);
}

TEST_P(FocusGround, GridsLieInFocusAtRoundSpacing) {
    input_ = lit_from_above(scene_.view(128, 128, 6000, 0, -90));
    add(128, 128, 1500);
    design::DesignSettings design = white_design();
    ask_for(design, regions_);
    design.foci[0].terrain = {};
    design.foci[0].border = {FocusBorderKind::grid, {255, 0, 0}, 1};
    ChunkDrawing drawing(scene_, design, "egl", GetParam());
    const ChunkPicture picture = drawing.draw(input_, 0.5);
    EXPECT_EQ(focus_grid_spacing_m(1500), 500);
    int lines = 0;
    bool was = false;
    for (std::uint32_t x = 20; x < 300; ++x) {
        const double east_m = in_focus_plane(regions_[0], ground_at(scene_, input_.view, x, 103)).x;
        const bool is_line = picture.at(x, 103).green < 200;
        if (is_line && !was) {
            ++lines;
            const double off = std::remainder(east_m, 500);
            const double rim =
                focus_part_distance_m(regions_[0], 0, in_focus_plane(regions_[0], ground_at(scene_, input_.view, x, 103)));
            EXPECT_TRUE(std::fabs(off) < 40 || std::fabs(rim) < 40) << east_m;
        }
        was = is_line;
    }
    EXPECT_EQ(lines, 7) << "five meridians, and the rim twice";
}

INSTANTIATE_TEST_SUITE_P(Lanes, FocusGround, testing::Values("es2-small", "es3-mid"),
                         [](const auto& lane) { return std::string(lane.param).substr(0, 3); });

}  // namespace
}  // namespace tedavis::draw::test_focus_ground_pictures
