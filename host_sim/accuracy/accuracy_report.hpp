/// All that a run of `tedavis accuracy` has measured, and under which conditions.
#pragma once

#include <string>
#include <vector>

#include "host_sim/accuracy/measured_knob.hpp"

namespace tedavis::host_sim {

struct MeasuringConditions {
    std::string version, compiler, command, date;  ///< date: of the first knob, UTC
    std::string processor;
    unsigned processors = 0;
    double load = 0;  ///< of the machine when the run began, mean of a minute; 0: unknown
    std::string terrain;
    bool is_quick = false;
};

struct AccuracyReport {
    MeasuringConditions conditions;
    bool interrupted = false;
    std::vector<MeasuredKnob> knobs;        ///< in the registry's order
    std::vector<std::string> not_measured;  ///< names of knobs that were asked for, too
};

/// Of this machine and program.
[[nodiscard]] MeasuringConditions conditions_now(const std::string& command, const std::string& terrain, bool is_quick);

/// True where figures of both may stand in one report: same program, machine, terrain and extent.
[[nodiscard]] bool are_comparable(const MeasuringConditions& a, const MeasuringConditions& b);

}  // namespace tedavis::host_sim
