#include "render_core/scene/member_choice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace tedavis::scene::test_member_choice {
namespace {

TEST(MemberChoice, IsEvenWithTheFirstAndTheLast) {
    for (std::uint32_t count = 2; count <= 16; ++count)
        for (std::uint32_t shown = 2; shown <= count; ++shown) {
            std::set<std::uint32_t> chosen;
            for (std::uint32_t n = 0; n < shown; ++n) {
                const std::uint32_t member = spaced_member(n, shown, count);
                EXPECT_EQ(member, std::lround(static_cast<double>(n) * (count - 1) / (shown - 1)));
                chosen.insert(member);
            }
            EXPECT_EQ(chosen.size(), shown) << "none twice";
            EXPECT_EQ(*chosen.begin(), 0u);
            EXPECT_EQ(*chosen.rbegin(), count - 1);
        }
    EXPECT_EQ(spaced_member(0, 1, 9), 4u) << "one alone is the middle one";
}

TEST(MemberChoice, TurnsFollowTheTimeAlone) {
    constexpr std::int64_t kStep_ns = 2'500'000'000;
    for (std::int64_t time_ns = -40'000'000'000; time_ns < 40'000'000'000; time_ns += 700'000'001) {
        const double steps = std::floor(static_cast<double>(time_ns) / 2.5e9);
        EXPECT_EQ(member_turn(time_ns, kStep_ns, 9), static_cast<std::uint32_t>(steps - 9 * std::floor(steps / 9))) << time_ns;
        const std::int64_t next_ns = next_turn_ns(time_ns, kStep_ns);
        EXPECT_GT(next_ns, time_ns);
        EXPECT_LE(next_ns - time_ns, kStep_ns);
        EXPECT_EQ(member_turn(next_ns - 1, kStep_ns, 9), member_turn(time_ns, kStep_ns, 9));
        EXPECT_NE(member_turn(next_ns, kStep_ns, 9), member_turn(time_ns, kStep_ns, 9));
    }
    EXPECT_EQ(member_turn(12'345, kStep_ns, 1), 0u);
}

}  // namespace
}  // namespace tedavis::scene::test_member_choice
