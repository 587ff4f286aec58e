/// Statistics of a whole candump log: how many of its frames the bus layout decodes, their interfaces, and whether its time
/// always advances. `replay` collects them while it indexes the log, `check` by reading it once.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bus/candump/candump_log_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "host_sim/reports/run_findings.hpp"

namespace tedavis::host_sim {

/// Number of frames by CanFrame::channel; the last entry counts the frames of all further interfaces.
using InterfaceFrames = std::array<std::uint64_t, bus::kMaxLogInterfaces + 1>;

struct LogInterface {
    std::string name;
    std::uint64_t frames = 0;
};

struct LogFacts {
    base::Time first, last;  ///< stamps of the first and the newest frame
    bus::BusCounters counters;
    bus::DecoderCounts decoder;
    bus::LogLineCounts lines;
    std::uint64_t broken_lines = 0;        ///< lines that begin like a frame and are none
    std::vector<bus::LineReport> reports;  ///< the first of them
    std::vector<LogInterface> interfaces;  ///< in order of appearance
    bool has_position = false;             ///< a latitude and a longitude were received
};

/// Returns the statistics of a log that was read to its end, with every frame given to the assembler.
[[nodiscard]] LogFacts facts_of(const bus::CandumpLogSource& source, const bus::StateAssembler& assembler,
                                const InterfaceFrames& frames, base::Time first);

/// True if the file LOG.json of `convert` states --assume-geometric: the log's geometric heights are pressure altitudes.
[[nodiscard]] bool assumes_heights(const std::string& log);

/// Reads a log that may be gzip-compressed. Throws UserError where no line of it is a frame.
[[nodiscard]] LogFacts read_log_facts(const std::string& log, const bus::BusSettings& settings);

/// Returns the defects of a log with which a flight cannot be shown, or not correctly. `bus` is the bus file as the user named
/// it.
[[nodiscard]] Findings log_findings(const std::string& log, const std::string& bus, const LogFacts& facts);

}  // namespace tedavis::host_sim
