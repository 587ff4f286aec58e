#include "render_core/terrain/projected_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/terrain/terrain_views.hpp"

namespace tedavis::terrain::test_projected_error {
namespace {

using test_support::project;
using test_support::TdbSpec;
using test_support::WrittenTdb;

const WrittenTdb& rough() {
    static const WrittenTdb tdb([] {
        TdbSpec spec;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) {
            return 1500 + 400 * std::sin(i * 0.09) * std::cos(j * 0.07) + 60 * std::sin(i * 1.3 + j * 2.1);
        };
        return spec;
    }());
    return tdb;
}

glm::dvec3 in_box(const ChunkEntry& e, double north, double east, double down) {
    glm::dvec3 point(e.centre_m[0], e.centre_m[1], e.centre_m[2]);
    const double along[3] = {north, east, down};
    for (int a = 0; a < 3; ++a)
        point += glm::dvec3(e.axes[3 * a], e.axes[3 * a + 1], e.axes[3 * a + 2]) * (along[a] * double{e.half_extent_m[a]});
    return point;
}

TEST(ProjectedError, AChunkWithAVisiblePointIsNeverOutside) {
    int visible = 0, outside = 0;
    for (const View& view : test_support::some_views(rough(), 60))
        for (const ChunkKey& key : rough().keys()) {
            const ChunkEntry& entry = rough().entry(key);
            bool sees = false;
            for (double n = -1; n <= 1; n += 0.25)
                for (double e = -1; e <= 1; e += 0.25)
                    for (double d = -1; d <= 1; d += 0.5) sees = sees || project(view, in_box(entry, n, e, d)).visible;
            visible += sees ? 1 : 0;
            EXPECT_FALSE(sees && is_outside_view(entry, view));
            outside += is_outside_view(entry, view) ? 1 : 0;
        }
    EXPECT_GT(visible, 100);
    EXPECT_GT(outside, 100) << "a test that never rejects proves nothing";
}

/// Else what a wider view asks for would not do for a narrower one.
TEST(ProjectedError, WhatIsOutsideAViewIsOutsideEveryNarrowerOne) {
    int outside = 0, behind = 0;
    for (const View& view : test_support::some_views(rough(), 400, 11, 0.1))
        for (const ChunkKey& key : rough().keys()) {
            const ChunkEntry& entry = rough().entry(key);
            bool was_outside = false;
            for (const std::uint32_t percent : {300u, 200u, 125u, 100u, 50u, 10u}) {
                View narrowed = view;
                narrowed.width = view.width * percent / 100;
                narrowed.height = view.height * percent / 100;
                const bool is_outside = is_outside_view(entry, narrowed);
                EXPECT_TRUE(is_outside || !was_outside) << percent;
                was_outside = is_outside;
            }
            outside += was_outside ? 1 : 0;
            const bool centre_behind = glm::dot(in_box(entry, 0, 0, 0) - view.eye, view.forward) < 0;
            behind += centre_behind && !is_outside_view(entry, view) ? 1 : 0;
        }
    EXPECT_GT(outside, 1000);
    EXPECT_GT(behind, 20) << "boxes that reach behind the eye are the hard ones";
}

/// What is drawn on a plane may be seen where the relief is not, and the other way round.
TEST(ProjectedError, BoxesOfAFlatViewHoldThePlane) {
    const Lattice& lattice = rough().lattice();
    int visible = 0, outside = 0, only_flat = 0;
    for (View view : test_support::some_views(rough(), 60)) {
        const View relief = view;
        view.flat_msl_m = 300;
        for (const ChunkKey& key : rough().keys()) {
            const PostRange posts = lattice.posts_of(key);
            const ChunkEntry& entry = rough().entry(key);
            const DepthSpan span = depth_span(entry, view, 0);
            bool sees = false;
            for (std::uint32_t j = posts.j0; j <= posts.j1; j += 8)
                for (std::uint32_t i = posts.i0; i <= posts.i1; i += 8) {
                    const double latitude = lattice.latitude_rad(j);
                    const glm::dvec3 at = lattice.position(i, j, 300 + WrittenTdb::undulation_m(latitude));
                    sees = sees || project(view, at).visible;
                    const double depth = glm::dot(at - view.eye, view.forward);
                    EXPECT_GE(depth, span.near_m - 0.01);
                    EXPECT_LE(depth, span.far_m + 0.01);
                }
            visible += sees ? 1 : 0;
            EXPECT_FALSE(sees && is_outside_view(entry, view));
            outside += is_outside_view(entry, view) ? 1 : 0;
            only_flat += sees && is_outside_view(entry, relief) ? 1 : 0;
        }
    }
    EXPECT_GT(visible, 50);
    EXPECT_GT(outside, 50);
    EXPECT_GT(only_flat, 0) << "the boxes of the relief would not do";
}

TEST(ProjectedError, NothingInTheBoxIsSeenHigherThanItsHighestTangent) {
    int reached = 0, crossing = 0, behind = 0;
    for (const View& view : test_support::some_views(rough(), 60))
        for (const ChunkKey& key : rough().keys()) {
            const ChunkEntry& entry = rough().entry(key);
            for (const double turn : {0.0, 0.7, 2.9}) {
                const glm::dvec2 up(std::sin(turn), -std::cos(turn));
                const double bound = highest_tangent(entry, view, up, 0);
                double highest = -std::numeric_limits<double>::infinity();
                bool all_ahead = true;
                for (double n = -1; n <= 1; n += 0.125)
                    for (double e = -1; e <= 1; e += 0.125)
                        for (double d = -1; d <= 1; d += 0.5) {
                            const glm::dvec3 place = in_box(entry, n, e, d) - view.eye;
                            const double depth = glm::dot(place, view.forward);
                            all_ahead = all_ahead && depth >= view.near_m;
                            if (depth < view.near_m) continue;
                            const double tangent =
                                (up.x * glm::dot(place, view.right) + up.y * glm::dot(place, view.down)) / depth;
                            highest = std::fmax(highest, tangent);
                        }
                const double rounding = std::isfinite(bound) ? 1e-8 * std::fmax(1, std::abs(bound)) : 0;
                ASSERT_LE(highest, bound + rounding) << "turned by " << turn;
                reached += highest > bound - 1e-9 ? 1 : 0;
                crossing += !all_ahead && highest > -1e9 ? 1 : 0;
                behind += bound < -1e9 ? 1 : 0;
            }
        }
    EXPECT_GT(reached, 1000) << "a bound that is far away proves nothing";
    EXPECT_GT(crossing, 50);
    EXPECT_GT(behind, 50);
}

TEST(ProjectedError, WhatCannotBeBoundedIsSeenInfinitelyHigh) {
    View view = test_support::view_from(rough(), 64, 127, 3000, 0, 20);
    const ChunkEntry& entry = rough().entry({0, 2, 0});
    EXPECT_GT(highest_tangent(entry, view, {0, -1}, 500), highest_tangent(entry, view, {0, -1}, 0));
    view.eye.x = std::nan("");
    EXPECT_EQ(highest_tangent(entry, view, {0, -1}, 0), std::numeric_limits<double>::infinity());
}

TEST(ProjectedError, StretchingUpwardsBringsIntoViewWhatLiesBelowIt) {
    View view = test_support::view_from(rough(), 64, 127, 3000, 0, 20);
    const ChunkEntry& entry = rough().entry({0, 2, 0});
    EXPECT_TRUE(is_outside_view(entry, view));
    EXPECT_FALSE(is_outside_view(entry, view, 9000));
}

/// Raises and lowers points inside the box by the error and looks how far they move in the picture.
TEST(ProjectedError, NoPointOfTheBoxMovesFurtherInThePicture) {
    const double error_m = 3;
    double tightest = 1e9;
    std::vector<View> views = test_support::some_views(rough(), 40);
    views.push_back(test_support::view_from(rough(), 64, 64, 2500, 0, -90));
    for (const View& view : views)
        for (const ChunkKey& key : rough().keys()) {
            const ChunkEntry& entry = rough().entry(key);
            const double bound_px = error_in_box_px(entry, view, error_m, 0);
            for (double n = -0.96; n <= 1; n += 0.24)
                for (double e = -0.96; e <= 1; e += 0.24)
                    for (const double above_m : {-error_m, error_m}) {
                        const glm::dvec3 point = in_box(entry, n, e, 0);
                        const earth::Geodetic place = earth::from_ecef(point);
                        const glm::dvec3 drawn =
                            point - earth::north_east_down(place.latitude_rad, place.longitude_rad)[2] * above_m;
                        const auto a = project(view, point), b = project(view, drawn);
                        if (!b.visible || glm::dot(point - view.eye, view.forward) < view.near_m) continue;
                        const double moved_px = std::hypot(a.x - b.x, a.y - b.y);
                        EXPECT_LE(moved_px, bound_px * (1 + 1e-9));
                        if (moved_px > 0) tightest = std::min(tightest, bound_px / moved_px);
                    }
        }
    EXPECT_LT(tightest, 1.3) << "the bound is of some use";
}

TEST(ProjectedError, TheGroundNearTheEyeTightensErrorsWithinItsMargin) {
    View view = test_support::view_from(rough(), 64, 64, 30, 0, -10);
    view.near_m = 1;
    const ChunkEntry& entry = rough().entry({0, 2, 2});
    const double unknown_px = error_in_box_px(entry, view, 0.01, 0);
    const auto knows = [](double margin_m, double px_per_m) { return NearGround{{{margin_m, px_per_m}}, 1}; };
    view.ground = knows(0.02, 20);
    EXPECT_DOUBLE_EQ(error_in_box_px(entry, view, 0.01, 0), 0.2);
    EXPECT_DOUBLE_EQ(error_in_box_px(entry, view, 0.01, 1), 0.2);
    EXPECT_LT(0.2, unknown_px);
    EXPECT_GT(error_in_box_px(entry, view, 0.03, 0), 2 * unknown_px) << "beyond the margin nothing is known";
    view.ground = {{{0.02, 20}, {0.08, 22}}, 2};
    EXPECT_DOUBLE_EQ(error_in_box_px(entry, view, 0.03, 0), 0.66) << "unless it is of larger errors";
    view.ground = knows(0.02, 1e6);
    EXPECT_EQ(error_in_box_px(entry, view, 0.01, 0), unknown_px) << "never more than without";
    view.ground = knows(0.02, std::nan(""));
    EXPECT_EQ(error_in_box_px(entry, view, 0.01, 0), unknown_px);
    EXPECT_EQ(error_in_box_px(entry, view, 0, 0), 0);
}

TEST(ProjectedError, NoErrorIsExactlyNoPixel) {
    const ChunkEntry& entry = rough().entry({1, 0, 0});
    View view = test_support::view_from(rough(), 20, 20, 0, 0, 0);
    EXPECT_EQ(error_in_box_px(entry, view, 0, 0), 0);
    view.eye.x = std::nan("");
    EXPECT_EQ(error_in_box_px(entry, view, 0, 0), 0);
}

TEST(ProjectedError, IsFiniteInsideTheBoxAndRefinesWhereTheViewIsNoNumber) {
    const ChunkEntry& entry = rough().entry({1, 0, 0});
    View view = test_support::view_from(rough(), 20, 20, 1, 0, 0);
    EXPECT_TRUE(std::isfinite(error_in_box_px(entry, view, 2, 0)));
    EXPECT_GT(error_in_box_px(entry, view, 2, 0), 100);
    view.eye.x = std::nan("");
    EXPECT_FALSE(error_in_box_px(entry, view, 2, 0) <= 1e3);
    EXPECT_FALSE(is_outside_view(entry, view));
    view = test_support::view_from(rough(), 20, 20, 1, 0, 0);
    view.focal_px = std::nan("");
    EXPECT_FALSE(error_in_box_px(entry, view, 2, 0) <= 1e3);
}

TEST(ProjectedError, FallsWithDistanceAndGrowsWithTheLift) {
    const ChunkEntry& entry = rough().entry({0, 2, 2});
    const View view = test_support::view_from(rough(), 64, 128, 500, 0, -10);
    double last_px = 1e300;
    for (double back_m = 0; back_m < 20000; back_m += 500) {
        View further = view;
        further.eye -= view.forward * back_m;
        const double error_px = error_in_box_px(entry, further, 1, 0);
        EXPECT_LE(error_px, last_px);
        EXPECT_GE(error_in_box_px(entry, further, 1, 50), error_px * (1 - 1e-12));
        EXPECT_GT(error_in_box_px(entry, further, 2, 0), error_px);
        last_px = error_px;
    }
    EXPECT_LT(box_distance_m(entry, view), double{distance_m(entry, view)});
}

}  // namespace
}  // namespace tedavis::terrain::test_projected_error
