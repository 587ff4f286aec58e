#include "host_sim/flight_test/timed_input.hpp"

#include <array>
#include <limits>

#include "bus/candump/candump_log_source.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/replay/read_switch_log.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr base::Time kAfterAll{std::numeric_limits<std::int64_t>::max()};

std::vector<bus::CanFrame> frames_of_log(const std::string& path) {
    const std::string text = read_file_unpacked(path);
    bus::CandumpLogSource source({text.data(), text.size()});
    std::vector<bus::CanFrame> frames;
    std::array<bus::CanFrame, 256> batch;
    while (const std::size_t count = source.read(kAfterAll, {batch.data(), batch.size()}))
        for (std::size_t n = 0; n < count; ++n)
            if (batch[n].kind != bus::FrameKind::error) frames.push_back(batch[n]);
    if (frames.empty()) throw UserError(path + ": has no frame of a bus; name a candump log");
    return frames;
}

base::Time since(base::Time time, base::Time first) { return base::Time{} + (time - first); }

}  // namespace

std::uint32_t resting_levels(const bus::SwitchConfig& panel) {
    for (const bus::SwitchPattern& pattern : panel.patterns)
        if (pattern.phase.scenario == flight::Scenario::unknown) return pattern.high;
    return 0;
}

TimedInput read_timed_input(const PlayerFiles& files, const bus::SwitchConfig& panel) {
    TimedInput input;
    input.frames = frames_of_log(files.log);
    const base::Time first = input.frames.front().time;
    for (bus::CanFrame& frame : input.frames) frame.time = since(frame.time, first);
    input.first_levels = resting_levels(panel);
    if (files.switches.empty()) return input;
    input.throws_panel = true;
    const PanelReading reading = read_panel(read_switch_log(files.switches), panel);
    if (reading.edges.empty())
        throw UserError(files.switches + ": names no line of the panel; say the panel that it was recorded of");
    for (const bus::SwitchEdge& edge : reading.edges) {
        const std::uint32_t bit = std::uint32_t{1} << edge.line;
        if (edge.time <= first)
            input.first_levels = edge.level ? input.first_levels | bit : input.first_levels & ~bit;
        else
            input.edges.push_back({since(edge.time, first), edge.line, edge.level});
    }
    return input;
}

}  // namespace tedavis::host_sim
