#include "render_core/scene/focus_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::scene::test_focus_map {
namespace {

FocusRegion region_at(double latitude_deg, double longitude_deg, double width_m, const glm::dvec2& point) {
    FocusRegion region = focus_region_at(base::radians(latitude_deg), base::radians(longitude_deg));
    region.radius_m = 2000;
    region.context.width_m = width_m;
    region.context.levels = 0;
    region.points[0] = point;
    region.point_count = 1;
    return region;
}

glm::dvec2 in_double(const FocusRegion& region, double latitude_rad, double longitude_rad) {
    return in_focus_plane(region, earth::to_ecef({latitude_rad, longitude_rad, {0}}));
}

/// Against ECEF, everywhere but at the poles themselves, and across the antimeridian.
TEST(FocusMap, SaysWhatTheRegionSays) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> off(-0.4, 0.4);
    std::uint32_t within = 0, rejected = 0;
    for (const double latitude_deg : {-84.0, -33.0, 0.0, 46.8, 69.0, 85.0})
        for (const double longitude_deg : {-180.0, -179.9, 9.8, 179.95}) {
            const FocusRegion region = region_at(latitude_deg, longitude_deg, 9000, {3000, -4000});
            const FocusMap map(region);
            for (int n = 0; n < 400; ++n) {
                const double latitude = base::radians(latitude_deg + off(random));
                const double longitude = earth::wrap_longitude(base::radians(longitude_deg + 2 * off(random)));
                const glm::dvec2 exact = in_double(region, latitude, longitude);
                const glm::dvec2 found = map.in_plane(region, latitude, longitude);
                EXPECT_NEAR(found.x, exact.x, 0.01) << latitude_deg;
                EXPECT_NEAR(found.y, exact.y, 0.01) << latitude_deg;
                const double degree = ground_focus_degree(region, exact);
                EXPECT_NEAR(map.degree(region, latitude, longitude), degree, 1e-6)
                    << latitude_deg << " " << exact.x << " " << exact.y;
                within += degree > 0 ? 1 : 0;
                rejected += map.beyond(latitude, longitude) != 0 ? 1 : 0;
            }
        }
    EXPECT_GT(within, 300u);
    EXPECT_GT(rejected, 2000u) << "most need no closer look";
}

TEST(FocusMap, ARegionThatIsTooWideIsLookedAtPlaceByPlace) {
    const FocusRegion region = region_at(46.8, 9.8, 450'000, {0, 0});
    const FocusMap map(region);
    const double latitude = base::radians(49.9), longitude = base::radians(13.5);
    EXPECT_EQ(map.beyond(latitude, longitude), 0u);
    EXPECT_EQ(map.degree(region, latitude, longitude), ground_focus_degree(region, in_double(region, latitude, longitude)));
    EXPECT_GT(map.degree(region, latitude, longitude), 0);
}

}  // namespace
}  // namespace tedavis::scene::test_focus_map
