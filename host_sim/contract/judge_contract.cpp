#include "host_sim/contract/judge_contract.hpp"

#include <algorithm>
#include <limits>

namespace tedavis::host_sim {
namespace {

using Readings = std::vector<std::vector<ContractReading>>;

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// When the last of the frames that were measured is over.
double end_of_readings(const FlightRun& run, std::size_t measured) {
    if (measured < run.frames.size()) return run.frames[measured].time_s;
    const double last_s = run.frames[measured - 1].time_s;
    return measured < 2 ? last_s + 1 : 2 * last_s - run.frames[measured - 2].time_s;
}

ConditionState state_of_condition(const JudgedCondition& judged) {
    if (judged.verdict.is_broken) return ConditionState::broken;
    if (judged.missing > 0) return ConditionState::missing;
    if (judged.verdict.measured > 0) return ConditionState::holds;
    return judged.condition.is_optional ? ConditionState::passed : ConditionState::absent;
}

JudgedCondition judge_condition(const ContractCondition& condition, std::size_t place, const FlightRun& run,
                                const Readings& readings) {
    JudgedCondition judged;
    judged.condition = condition;
    perception::ConditionWatch watch(condition.limit);
    for (std::size_t n = 0; n < readings.size(); ++n) {
        const ContractReading& reading = readings[n][place];
        const double time_s = run.frames[n].time_s;
        if (reading.state == ReadingState::missing && judged.missing++ == 0) judged.first_missing = n;
        judged.values.push_back(reading.state == ReadingState::measured ? reading.value : kNotMeasured);
        if (reading.state == ReadingState::measured)
            watch.add({time_s, reading.value, static_cast<std::uint32_t>(n)});
        else
            watch.skip(time_s);
    }
    watch.end(end_of_readings(run, readings.size()));
    judged.verdict = watch.verdict();
    judged.state = state_of_condition(judged);
    const auto reading_at = [&](std::size_t frame) { return readings[frame][place]; };
    judged.worst = reading_at(judged.verdict.worst.place);
    judged.tightest = reading_at(judged.verdict.tightest.place);
    judged.first = reading_at(judged.state == ConditionState::missing ? judged.first_missing : judged.verdict.first.place);
    return judged;
}

}  // namespace

bool JudgedContract::holds() const {
    return !interrupted &&
           std::all_of(conditions.begin(), conditions.end(), [](const JudgedCondition& one) { return one.is_kept(); });
}

JudgedContract judge_contract(const Contract& contract, const FlightRun& run, const Readings& readings) {
    JudgedContract judged{contract.path, contract.title, run.folder, {}, readings.size() < run.frames.size(), {}};
    for (std::size_t n = 0; n < readings.size(); ++n) judged.times_s.push_back(run.frames[n].time_s);
    for (std::size_t n = 0; n < contract.conditions.size(); ++n)
        judged.conditions.push_back(judge_condition(contract.conditions[n], n, run, readings));
    return judged;
}

}  // namespace tedavis::host_sim
