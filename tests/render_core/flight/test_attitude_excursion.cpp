#include "render_core/flight/attitude_excursion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tedavis::flight::test_attitude_excursion {
namespace {

constexpr double degrees(double value) { return base::radians(value); }

TEST(AttitudeExcursion, RisesWithTheAngleAndFallsWithAPlay) {
    AttitudeExcursion excursion;
    excursion.step(degrees(31), degrees(-70));
    EXPECT_DOUBLE_EQ(excursion.pitch_up_rad, degrees(31));
    EXPECT_DOUBLE_EQ(excursion.bank_rad, degrees(70)) << "to either side";
    excursion.step(degrees(27), degrees(66));
    EXPECT_DOUBLE_EQ(excursion.pitch_up_rad, degrees(31));
    EXPECT_DOUBLE_EQ(excursion.bank_rad, degrees(70));
    excursion.step(degrees(24), degrees(-60));
    EXPECT_DOUBLE_EQ(excursion.pitch_up_rad, degrees(29));
    EXPECT_DOUBLE_EQ(excursion.bank_rad, degrees(65));
    excursion.step(degrees(-22), 0);
    EXPECT_DOUBLE_EQ(excursion.pitch_down_rad, degrees(22));
}

TEST(AttitudeExcursion, BeginsAnewAfterAnUnknownAngle) {
    AttitudeExcursion excursion;
    excursion.step(degrees(31), degrees(70));
    excursion.step(std::nan(""), degrees(68));
    EXPECT_EQ(excursion.pitch_up_rad, 0);
    EXPECT_DOUBLE_EQ(excursion.bank_rad, degrees(70));
    excursion.step(degrees(28), degrees(68));
    EXPECT_DOUBLE_EQ(excursion.pitch_up_rad, degrees(28));
}

/// A switch with two thresholds, as such a picture is usually described.
class TwoThresholds {
public:
    explicit TwoThresholds(double limit_rad) : limit_rad_(limit_rad) {}
    bool step(double angle_rad) {
        if (angle_rad > limit_rad_) is_on_ = true;
        if (angle_rad <= limit_rad_ - AttitudeExcursion::kPlay_rad) is_on_ = false;
        return is_on_;
    }

private:
    double limit_rad_;
    bool is_on_ = false;
};

TEST(AttitudeExcursion, IsASwitchWithTwoThresholdsForEveryLimit) {
    for (const double limit_deg : {20.0, 30.0, 65.0}) {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> change(-4, 4);
        TwoThresholds expected(degrees(limit_deg));
        AttitudeExcursion excursion;
        double angle_deg = limit_deg;
        int switched = 0;
        bool was_on = false;
        for (int n = 0; n < 20'000; ++n) {
            angle_deg = std::fabs(angle_deg + change(random));
            if (angle_deg > 2 * limit_deg) angle_deg = limit_deg;
            const bool is_on = expected.step(degrees(angle_deg));
            excursion.step(degrees(angle_deg), 0);
            ASSERT_EQ(excursion.pitch_up_rad > degrees(limit_deg), is_on) << angle_deg << " of " << limit_deg;
            switched += is_on != was_on ? 1 : 0;
            was_on = is_on;
        }
        EXPECT_GT(switched, 100) << "control: both states are reached often";
    }
}

}  // namespace
}  // namespace tedavis::flight::test_attitude_excursion
