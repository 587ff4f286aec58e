#include "render_core/terrain/ground_scan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::terrain::test_ground_scan {
namespace {

using base::radians;

constexpr double kMargin_m = 2, kError_m = 0.25;

View view_of(double pitch_deg, double roll_deg) {
    const glm::dmat3 body = earth::body_axes(radians(46), radians(9), radians(70), radians(pitch_deg), radians(roll_deg));
    View view;
    view.eye = earth::to_ecef({radians(46), radians(9), {2000}});
    view.forward = body[0];
    view.right = body[1];
    view.down = body[2];
    view.width = 800;
    view.height = 600;
    view.focal_px = 700;
    view.near_m = 1;
    return view;
}

glm::dvec3 down_at(const glm::dvec3& place) {
    const earth::Geodetic geodetic = earth::from_ecef(place);
    return earth::north_east_down(geodetic.latitude_rad, geodetic.longitude_rad)[2];
}

/// Drawn pixels between a true place and one over it; 0 where it is not drawn.
double moved_px(const View& view, const glm::dvec3& truth, double above_m) {
    const glm::dvec3 t = seen(view, truth - view.eye), d = seen(view, truth - down_at(truth) * above_m - view.eye);
    if (d.z < view.near_m || t.z < view.near_m || std::abs(d.x) > view.half_width_tangent() * d.z ||
        std::abs(d.y) > view.half_height_tangent() * d.z)
        return 0;
    return view.focal_px * std::hypot(d.x / d.z - t.x / t.z, d.y / d.z - t.y / t.z);
}

struct Triangle {
    glm::dvec3 corner[3];

    /// Weights 0..1 that sum to 1.
    [[nodiscard]] glm::dvec3 at(double u, double v) const {
        return u + v <= 1 ? corner[0] + u * (corner[1] - corner[0]) + v * (corner[2] - corner[0]) : at(1 - u, 1 - v);
    }
};

class GroundScanOfTriangles : public ::testing::Test {
protected:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
    Triangle triangle_round(const View& view) {
        const double size_m = std::exp(uniform(1, 6));
        const glm::dvec3 middle(uniform(-300, 300), uniform(-100, 400), uniform(-50, 900));
        Triangle triangle;
        for (glm::dvec3& corner : triangle.corner) {
            const glm::dvec3 place = middle + size_m * glm::dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
            corner = view.eye + view.right * place.x + view.down * place.y + view.forward * place.z;
        }
        return triangle;
    }
    /// Over places of the triangle, true ones by up to the error beside it, drawn ones by the margin beside those.
    double most_found(const View& view, const Triangle& triangle) {
        double most = 0;
        for (int n = 0; n < 200; ++n) {
            const glm::dvec3 place = triangle.at(uniform(0, 1), uniform(0, 1));
            const glm::dvec3 truth = place + down_at(place) * uniform(-kError_m, kError_m);
            for (const double above_m : {-kMargin_m, kMargin_m})
                most = std::max(most, moved_px(view, truth, above_m) / kMargin_m);
        }
        return most;
    }

    std::mt19937 random{11};
};

TEST_F(GroundScanOfTriangles, NothingInThemMovesFurtherThanTheyAndTheirBoxesSay) {
    int seen_ones = 0, bounded = 0, tight = 0, unlike = 0;
    for (int n = 0; n < 2000; ++n) {
        const View view = view_of(uniform(-60, 20), n % 3 == 0 ? uniform(-180, 180) : 0);
        const Triangle triangle = triangle_round(view);
        const GroundScan scan(view, down_at(view.eye), kMargin_m, kError_m);
        ViewBox box;
        glm::dvec3 corner[3];
        for (int c = 0; c < 3; ++c) box.include(corner[c] = seen(view, triangle.corner[c] - view.eye));
        const double by_box = scan.px_per_m(box), by_triangle = scan.px_per_m(corner[0], corner[1], corner[2]);
        const double found = most_found(view, triangle);
        EXPECT_LE(found, by_box) << n;
        EXPECT_LE(found, by_triangle) << n;
        seen_ones += found > 0 ? 1 : 0;
        bounded += found > 0 && std::isfinite(by_triangle) ? 1 : 0;
        tight += found > 0.5 * by_triangle ? 1 : 0;
        unlike += by_triangle < 0.5 * by_box ? 1 : 0;
    }
    EXPECT_GT(seen_ones, 600);
    EXPECT_GT(bounded, 0.7 * seen_ones);
    EXPECT_GT(tight, 100) << "half of it would not hold";
    EXPECT_GT(unlike, 100) << "triangles say more than their boxes";
}

TEST_F(GroundScanOfTriangles, AreAtMostOnlyWhatTheirBoundIsAtMost) {
    int said = 0, greater = 0;
    for (int n = 0; n < 20000; ++n) {
        const View view = view_of(uniform(-60, 20), n % 3 == 0 ? uniform(-180, 180) : 0);
        const Triangle triangle = triangle_round(view);
        const GroundScan scan(view, down_at(view.eye), kMargin_m, kError_m);
        glm::dvec3 corner[3];
        for (int c = 0; c < 3; ++c) corner[c] = seen(view, triangle.corner[c] - view.eye);
        const double bound = scan.px_per_m(corner[0], corner[1], corner[2]);
        if (!(bound > 0) || std::isinf(bound)) continue;
        EXPECT_FALSE(scan.is_at_most(bound * (1 - 1e-12), corner[0], corner[1], corner[2])) << n;
        ++greater;
        said += scan.is_at_most(3 * bound, corner[0], corner[1], corner[2]) ? 1 : 0;
    }
    EXPECT_GT(greater, 4000);
    EXPECT_GT(said, greater / 2) << "most are known without the bound";
}

TEST_F(GroundScanOfTriangles, WhatCannotBeDrawnMovesNothing) {
    const View view = view_of(-20, 0);
    const GroundScan scan(view, down_at(view.eye), kMargin_m, kError_m);
    const auto both = [&scan](const glm::dvec3& middle) {
        ViewBox box;
        const glm::dvec3 a = middle, b = middle + glm::dvec3(5, 0, 0), c = middle + glm::dvec3(0, 0, 5);
        for (const glm::dvec3& corner : {a, b, c}) box.include(corner);
        return std::pair{scan.px_per_m(box), scan.px_per_m(a, b, c)};
    };
    const std::pair<double, double> none{0, 0};
    EXPECT_EQ(both({0, 0, -20}), none) << "behind the eye";
    EXPECT_EQ(both({100, 0, 100}), none) << "beside the picture";
    EXPECT_EQ(both({-100, 0, 100}), none);
    EXPECT_EQ(both({0, 80, 100}), none);
    EXPECT_EQ(both({0, -80, 100}), none);
    EXPECT_GT(both({0, 0, 100}).first, 0);
    EXPECT_GT(both({0, 0, 100}).second, 0);
    EXPECT_EQ(scan.px_per_m(ViewBox{}), 0) << "nothing was put into it";
}

TEST_F(GroundScanOfTriangles, AtTheEyeTheyMoveAsFarAsTheNearPlaneAllows) {
    const View view = view_of(-20, 0);
    const GroundScan scan(view, down_at(view.eye), kMargin_m, kError_m);
    const glm::dvec3 corners[3] = {{-10, 1, -10}, {10, 1, -10}, {0, 1, 30}};
    ViewBox box;
    for (const glm::dvec3& corner : corners) box.include(corner);
    EXPECT_GE(scan.px_per_m(box), view.focal_px / view.near_m) << "the near plane alone bounds it";
    EXPECT_TRUE(std::isinf(scan.px_per_m(corners[0], corners[1], corners[2])));
}

}  // namespace
}  // namespace tedavis::terrain::test_ground_scan
