/// Evaluates whether a run meets a contract, from the readings of its pictures over time.
///
/// A picture lasts until the next one, the last one as long as the one before it. A condition that was not measured does not
/// hold, nor does the contract, except for an optional condition for which the flight had nothing to measure. A condition does
/// not hold either, optional or not, where the run lacks what its measure needs for any picture to which it applies.
#pragma once

#include <string>
#include <vector>

#include "host_sim/contract/contract.hpp"
#include "host_sim/contract/contract_reading.hpp"
#include "host_sim/evaluation/flight_run.hpp"

namespace tedavis::host_sim {

enum class ConditionState : std::uint8_t {
    holds,
    broken,
    missing,  ///< the run lacks data for the measure, so the condition is not proven
    absent,   ///< nothing to measure in this flight, and not optional, so the condition is not proven
    passed    ///< the same, but optional
};
inline constexpr const char* kConditionStateNames[] = {"holds", "broken", "not measured", "nothing to measure", "passed over"};

struct JudgedCondition {
    ContractCondition condition;
    ConditionState state = ConditionState::absent;
    perception::ConditionVerdict verdict;    ///< places are indices of frames
    ContractReading first, worst, tightest;  ///< of the verdict's moments; `first` is also that of the first missing one
    std::vector<double> values;              ///< of each frame; not a number where it was not measured
    std::size_t missing = 0;                 ///< frames that lack what is needed
    std::size_t first_missing = 0;           ///< index of a frame

    [[nodiscard]] bool is_kept() const { return state == ConditionState::holds || state == ConditionState::passed; }
};

struct JudgedContract {
    std::string path, title, run;
    std::vector<double> times_s;  ///< of the frames that were measured
    bool interrupted = false;     ///< judged by the frames so far
    std::vector<JudgedCondition> conditions;

    /// A contract that was evaluated over a part of the flight does not hold.
    [[nodiscard]] bool holds() const;
};

/// `readings` are those of the run's first frames, at least one, each with one reading per condition.
[[nodiscard]] JudgedContract judge_contract(const Contract& contract, const FlightRun& run,
                                            const std::vector<std::vector<ContractReading>>& readings);

}  // namespace tedavis::host_sim
