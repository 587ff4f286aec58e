#include "bus/canaerospace/identifier_table.hpp"

#include <array>

#include "render_core/base/units.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::bus {
namespace {

using base::kPi;
using flight::Signal;

constexpr std::uint32_t kAnalogue = type_bit(DataType::float32) | type_bit(DataType::short16x2);
constexpr std::uint32_t kSelectable =
    kAnalogue | type_bit(DataType::nodata);  ///< a message without data: nothing is selected, or no ground is in range
constexpr std::uint32_t kPosition =
    kAnalogue | type_bit(DataType::double_high) | type_bit(DataType::double_low) | type_bit(DataType::long32);
constexpr std::uint32_t kUnsigned = type_bit(DataType::ulong32) | type_bit(DataType::ushort16);
constexpr std::uint32_t kBits = type_bit(DataType::blong32) | type_bit(DataType::bshort16);
constexpr std::uint32_t kClock = type_bit(DataType::char8x4) | type_bit(DataType::uchar8x4) | type_bit(DataType::uchar8x3);
constexpr std::uint32_t kAnyNumber = kAnalogue | kUnsigned | type_bit(DataType::long32) | type_bit(DataType::short16) |
                                     type_bit(DataType::char8) | type_bit(DataType::uchar8);

constexpr IdentifierEntry kTable[] = {
    {300, "body longitudinal acceleration", BusUnit::acceleration, kAnalogue, Signal::longitudinal_acceleration, 0, false, false,
     -150, 150},
    {301, "body lateral acceleration", BusUnit::acceleration, kAnalogue, Signal::lateral_acceleration, 0, false, false, -150,
     150},
    {302, "body normal acceleration", BusUnit::acceleration, kAnalogue, Signal::normal_acceleration, 0, false, false, -150, 150},
    {303, "body pitch rate", BusUnit::degree_per_second, kAnalogue, Signal::pitch_rate, 0, false, false, -10, 10},
    {304, "body roll rate", BusUnit::degree_per_second, kAnalogue, Signal::roll_rate, 0, false, false, -10, 10},
    {305, "body yaw rate", BusUnit::degree_per_second, kAnalogue, Signal::yaw_rate, 0, false, false, -10, 10},
    {311, "body pitch angle", BusUnit::degree, kAnalogue, Signal::pitch, 0, false, false, -kPi / 2, kPi / 2},
    {312, "body roll angle", BusUnit::degree, kAnalogue, Signal::roll, 0, false, false, -kPi, kPi},
    {313, "body sideslip", BusUnit::degree, kAnalogue, Signal::sideslip, 0, false, false, -kPi / 2, kPi / 2},
    {314, "altitude rate", BusUnit::metre_per_second, kAnalogue, Signal::vertical_speed, 0, false, false, -300, 300},
    {315, "indicated airspeed", BusUnit::metre_per_second, kAnalogue, Signal::indicated_airspeed, 0, false, false, -10, 1000},
    {316, "true airspeed", BusUnit::metre_per_second, kAnalogue, Signal::true_airspeed, 0, false, false, -10, 1000},
    {317, "calibrated airspeed", BusUnit::metre_per_second, kAnalogue, Signal::calibrated_airspeed, 0, false, false, -10, 1000},
    {318, "Mach number", BusUnit::none, kAnalogue, Signal::count_, 0, false, false, -0.1, 5},
    {319, "baro correction", BusUnit::pressure, kAnalogue, Signal::baro_setting, 0, false, false, 80000, 110000},
    {320, "baro corrected altitude", BusUnit::metre, kAnalogue, Signal::baro_altitude, 0, false, false, -2000, 40000},
    {321, "heading angle", BusUnit::degree, kAnalogue, Signal::true_heading, 1, false, false, -kPi, 2 * kPi},
    {322, "standard altitude", BusUnit::metre, kAnalogue, Signal::standard_altitude, 0, false, false, -2000, 40000},
    {323, "total air temperature", BusUnit::kelvin, kAnalogue, Signal::count_, 0, false, false, 150, 450},
    {324, "static air temperature", BusUnit::kelvin, kAnalogue, Signal::outside_temperature, 1, false, false, 150, 350},
    {325, "differential pressure", BusUnit::pressure, kAnalogue, Signal::count_, 0, false, false, -10000, 200000},
    {326, "static pressure", BusUnit::pressure, kAnalogue, Signal::count_, 0, false, false, 100, 120000},
    {327, "heading rate", BusUnit::degree_per_second, kAnalogue, Signal::heading_rate, 0, false, false, -10, 10},
    {328, "port side angle of attack", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, kPi},
    {329, "starboard side angle of attack", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, kPi},
    {332, "true altitude", BusUnit::metre, kAnalogue, Signal::true_altitude, 0, false, false, -2000, 40000},
    {333, "wind speed", BusUnit::metre_per_second, kAnalogue, Signal::wind_speed, 0, false, false, 0, 200},
    {334, "wind direction", BusUnit::degree, kAnalogue, Signal::wind_direction, 0, false, false, -kPi, 2 * kPi},
    {335, "outside air temperature", BusUnit::kelvin, kAnalogue, Signal::outside_temperature, 0, false, false, 150, 350},
    {340, "flaps position", BusUnit::none, kAnyNumber, Signal::count_, 0, false, true, -1000, 1000},
    {341, "slats position", BusUnit::none, kAnyNumber, Signal::count_, 0, false, true, -1000, 1000},
    {342, "speed brake position", BusUnit::none, kAnyNumber, Signal::count_, 0, false, true, -1000, 1000},
    {343, "spoiler position", BusUnit::none, kAnyNumber, Signal::count_, 0, false, true, -1000, 1000},
    {344, "total velocity", BusUnit::metre_per_second, kAnyNumber, Signal::count_, 0, false, true, -1000, 1000},
    {345, "airmass vertical speed", BusUnit::metre_per_second, kAnyNumber, Signal::count_, 0, false, true, -1000, 1000},
    {346, "tail angle of attack port", BusUnit::degree, kAnyNumber, Signal::count_, 0, false, true, -kPi, kPi},
    {347, "tail angle of attack starboard", BusUnit::degree, kAnyNumber, Signal::count_, 0, false, true, -kPi, kPi},
    {348, "total energy speed 1", BusUnit::metre_per_second, kAnyNumber, Signal::count_, 0, false, true, -1000, 1000},
    {349, "total energy speed 2", BusUnit::metre_per_second, kAnyNumber, Signal::count_, 0, false, true, -1000, 1000},
    {350, "total energy speed 3", BusUnit::metre_per_second, kAnyNumber, Signal::count_, 0, false, true, -1000, 1000},
    {354, "glider state", BusUnit::none, kAnyNumber, Signal::count_, 0, false, true, -1000, 1000},
    {430, "flaps lever position", BusUnit::none, kAnalogue, Signal::flaps_lever, 0, false, false, -1, 1},
    {431, "slats lever position", BusUnit::none, kAnalogue, Signal::count_, 0, false, false, -1, 1},
    {1017, "waypoint latitude", BusUnit::degree, kPosition, Signal::count_, 0, true, false, -kPi / 2, kPi / 2},
    {1018, "waypoint longitude", BusUnit::degree, kPosition, Signal::count_, 0, true, false, -kPi, kPi},
    {1027, "waypoint planned altitude", BusUnit::metre, kAnalogue, Signal::count_, 0, true, false, -2000, 40000},
    {1030, "waypoint height above ellipsoid", BusUnit::metre, kAnalogue, Signal::count_, 0, true, false, -2000, 40000},
    {1036, "GPS latitude", BusUnit::degree, kPosition, Signal::latitude, 0, false, false, -kPi / 2, kPi / 2},
    {1037, "GPS longitude", BusUnit::degree, kPosition, Signal::longitude, 0, false, false, -kPi, kPi},
    {1038, "GPS height above ellipsoid", BusUnit::metre, kAnalogue, Signal::ellipsoid_height, 0, false, false, -2000, 40000},
    {1039, "GPS ground speed", BusUnit::metre_per_second, kAnalogue, Signal::ground_speed, 0, false, false, 0, 1000},
    {1040, "GPS true track", BusUnit::degree, kAnalogue, Signal::true_track, 0, false, false, -kPi, 2 * kPi},
    {1041, "GPS magnetic track", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, 2 * kPi},
    {1042, "GPS cross track error", BusUnit::metre, kAnalogue, Signal::cross_track_deviation, 0, false, false, -10000000.0,
     10000000.0},
    {1043, "GPS track error angle", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, kPi},
    {1044, "GPS glideslope deviation", BusUnit::metre, kAnalogue, Signal::gnss_vertical_deviation, 0, false, false, -100000.0,
     100000.0},
    {1045, "GPS predicted RAIM", BusUnit::none, kUnsigned, Signal::count_, 0, false, false, 0, 4294967295},
    {1046, "GPS vertical figure of merit", BusUnit::metre, kAnalogue, Signal::vertical_accuracy, 0, false, false, 0, 100000.0},
    {1047, "GPS horizontal figure of merit", BusUnit::metre, kAnalogue, Signal::horizontal_accuracy, 0, false, false, 0,
     100000.0},
    {1048, "GPS mode of operation", BusUnit::none, type_bit(DataType::short16), Signal::count_, 0, false, false, -32768, 32767},
    {1049, "INS latitude", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi / 2, kPi / 2},
    {1050, "INS longitude", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, kPi},
    {1051, "INS height above ellipsoid", BusUnit::metre, kAnalogue, Signal::count_, 0, false, false, -2000, 40000},
    {1052, "INS ground speed", BusUnit::metre_per_second, kAnalogue, Signal::ground_speed, 1, false, false, 0, 1000},
    {1053, "INS true track", BusUnit::degree, kAnalogue, Signal::true_track, 1, false, false, -kPi, 2 * kPi},
    {1054, "INS magnetic track", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, 2 * kPi},
    {1057, "INS vertical figure of merit", BusUnit::metre, kAnalogue, Signal::count_, 0, false, false, 0, 100000.0},
    {1058, "INS horizontal figure of merit", BusUnit::metre, kAnalogue, Signal::count_, 0, false, false, 0, 100000.0},
    {1069, "magnetic heading", BusUnit::degree, kAnalogue, Signal::magnetic_heading, 0, false, false, -kPi, 2 * kPi},
    {1070, "radio height", BusUnit::metre, kSelectable, Signal::radio_height, 0, false, false, -20, 10000},
    {1087, "ILS 1 localizer deviation", BusUnit::degree, kAnalogue, Signal::ils1_localizer_deviation, 0, false, false, -kPi, kPi},
    {1088, "ILS 2 localizer deviation", BusUnit::degree, kAnalogue, Signal::ils2_localizer_deviation, 0, false, false, -kPi, kPi},
    {1089, "ILS 3 localizer deviation", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, kPi},
    {1090, "ILS 4 localizer deviation", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, kPi},
    {1091, "ILS 1 glideslope deviation", BusUnit::degree, kAnalogue, Signal::ils1_glideslope_deviation, 0, false, false, -kPi,
     kPi},
    {1092, "ILS 2 glideslope deviation", BusUnit::degree, kAnalogue, Signal::ils2_glideslope_deviation, 0, false, false, -kPi,
     kPi},
    {1093, "ILS 3 glideslope deviation", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, kPi},
    {1094, "ILS 4 glideslope deviation", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, kPi},
    {1095, "flight director 1 pitch", BusUnit::degree, kSelectable, Signal::flight_director_pitch, 0, false, false, -kPi, kPi},
    {1096, "flight director 2 pitch", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, kPi},
    {1097, "flight director 1 roll", BusUnit::degree, kSelectable, Signal::flight_director_roll, 0, false, false, -kPi, kPi},
    {1098, "flight director 2 roll", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, kPi},
    {1099, "decision height", BusUnit::metre, kSelectable, Signal::decision_height, 0, false, false, 0, 1000},
    {1120, "desired track angle", BusUnit::degree, kAnalogue, Signal::desired_track, 0, false, false, -kPi, 2 * kPi},
    {1121, "magnetic variation", BusUnit::degree, kAnalogue, Signal::magnetic_variation, 0, false, false, -kPi, kPi},
    {1122, "selected glidepath angle", BusUnit::degree, kSelectable, Signal::selected_glidepath, 0, false, false, 0, kPi / 12},
    {1123, "selected runway heading", BusUnit::degree, kAnalogue, Signal::count_, 0, false, false, -kPi, 2 * kPi},
    {1124, "computed vertical velocity", BusUnit::metre_per_second, kAnalogue, Signal::vertical_speed, 1, false, false, -300,
     300},
    {1125, "selected course", BusUnit::degree, kSelectable, Signal::selected_course, 0, false, false, -kPi, 2 * kPi},
    {1130, "true east velocity", BusUnit::metre_per_second, kAnalogue, Signal::count_, 0, false, false, -1000, 1000},
    {1131, "true north velocity", BusUnit::metre_per_second, kAnalogue, Signal::count_, 0, false, false, -1000, 1000},
    {1132, "true up velocity", BusUnit::metre_per_second, kAnalogue, Signal::vertical_speed, 2, false, false, -300, 300},
    {1133, "true heading", BusUnit::degree, kAnalogue, Signal::true_heading, 0, false, false, -kPi, 2 * kPi},
    {1134, "geoid separation", BusUnit::metre, kAnyNumber, Signal::count_, 0, false, true, -200, 200},
    {1135, "glider wind state", BusUnit::none, kAnyNumber, Signal::count_, 0, false, true, -1000000.0, 1000000.0},
    {1175, "gear lever switches", BusUnit::bits, kBits, Signal::count_, 0, false, false, 0, 4294967295},
    {1176, "gear lights and weight on wheels", BusUnit::bits, kBits, Signal::count_, 0, false, false, 0, 4294967295},
    {1200, "UTC", BusUnit::time_of_day, kClock, Signal::count_, 0, false, false, 0, 0},
    {1206, "date", BusUnit::date, kClock, Signal::count_, 0, false, false, 0, 0},
};
/// The identifier is the distance from the bus file's first one.
constexpr IdentifierEntry kGuidance[] = {
    {0, "navigation source", BusUnit::none, type_bit(DataType::uchar8), Signal::navigation_source, 0, false, false, 0,
     flight::kMaxNavigationSource},
    {1, "selected altitude", BusUnit::metre, kSelectable, Signal::selected_altitude, 0, false, false, -500, 20000},
    {2, "selected heading", BusUnit::degree, kSelectable, Signal::selected_heading, 0, false, false, -kPi, 2 * kPi},
    {3, "selected airspeed", BusUnit::metre_per_second, kSelectable, Signal::selected_airspeed, 0, false, false, 0, 400},
    {4, "selected vertical speed", BusUnit::metre_per_second, kSelectable, Signal::selected_vertical_speed, 0, false, false, -100,
     100},
    {5, "minimum altitude", BusUnit::metre, kSelectable, Signal::minimum_altitude, 0, false, false, -500, 10000},
    {6, "flaps position", BusUnit::none, kAnalogue, Signal::flaps_position, 0, false, false, 0, 1},
    {7, "waypoint bearing", BusUnit::degree, kSelectable, Signal::waypoint_bearing, 0, false, false, -kPi, 2 * kPi},
};
static_assert(sizeof kGuidance / sizeof kGuidance[0] == kGuidanceIdentifiers);

constexpr std::size_t kTableSize = sizeof kTable / sizeof kTable[0];
static_assert(kTableSize + kGuidanceIdentifiers <= kMaxPlaces);
constexpr std::size_t kIdentifierCount = 2048;

constexpr std::array<std::uint16_t, kIdentifierCount> make_index() {
    std::array<std::uint16_t, kIdentifierCount> index{};
    for (auto& place : index) place = kNotInTable;
    for (std::size_t i = 0; i < kTableSize; ++i) index[kTable[i].identifier] = static_cast<std::uint16_t>(i);
    return index;
}
constexpr std::array<std::uint16_t, kIdentifierCount> kIndex = make_index();

constexpr std::uint16_t kHeadingAngle = 321;
constexpr std::uint16_t kWindDirection = 334;
constexpr std::uint16_t kMagneticVariation = 1121;

double unit_factor(BusUnit unit, const BusDialect& dialect) {
    switch (unit) {
        case BusUnit::acceleration: return dialect.acceleration == AccelerationUnit::g ? base::kStandardGravity : 1.0;
        case BusUnit::pressure: return dialect.pressure == PressureUnit::hpa ? base::kPascalsPerHectopascal : 1.0;
        case BusUnit::degree:
        case BusUnit::degree_per_second: return base::kRadiansPerDegree;
        default: return 1.0;
    }
}

bool is_deviation(Signal signal) {
    switch (signal) {
        case Signal::ils1_localizer_deviation:
        case Signal::ils1_glideslope_deviation:
        case Signal::ils2_localizer_deviation:
        case Signal::ils2_glideslope_deviation:
        case Signal::cross_track_deviation:
        case Signal::gnss_vertical_deviation: return true;
        default: return false;
    }
}

bool is_direction_of_guidance(Signal signal) {
    return signal == Signal::desired_track || signal == Signal::waypoint_bearing || signal == Signal::selected_course ||
           signal == Signal::selected_heading;
}

AngleRange range_of(Signal signal) {
    switch (signal) {
        case Signal::true_heading:
        case Signal::magnetic_heading:
        case Signal::true_track:
        case Signal::desired_track:
        case Signal::waypoint_bearing:
        case Signal::selected_course:
        case Signal::selected_heading:
        case Signal::wind_direction: return AngleRange::heading;
        case Signal::longitude: return AngleRange::longitude;
        default: return AngleRange::as_is;
    }
}

}  // namespace

const char* to_string(BusUnit unit) noexcept {
    switch (unit) {
        case BusUnit::none: return "";
        case BusUnit::acceleration: return "g";
        case BusUnit::degree: return "deg";
        case BusUnit::degree_per_second: return "deg/s";
        case BusUnit::metre: return "m";
        case BusUnit::metre_per_second: return "m/s";
        case BusUnit::kelvin: return "K";
        case BusUnit::pressure: return "hPa";
        case BusUnit::bits: return "bits";
        case BusUnit::time_of_day: return "h:m:s";
        case BusUnit::date: return "d.m.y";
    }
    return "";
}

base::Span<const IdentifierEntry> identifier_table() noexcept { return {kTable, kTableSize}; }

std::uint16_t identifier_index(std::uint16_t identifier) noexcept {
    return identifier < kIdentifierCount ? kIndex[identifier] : kNotInTable;
}

base::Span<const IdentifierEntry> guidance_table() noexcept { return base::Span<const IdentifierEntry>(kGuidance); }

std::uint16_t place_of(std::uint16_t identifier, const GuidanceSettings& guidance) noexcept {
    if (guidance.has(identifier)) return static_cast<std::uint16_t>(kTableSize + identifier - guidance.first_identifier);
    return identifier_index(identifier);
}

const IdentifierEntry& entry_at(std::uint16_t place) noexcept {
    TEDAVIS_CHECK(place < place_count());
    return place < kTableSize ? kTable[place] : kGuidance[place - kTableSize];
}

std::uint16_t place_of_signal(Signal signal) noexcept {
    std::uint16_t found = kNotInTable;
    for (std::uint16_t place = 0; place < place_count(); ++place) {
        const IdentifierEntry& entry = entry_at(place);
        if (entry.signal == signal && (found == kNotInTable || entry.rank < entry_at(found).rank)) found = place;
    }
    return found;
}

std::uint16_t place_count() noexcept { return static_cast<std::uint16_t>(kTableSize + kGuidanceIdentifiers); }

SignalBinding bind(const IdentifierEntry& entry, const BusDialect& dialect) noexcept {
    SignalBinding binding;
    binding.signal = entry.signal;
    binding.rank = entry.rank;
    binding.factor = unit_factor(entry.unit, dialect);
    if (entry.identifier == kHeadingAngle && dialect.heading == HeadingReference::magnetic)
        binding.signal = Signal::magnetic_heading;
    if (entry.identifier == kWindDirection && dialect.wind == WindDirection::to) binding.offset = kPi;
    if (entry.identifier == kMagneticVariation && dialect.variation == VariationSign::west_positive)
        binding.factor = -binding.factor;
    if (is_deviation(binding.signal) && dialect.deviation == DeviationSign::path) binding.factor = -binding.factor;
    binding.is_magnetic = is_direction_of_guidance(binding.signal) && dialect.directions == HeadingReference::magnetic;
    binding.range = range_of(binding.signal);
    return binding;
}

double to_si(const SignalBinding& binding, double number) noexcept {
    const double si = number * binding.factor + binding.offset;
    switch (binding.range) {
        case AngleRange::heading: return earth::wrap_heading(si);
        case AngleRange::longitude: return earth::wrap_longitude(si);
        case AngleRange::as_is: return si;
    }
    return si;
}

double from_si(const SignalBinding& binding, double si) noexcept {
    const double shifted = si - binding.offset;
    return (binding.range == AngleRange::as_is ? shifted : earth::wrap_longitude(shifted)) / binding.factor;
}

}  // namespace tedavis::bus
