#include "render_core/draw/drawers/data/glyph_drawer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/device.hpp"
#include "tests/render_core/draw/drawers/data/glyph_picture.hpp"
#include "tests/support/programs/headless_backends.hpp"

namespace tedavis::draw::test_glyph_drawer {
namespace {

using test_support::glyph_pixels;
using test_support::GlyphPicture;

constexpr std::uint32_t kWidth = 320, kHeight = 240;
constexpr double kLatitude = 0.8, kLongitude = 0.2;
constexpr DepthRange kRange{1, 20'000};
constexpr design::Color kRed{200, 40, 30};

/// Level, to the north.
DataFrame level_frame() {
    DataFrame frame;
    const glm::dvec3 eye = earth::to_ecef({kLatitude, kLongitude, {2000}});
    frame.view = test_support::free_view(eye, earth::body_axes(kLatitude, kLongitude, 0, 0, 0), kWidth, kHeight, 1);
    frame.towards_light = -frame.view.down;
    return frame;
}

/// East, north and up of the eye.
glm::vec3 local(double east, double north, double up) {
    const glm::dmat3 ned = earth::north_east_down(kLatitude, kLongitude);
    return glm::vec3(ned[1] * east + ned[0] * north - ned[2] * up);
}

struct Glyphs {
    Glyphs() : room(8192), batch(room) {}
    void add(GlyphShape shape, const GlyphInstance& glyph, GlyphFacing facing = GlyphFacing::up) {
        const auto span = batch.add(shape, facing, glyph.rgba[3] < 255, 1);
        ASSERT_FALSE(span.empty());
        span[0] = glyph;
    }
    std::vector<GlyphInstance> room;
    GlyphBatch batch;
};

struct Box {
    int left = 1 << 20, right = -1, bottom = 1 << 20, top = -1;
};
/// Of what is not background; rows from the bottom.
Box box_of(const std::vector<std::uint8_t>& rgba) {
    Box box;
    for (int row = 0; row < static_cast<int>(kHeight); ++row)
        for (int column = 0; column < static_cast<int>(kWidth); ++column) {
            const std::uint8_t* pixel = &rgba[4 * (static_cast<std::size_t>(row) * kWidth + column)];
            if (pixel[0] == test_support::kGlyphBackground.red && pixel[1] == test_support::kGlyphBackground.green) continue;
            box.left = std::min(box.left, column);
            box.right = std::max(box.right, column);
            box.bottom = std::min(box.bottom, row);
            box.top = std::max(box.top, row);
        }
    return box;
}

/// Pixels that differ by more than rounding.
int different_pixels(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int count = 0;
    for (std::size_t n = 0; n < a.size(); n += 4) {
        int difference = 0;
        for (std::size_t k = 0; k < 3; ++k) difference = std::max(difference, std::abs(a[n + k] - b[n + k]));
        count += difference > 3;
    }
    return count;
}

std::vector<std::uint8_t> drawn(const char* device, const Glyphs& glyphs, const DataFrame& frame = level_frame(),
                                const DepthRange& range = kRange) {
    GlyphPicture picture(device, kWidth, kHeight);
    return picture.picture(glyphs.batch, frame, range);
}

constexpr const char* kDevices[] = {"es2-small", "es3-mid"};

TEST(GlyphDrawer, AxesAreOrthonormalAndAsAsked) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> any(-1, 1);
    const glm::vec3 earth_to_eye(level_frame().view.eye);
    for (int n = 0; n < 500; ++n) {
        const glm::dvec3 direction =
            n % 7 == 0 ? glm::dvec3(0) : glm::normalize(glm::dvec3(any(random), any(random), any(random)));
        const GlyphFacing facing = n % 2 == 0 ? GlyphFacing::up : GlyphFacing::eye;
        const GlyphInstance glyph = make_glyph(local(any(random) * 900, 1000, any(random) * 900), {1, 1, 1}, direction, kRed);
        const GlyphAxes axes = glyph_axes(glyph, facing, earth_to_eye);
        EXPECT_LT(glm::length(glm::cross(axes.x, axes.y) - axes.z), 1e-4f) << "right-handed";
        EXPECT_NEAR(glm::length(axes.x), 1, 1e-5);
        EXPECT_NEAR(glm::length(axes.y), 1, 1e-5);
        if (direction == glm::dvec3(0)) {
            EXPECT_NEAR(glm::dot(axes.z, -glm::normalize(glyph.place)), 1, 1e-5) << "faces the eye";
            EXPECT_GT(glm::dot(axes.y, local(0, 0, 1)), 0.3) << "stands upright";
            continue;
        }
        EXPECT_GT(glm::dot(glm::dvec3(axes.x), direction), 0.999);
        const glm::vec3 wanted = facing == GlyphFacing::up ? local(0, 0, 1) : -glm::normalize(glyph.place);
        EXPECT_GE(glm::dot(axes.z, wanted), 0) << "as far as the direction leaves it free";
    }
    const GlyphAxes steep =
        glyph_axes(make_glyph(local(0, 100, 0), {1, 1, 1}, local(0, 0, 1), kRed), GlyphFacing::up, earth_to_eye);
    EXPECT_NEAR(glm::length(steep.y), 1, 1e-5) << "straight up as well";
}

TEST(GlyphDrawer, UprightIsTheVerticalHoweverFarTheEye) {
    const earth::Geodetic place{base::radians(46.8), base::radians(9.8), {1500}};
    const glm::dvec3 at = earth::to_ecef(place), up = -earth::north_east_down(place.latitude_rad, place.longitude_rad)[2];
    for (const double distance_m : {2e3, 1e5, 1.5e7})
        for (const double pitch_deg : {-20.0, -60.0, -90.0}) {
            const glm::dvec3 forward =
                earth::body_axes(place.latitude_rad, place.longitude_rad, 1.2, base::radians(pitch_deg), 0)[0];
            const glm::dvec3 eye = at - distance_m * forward;
            const auto axes = [&](const glm::dvec3& direction, GlyphFacing facing) {
                return glyph_axes(make_glyph(glm::vec3(at - eye), {1, 1, 1}, direction, kRed), facing, glm::vec3(eye));
            };
            const GlyphAxes bar = axes(earth::north_east_down(place.latitude_rad, place.longitude_rad)[0], GlyphFacing::up);
            EXPECT_GT(glm::dot(glm::dvec3(bar.z), up), std::cos(base::radians(0.5))) << distance_m;
            const GlyphAxes stem = axes(up, GlyphFacing::eye_upright);
            EXPECT_LT(glm::length(glm::dvec3(stem.x) - up), 2e-5) << distance_m << " " << pitch_deg;
            EXPECT_TRUE(pitch_deg == -90 || glm::dot(glm::dvec3(stem.z), forward) < -0.3) << "seen from the eye";
        }
}

TEST(GlyphDrawer, StemsLeadFromTheirPlaceDown) {
    for (const char* device : kDevices) {
        Glyphs glyphs;
        glyphs.add(GlyphShape::stem, make_glyph(local(0, 100, -10), {20, 2, 1}, local(0, 0, 1), kRed), GlyphFacing::eye_upright);
        const Box box = box_of(drawn(device, glyphs));
        const double px_per_m = level_frame().view.focal_px / 100;
        EXPECT_NEAR(box.top - box.bottom + 1, 20 * px_per_m, 2) << device;
        EXPECT_NEAR(box.right - box.left + 1, 2 * px_per_m, 1.5) << device << ", dark side and all";
        EXPECT_NEAR(0.5 * (box.bottom + box.top + 1), 0.5 * kHeight - 10 * px_per_m, 1.5) << device;
    }
}

TEST(GlyphDrawer, SpheresStandWhereTheyAreAndAsLarge) {
    for (const char* device : kDevices) {
        Glyphs glyphs;
        glyphs.add(GlyphShape::sphere, make_glyph(local(10, 100, -5), {20, 20, 20}, {1, 0, 0}, kRed));
        const auto pixels = drawn(device, glyphs);
        const double focal_px = level_frame().view.focal_px;
        const Box box = box_of(pixels);
        EXPECT_NEAR(0.5 * (box.left + box.right + 1), 0.5 * kWidth + 0.1 * focal_px, 1.5) << device;
        EXPECT_NEAR(0.5 * (box.bottom + box.top + 1), 0.5 * kHeight - 0.05 * focal_px, 1.5) << device;
        const double across_px = 0.2 * focal_px;
        EXPECT_NEAR(glyph_pixels(pixels), 0.785 * across_px * across_px, 0.08 * across_px * across_px) << device;
    }
}

TEST(GlyphDrawer, ArrowsPointWhereTheirDirectionDoes) {
    for (const char* device : kDevices)
        for (const bool to_the_right : {true, false}) {
            Glyphs glyphs;
            const glm::dvec3 direction(local(to_the_right ? 1 : -1, 0, 0));
            glyphs.add(GlyphShape::arrow, make_glyph(local(0, 100, 0), {60, 30, 30}, direction, kRed));
            const auto pixels = drawn(device, glyphs);
            const Box box = box_of(pixels);
            const double focal_px = level_frame().view.focal_px;
            EXPECT_NEAR(box.right + 1 - box.left, 0.6 * focal_px, 3) << device;
            EXPECT_NEAR(box.top + 1 - box.bottom, 0.3 * 0.8 * focal_px, 5) << device;
            const auto height_at = [&](int column) {
                int rows = 0;
                for (int row = 0; row < static_cast<int>(kHeight); ++row)
                    rows += pixels[4 * (static_cast<std::size_t>(row) * kWidth + column)] != test_support::kGlyphBackground.red;
                return rows;
            };
            const int near_left = height_at(box.left + 4), near_right = height_at(box.right - 4);
            EXPECT_GT(to_the_right ? near_left : near_right, to_the_right ? near_right : near_left) << "its tip is thin";
        }
}

TEST(GlyphDrawer, BarsStandOnTheirPlace) {
    for (const char* device : kDevices) {
        Glyphs glyphs;
        glyphs.add(GlyphShape::box, make_glyph(local(0, 100, 0), {5, 5, 30}, local(0, 1, 0), kRed));
        const Box box = box_of(drawn(device, glyphs));
        const double focal_px = level_frame().view.focal_px;
        EXPECT_NEAR(box.bottom, 0.5 * kHeight, 1.5) << device;
        EXPECT_NEAR(box.top + 1, 0.5 * kHeight + 0.3 * focal_px, 10) << device;
        EXPECT_NEAR(box.right + 1 - box.left, 0.05 * focal_px, 2) << device;
    }
}

TEST(GlyphDrawer, FlatShapesKeepTheirColorAndFaceWhomTheyAreTold) {
    for (const char* device : kDevices) {
        Glyphs edge_on, facing;
        const GlyphInstance circle = make_glyph(local(0, 100, 0), {40, 40, 40}, local(1, 0, 0), kRed);
        edge_on.add(GlyphShape::circle, circle, GlyphFacing::up);
        facing.add(GlyphShape::circle, circle, GlyphFacing::eye);
        EXPECT_LT(glyph_pixels(drawn(device, edge_on)), 150) << device;
        const auto pixels = drawn(device, facing);
        const double across_px = 0.4 * level_frame().view.focal_px;
        EXPECT_NEAR(glyph_pixels(pixels), 0.785 * across_px * across_px, 0.05 * across_px * across_px) << device;
        const std::uint8_t* middle = &pixels[4 * (std::size_t{kHeight / 2} * kWidth + kWidth / 2)];
        EXPECT_NEAR(middle[0], kRed.red, 1);
        EXPECT_NEAR(middle[1], kRed.green, 1);
        EXPECT_NEAR(middle[2], kRed.blue, 1);
    }
}

TEST(GlyphDrawer, NearHidesFarInWhateverOrder) {
    for (const char* device : kDevices)
        for (const bool near_first : {true, false}) {
            Glyphs glyphs;
            const GlyphInstance nearer = make_glyph(local(0, 80, 0), {10, 10, 10}, {}, {0, 250, 0});
            const GlyphInstance farther = make_glyph(local(0, 160, 0), {60, 60, 60}, {}, kRed);
            for (const bool take_near : {near_first, !near_first}) glyphs.add(GlyphShape::circle, take_near ? nearer : farther);
            const auto pixels = drawn(device, glyphs);
            EXPECT_EQ(pixels[4 * (std::size_t{kHeight / 2} * kWidth + kWidth / 2) + 1], 250) << device;
        }
}

TEST(GlyphDrawer, TransparentOnesBlendAndHideNothing) {
    for (const char* device : kDevices) {
        Glyphs glyphs;
        glyphs.add(GlyphShape::circle, make_glyph(local(0, 80, 0), {60, 60, 60}, {}, {200, 40, 30, 128}));
        glyphs.add(GlyphShape::circle, make_glyph(local(0, 160, 0), {20, 20, 20}, {}, {0, 250, 0}));
        const auto pixels = drawn(device, glyphs);
        const auto expect_blend = [&](std::size_t column, const design::Color& below) {
            const std::uint8_t* pixel = &pixels[4 * (std::size_t{kHeight / 2} * kWidth + column)];
            const design::Color blend = design::blended(below, kRed, 128.0 / 255);
            EXPECT_NEAR(pixel[0], blend.red, 1) << device;
            EXPECT_NEAR(pixel[1], blend.green, 1) << device;
            EXPECT_EQ(pixel[3], 255) << "the picture's alpha stays";
        };
        expect_blend(kWidth / 2, {0, 250, 0});
        expect_blend(kWidth / 2 + 60, test_support::kGlyphBackground);
    }
}

TEST(GlyphDrawer, HazeHidesWhatIsFar) {
    for (const char* device : kDevices) {
        DataFrame frame = level_frame();
        frame.haze = {220, 225, 230};
        frame.haze_per_m = 1 / 1000.0;
        Glyphs glyphs;
        glyphs.add(GlyphShape::circle, make_glyph(local(0, 1000, 0), {400, 400, 400}, {}, kRed));
        const auto pixels = drawn(device, glyphs, frame);
        const design::Color expected = design::blended(kRed, frame.haze, 1 - std::exp(-1.0));
        EXPECT_NEAR(pixels[4 * (std::size_t{kHeight / 2} * kWidth + kWidth / 2)], expected.red, 2) << device;
    }
}

TEST(GlyphDrawer, SidesTowardsTheLightAreBrighter) {
    for (const char* device : kDevices) {
        Glyphs glyphs;
        glyphs.add(GlyphShape::sphere, make_glyph(local(0, 100, 0), {60, 60, 60}, {1, 0, 0}, kRed));
        const auto pixels = drawn(device, glyphs);
        const Box box = box_of(pixels);
        const auto red_at = [&](int row) { return pixels[4 * (static_cast<std::size_t>(row) * kWidth + kWidth / 2)]; };
        EXPECT_NEAR(red_at(box.top - 3), kRed.red, 12) << device;
        EXPECT_NEAR(red_at(box.bottom + 3), kRed.red * level_frame().ambient, 12) << device;
    }
}

/// All shapes in both facings, sizes unequal along the axes.
Glyphs many_glyphs(int count) {
    Glyphs glyphs;
    std::mt19937 random(8);
    std::uniform_real_distribution<double> any(-1, 1);
    for (std::size_t shape = 0; shape < kGlyphShapes; ++shape) {
        const auto span = glyphs.batch.add(static_cast<GlyphShape>(shape), shape % 2 == 0 ? GlyphFacing::up : GlyphFacing::eye,
                                           false, static_cast<std::uint32_t>(count));
        for (GlyphInstance& glyph : span) {
            const double ahead = 500 + 400 * any(random);
            const glm::dvec3 direction = glm::normalize(glm::dvec3(local(any(random), any(random), 0.2 * any(random))));
            glyph = make_glyph(local(0.5 * ahead * any(random), ahead, 0.35 * ahead * any(random)),
                               {30, 24, 15 + 10 * any(random)}, direction, {200, static_cast<std::uint8_t>(16 * shape), 30});
        }
    }
    return glyphs;
}

TEST(GlyphDrawer, BothLanesDrawTheSamePicture) {
    DataFrame frame = level_frame();
    frame.haze = {220, 225, 230};
    frame.haze_per_m = 1 / 5000.0;
    const Glyphs glyphs = many_glyphs(20);
    const auto es2 = drawn("es2-small", glyphs, frame), es3 = drawn("es3-mid", glyphs, frame);
    EXPECT_GT(glyph_pixels(es3), 5000);
    EXPECT_LE(different_pixels(es2, es3), static_cast<int>(kWidth * kHeight / 1000));
    const auto fewer = drawn("es3-mid", many_glyphs(19), frame);
    EXPECT_GT(different_pixels(es3, fewer), 100) << "the comparison can fail";
}

TEST(GlyphDrawer, DepthRangesTogetherDrawAllOfIt) {
    for (const char* device : kDevices) {
        const Glyphs glyphs = many_glyphs(10);
        const auto whole = drawn(device, glyphs);
        GlyphPicture picture(device, kWidth, kHeight);
        picture.clear();
        picture.drawer.upload(picture.session.gl, glyphs.batch);
        picture.drawer.draw(picture.session.gl, level_frame(), {480, 20'000});
        picture.session.gl->Clear(GL_DEPTH_BUFFER_BIT);
        picture.drawer.draw(picture.session.gl, level_frame(), {1, 490});
        EXPECT_LE(different_pixels(whole, picture.session.pixels()), static_cast<int>(kWidth * kHeight / 500)) << device;
    }
}

TEST(GlyphDrawer, InstancesTakeADrawAShapeAndBatchesAsManyAsTheyNeed) {
    const Glyphs glyphs = many_glyphs(100);
    std::vector<std::uint8_t> pixels[2];
    std::uint32_t draws[2];
    std::uint64_t indices[2];
    for (std::size_t n = 0; n < 2; ++n) {
        GlyphPicture picture(kDevices[n], kWidth, kHeight);
        pixels[n] = picture.picture(glyphs.batch, level_frame(), kRange);
        draws[n] = picture.draws;
        indices[n] = picture.session.gl.frame().indices;
    }
    EXPECT_EQ(draws[1], kGlyphShapes);
    EXPECT_GT(draws[0], 2 * kGlyphShapes) << "the buffer was filled again";
    EXPECT_EQ(indices[0], indices[1]) << "as many triangles";
    EXPECT_LE(different_pixels(pixels[0], pixels[1]), static_cast<int>(kWidth * kHeight / 500));
}

TEST(GlyphDrawer, NothingIsDrawnOfNothing) {
    for (const char* device : kDevices) {
        Glyphs none;
        GlyphPicture picture(device, kWidth, kHeight);
        EXPECT_EQ(picture.drawer.draw(picture.session.gl, level_frame(), kRange), 0u) << "before any upload";
        EXPECT_EQ(glyph_pixels(picture.picture(none.batch, level_frame(), kRange)), 0);
        EXPECT_EQ(picture.draws, 0u);
    }
}

TEST(GlyphDrawer, WhatTheBufferCannotHoldIsLeftOut) {
    test_support::GlSession session("egl", "es3-mid", kWidth, kHeight);
    base::BudgetLine line = *session.device.budget.find(effects::kSceneGlyphVertices);
    line.bytes = 20480;
    line.use = {};
    line.use.capacity = line.bytes;
    const std::uint32_t most = glyph_instances_within(GlyphDrawer::has_instances(session.gl), line.bytes);
    ASSERT_GT(most, 4u);
    ASSERT_LT(most, 200u);
    std::vector<unsigned char> block(glyph_drawer_bytes(GlyphDrawer::has_instances(session.gl), line.bytes));
    base::Arena arena(block.data(), block.size());
    GlyphDrawer drawer;
    ASSERT_EQ(drawer.start(session.gl, line, arena).message.view(), "");
    session.gl.seal();
    session.gl.begin_frame();
    const Glyphs glyphs = many_glyphs(static_cast<int>(most) - 3);
    drawer.upload(session.gl, glyphs.batch);
    EXPECT_EQ(drawer.draw(session.gl, level_frame(), kRange), 2u) << "of the second run three";
    EXPECT_EQ(session.gl.frame().uploaded_bytes, most * sizeof(GlyphInstance));
    session.gl.retire();
    drawer.destroy(session.gl);
    EXPECT_EQ(line.use.in_use, 0u);
}

TEST(GlyphDrawer, RefusesTooLittleMemoryWithTheLinesName) {
    for (const char* device : kDevices) {
        test_support::GlSession session("egl", device);
        base::BudgetLine& line = *session.device.budget.find(effects::kSceneGlyphVertices);
        std::vector<unsigned char> little(100);
        base::Arena arena(little.data(), little.size());
        GlyphDrawer drawer;
        const base::Error error = drawer.start(session.gl, line, arena);
        EXPECT_NE(error.message.view().find("'scene_glyphs' has 100 of 100 bytes left"), std::string_view::npos) << device;
        std::vector<unsigned char> enough(std::size_t{64} << 20);
        base::Arena large(enough.data(), enough.size());
        line.bytes = 100;
        GlyphDrawer other;
        const base::Error of_gpu = other.start(session.gl, line, large);
        EXPECT_NE(of_gpu.message.view().find("'scene_glyph_vertices' has 100 of 100 bytes left"), std::string_view::npos)
            << device << ": " << of_gpu.message.view();
    }
}

TEST(GlyphDrawer, OsMesaAndEglAgreeBitForBit) {
    std::vector<std::vector<std::uint8_t>> pictures;
    const Glyphs glyphs = many_glyphs(10);
    for (const std::string& backend : test_support::headless_backends()) {
        GlyphPicture picture("es3-mid", kWidth, kHeight, backend);
        pictures.push_back(picture.picture(glyphs.batch, level_frame(), kRange));
    }
    for (const auto& picture : pictures) EXPECT_EQ(picture, pictures.front());
}

}  // namespace
}  // namespace tedavis::draw::test_glyph_drawer
