#include "host_sim/geoid_below.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_geoid_below {
namespace {

TEST(GeoidBelow, DatabaseAndGridAgreeWhereBothAre) {
    const test_support::BuiltDatabase built(test_support::make_rough_raster(65, 65));
    GeoidBelow with(&built.database), without(nullptr);
    for (const double east : {9.601, 9.62, 9.65}) {
        const double latitude = base::radians(47.08), longitude = base::radians(east);
        EXPECT_NEAR(with.at(latitude, longitude).m, without.at(latitude, longitude).m, 0.01);
        EXPECT_GT(without.at(latitude, longitude).m, 40) << "about 48 m over the Alps";
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_geoid_below
