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
    /// In SI units; 0 where it was never received.
    [[nodiscard]] double value(flight::Signal signal) const { return state_[signal].value_or(0); }
    /// Whether the view may be turned by it: a magnetic heading needs the variation.
    [[nodiscard]] bool turns_view(flight::Signal heading) const;
    /// A source of the group is valid, and may turn the view where the group is that of the view's heading.
    [[nodiscard]] bool has_valid(SignalGroup group) const;

    /// Bits of Consequence that hold for the group in this frame; none until they are stated.
    void add_consequences(SignalGroup group, std::uint8_t bits) { consequences_[static_cast<std::size_t>(group)] |= bits; }
    [[nodiscard]] std::uint8_t consequences_of(SignalGroup group) const { return consequences_[static_cast<std::size_t>(group)]; }

    /// The first valid source of the group, else a stale one with a flag, else what its consequences say.
    [[nodiscard]] ElementDecision decision(SignalGroup group) const;
    /// As good as the worse of two groups that state nothing without each other; what failed is said in any case.
    [[nodiscard]] ElementDecision worse_of(SignalGroup a, SignalGroup b) const;

private:
    /// The first source in this state; count_ for none.
    [[nodiscard]] flight::Signal first_in(SignalGroup group, base::SignalState wanted) const;

    const flight::AircraftState& state_;
    base::Time now_;
    std::array<std::uint8_t, kGroupCount> consequences_{};
};

}  // namespace tedavis::policy
