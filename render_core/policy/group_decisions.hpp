/// What is known of each group of signals in one frame: the states of its sources, and the element's decision that follows from
/// them by the table of signal_rules.hpp.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/base/time.hpp"
#include "render_core/flight/aircraft_state.hpp"
#include "render_core/policy/display_decisions.hpp"
#include "render_core/policy/signal_rules.hpp"

namespace tedavis::policy {

class GroupDecisions {
public:
    /// `state` must outlive it.
    GroupDecisions(const flight::AircraftState& state, base::Time now) : state_(state), now_(now) {}

    [[nodiscard]] base::SignalState state_of(flight::Signal signal) const { return state_.state_of(signal, now_); }
    [[nodiscard]] bool valid(flight::Signal signal) const { return state_of(signal) == base::SignalState::valid; }
    /// Returns the value in SI units; 0 where it was never received.
    [[nodiscard]] double value(flight::Signal signal) const { return state_[signal].value_or(0); }
    /// Whether this heading may turn the view: a magnetic heading needs the variation.
    [[nodiscard]] bool turns_view(flight::Signal heading) const;
    /// Whether a source of the group is valid, and, where the group is that of the view's heading, may turn the view.
    [[nodiscard]] bool has_valid(SignalGroup group) const;

    /// Adds bits of Consequence that hold for the group in this frame; at first there are none.
    void add_consequences(SignalGroup group, std::uint8_t bits) { consequences_[static_cast<std::size_t>(group)] |= bits; }
    [[nodiscard]] std::uint8_t consequences_of(SignalGroup group) const { return consequences_[static_cast<std::size_t>(group)]; }

    /// Decides for the first valid source of the group, else for a stale one with a flag, else by the group's consequences.
    [[nodiscard]] ElementDecision decision(SignalGroup group) const;
    /// Returns the worse of the decisions of two groups that mean nothing without each other; a failure is shown in any case.
    [[nodiscard]] ElementDecision worse_of(SignalGroup a, SignalGroup b) const;

private:
    /// Returns the first source in this state; count_ for none.
    [[nodiscard]] flight::Signal first_in(SignalGroup group, base::SignalState wanted) const;

    const flight::AircraftState& state_;
    base::Time now_;
    std::array<std::uint8_t, kGroupCount> consequences_{};
};

}  // namespace tedavis::policy
