// Alerts are found before the run by the very intervals that its frames show; the oracle is a run of all frames.
#include "host_sim/replay/flight_events.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "host_sim/user_error.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_flight_events {
namespace {

/// The flight of flown_circle.hpp, but level and low, so that the ground comes up ahead of it.
class FlownLow final : public test_support::FlownCircle {
public:
    [[nodiscard]] base::Time end() const override { return begin() + base::Duration::seconds(20); }
    [[nodiscard]] std::optional<SignalSample> at(base::Time time) const override {
        using flight::Signal;
        auto sample = FlownCircle::at(time);
        const double s = (time - begin()).to_seconds();
        (*sample)[Signal::latitude] = base::radians(47.0) + 60 * s / 6.37e6;
        (*sample)[Signal::longitude] = base::radians(9.68);
        (*sample)[Signal::true_track] = (*sample)[Signal::true_heading] = 0;
        (*sample)[Signal::ellipsoid_height] = 1900 - 8 * s;
        (*sample)[Signal::vertical_speed] = -8;
        return sample;
    }
};

struct Flown {
    test_support::FlownFiles files{FlownLow()};
    ReplayOptions asked = files.options("unused");
    DisplaySession session{asked.picture, false};
    FlightPlayer player{{asked.log, asked.picture.bus, asked.switches, asked.switch_config}, session.display()};
    FramePreroll preroll{player, session, session.device().frame_rate_hz};
    TimeRanges whole{{player.first(), player.last()}};
};

TEST(FlightEvents, AlertsBeginWhereTheFramesOfARunShowThem) {
    std::vector<base::Time> alerts;
    {
        Flown flown;
        alerts = alert_instants(flown.preroll, flown.whole);
    }
    ASSERT_FALSE(alerts.empty()) << "the ground comes up";
    std::vector<base::Time> begun;
    auto before = policy::TerrainAhead::none;
    Flown run;
    for (base::Time time = run.whole[0].from; time <= run.whole[0].to; time = time + base::Duration::milliseconds(100)) {
        EXPECT_TRUE(run.preroll.preroll(time));
        const flight::FrameInput input = run.player.at(time);
        run.session.display().plan({input.state, input.phase, time, input.trail, input.legend});
        const auto alert = run.session.display().memory().boost.terrain_ahead();
        if (alert > before) begun.push_back(time);
        before = alert;
    }
    ASSERT_EQ(alerts.size(), begun.size());
    for (std::size_t n = 0; n < alerts.size(); ++n) {
        EXPECT_LE(alerts[n], begun[n]);
        EXPECT_LT(begun[n] - alerts[n], base::Duration::milliseconds(101)) << "the first frame drawn since";
    }
}

TEST(FlightEvents, AreThoseOfTheRangeInOrder) {
    Flown flown;
    const std::vector<base::Time> all = event_instants(flown.player, flown.preroll, flown.whole, 100);
    EXPECT_TRUE(std::is_sorted(all.begin(), all.end()));
    for (const base::Time change : flown.player.outline().phase_changes())
        EXPECT_EQ(std::count(all.begin(), all.end(), change), 1);
    const base::Time middle = all[all.size() / 2];
    const auto expected =
        static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [&](base::Time time) { return time >= middle; }));
    EXPECT_EQ(event_instants(flown.player, flown.preroll, {{middle, flown.whole[0].to}}, 100).size(), expected);
}

TEST(FlightEvents, ALookAheadTellsHowFarItIsAndCanBeEnded) {
    Flown flown;
    std::vector<base::Time> told;
    (void)alert_instants(flown.preroll, flown.whole, [&](base::Time time) { told.push_back(time); });
    EXPECT_EQ(told.front(), flown.whole[0].from);
    EXPECT_GT(told.back(), flown.whole[0].to - base::Duration::seconds(1));
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    std::size_t calls = 0;
    const auto end_at_third = [&](base::Time) {
        if (++calls == 3) throw Interrupted("enough");
    };
    EXPECT_THROW((void)alert_instants(flown.preroll, flown.whole, end_at_third), Interrupted);
    EXPECT_EQ(calls, 3u);
}

TEST(FlightEvents, OfSeveralPartsAreThoseInThem) {
    Flown flown;
    const std::vector<base::Time> all = event_instants(flown.player, flown.preroll, flown.whole, 100);
    ASSERT_GE(all.size(), 2u);
    const TimeRanges ends{{all.front(), all.front()}, {all.back(), flown.whole[0].to}};
    EXPECT_EQ(event_instants(flown.player, flown.preroll, ends, 100), (std::vector<base::Time>{all.front(), all.back()}));
}

TEST(FlightEvents, OfTooManyAlertsComeFirst) {
    Flown flown;
    const std::vector<base::Time> alerts = alert_instants(flown.preroll, flown.whole);
    const std::vector<base::Time> one = event_instants(flown.player, flown.preroll, flown.whole, 1);
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(std::count(alerts.begin(), alerts.end(), one[0]), 1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_events
