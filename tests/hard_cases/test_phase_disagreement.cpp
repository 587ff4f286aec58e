// A caution that is on in ordinary flight is not heeded when it matters. The default flight has every phase, stated by
// panel, bus and motion in turn, and nobody in it is wrong for long.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "host_sim/replay/flight_player.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/default_flight.hpp"

namespace tedavis::host_sim::test_phase_disagreement {
namespace {

/// Seconds of the flight.
struct Lit {
    double from_s, to_s;
    double differed_s;  ///< how long motion had stated another scenario than the one in effect
};

/// The default flight in steps of 20 ms, with motion detected once more beside the player.
class Flown {
public:
    Flown()
        : flight_(test_support::default_flight()),
          headless_("egl", "es3-mid", 64, 64, &terrain_.bytes),
          player_({folder_.write("flight.log", flight_.log), "canaerospace", folder_.write("flight.switches", flight_.switch_log),
                   "one_hot"},
                  headless_.display()) {}

    [[nodiscard]] double length_s() const { return (player_.last() - player_.first()).to_seconds(); }

    /// The panel as it was at `second` for the rest of the flight.
    void leave_the_panel_from(double second) {
        player_.replace_switches_after(player_.first() + base::Duration::from_seconds(second), {});
    }

    [[nodiscard]] std::vector<Lit> disagreements() {
        std::vector<Lit> all;
        flight::MotionPhaseState motion;
        std::optional<base::Time> differs_since;
        bool was_lit = false;
        for (base::Time now = player_.first(); now <= player_.last(); now = now + base::Duration::milliseconds(20)) {
            const flight::FrameInput instant = player_.at(now);
            const flight::PhaseStatement moved = flight::detect_motion_phase(instant.state, now, {}, motion);
            const bool differs = moved.stated && moved.phase.scenario != instant.phase.phase.scenario;
            if (!differs) differs_since.reset();
            if (differs && !differs_since) differs_since = now;
            const double second = (now - player_.first()).to_seconds();
            if (instant.phase.disagreement && !was_lit)
                all.push_back({second, second, differs_since ? (now - *differs_since).to_seconds() : 0});
            if (instant.phase.disagreement) all.back().to_s = second;
            was_lit = instant.phase.disagreement;
        }
        return all;
    }

private:
    test_support::TemporaryFolder folder_;
    test_support::RecordedFlight flight_;
    test_support::DefaultTerrain terrain_;
    test_support::HeadlessDisplay headless_;
    FlightPlayer player_;
};

TEST(PhaseDisagreement, is_lit_in_the_default_flight_only_where_scenarios_differ_for_long) {
    Flown flown;
    double lit_s = 0;
    for (const Lit& lit : flown.disagreements()) {
        EXPECT_GE(lit.differed_s, 20) << "from " << lit.from_s << " s";
        lit_s += lit.to_s - lit.from_s;
    }
    EXPECT_LT(lit_s, 0.05 * flown.length_s());
}

TEST(PhaseDisagreement, is_lit_when_the_panel_is_left_at_cruise_through_the_approach) {
    constexpr double kCruise_s = 120, kBusSaysDescent_s = 135.3, kEndOfGoodApproach_s = 252;
    Flown flown;
    flown.leave_the_panel_from(kCruise_s);
    double lit_s = 0;
    for (const Lit& lit : flown.disagreements()) {
        EXPECT_GE(lit.from_s, kBusSaysDescent_s);
        lit_s += std::min(lit.to_s, kEndOfGoodApproach_s) - std::min(lit.from_s, kEndOfGoodApproach_s);
    }
    EXPECT_GT(lit_s, 0.95 * (kEndOfGoodApproach_s - kBusSaysDescent_s));
}

}  // namespace
}  // namespace tedavis::host_sim::test_phase_disagreement
