/// What a whole candump log holds: how many of its frames the bus understands, from which interfaces they are, whether its time
/// runs on. `replay` learns it while it indexes the log, `check` by reading it once.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bus/candump/candump_log_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "host_sim/reports/run_findings.hpp"

namespace tedavis::host_sim {

/// Frames by CanFrame::channel; those of more interfaces than a source tells apart come last.
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
    std::uint64_t broken_lines = 0;        ///< begun like a frame and none
    std::vector<bus::LineReport> reports;  ///< the first of them
    std::vector<LogInterface> interfaces;  ///< in order of appearance
    bool has_position = false;             ///< a latitude and a longitude were received
};

/// Of a log that was read to its end, every frame of it fed to the assembler.
[[nodiscard]] LogFacts facts_of(const bus::CandumpLogSource& source, const bus::StateAssembler& assembler,
                                const InterfaceFrames& frames, base::Time first);

/// True where `convert` says beside the log (LOG.json) that its geometric heights are pressure altitudes, --assume-geometric.
[[nodiscard]] bool assumes_heights(const std::string& log);

/// Reads a log that may be gzip-compressed. Throws UserError where no line of it is a frame.
[[nodiscard]] LogFacts read_log_facts(const std::string& log, const bus::BusSettings& settings);

/// What a flight cannot be shown from, or only wrongly. `bus`: as the user named its file.
[[nodiscard]] Findings log_findings(const std::string& log, const std::string& bus, const LogFacts& facts);

}  // namespace tedavis::host_sim
