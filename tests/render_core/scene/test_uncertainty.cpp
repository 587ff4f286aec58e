#include "render_core/scene/uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace tedavis::scene::test_uncertainty {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Uncertainty level(double value) { return Uncertainty::from_level(value); }

TEST(Uncertainty, UnknownUnlessStated) {
    EXPECT_FALSE(Uncertainty().is_known());
    EXPECT_EQ(Uncertainty().level(), 1) << "as conspicuous as the least sure";
}

/// Every 61st bit pattern of a float, all exponents and both signs among them: nothing out of range, and NaN is never certain.
TEST(Uncertainty, FromAnyFloat) {
    std::uint64_t unknown = 0, known = 0;
    for (std::uint64_t bits = 0; bits < (std::uint64_t{1} << 32); bits += 61) {
        const auto pattern = static_cast<std::uint32_t>(bits);
        float value = 0;
        std::memcpy(&value, &pattern, sizeof value);
        const Uncertainty u = level(double{value});
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
