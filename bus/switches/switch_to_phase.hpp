/// Maps debounced switch levels to a flight phase.
///
/// A pattern that the config lists states its phase, once every line of it is settled: lines of one panel that change together
/// (its supply fails, or its knob is turned) do so some milliseconds apart, and what they show in between may be another phase's
/// pattern. Any other pattern, or lines that never reported, is impossible: the last valid phase is kept, and the fault is raised
/// once this has lasted for the settle time, because a rotary switch passes through impossible patterns. The next valid pattern
/// clears the fault.
///
/// The status at `now` depends only on the edges at or before `now`: every debounced change is evaluated at its own instant,
/// however rarely status() is called.
///
/// Thread  one. Memory  inside the object; `State` is plain and can be saved. Failure  the fault flag.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "bus/switches/switch_config.hpp"
#include "bus/switches/switch_debounce.hpp"
#include "bus/switches/switch_edge.hpp"
#include "render_core/flight/phase_statement.hpp"

namespace tedavis::bus {

struct SwitchPhase {
    /// Empty before the first valid pattern and while the pattern stands for the phase `unknown`.
    flight::PhaseStatement statement;
    bool fault = false;
    SwitchLevels levels;  ///< debounced
};

class SwitchToPhase {
public:
    explicit SwitchToPhase(const SwitchConfig& config) : config_(config), state_(config.debounce) {}

    /// Adds an edge, in the order of the source; an edge earlier than its predecessor counts as simultaneous with it. Edges of
    /// one instant are evaluated together.
    void add(const SwitchEdge& edge);
    /// Returns the phase at `now`, which must not lie before the newest edge added.
    [[nodiscard]] SwitchPhase status(base::Time now) const;

    struct State {
        explicit State(base::Duration stable) : debounce(stable) {}
        SwitchDebounce debounce;
        base::Time newest_edge{std::numeric_limits<std::int64_t>::min()};
        base::Time evaluated{std::numeric_limits<std::int64_t>::min()};
        base::Time impossible_since;
        flight::PhaseStatement last_valid;
        bool edge_waits = false;  ///< edges at `newest_edge` are not evaluated yet
        bool impossible = false;
    };
    [[nodiscard]] const State& state() const { return state_; }
    void restore(const State& state) { state_ = state; }
    [[nodiscard]] const SwitchConfig& config() const { return config_; }

private:
    void evaluate(State& state, base::Time at) const;
    [[nodiscard]] const SwitchPattern* pattern_of(const State& state, base::Time at) const;
    void evaluate_waiting_edges(State& state) const;

    SwitchConfig config_;
    State state_;
};
static_assert(std::is_trivially_copyable_v<SwitchToPhase::State>);

}  // namespace tedavis::bus
