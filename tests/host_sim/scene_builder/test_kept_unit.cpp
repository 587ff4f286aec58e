#include "host_sim/scene_builder/kept_unit.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_kept_unit {
namespace {

void expect_kept(const std::string& stated, const std::string& unit, double factor, double offset) {
    const KeptUnit kept = kept_unit(stated);
    EXPECT_EQ(kept.unit, unit) << stated;
    EXPECT_NEAR(kept.factor, factor, 1e-9) << stated;
    EXPECT_EQ(kept.offset, offset) << stated;
}

TEST(KeptUnit, IsOfTheInternationalSystem) {
    expect_kept("m s**-1", "m/s", 1, 0);
    expect_kept("kt", "m/s", 1852.0 / 3600, 0);
    expect_kept("ft", "m", 0.3048, 0);
    expect_kept("deg", "rad", 0.017453292519943295, 0);
    expect_kept("C", "K", 1, 273.15);
    expect_kept("hPa", "Pa", 100, 0);
}

TEST(KeptUnit, WhatIsUnknownStays) {
    expect_kept("dBZ", "dBZ", 1, 0);
    expect_kept("", "", 1, 0);
    expect_kept("kilograms of snow", "", 1, 0);
}

TEST(UnitSuffix, IsTheEndOfAName) {
    const auto expect_parts = [](const std::string& column, const std::string& name, const std::string& unit) {
        EXPECT_EQ(unit_suffix(column).name, name);
        EXPECT_EQ(unit_suffix(column).unit, unit) << column;
    };
    expect_parts("height_m", "height", "m");
    expect_parts("top_ft", "top", "ft");
    expect_parts("wind_mps", "wind", "m/s");
    expect_parts("height", "height", "");
    expect_parts("_m", "_m", "");
    expect_parts("team", "team", "");
}

}  // namespace
}  // namespace tedavis::host_sim::test_kept_unit
