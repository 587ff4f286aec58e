#include "render_core/flight/flight_phase.hpp"

#include <cstddef>

namespace tedavis::flight {
namespace {

struct ScenarioEntry {
    Scenario scenario;
    const char* name;
    const char* sub_phases[5];  // index 0 is "none stated"; a null ends the list
};

constexpr ScenarioEntry kScenarios[] = {
    {Scenario::ground, "ground", {"", nullptr, nullptr, nullptr, nullptr}},
    {Scenario::takeoff, "takeoff", {"", "start", "first_climb", "second_climb", nullptr}},
    {Scenario::cruise, "cruise", {"", nullptr, nullptr, nullptr, nullptr}},
    {Scenario::approach, "approach", {"", "descent", "initial", "final", "landing"}},
    {Scenario::go_around, "go_around", {"", "abort", "replanning", nullptr, nullptr}},
    {Scenario::unknown, "unknown", {"", nullptr, nullptr, nullptr, nullptr}},
};

const ScenarioEntry& entry_of(Scenario scenario) {
    for (const ScenarioEntry& entry : kScenarios)
        if (entry.scenario == scenario) return entry;
    return kScenarios[5];
}

}  // namespace

const char* scenario_name(FlightPhase phase) noexcept { return entry_of(phase.scenario).name; }

const char* sub_phase_name(FlightPhase phase) noexcept {
    const ScenarioEntry& entry = entry_of(phase.scenario);
    const bool known = phase.sub_phase < 5 && entry.sub_phases[phase.sub_phase] != nullptr;
    return known ? entry.sub_phases[phase.sub_phase] : "";
}

ParsedPhase phase_from_name(std::string_view name) noexcept {
    const std::size_t dot = name.find('.');
    const std::string_view scenario = name.substr(0, dot);
    const std::string_view sub_phase = dot == std::string_view::npos ? std::string_view() : name.substr(dot + 1);
    if (dot != std::string_view::npos && sub_phase.empty()) return {};
    for (const ScenarioEntry& entry : kScenarios) {
        if (scenario != entry.name) continue;
        for (std::uint8_t i = 0; i < 5 && entry.sub_phases[i] != nullptr; ++i)
            if (sub_phase == entry.sub_phases[i]) return {{entry.scenario, i}, true};
    }
    return {};
}

ParsedPhase phase_from_code(std::uint8_t code) noexcept {
    const auto scenario = static_cast<std::uint8_t>(code / 10);
    const auto sub_phase = static_cast<std::uint8_t>(code % 10);
    if (scenario < 1 || scenario > 6 || sub_phase > 4) return {};
    const ScenarioEntry& entry = kScenarios[scenario - 1];
    if (entry.sub_phases[sub_phase] == nullptr) return {};
    return {{entry.scenario, sub_phase}, true};
}

const char* to_string(PhaseSource source) noexcept {
    switch (source) {
        case PhaseSource::none: return "none";
        case PhaseSource::held: return "held";
        case PhaseSource::motion: return "motion";
        case PhaseSource::can: return "can";
        case PhaseSource::switches: return "switch";
    }
    return "none";
}

Aspect prioritized_aspect(FlightPhase phase) noexcept {
    if (phase.scenario == Scenario::cruise) return Aspect::data;
    return phase == kGoAroundReplanning ? Aspect::uncertainty : Aspect::terrain;
}

}  // namespace tedavis::flight
