/// What the failure policy is asked about: signals in every state, conditions, and what it decided.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "render_core/policy/failure_policy.hpp"

namespace tedavis::test_support {

inline constexpr base::Time kPolicyNow{1'000'000'000'000};

inline base::Stamped<double> signal_in_state(base::SignalState state, double value) {
    switch (state) {
        case base::SignalState::missing: return {};
        case base::SignalState::valid: return {value, kPolicyNow};
        case base::SignalState::stale: return {value, kPolicyNow - base::Duration::milliseconds(700)};
        case base::SignalState::lost: return {value, kPolicyNow - base::Duration::seconds(5)};
        case base::SignalState::invalid: return {value, kPolicyNow, base::Quality::bad};
    }
    return {};
}

inline double plausible_value(flight::Signal signal) {
    switch (signal) {
        case flight::Signal::horizontal_accuracy:
        case flight::Signal::vertical_accuracy: return 5;
        case flight::Signal::ground_speed:
        case flight::Signal::indicated_airspeed: return 60;
        case flight::Signal::baro_setting: return 101'325;
        case flight::Signal::navigation_source: return static_cast<double>(flight::NavigationSource::radio1);
        default: return 0.1;
    }
}

inline flight::AircraftState everything_valid() {
    flight::AircraftState state;
    for (std::size_t i = 0; i < flight::kSignalCount; ++i)
        state.signals[i] = signal_in_state(base::SignalState::valid, plausible_value(static_cast<flight::Signal>(i)));
    state.own_ship.state = base::SignalState::valid;
    state.own_ship.height_is_geometric = true;
    state.own_ship.velocity_north_mps = 60;
    state.own_ship.at = kPolicyNow;
    return state;
}

inline void put_signal(flight::AircraftState& state, flight::Signal signal, base::SignalState as) {
    state[signal] = signal_in_state(as, plausible_value(signal));
}

inline policy::DisplayConditions good_conditions() {
    policy::DisplayConditions conditions;
    conditions.terrain = policy::TerrainSource::ready;
    return conditions;
}

inline policy::DisplayDecisions decide_on(const flight::AircraftState& state,
                                          const policy::DisplayConditions& conditions = good_conditions()) {
    return policy::decide_display(state, kPolicyNow, conditions, design::default_design_settings());
}

inline std::vector<std::string> flags_of(const policy::DisplayDecisions& decisions) {
    std::vector<std::string> flags;
    for (const auto& flag : decisions.flags) flags.emplace_back(flag.view());
    return flags;
}
inline bool has_flag(const policy::DisplayDecisions& decisions, const std::string& name) {
    const auto flags = flags_of(decisions);
    return std::find(flags.begin(), flags.end(), name) != flags.end();
}
inline bool has_notice(const policy::DisplayDecisions& decisions, std::string_view text) {
    return std::any_of(decisions.notices.begin(), decisions.notices.end(),
                       [&](const policy::Notice& n) { return n.text.view() == text; });
}

inline constexpr base::SignalState kBadStates[] = {base::SignalState::missing, base::SignalState::stale, base::SignalState::lost,
                                                   base::SignalState::invalid};

inline policy::DisplayConditions map_conditions() {
    policy::DisplayConditions conditions = good_conditions();
    conditions.is_map = true;
    return conditions;
}

}  // namespace tedavis::test_support
