#include "host_sim/accuracy/negative_control.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/made_knob.hpp"

namespace tedavis::host_sim::test_negative_control {
namespace {

using ::testing::HasSubstr;

/// Two levels whose errors are given.
class TwoLevels final : public Knob {
public:
    TwoLevels(double wrong, double right) : Knob(test_support::made_facts({{"bad", 1}, {"good", 2}})), errors_{wrong, right} {}
    [[nodiscard]] std::size_t samples() const override { return 1; }
    void run(std::size_t, std::size_t) override {}
    void find_errors(std::size_t level, std::size_t, std::vector<double>& errors) override { errors.push_back(errors_[level]); }
    [[nodiscard]] std::string place_of(std::size_t, std::size_t) const override { return "here"; }

private:
    double errors_[2];
};

NegativeControl control(double wrong, double right) {
    TwoLevels knob(wrong, right);
    return measure_control(knob);
}

TEST(NegativeControl, IsCaughtFromTenTimesTheRightError) {
    EXPECT_TRUE(control(10, 1).is_caught);
    EXPECT_FALSE(control(9.9, 1).is_caught);
    EXPECT_TRUE(control(1e-8, 0).is_caught) << "ten times the reference's bound";
    EXPECT_FALSE(control(0.9e-8, 0).is_caught);
    EXPECT_FALSE(control(0, 0).is_caught);
}

TEST(NegativeControl, SaysWhetherItWasCaught) {
    EXPECT_THAT(control_text(control(40, 1)), HasSubstr("bad instead of good, is wrong by 40 m in the mean"));
    EXPECT_THAT(control_text(control(40, 1)), HasSubstr("the figures show that it is wrong"));
    EXPECT_THAT(control_text(control(2, 1)), HasSubstr("cannot be trusted"));
    EXPECT_EQ(control(40, 1).worst_place, "here");
}

}  // namespace
}  // namespace tedavis::host_sim::test_negative_control
