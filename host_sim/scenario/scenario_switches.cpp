#include "host_sim/scenario/scenario_switches.hpp"

#include <array>

#include "bus/switches/switch_log.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr base::Duration kKnobTurns = base::Duration::milliseconds(18);

const bus::SwitchPattern* pattern_for(const bus::SwitchConfig& config, flight::FlightPhase phase) {
    for (const bus::SwitchPattern& pattern : config.patterns) {
        if (pattern.phase == phase) return &pattern;
    }
    for (const bus::SwitchPattern& pattern : config.patterns) {
        if (pattern.phase == flight::FlightPhase{phase.scenario, 0}) return &pattern;
    }
    return nullptr;
}

std::uint32_t levels_for(const bus::SwitchConfig& config, const Leg& leg) {
    const bool stated = leg.stated_by == PhaseStatedBy::switches;
    const flight::FlightPhase phase = stated ? leg.phase : flight::FlightPhase{};
    const bus::SwitchPattern* pattern = pattern_for(config, phase);
    if (pattern == nullptr) {
        throw UserError("the switch panel '" + std::string(config.title.view()) + "' has no pattern for " +
                        flight::scenario_name(phase) + "; add one or let another source state that phase");
    }
    return pattern->high;
}

class LogText {
public:
    explicit LogText(const bus::SwitchConfig& config) : config_(config), text_(bus::kSwitchLogHeader) {}

    void edges(base::Time time, std::uint32_t changed, std::uint32_t levels) {
        for (std::size_t line = 0; line < config_.lines.size(); ++line) {
            const std::uint32_t bit = std::uint32_t{1} << line;
            if ((changed & bit) == 0) continue;
            std::array<char, bus::kMaxSwitchLogLine> out;
            const std::size_t count = bus::format_switch_log_line({time, static_cast<std::uint8_t>(line), (levels & bit) != 0},
                                                                  config_, {out.data(), out.size()});
            text_.append(out.data(), count);
        }
    }
    [[nodiscard]] std::string text() const { return text_; }

private:
    const bus::SwitchConfig& config_;
    std::string text_;
};

}  // namespace

std::string scenario_switch_log(const Scenario& scenario, const ScenarioFlight& flight, const bus::SwitchConfig& config) {
    LogText log(config);
    std::uint32_t levels = levels_for(config, scenario.legs.front());
    log.edges(flight.begin(), config.all_lines(), levels);
    for (std::size_t i = 1; i < scenario.legs.size(); ++i) {
        const std::uint32_t next = levels_for(config, scenario.legs[i]);
        const base::Time time = flight.begin() + base::Duration::from_seconds(flight.legs()[i].begin_s);
        log.edges(time, levels & ~next, next);
        log.edges(time + kKnobTurns, next & ~levels, next);
        levels = next;
    }
    return log.text();
}

}  // namespace tedavis::host_sim
