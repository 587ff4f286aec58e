#include "render_core/flight/phase_arbiter.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace tedavis::flight::test_phase_arbiter {
namespace {

constexpr FlightPhase kCruise{Scenario::cruise, 0};
constexpr FlightPhase kApproach{Scenario::approach, 0};
constexpr FlightPhase kGround{Scenario::ground, 0};
constexpr PhaseStatement kNothing{};

constexpr base::Time at_ms(std::int64_t ms) { return {1'700'000'000'000'000'000 + ms * 1'000'000}; }
constexpr PhaseStatement states(FlightPhase phase) { return {phase, true}; }

std::string shown(const PhaseStatus& status) {
    const std::string sub_phase = sub_phase_name(status.phase);
    return std::string(scenario_name(status.phase)) + (sub_phase.empty() ? "" : "." + sub_phase) + " " +
           to_string(status.source) + (status.disagreement ? " disagreement" : "") + (status.switch_fault ? " fault" : "");
}

class Arbiter {
public:
    PhaseInputs inputs;
    /// Updates every 50 ms from where it stands up to `ms`, inclusive; returns the last status. `each` sets inputs.
    std::string until(
        std::int64_t ms, const std::function<void(std::int64_t)>& each = [](std::int64_t) {}) {
        for (; now_ms_ <= ms; now_ms_ += 50) {
            each(now_ms_);
            last_ = shown(arbitrate_phase(inputs, at_ms(now_ms_), {}, state));
            if (history.empty() || history.back() != last_) history.push_back(last_);
        }
        return last_;
    }
    void can(FlightPhase phase, std::int64_t ms) { inputs.can = {phase, at_ms(ms)}; }
    PhaseArbiterState state;
    std::vector<std::string> history;

private:
    std::int64_t now_ms_ = 0;
    std::string last_;
};

TEST(PhaseArbiter, truth_table_of_authority) {
    for (int present = 0; present < 8; ++present) {
        Arbiter a;
        if ((present & 4) != 0) a.inputs.switches = states(kApproach);
        if ((present & 2) != 0) a.can(kCruise, 0);
        if ((present & 1) != 0) a.inputs.motion = states(kGround);
        const std::string expected = (present & 4) != 0   ? "approach switch"
                                     : (present & 2) != 0 ? "cruise can"
                                     : (present & 1) != 0 ? "ground motion"
                                                          : "unknown none";
        EXPECT_EQ(a.until(0), expected) << present << ": the first statement takes effect at once";
    }
}

TEST(PhaseArbiter, nothing_at_all_is_unknown_without_source) {
    Arbiter a;
    EXPECT_EQ(a.until(60'000), "unknown none");
    EXPECT_EQ(a.history.size(), 1u);
}

TEST(PhaseArbiter, a_switch_takes_effect_at_once_over_everything) {
    Arbiter a;
    a.can(kApproach, 0);
    a.until(1000);
    a.inputs.switches = states(kCruise);
    EXPECT_EQ(a.until(1050).substr(0, 13), "cruise switch");
}

TEST(PhaseArbiter, can_times_out_after_three_seconds_then_holds_then_is_lost) {
    Arbiter a;
    a.can(kCruise, 0);
    EXPECT_EQ(a.until(3000), "cruise can");
    EXPECT_EQ(a.until(3050), "cruise held");
    EXPECT_EQ(a.until(13'000), "cruise held") << "ten seconds since it was last stated";
    EXPECT_EQ(a.until(13'050), "unknown none");
}

TEST(PhaseArbiter, a_can_message_from_the_future_or_marked_bad_states_nothing) {
    Arbiter a;
    a.inputs.can = {kCruise, at_ms(10'000)};
    EXPECT_EQ(a.until(0), "unknown none");
    a.inputs.can = {kCruise, at_ms(0), base::Quality::bad};
    EXPECT_EQ(a.until(100), "unknown none");
}

TEST(PhaseArbiter, can_that_says_unknown_leaves_the_phase_to_motion_but_motion_that_says_unknown_is_heard) {
    Arbiter a;
    a.can(FlightPhase{}, 0);
    a.inputs.motion = states(kGround);
    EXPECT_EQ(a.until(0), "ground motion");
    Arbiter b;
    b.inputs.motion = states(kCruise);
    b.until(1000);
    b.inputs.motion = states(FlightPhase{});
    EXPECT_EQ(b.until(1050), "unknown motion") << "at once, because it turns to terrain";
}

TEST(PhaseArbiter, motion_takes_over_from_can_after_its_dwell) {
    Arbiter a;
    a.can(kCruise, 0);
    a.inputs.motion = states(kCruise);
    a.until(3000);
    a.inputs.motion = states(kApproachDescent);
    EXPECT_EQ(a.until(5000).substr(0, 11), "cruise held");
    EXPECT_EQ(a.until(5050), "approach.descent motion");
}

TEST(PhaseArbiter, every_change_of_a_phase_needs_its_dwell_except_towards_terrain) {
    Arbiter a;
    a.inputs.motion = states(kTakeoffFirstClimb);
    a.until(1000);
    a.inputs.motion = states(kTakeoffSecondClimb);
    EXPECT_EQ(a.until(3000), "takeoff.first_climb motion");
    EXPECT_EQ(a.until(3050), "takeoff.second_climb motion");
    a.inputs.motion = states(kCruise);
    EXPECT_EQ(a.until(5050), "takeoff.second_climb motion");
    EXPECT_EQ(a.until(5100), "cruise motion");
    a.inputs.motion = states(kApproachDescent);
    EXPECT_EQ(a.until(5150), "approach.descent motion");
}

TEST(PhaseArbiter, a_single_contrary_message_changes_nothing) {
    Arbiter a;
    a.until(10'000, [&](std::int64_t ms) { a.can(ms == 5000 ? kApproachLanding : kApproachFinal, ms); });
    EXPECT_EQ(a.history, std::vector<std::string>{"approach.final can"});
}

TEST(PhaseArbiter, two_senders_that_alternate_do_not_flicker) {
    Arbiter a;
    a.until(60'000, [&](std::int64_t ms) { a.can(ms / 500 % 2 == 0 ? kCruise : kApproach, ms); });
    EXPECT_EQ(a.history, (std::vector<std::string>{"cruise can", "approach can"})) << "it settles on the one that shows terrain";
}

TEST(PhaseArbiter, can_at_the_edge_of_its_timeout_does_not_flicker_with_motion) {
    Arbiter a;
    a.inputs.motion = states(kApproach);
    a.until(60'000, [&](std::int64_t ms) {
        if (ms % 3200 == 0) a.can(kCruise, ms);
    });
    for (const std::string& seen : a.history) EXPECT_EQ(seen.substr(0, 6), "cruise") << seen;
}

TEST(PhaseArbiter, a_switch_fault_is_passed_on_with_the_kept_phase_and_without_one) {
    Arbiter a;
    a.inputs.switches = states(kApproach);
    a.inputs.switch_fault = true;
    EXPECT_EQ(a.until(0), "approach switch fault");
    Arbiter b;
    b.inputs.switch_fault = true;
    EXPECT_EQ(b.until(0), "unknown none fault");
    b.inputs.motion = states(kGround);
    EXPECT_EQ(b.until(50), "ground motion fault");
}

TEST(PhaseArbiter, disagreement_rises_and_falls_with_a_dwell) {
    Arbiter a;
    a.inputs.switches = states(kCruise);
    a.inputs.motion = states(kApproach);
    EXPECT_EQ(a.until(1950), "cruise switch");
    EXPECT_EQ(a.until(2000), "cruise switch disagreement");
    a.inputs.motion = states(kCruise);
    EXPECT_EQ(a.until(4000), "cruise switch disagreement");
    EXPECT_EQ(a.until(4050), "cruise switch");
    EXPECT_EQ(a.history.size(), 3u);
}

/// Seconds until the flag rises when a switch turns from what motion states to another scenario; -1 when it does not.
double seconds_to_the_flag(Scenario motion, Scenario switched) {
    Arbiter a;
    a.inputs.motion = states({motion, 0});
    a.inputs.switches = a.inputs.motion;
    a.until(950);
    a.inputs.switches = states({switched, 0});
    for (std::int64_t ms = 1000; ms <= 61'000; ms += 50)
        if (a.until(ms).find("disagreement") != std::string::npos) return static_cast<double>(ms - 1000) / 1000;
    return -1;
}

TEST(PhaseArbiter, a_source_that_is_only_late_contradicts_after_the_time_that_the_passage_takes) {
    using S = Scenario;
    // Rows: what motion still states; columns: what the switch says. Ground, take-off, cruise, approach, go-around.
    constexpr S kAll[] = {S::ground, S::takeoff, S::cruise, S::approach, S::go_around};
    constexpr double kSeconds[5][5] = {{-1, 20, 2, 2, 2},  //
                                       {20, -1, 40, 20, 2},
                                       {2, 2, -1, 20, 2},
                                       {20, 20, 2, -1, 20},
                                       {2, 2, 40, 40, -1}};
    for (int motion = 0; motion < 5; ++motion)
        for (int switched = 0; switched < 5; ++switched)
            EXPECT_EQ(seconds_to_the_flag(kAll[motion], kAll[switched]), kSeconds[motion][switched]) << motion << " " << switched;
}

TEST(PhaseArbiter, motion_that_stays_in_cruise_through_an_approach_for_30_s_is_a_disagreement) {
    Arbiter a;
    a.inputs.switches = states(kApproach);
    a.inputs.motion = states(kCruise);
    EXPECT_EQ(a.until(30'000), "approach switch disagreement");
}

TEST(PhaseArbiter, the_allowance_is_counted_anew_for_the_next_scenario_only) {
    Arbiter a;
    a.inputs.motion = states(kTakeoffSecondClimb);
    a.inputs.switches = states(kCruise);
    a.until(34'950);
    a.inputs.switches = states(kApproachDescent);
    a.until(44'950);
    a.inputs.switches = states(kApproachInitial);
    EXPECT_EQ(a.until(54'950), "approach.initial switch");
    EXPECT_EQ(a.until(55'000), "approach.initial switch disagreement") << "20 s in approach, whatever its phases";
}

TEST(PhaseArbiter, a_late_source_does_not_hurry_another) {
    Arbiter a;
    a.inputs.switches = states(kApproach);
    a.inputs.motion = states(kCruise);
    a.until(15'000, [&](std::int64_t ms) {
        if (ms >= 14'000) a.can(kGround, ms);
    });
    EXPECT_EQ(a.history, std::vector<std::string>{"approach switch"});
    EXPECT_EQ(a.until(16'000, [&](std::int64_t ms) { a.can(kGround, ms); }), "approach switch disagreement");
}

TEST(PhaseArbiter, another_sub_phase_or_no_statement_or_unknown_is_no_disagreement) {
    for (const PhaseStatement motion : {states(kApproachFinal), kNothing, states(FlightPhase{})}) {
        Arbiter a;
        a.inputs.switches = states(kApproach);
        a.inputs.motion = motion;
        EXPECT_EQ(a.until(10'000), "approach switch");
    }
}

TEST(PhaseArbiter, a_bouncing_contradiction_raises_no_flag) {
    Arbiter a;
    a.inputs.switches = states(kCruise);
    a.until(30'000, [&](std::int64_t ms) { a.inputs.motion = ms / 1000 % 2 == 0 ? states(kApproach) : kNothing; });
    EXPECT_EQ(a.history, std::vector<std::string>{"cruise switch"});
}

TEST(PhaseArbiter, turning_the_switch_to_auto_hands_over_after_the_dwell) {
    Arbiter a;
    a.inputs.switches = states(kApproach);
    a.until(1000, [&](std::int64_t ms) { a.can(kCruise, ms); });
    a.inputs.switches = kNothing;
    EXPECT_EQ(a.until(2000, [&](std::int64_t ms) { a.can(kCruise, ms); }), "approach held");
    EXPECT_EQ(a.until(2050, [&](std::int64_t ms) { a.can(kCruise, ms); }), "cruise can");
}

TEST(PhaseArbiter, sources_that_never_settle_are_heard_when_the_hold_is_over) {
    Arbiter a;
    a.inputs.motion = states(kGround);
    a.until(0);
    const FlightPhase restless[] = {kTakeoffStart, kTakeoffFirstClimb};
    a.until(9'950, [&](std::int64_t ms) { a.inputs.motion = states(restless[ms / 100 % 2]); });
    EXPECT_EQ(a.history, std::vector<std::string>{"ground motion"});
    a.until(20'000, [&](std::int64_t ms) { a.inputs.motion = states(restless[ms / 100 % 2]); });
    EXPECT_EQ(a.history.size(), 2u) << "one of them is taken and kept";
}

TEST(PhaseArbiter, a_scripted_flight_with_all_sources) {
    Arbiter a;
    const auto script = [&](std::int64_t ms) {
        a.inputs.motion = ms < 20'000 ? states(kGround) : ms < 40'000 ? states(kTakeoffFirstClimb) : states(kCruise);
        if (ms >= 60'000 && ms <= 80'000 && ms % 1000 == 0) a.can(kApproachInitial, ms);
        if (ms >= 90'000) a.inputs.switches = states(kGoAroundAbort);
        if (ms >= 100'000) a.inputs.switches = states(kGoAroundReplanning);
    };
    a.until(110'000, script);
    EXPECT_EQ(a.history,
              (std::vector<std::string>{"ground motion", "takeoff.first_climb motion", "cruise motion", "approach.initial can",
                                        "approach.initial can disagreement", "approach.initial held disagreement",
                                        "cruise motion", "go_around.abort switch", "go_around.abort switch disagreement",
                                        "go_around.replanning switch disagreement"}));
}

TEST(PhaseArbiter, time_that_runs_back_starts_anew_and_a_saved_state_goes_on) {
    PhaseArbiterState state;
    PhaseInputs inputs;
    inputs.motion = states(kCruise);
    static_cast<void>(arbitrate_phase(inputs, at_ms(10'000), {}, state));
    PhaseArbiterState saved = state;
    inputs.motion = kNothing;
    EXPECT_EQ(shown(arbitrate_phase(inputs, at_ms(5'000), {}, state)), "unknown none");
    EXPECT_EQ(shown(arbitrate_phase(inputs, at_ms(12'000), {}, saved)), "cruise held");
}

}  // namespace
}  // namespace tedavis::flight::test_phase_arbiter
