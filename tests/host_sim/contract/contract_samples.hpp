/// Contracts, readings and frames made by hand, for tests of what judges them.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/contract/judge_contract.hpp"

namespace tedavis::test_support {

inline host_sim::ContractCondition most_of(const std::string& name, double limit, double for_s = 0) {
    host_sim::ContractCondition condition;
    condition.name = name;
    condition.limit = {true, limit, for_s};
    return condition;
}

inline host_sim::ContractReading reading_of(double value) {
    return {host_sim::ReadingState::measured, value, {10, 20, 30, 40}, "upper left", "what"};
}

/// A frame a second, all in cruise.
inline host_sim::FlightRun run_of_seconds(std::size_t frames) {
    host_sim::FlightRun run;
    run.folder = "out/run";
    run.design = "default";
    for (std::size_t n = 0; n < frames; ++n) {
        host_sim::FlightFrame frame;
        frame.frame = n;
        frame.time_s = static_cast<double>(n);
        frame.phase = "cruise";
        run.frames.push_back(frame);
    }
    return run;
}

/// One condition's values, a frame each; nothing: there is nothing to measure.
inline std::vector<std::vector<host_sim::ContractReading>> series_of(std::initializer_list<std::optional<double>> values) {
    std::vector<std::vector<host_sim::ContractReading>> readings;
    for (const auto& value : values) readings.push_back({value ? reading_of(*value) : host_sim::ContractReading()});
    return readings;
}

inline host_sim::Contract contract_of(const std::vector<host_sim::ContractCondition>& conditions) {
    host_sim::Contract contract;
    contract.path = "c.toml";
    contract.title = "samples";
    contract.conditions = conditions;
    return contract;
}

}  // namespace tedavis::test_support
