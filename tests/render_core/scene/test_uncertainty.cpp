#include "render_core/scene/uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "tests/support/files/hard_case.hpp"

namespace tedavis::scene::test_uncertainty {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Uncertainty level(double value) { return Uncertainty::from_level(value); }

TEST(Uncertainty, UnknownUnlessStated) {
    EXPECT_FALSE(Uncertainty().is_known());
    EXPECT_EQ(Uncertainty().level(), 1) << "as conspicuous as the least sure";
}

/// The naive form, a cast. Of NaN it makes the least int on x86 and 0 on AArch64: both are the code 0, certain. Levels above 1
/// and below 0 wrap.
std::uint8_t cast_code(float value) {
    const double scaled = std::isnan(value) ? double{std::numeric_limits<int>::min()} : double{value} * Uncertainty::kFull;
    const double within = std::fmax(std::fmin(scaled, std::numeric_limits<int>::max()), std::numeric_limits<int>::min());
    return static_cast<std::uint8_t>(static_cast<int>(within));
}

/// By how much a code looks more certain than a value is; what is below 0 or no number is as uncertain as can be.
double too_certain(const Uncertainty& u, float value) {
    const double least = value >= 0 ? std::fmin(double{value}, 1) : 1;
    return std::fmax(least - u.level(), 0);
}

/// Every 61st bit pattern of a float, all exponents and both signs among them: nothing out of range, and NaN is never certain.
TEST(Uncertainty, FromAnyFloat) {
    std::uint64_t unknown = 0, known = 0, cast_certain = 0;
    double worst = 0, worst_cast = 0;
    for (std::uint64_t bits = 0; bits < (std::uint64_t{1} << 32); bits += 61) {
        const auto pattern = static_cast<std::uint32_t>(bits);
        float value = 0;
        std::memcpy(&value, &pattern, sizeof value);
        const Uncertainty u = level(double{value}), cast = Uncertainty::from_code(cast_code(value));
        worst = std::fmax(worst, too_certain(u, value));
        worst_cast = std::fmax(worst_cast, too_certain(cast, value));
        cast_certain += std::isnan(value) && cast == level(0) ? 1 : 0;
        const bool should_be_known = !std::isnan(value) && value >= 0;
        ASSERT_EQ(u.is_known(), should_be_known) << value;
        if (!should_be_known) {
            ++unknown;
            continue;
        }
        ++known;
        const double clamped = std::fmin(double{value}, 1);
        ASSERT_GE(u.level(), clamped - 1e-9) << "nothing looks more certain than it is";
        ASSERT_LE(u.level(), clamped + 1.0 / Uncertainty::kFull);
    }
    EXPECT_GT(unknown, 30'000'000u);
    EXPECT_GT(known, 30'000'000u);
    EXPECT_LE(worst, 1e-9);
    EXPECT_EQ(worst_cast, 1) << "control: nothing is more certain than what a cast makes of what is unknown";
    EXPECT_GT(cast_certain, 100'000u) << "NaN among it";
    test_support::record_worst("A36", worst);
    test_support::record_control("A36", worst_cast);
}

TEST(Uncertainty, CodesComeBackAsTheyAre) {
    for (int code = 0; code < 255; ++code) {
        const Uncertainty u = Uncertainty::from_code(static_cast<std::uint8_t>(code));
        EXPECT_EQ(level(u.level()), u) << code;
    }
    EXPECT_EQ(level(1), Uncertainty::from_code(Uncertainty::kFull));
    EXPECT_EQ(level(0), Uncertainty::from_code(0));
    EXPECT_FALSE(level(-1e-12).is_known());
}

TEST(Uncertainty, GrowsWithAgeAndNeverShrinks) {
    const Uncertainty fresh = level(0.2);
    EXPECT_EQ(aged(fresh, {}, 0.1), fresh);
    EXPECT_NEAR(aged(fresh, base::Duration::seconds(7200), 0.1).level(), 0.4, 1.0 / 254);
    EXPECT_EQ(aged(fresh, base::Duration::seconds(-7200), 0.1), aged(fresh, base::Duration::seconds(7200), 0.1))
        << "a forecast is the less sure the farther off it is";
    EXPECT_EQ(aged(fresh, base::Duration::seconds(1'000'000'000), 0.1).level(), 1);
    for (int minutes = 1; minutes < 600; ++minutes)
        EXPECT_GE(aged(fresh, base::Duration::seconds(60 * minutes), 0.05).code(),
                  aged(fresh, base::Duration::seconds(60 * (minutes - 1)), 0.05).code());
    EXPECT_FALSE(aged({}, {}, 0).is_known()) << "what is unknown does not become known";
    EXPECT_FALSE(aged(fresh, {}, kNan).is_known());
    EXPECT_FALSE(aged(fresh, {}, -0.1).is_known());
}

TEST(Uncertainty, TheWorseOfTwo) {
    EXPECT_EQ(worse(level(0.2), level(0.6)), level(0.6));
    EXPECT_EQ(worse(level(0.6), level(0.2)), level(0.6));
    EXPECT_FALSE(worse(level(1), {}).is_known()) << "unknown is worse than any level";
}

}  // namespace
}  // namespace tedavis::scene::test_uncertainty
