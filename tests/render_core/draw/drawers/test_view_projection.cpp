#include "render_core/draw/drawers/view_projection.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "render_core/draw/view_frame.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/free_view.hpp"

namespace tedavis::draw::test_view_projection {
namespace {

using base::radians;

constexpr DepthRange kRange{2, 50'000};
constexpr double kLatitude = 0.8, kLongitude = 0.2;

terrain::View tilted_view() {
    const glm::dvec3 eye = earth::to_ecef({kLatitude, kLongitude, {2500}});
    const glm::dmat3 axes = earth::body_axes(kLatitude, kLongitude, radians(77), radians(-12), radians(30));
    return test_support::free_view(eye, axes, 640, 480, kRange.near_m);
}

glm::dvec3 on_screen(const glm::dmat4& matrix, const glm::dvec3& place) {
    const glm::dvec4 clip = matrix * glm::dvec4(place, 1);
    return glm::dvec3(clip) / clip.w;
}

TEST(ViewProjection, PutsPlacesWhereSymbologyPutsDirections) {
    const terrain::View view = tilted_view();
    const glm::dmat4 matrix = view_projection(view, kRange);
    const ViewFrame frame = make_view_frame(view);
    for (const glm::dvec3& ahead : {glm::dvec3(900, 100, 50), glm::dvec3(40, -20, 11), glm::dvec3(20'000, 3000, -6000)}) {
        const glm::dvec3 place = view.forward * ahead.x + view.right * ahead.y + view.down * ahead.z;
        const glm::dvec3 direction = glm::transpose(earth::north_east_down(kLatitude, kLongitude)) * place;
        const ProjectedPoint expected = project(frame, direction);
        ASSERT_TRUE(expected.in_front);
        const glm::dvec3 at = on_screen(matrix, place);
        EXPECT_NEAR((at.x + 1) * 320, static_cast<double>(expected.at.x), 1e-3);
        EXPECT_NEAR((1 - at.y) * 240, static_cast<double>(expected.at.y), 1e-3);
    }
}

TEST(ViewProjection, EndsOfTheRangeAreEndsOfDepth) {
    const terrain::View view = tilted_view();
    const glm::dmat4 matrix = view_projection(view, kRange);
    EXPECT_NEAR(on_screen(matrix, view.forward * kRange.near_m).z, -1, 1e-9);
    EXPECT_NEAR(on_screen(matrix, view.forward * kRange.far_m).z, 1, 1e-9);
    EXPECT_LT(on_screen(matrix, view.forward * (0.5 * kRange.near_m)).z, -1) << "nearer is cut away";
}

TEST(ViewProjection, PlacesMayBeMeasuredBesideTheEye) {
    const terrain::View view = tilted_view();
    const glm::dvec3 fraction(0.25, -0.375, 0.125), place(view.forward * 300.0 + view.down * 40.0);
    const glm::dvec3 direct = on_screen(view_projection(view, kRange), place);
    const glm::dvec3 beside = on_screen(view_projection(view, kRange, fraction), place + fraction);
    EXPECT_LT(glm::distance(direct, beside), 1e-12);
    EXPECT_GT(glm::distance(direct, on_screen(view_projection(view, kRange), place + fraction)), 1e-5);
}

}  // namespace
}  // namespace tedavis::draw::test_view_projection
