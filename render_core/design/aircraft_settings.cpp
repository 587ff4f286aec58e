#include "render_core/design/aircraft_settings.hpp"

#include <algorithm>

#include "render_core/base/config_reader.hpp"
#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

using base::ConfigSection;

constexpr double kMinSpeed_kt = 10, kMaxSpeed_kt = 680;

/// The keys by which a file may state a speed.
struct SpeedKeys {
    explicit SpeedKeys(std::string_view name) : knots(name), metres(name) {
        knots.append("_kt");
        metres.append("_mps");
    }
    base::FixedString<31> knots, metres;
};

/// True where the section states the speed, in whatever unit or without one.
bool states_speed(const ConfigSection& section, std::string_view name) {
    const SpeedKeys keys(name);
    return section.has(name) || section.has(keys.knots.view()) || section.has(keys.metres.view());
}

/// A fault of the speed, at its line.
void fault_of_speed(ConfigSection& section, std::string_view name, std::string_view what) {
    const SpeedKeys keys(name);
    const std::string_view in_unit = section.has(keys.metres.view()) ? keys.metres.view() : keys.knots.view();
    fault_of(section, section.has(in_unit) ? in_unit : name, what);
}

void refuse_without_unit(ConfigSection& section, std::string_view name) {
    if (!section.has(name)) return;
    const SpeedKeys keys(name);
    base::FixedString<127> what("has no unit; write '");
    what.append(keys.knots.view());
    what.append("' for knots or '");
    what.append(keys.metres.view());
    what.append("' for metres per second");
    fault_of(section, name, what.view());
}

/// The speed in m/s; the lower bound after a fault, also where it is missing.
double read_speed(ConfigSection& section, std::string_view name) {
    const SpeedKeys keys(name);
    refuse_without_unit(section, name);
    const bool has_metres = section.has(keys.metres.view());
    if (has_metres && section.has(keys.knots.view()))
        fault_of(section, keys.metres.view(), "is stated in knots as well; leave one of the two out");
    if (has_metres) return section.number(keys.metres.view(), kMinAircraftSpeed_mps, kMaxAircraftSpeed_mps);
    return section.number(keys.knots.view(), kMinSpeed_kt, kMaxSpeed_kt) * base::kMpsPerKnot;
}

void read_limit_speeds(ConfigSection& root, AircraftSettings& aircraft) {
    ConfigSection section = root.section("speeds");
    aircraft.has_vmo = states_speed(section, "vmo");
    if (aircraft.has_vmo == states_speed(section, "vne"))
        return fault_of(root, "speeds",
                        "needs either vne_kt (never exceed) or vmo_kt (maximum operating speed); give one of them");
    aircraft.limit_mps = read_speed(section, aircraft.has_vmo ? "vmo" : "vne");
    if (states_speed(section, "vno")) {
        aircraft.normal_limit_mps = read_speed(section, "vno");
        if (aircraft.has_vmo) fault_of_speed(section, "vno", "belongs to vne; an aircraft with vmo has none, remove it");
        if (aircraft.normal_limit_mps >= aircraft.limit_mps) fault_of_speed(section, "vno", "must be below vne");
    }
    if (!section.has("vmo_up_to_ft")) return;
    aircraft.limit_up_to_m = section.number("vmo_up_to_ft", 1000, 60'000) * base::kMetresPerFoot;
    if (!aircraft.has_vmo) fault_of(section, "vmo_up_to_ft", "belongs to vmo; an aircraft with vne has none, remove it");
}

/// The flaps at 0 have the aircraft's own limit.
double read_flap_limit(ConfigSection& section, double position, const AircraftSettings& aircraft) {
    if (position > 0) return read_speed(section, "limit");
    if (states_speed(section, "limit"))
        fault_of_speed(section, "limit", "is for flaps that are out; at position 0 it is vne or vmo, remove it");
    return aircraft.limit_mps;
}

void require_flap_position(ConfigSection& section, double position, const AircraftSettings& aircraft) {
    constexpr double kRounding = 1e-9;
    if (aircraft.flaps.empty() && position > 0)
        fault_of(section, "position", "of the first setting must be 0, where the flaps are up");
    if (!aircraft.flaps.empty() && position < aircraft.flaps.back().position + kMinFlapStep - kRounding)
        fault_of(section, "position",
                 "must be at least 0.05 more than that of the setting before it; sort the settings from 0 to 1");
}

FlapSetting read_flap_setting(ConfigSection& section, const AircraftSettings& aircraft) {
    FlapSetting setting;
    setting.name = section.text("name");
    if (setting.name.empty() || setting.name.cut()) fault_of(section, "name", "must be 1 to 7 characters long");
    setting.position = section.number("position", 0, 1);
    require_flap_position(section, setting.position, aircraft);
    setting.limit_mps = read_flap_limit(section, setting.position, aircraft);
    setting.stall_mps = read_speed(section, "stall");
    if (setting.stall_mps * aircraft.caution_factor >= setting.limit_mps)
        fault_of_speed(section, "stall", "times caution_factor must be below the highest speed with these flaps");
    return setting;
}

/// Flaps that are farther out allow less speed, and lower the stall speed.
void require_flap_order(ConfigSection& section, const FlapSetting& before, const FlapSetting& setting) {
    if (setting.limit_mps > before.limit_mps) fault_of_speed(section, "limit", "must not be above that of the setting before it");
    if (setting.stall_mps > before.stall_mps) fault_of_speed(section, "stall", "must not be above that of the setting before it");
}

/// A helicopter has neither flaps nor a stall speed.
void take_no_flaps(ConfigSection& root, AircraftSettings& aircraft) {
    if (root.has("flaps")) fault_of(root, "flaps", "is for airplanes and gliders; a helicopter has none, remove it");
    static_cast<void>(aircraft.flaps.try_push_back({{}, 0, aircraft.limit_mps, 0}));
}

void read_flap_settings(ConfigSection& root, AircraftSettings& aircraft) {
    const std::size_t count = root.table_count("flaps");
    if (aircraft.aircraft_class == flight::AircraftClass::helicopter) return take_no_flaps(root, aircraft);
    if (count == 0)
        fault_of(root, "flaps", "must be stated, one [[flaps]] for each setting; a single one at position 0 without flaps");
    for (std::size_t n = 0; n < count; ++n) {
        ConfigSection section = root.table_at("flaps", n);
        const FlapSetting setting = read_flap_setting(section, aircraft);
        if (n > 0) require_flap_order(section, aircraft.flaps.back(), setting);
        if (n > 0 && n + 1 == count && setting.position < 1)
            fault_of(section, "position", "of the last setting must be 1, which is full travel");
        if (!aircraft.flaps.try_push_back(setting))
            return fault_of(section, "name", "is of one setting too many; keep at most 8");
    }
}

/// The range between the low-speed cue and the normal limit must not be empty.
void require_normal_range(ConfigSection section, const AircraftSettings& aircraft) {
    if (aircraft.flaps.empty() || aircraft.normal_limit_mps == 0) return;
    if (aircraft.flaps[0].stall_mps * aircraft.caution_factor >= aircraft.normal_limit_mps)
        fault_of_speed(section, "vno", "must be above the stall speed with the flaps at 0 times caution_factor");
}

bool is_flag_name(std::string_view name) {
    const auto is_sign = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
    return !name.empty() && name.size() <= 2 && std::all_of(name.begin(), name.end(), is_sign);
}

SpeedFlag read_speed_flag(ConfigSection section, const AircraftSettings& aircraft) {
    const std::string_view name = section.text("name");
    if (!is_flag_name(name)) fault_of(section, "name", "must be one or two upper-case letters or digits");
    for (const SpeedFlag& other : aircraft.flags)
        if (other.name.view() == name) fault_of(section, "name", "is that of another flag; give it another one");
    const SpeedFlag flag{name, read_speed(section, "speed")};
    if (flag.speed_mps > aircraft.limit_mps) fault_of_speed(section, "speed", "must not be above vne or vmo");
    return flag;
}

void read_speed_flags(ConfigSection& root, AircraftSettings& aircraft) {
    for (std::size_t n = 0; n < root.table_count("flag"); ++n) {
        ConfigSection section = root.table_at("flag", n);
        if (!aircraft.flags.try_push_back(read_speed_flag(section, aircraft)))
            return fault_of(section, "name", "is of one flag too many; keep at most 10");
    }
}

void read_eye_point(ConfigSection section, EyePoint& eye) {
    eye.forward_m = section.number("forward_m", -100, 100, eye.forward_m);
    eye.right_m = section.number("right_m", -100, 100, eye.right_m);
    eye.up_m = section.number("up_m", -100, 100, eye.up_m);
}

void read_turn_limits(ConfigSection section, AircraftSettings& aircraft) {
    aircraft.excessive_bank_rad =
        base::radians(section.number("excessive_bank_deg", 10, 85, base::degrees(aircraft.excessive_bank_rad)));
    aircraft.standard_turn_rad_s =
        base::radians(section.number("standard_turn_deg_s", 0.5, 6, base::degrees(aircraft.standard_turn_rad_s)));
}

}  // namespace

base::Result<AircraftSettings, base::Error> load_aircraft(std::string_view text, std::string_view file_name) {
    base::ConfigReader reader(text, file_name);
    ConfigSection root = reader.root();
    AircraftSettings aircraft;
    aircraft.name = root.text("name");
    if (aircraft.name.empty() || aircraft.name.cut()) fault_of(root, "name", "must be 1 to 31 characters long");
    root.choose("class", flight::kAircraftClassNames, aircraft.aircraft_class);
    read_limit_speeds(root, aircraft);
    aircraft.caution_factor = root.section("low_speed").number("caution_factor", 1.01, 1.5, aircraft.caution_factor);
    read_flap_settings(root, aircraft);
    require_normal_range(root.section("speeds"), aircraft);
    read_speed_flags(root, aircraft);
    read_eye_point(root.section("eye"), aircraft.eye);
    read_turn_limits(root.section("turn"), aircraft);
    if (!reader.finish()) return base::fail(reader.error());
    return aircraft;
}

}  // namespace tedavis::design
