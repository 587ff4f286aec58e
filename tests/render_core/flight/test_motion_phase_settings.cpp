#include "render_core/flight/motion_phase_settings.hpp"

#include <gtest/gtest.h>

#include "render_core/base/units.hpp"

namespace tedavis::flight::test_motion_phase_settings {
namespace {

constexpr AircraftClass kClasses[] = {AircraftClass::light, AircraftClass::jet, AircraftClass::helicopter, AircraftClass::glider,
                                      AircraftClass::unstated};

TEST(MotionPhaseSettings, EveryClassHasANameOfItsOwn) {
    ASSERT_EQ(std::size(kClasses), kAircraftClassNames.size() + 1);
    for (std::size_t n = 0; n < kAircraftClassNames.size(); ++n) {
        EXPECT_EQ(static_cast<std::size_t>(kClasses[n]), n);
        for (std::size_t other = 0; other < n; ++other) EXPECT_NE(kAircraftClassNames[n], kAircraftClassNames[other]);
    }
}

/// Heights at which phases follow each other must be in their order, or a flight would skip one.
TEST(MotionPhaseSettings, HeightsAndSpeedsAreInOrder) {
    for (const AircraftClass aircraft : kClasses) {
        const MotionPhaseSettings s = motion_phase_settings(aircraft);
        const auto name = static_cast<int>(aircraft);
        EXPECT_LT(s.standing_speed_mps, s.takeoff_run_speed_mps) << name;
        EXPECT_LT(s.takeoff_run_speed_mps, s.takeoff_speed_mps) << name;
        EXPECT_LT(s.lift_off_height_m + s.terrain_height_margin_m, s.final_height_m) << name;
        EXPECT_LT(s.final_height_m, s.initial_height_m) << name;
        EXPECT_LT(s.terrain_priority_height_m, s.cruise_height_m) << name;
        EXPECT_LT(s.initial_height_m, s.cruise_height_m) << name << ": an approach is no cruise";
        EXPECT_LE(s.level_mps + s.level_hysteresis_mps, s.descent_mps) << name << ": nothing is level and a descent";
        EXPECT_GE(s.terrain_priority_height_m, 1500 * base::kMetresPerFoot - 1e-6) << name;
    }
}

}  // namespace
}  // namespace tedavis::flight::test_motion_phase_settings
