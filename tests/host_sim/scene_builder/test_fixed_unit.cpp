#include "host_sim/scene_builder/fixed_unit.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_fixed_unit {
namespace {

using scene::LayerRole;

TEST(FixedUnit, WhatIsReadByItsNameHasOne) {
    EXPECT_EQ(fixed_unit(LayerRole::wind, "east"), "m/s");
    EXPECT_EQ(fixed_unit(LayerRole::obstacle, "height"), "m");
    EXPECT_EQ(fixed_unit(LayerRole::building, "height"), "m");
    EXPECT_EQ(fixed_unit(LayerRole::no_go, "ceiling"), "m");
    EXPECT_EQ(fixed_unit(LayerRole::airspace, "floor"), "m");
    EXPECT_EQ(fixed_unit(LayerRole::storm_cell, "speed"), "m/s");
    EXPECT_EQ(fixed_unit(LayerRole::storm_cell, "toward"), "rad");
    EXPECT_EQ(fixed_unit(LayerRole::trajectory, "position_accuracy"), "m");
    EXPECT_EQ(fixed_unit(LayerRole::model, "heading"), "rad");
    EXPECT_EQ(fixed_unit(LayerRole::runway, "width"), "m");
}

TEST(FixedUnit, OthersMeanWhatTheFileSays) {
    EXPECT_EQ(fixed_unit(LayerRole::trajectory, "height"), "") << "the line's own points say where it is";
    EXPECT_EQ(fixed_unit(LayerRole::sample, "height"), "");
    EXPECT_EQ(fixed_unit(LayerRole::field, "speed"), "");
    EXPECT_EQ(fixed_unit(LayerRole::wind, "speed"), "");
    EXPECT_EQ(fixed_unit(LayerRole::obstacle, "heigh"), "");
    EXPECT_EQ(fixed_unit(LayerRole::no_go, "floor_datum"), "");
}

TEST(FixedUnit, KnownUnitsHaveTheirFactor) {
    EXPECT_DOUBLE_EQ(factor_between("ft", "m").value(), 0.3048);
    EXPECT_DOUBLE_EQ(factor_between("NM", "m").value(), 1852);
    EXPECT_DOUBLE_EQ(36 * factor_between("kt", "m/s").value(), 18.52);
    EXPECT_DOUBLE_EQ(36 * factor_between("km/h", "m/s").value(), 10);
    EXPECT_DOUBLE_EQ(180 * factor_between("deg", "rad").value(), 3.14159265358979323846);
    EXPECT_FALSE(factor_between("furlong", "m").has_value());
    EXPECT_FALSE(factor_between("ft", "m/s").has_value()) << "a height is no speed";
}

}  // namespace
}  // namespace tedavis::host_sim::test_fixed_unit
