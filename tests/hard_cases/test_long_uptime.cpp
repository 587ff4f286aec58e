// A display that has run for sixty days shows a flight as one that was just started: the same bytes on the bus and the same edges
// of the switches, only with later stamps, give the same pictures, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "host_sim/replay/flight_player.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/files/hard_case.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/default_flight.hpp"

namespace tedavis::test_long_uptime {
namespace {

constexpr std::uint32_t kWidth = 320, kHeight = 240;
constexpr double kStep_s = 12, kFrame_s = 1.0 / 30;
constexpr int kFramesOfMoment = 3;
/// Sixty days and four seconds: whole turns of the activity mark's hand, which goes round in seven.
constexpr std::int64_t kLater_s = 60 * 86'400 + 4;
static_assert(kLater_s % 7 == 0);

using Picture = std::vector<std::uint8_t>;

class LongUptime : public ::testing::Test {
protected:
    std::vector<Picture> flown(std::int64_t later_s) {
        test_support::HeadlessDisplay headless("egl", "es3-mid", kWidth, kHeight, &terrain_.bytes);
        host_sim::FlightPlayer player(
            {folder_.write("flight.log", test_support::seconds_later(flight_.log, later_s)), "canaerospace",
             folder_.write("flight.switches", test_support::seconds_later(flight_.switch_log, later_s)), "one_hot"},
            headless.display());
        std::vector<Picture> pictures;
        for (double at_s = 0; player.first() + base::Duration::from_seconds(at_s) < player.last(); at_s += kStep_s)
            for (int n = 0; n < kFramesOfMoment; ++n) {
                const base::Time now = player.first() + base::Duration::from_seconds(at_s + n * kFrame_s);
                headless.display().plan(player.at(now));
                pictures.push_back(test_support::drawn_pixels(headless));
            }
        return pictures;
    }

    const test_support::RecordedFlight flight_ = test_support::default_flight();
    test_support::DefaultTerrain terrain_;
    const test_support::TemporaryFolder folder_;
};

double different(const std::vector<Picture>& a, const std::vector<Picture>& b) {
    double count = std::fabs(static_cast<double>(a.size()) - static_cast<double>(b.size()));
    for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n) count += a[n] != b[n];
    return count;
}

TEST_F(LongUptime, SixtyDaysLaterThePicturesAreTheSame) {
    const std::vector<Picture> now = flown(0);
    ASSERT_GT(now.size(), 80u);
    EXPECT_EQ(different(now, flown(kLater_s)), 0);
    EXPECT_GT(different(now, flown(kLater_s + 1)), 0) << "control: the mark's hand stands elsewhere";
}

/// Times between two frames are off by so many milliseconds: of the display's time, and of seconds as a float, the naive form.
TEST(UptimeClock, SecondsAsAFloatLoseTheFrame) {
    double ours_ms = 0, naive_ms = 0;
    for (int n = 0; n < 1000; ++n) {
        const base::Time now = base::Time{0} + base::Duration::from_seconds(kLater_s + n * kFrame_s);
        const base::Time next = now + base::Duration::from_seconds(kFrame_s);
        ours_ms = std::max(ours_ms, 1000 * std::fabs((next - now).to_seconds() - kFrame_s));
        const auto before = static_cast<float>(now.ns * 1e-9), after = static_cast<float>(next.ns * 1e-9);
        naive_ms = std::max(naive_ms, 1000 * std::fabs(static_cast<double>(after - before) - kFrame_s));
    }
    EXPECT_LT(ours_ms, 1e-5);
    EXPECT_GT(naive_ms, 100);
    test_support::record_worst("A55", ours_ms);
    test_support::record_control("A55", naive_ms);
}

}  // namespace
}  // namespace tedavis::test_long_uptime
