#include "host_sim/replay/log_facts.hpp"

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "host_sim/input_file.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kFramesOfARead = 256;

std::string seconds_words(base::Duration duration) {
    const double s = duration.to_seconds();
    return (s < 0.001 ? decimal(s * 1e6, 0) + " us" : decimal(s, s < 10 ? 3 : 0) + " s");
}

std::string first_report_words(const LogFacts& facts) {
    if (facts.reports.empty()) return {};
    return " (the first: line " + std::to_string(facts.reports[0].line) + ", " + bus::describe(facts.reports[0].fault) + ")";
}

void find_in_stamps(const std::string& log, const LogFacts& facts, Findings& findings) {
    const bus::LogLineCounts& lines = facts.lines;
    const std::uint64_t frames = facts.counters.frames;
    if (2 * lines.runs_back > frames) {
        findings.push_back({"log.reversed",
                            log + ": runs backwards: " + std::to_string(lines.runs_back) + " of " + counted(frames, "frame") +
                                " are stamped before the one above; put its lines in order of time",
                            lines.runs_back});
    } else if (lines.runs_back > 0) {
        findings.push_back({"log.time_runs_back",
                            log + ": time runs back at " + counted(lines.runs_back, "line") + ", first at line " +
                                std::to_string(lines.first_back_line) + " by " + seconds_words(lines.first_back) +
                                ", at most by " + seconds_words(lines.longest_back),
                            lines.runs_back});
    } else if (frames > 1 && facts.first == facts.last) {
        findings.push_back({"log.no_time", log + ": " + counted(frames, "frame") + " have one and the same stamp", frames});
    }
}

void find_in_lines(const std::string& log, const LogFacts& facts, Findings& findings) {
    if (facts.broken_lines > 0)
        findings.push_back({"log.broken_lines",
                            log + ": " + counted(facts.broken_lines, "broken line") + first_report_words(facts),
                            facts.broken_lines});
    if (facts.counters.dropped > 0)
        findings.push_back(
            {"log.dropped", log + ": the recorder lost " + counted(facts.counters.dropped, "frame"), facts.counters.dropped});
    if (facts.interfaces.size() < 2) return;
    std::string names;
    for (const LogInterface& one : facts.interfaces)
        names += (names.empty() ? "" : ", ") + one.name + " (" + counted(one.frames, "frame") + ")";
    findings.push_back({"log.interfaces",
                        log + ": frames of " + std::to_string(facts.interfaces.size()) +
                            " interfaces are read as one bus: " + names + "; keep the lines of one",
                        facts.interfaces.size()});
}

void find_on_the_bus(const std::string& log, const std::string& bus, const LogFacts& facts, Findings& findings) {
    const std::uint64_t frames = facts.counters.frames;
    if (facts.counters.decoded == 0) {
        findings.push_back({"bus.nothing_decoded",
                            log + ": none of " + counted(frames, "frame") + " can be decoded by the bus " + bus +
                                "; give a CANaerospace log, or its bus with --bus",
                            frames});
        return;
    }
    const bus::DecoderCounts& decoder = facts.decoder;
    if (!facts.has_position)
        findings.push_back({"bus.no_position",
                            log + ": no position is among " + counted(frames, "frame") + ", of which the bus " + bus +
                                " decodes " + std::to_string(facts.counters.decoded),
                            facts.counters.frames});
    if (decoder.impossible_phases > 0)
        findings.push_back({"bus.impossible_phase",
                            log + ": " + counted(decoder.impossible_phases, "flight phase message") +
                                " with a code that is no phase, the first with code " +
                                std::to_string(decoder.first_impossible_phase),
                            decoder.impossible_phases});
    const std::uint64_t out_of_range = decoder.out_of_range - decoder.impossible_phases;
    if (out_of_range > 0)
        findings.push_back({"bus.out_of_range",
                            log + ": " + counted(out_of_range, "value") + " out of the range of their signal, refused",
                            out_of_range});
}

}  // namespace

LogFacts facts_of(const bus::CandumpLogSource& source, const bus::StateAssembler& assembler, const InterfaceFrames& frames,
                  base::Time first) {
    LogFacts facts;
    facts.first = first;
    facts.last = source.position().newest;
    const bus::BusSnapshot end = assembler.snapshot(facts.last);
    facts.counters = end.counters;
    facts.decoder = end.decoder;
    facts.lines = source.line_counts();
    facts.broken_lines = source.statistics().malformed;
    facts.reports.assign(source.reports().begin(), source.reports().end());
    for (std::size_t n = 0; n < frames.size(); ++n)
        if (frames[n] > 0)
            facts.interfaces.push_back(
                {n < source.interface_names().size() ? std::string(source.interface_names()[n].view()) : "others", frames[n]});
    facts.has_position = end.state[flight::Signal::latitude].received() && end.state[flight::Signal::longitude].received();
    return facts;
}

bool assumes_heights(const std::string& log) {
    const std::string packed = ".gz";
    const bool is_packed = log.size() > packed.size() && log.compare(log.size() - packed.size(), packed.size(), packed) == 0;
    const std::string companion = log.substr(0, log.size() - (is_packed ? packed.size() : 0)) + ".json";
    if (!std::filesystem::is_regular_file(companion)) return false;
    const auto said = nlohmann::json::parse(read_file(companion), nullptr, false);
    const nlohmann::json::json_pointer assumed("/assume_geometric"), height("/derived/height");
    if (!said.is_object() || !said.contains(assumed) || said[assumed] != true || !said.contains(height)) return false;
    return said[height].is_string() && said[height].get<std::string>().find("pressure") != std::string::npos;
}

LogFacts read_log_facts(const std::string& log, const bus::BusSettings& settings) {
    const std::string text = read_file_unpacked(log);
    bus::CandumpLogSource source({text.data(), text.size()});
    bus::StateAssembler assembler(settings);
    std::array<bus::CanFrame, kFramesOfARead> batch;
    InterfaceFrames frames{};
    std::optional<base::Time> first;
    constexpr base::Time kEndOfTime{std::numeric_limits<std::int64_t>::max()};
    while (const std::size_t count = source.read(kEndOfTime, {batch.data(), batch.size()})) {
        if (!first) first = batch[0].time;
        for (std::size_t n = 0; n < count; ++n) ++frames[batch[n].channel];
        assembler.feed({batch.data(), count});
    }
    assembler.record_dropped(source.statistics().dropped);
    LogFacts facts = facts_of(source, assembler, frames, first.value_or(base::Time{}));
    if (!first)
        throw UserError(log + ": no line of it is a frame of a candump log" + first_report_words(facts) +
                        "; record with candump -l or -L");
    return facts;
}

Findings log_findings(const std::string& log, const std::string& bus, const LogFacts& facts) {
    Findings findings;
    find_in_stamps(log, facts, findings);
    find_in_lines(log, facts, findings);
    find_on_the_bus(log, bus, facts, findings);
    return findings;
}

}  // namespace tedavis::host_sim
