/// Debounced switch levels as a flight phase.
///
/// A pattern that the config lists states its phase. An impossible one (also: lines that never reported) keeps the last
/// valid phase, and raises the fault once it has lasted for the settle time: a knob that turns passes through impossible
/// patterns. The fault falls with the next valid pattern.
///
/// The status at `now` is a function of the edges at or before `now` and nothing else: every debounced change is
/// evaluated at its own instant, however rarely anybody asks.
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
    flight::PhaseStatement statement;  ///< nothing before the first valid pattern, and on a pattern of "unknown"
    bool fault = false;
    SwitchLevels levels;  ///< debounced
};

class SwitchToPhase {
public:
    explicit SwitchToPhase(const SwitchConfig& config) : config_(config), state_(config.debounce) {}

    /// In the order of the source; an edge earlier than its predecessor counts as simultaneous with it. Edges of one
    /// instant are evaluated together.
    void add(const SwitchEdge& edge);
    /// For a `now` not before the newest edge added.
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
    void evaluate_waiting_edges(State& state) const;

    SwitchConfig config_;
    State state_;
};
static_assert(std::is_trivially_copyable_v<SwitchToPhase::State>);

}  // namespace tedavis::bus
