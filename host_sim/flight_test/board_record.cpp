#include "host_sim/flight_test/board_record.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using RecordJson = nlohmann::json;

constexpr double kMilliseconds = 1000;

/// The value whose name a record states.
template <class Value>
Value named_value(const RecordJson& json, const char* (*name_of)(Value), std::size_t count) {
    const auto name = json.get<std::string>();
    for (std::size_t n = 0; n < count; ++n)
        if (name == name_of(static_cast<Value>(n))) return static_cast<Value>(n);
    throw UserError("'" + name + "' is not known");
}

const char* name_of_source(flight::PhaseSource source) { return flight::to_string(source); }
const char* name_of_state(base::SignalState state) { return base::to_string(state); }
const char* name_of_alert(policy::TerrainAhead alert) {
    static constexpr std::array<const char*, 3> kNames = {"none", "caution", "warning"};
    return kNames[static_cast<std::size_t>(alert)];
}
const char* name_of_effect_state(display::EffectState state) {
    static constexpr std::array<const char*, 3> kNames = {"run", "replaced", "skipped"};
    return kNames[static_cast<std::size_t>(state)];
}

double number_or_nan(const RecordJson& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

void take_phase(const RecordJson& json, flight::PhaseStatus& phase) {
    const auto sub_phase = json.at("sub_phase").get<std::string>();
    const std::string name = json.at("phase").get<std::string>() + (sub_phase.empty() ? "" : "." + sub_phase);
    const flight::ParsedPhase parsed = flight::phase_from_name(name);
    if (!parsed.ok) throw UserError("'" + name + "' is not known");
    phase.phase = parsed.phase;
    phase.source = named_value<flight::PhaseSource>(json.at("phase_source"), &name_of_source, 5);
    phase.switch_fault = json.at("switch_fault").get<bool>();
    phase.disagreement = json.at("disagreement").get<bool>();
}

void take_signals(const RecordJson& json, ObservedFrame& seen) {
    const RecordJson &signals = json.at("signals"), &values = json.at("values");
    for (std::size_t n = 0; n < flight::kSignalCount; ++n) {
        const char* const name = flight::to_string(static_cast<flight::Signal>(n));
        seen.record.signals[n] = named_value<base::SignalState>(signals.at(name), &name_of_state, 5);
        const auto value = values.find(name);
        seen.values.values[n] = value == values.end() ? std::nan("") : value->get<double>();
    }
    for (const RecordJson& flag : json.at("flags"))
        static_cast<void>(seen.record.flags.try_push_back(display::Name(flag.get<std::string>())));
}

void take_alerts(const RecordJson& json, display::AlertRecord& alerts) {
    const RecordJson& terrain = json.at("terrain");
    alerts.terrain = named_value<policy::TerrainAhead>(terrain.at("level"), &name_of_alert, 3);
    alerts.is_watching = terrain.at("watching").get<bool>();
    alerts.clearance_m = number_or_nan(terrain.at("clearance_m"));
    alerts.height_above_terrain_m = number_or_nan(terrain.at("height_above_terrain_m"));
    alerts.obstacle = named_value<policy::TerrainAhead>(json.at("obstacles").at("level"), &name_of_alert, 3);
}

void take_effects(const RecordJson& json, display::FrameRecord& record) {
    for (const RecordJson& one : json) {
        display::EffectRecord effect;
        effect.name = display::Name(one.at("name").get<std::string>());
        effect.state = named_value<display::EffectState>(one.at("state"), &name_of_effect_state, 3);
        effect.reason = base::FixedString<95>(one.at("reason").get<std::string>());
        static_cast<void>(record.effects.try_push_back(effect));
    }
}

BoardRecord record_of(const RecordJson& json) {
    BoardRecord record;
    record.frame = json.at("frame").get<std::uint64_t>();
    record.monotonic_s = json.at("monotonic_s").get<double>();
    if (const RecordJson& latency = json.at("can_to_screen_ms"); !latency.is_null())
        record.can_to_screen_s = latency.get<double>() / kMilliseconds;
    record.is_on_screen = json.at("on_screen").get<bool>();
    take_phase(json, record.seen.record.phase);
    take_signals(json, record.seen);
    take_alerts(json.at("alerts"), record.seen.record.alerts);
    take_effects(json.at("effects"), record.seen.record);
    record.seen.record.frame = record.frame;
    record.seen.record.design = base::FixedString<47>(json.at("presentation").at("design").get<std::string>());
    return record;
}

}  // namespace

BoardRecord read_board_record(std::string_view packet, std::string_view display) {
    const std::string place = std::string(display) + ": ";
    const RecordJson json = RecordJson::parse(packet, nullptr, false);
    if (!json.is_object()) throw UserError(place + "what comes is no record of a frame; name the socket of a tedavis-display");
    constexpr const char* kRemedy = "; run the tedavis-display of this program's version";
    try {
        return record_of(json);
    } catch (const RecordJson::exception& error) {
        const std::string what = error.what();
        const std::size_t quote = what.find('\'');
        const bool has_key = quote != std::string::npos && what.find("key") != std::string::npos;
        throw UserError(place + "its record " + (has_key ? "lacks " + what.substr(quote) : "has a value of another kind") +
                        kRemedy);
    } catch (const UserError& error) {
        throw UserError(place + "its record says a name that is not known here: " + error.what() + kRemedy);
    }
}

bool is_in_board_record(const FrameCondition& condition) {
    return condition.key != "text" && condition.key != "contract" && condition.key != "obstacle_alert" &&
           condition.key != "elements";
}

}  // namespace tedavis::host_sim
