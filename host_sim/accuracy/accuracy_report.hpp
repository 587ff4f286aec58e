/// All that a run of `tedavis accuracy` has measured, and under which conditions.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/accuracy/measured_knob.hpp"

namespace tedavis::host_sim {

struct MeasuredTerrain {
    std::string name;
    std::uint64_t identity = 0;  ///< terrain_identity()
};

struct MeasuringConditions {
    std::string version, compiler, command, date;  ///< date: of the first knob, UTC
    std::string processor;
    unsigned processors = 0;
    double load = 0;  ///< of the machine when the run began, mean of a minute; 0: unknown
    std::string terrain;
    std::uint64_t program = 0, terrain_identity = 0;  ///< of the file that ran, and of the heights (replay/index_key.hpp)
    bool is_quick = false;
};

struct AccuracyReport {
    MeasuringConditions conditions;
    bool interrupted = false;
    std::vector<MeasuredKnob> knobs;        ///< in the registry's order
    std::vector<std::string> not_measured;  ///< names of knobs that were asked for, too
};

/// Of this machine and program.
[[nodiscard]] MeasuringConditions conditions_now(const std::string& command, const MeasuredTerrain& terrain, bool is_quick);

/// True where figures of both may stand in one report: same program, machine, heights and extent.
[[nodiscard]] bool are_of_one_kind(const MeasuringConditions& a, const MeasuringConditions& b);

}  // namespace tedavis::host_sim
