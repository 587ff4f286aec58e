#include "render_core/design/aircraft_settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::design::test_aircraft_settings {
namespace {

using test_support::source_file;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The international knot in m/s, written down once more.
constexpr double kKnot = 1852.0 / 3600.0;

/// Lines 1 to 16, of which tests replace parts.
const std::string kSound =
    "name = 'own'\n"
    "[speeds]\n"
    "vno_kt = 120\n"
    "vne_kt = 160\n"
    "[[flaps]]\n"
    "name = 'UP'\n"
    "position = 0\n"
    "stall_kt = 50\n"
    "[[flaps]]\n"
    "name = 'FULL'\n"
    "position = 1\n"
    "limit_kt = 90\n"
    "stall_mps = 20\n"
    "[[flag]]\n"
    "name = 'R'\n"
    "speed_kt = 55\n";

std::string replaced(const std::string& part, const std::string& by) {
    std::string text = kSound;
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), by);
}

/// Empty where the file is accepted.
std::string error_of(const std::string& text) {
    const auto read = load_aircraft(text, "own.toml");
    return read.ok() ? std::string() : std::string(read.error().message.view());
}

AircraftSettings sound() { return load_aircraft(kSound, "own.toml").value(); }

TEST(AircraftSettings, ReadsEveryKeyIntoSiUnits) {
    const std::string text = kSound +
                             "[low_speed]\ncaution_factor = 1.2\n[eye]\nforward_m = 1.5\nright_m = -0.25\nup_m = -0.5\n"
                             "[turn]\nexcessive_bank_deg = 60\nstandard_turn_deg_s = 1.5\n";
    const auto read = load_aircraft(text, "own.toml");
    ASSERT_TRUE(read.ok()) << read.error().message.view();
    const AircraftSettings& aircraft = read.value();
    EXPECT_TRUE(aircraft.is_stated());
    EXPECT_EQ(aircraft.name.view(), "own");
    EXPECT_DOUBLE_EQ(aircraft.normal_limit_mps, 120 * kKnot);
    EXPECT_DOUBLE_EQ(aircraft.limit_mps, 160 * kKnot);
    EXPECT_FALSE(aircraft.has_vmo);
    EXPECT_TRUE(std::isinf(aircraft.limit_up_to_m));
    ASSERT_EQ(aircraft.flaps.size(), 2u);
    EXPECT_EQ(aircraft.flaps[0].name.view(), "UP");
    EXPECT_DOUBLE_EQ(aircraft.flaps[0].limit_mps, 160 * kKnot) << "flaps that are up have the aircraft's limit";
    EXPECT_DOUBLE_EQ(aircraft.flaps[0].stall_mps, 50 * kKnot);
    EXPECT_EQ(aircraft.flaps[1].position, 1);
    EXPECT_DOUBLE_EQ(aircraft.flaps[1].limit_mps, 90 * kKnot);
    EXPECT_EQ(aircraft.flaps[1].stall_mps, 20) << "stated in m/s";
    ASSERT_EQ(aircraft.flags.size(), 1u);
    EXPECT_EQ(aircraft.flags[0].name.view(), "R");
    EXPECT_DOUBLE_EQ(aircraft.flags[0].speed_mps, 55 * kKnot);
    EXPECT_EQ(aircraft.caution_factor, 1.2);
    EXPECT_EQ(aircraft.eye.forward_m, 1.5);
    EXPECT_EQ(aircraft.eye.right_m, -0.25);
    EXPECT_EQ(aircraft.eye.up_m, -0.5);
    EXPECT_DOUBLE_EQ(aircraft.excessive_bank_rad, std::acos(-1) / 3);
    EXPECT_DOUBLE_EQ(aircraft.standard_turn_rad_s, std::acos(-1) / 120);
}

TEST(AircraftSettings, WhatMayBeLeftOutHasADefault) {
    const AircraftSettings aircraft = sound();
    EXPECT_EQ(aircraft.caution_factor, 1.1);
    EXPECT_EQ(aircraft.eye.forward_m, 0);
    EXPECT_EQ(aircraft.eye.right_m, 0);
    EXPECT_EQ(aircraft.eye.up_m, 0);
    EXPECT_DOUBLE_EQ(aircraft.excessive_bank_rad, std::acos(-1) / 4);
    EXPECT_EQ(load_aircraft(replaced("vno_kt = 120\n", ""), "x").value().normal_limit_mps, 0);
    EXPECT_FALSE(AircraftSettings().is_stated());
}

TEST(AircraftSettings, AVmoStandsInForVneAndVno) {
    const std::string speeds = "vno_kt = 120\nvne_kt = 160\n";
    const auto read = load_aircraft(replaced(speeds, "vmo_mps = 100\nvmo_up_to_ft = 10000\n"), "x");
    ASSERT_TRUE(read.ok()) << read.error().message.view();
    EXPECT_TRUE(read.value().has_vmo);
    EXPECT_EQ(read.value().limit_mps, 100);
    EXPECT_NEAR(read.value().limit_up_to_m, 3048, 1e-9);
    EXPECT_EQ(read.value().flaps[0].limit_mps, 100);
}

/// A part of the sound file, what stands there instead, the line of the fault (0: the file's) and words of the sentence.
struct Fault {
    const char *part, *by;
    int line;
    const char* says;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.by; }
class AircraftFault : public ::testing::TestWithParam<Fault> {};

TEST_P(AircraftFault, IsOneSentenceWithFileAndLine) {
    const Fault& fault = GetParam();
    const std::string message = error_of(replaced(fault.part, fault.by));
    EXPECT_THAT(message, StartsWith(fault.line == 0 ? "own.toml: " : "own.toml:" + std::to_string(fault.line) + ": "));
    EXPECT_THAT(message, HasSubstr(fault.says));
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Each, AircraftFault,
    ::testing::Values(
        // Speeds without a unit, in two units, in another one, out of range
        Fault{"vne_kt", "vne", 4, "'vne' has no unit; write 'vne_kt' for knots or 'vne_mps' for metres per second"},
        Fault{"vno_kt", "vno", 3, "'vno' has no unit"}, Fault{"limit_kt", "limit", 12, "'limit' has no unit"},
        Fault{"stall_kt", "stall", 8, "'stall' has no unit"}, Fault{"speed_kt", "speed", 16, "'speed' has no unit"},
        Fault{"vne_kt = 160", "vne_kt = 160\nvne_mps = 82", 5, "is stated in knots as well"},
        Fault{"stall_kt = 50", "stall_kmh = 90", 5, "'stall_kt' is missing"},
        Fault{"vne_kt = 160", "vne_kt = '160 kt'", 4, "'vne_kt' must be a number from 10 to 680"},
        Fault{"stall_mps = 20", "stall_mps = 2", 13, "'stall_mps' must be a number from 5 to 350"},
        Fault{"stall_mps = 20", "stall_mps = nan", 13, "'stall_mps' must be a number"},
        // Bands out of order
        Fault{"vno_kt = 120", "vno_kt = 160", 3, "'vno_kt' must be below vne"},
        Fault{"vno_kt = 120", "vno_kt = 54", 3, "must be above the stall speed with the flaps at 0"},
        Fault{"stall_kt = 50", "stall_kt = 150", 8, "must be below the highest speed with these flaps"},
        Fault{"limit_kt = 90", "limit_mps = 21", 13, "must be below the highest speed with these flaps"},
        Fault{"speed_kt = 55", "speed_kt = 161", 16, "must not be above vne or vmo"},
        // Limits that do not belong together
        Fault{"vne_kt = 160", "vmo_kt = 160", 3, "belongs to vne"},
        Fault{"vne_kt = 160\n", "", 2, "either vne_kt (never exceed) or vmo_kt (maximum operating speed); give one of them"},
        Fault{"vne_kt = 160\n", "vne_kt = 160\nvmo_kt = 200\n", 2, "either vne_kt"},
        Fault{"vne_kt = 160\n", "vne_kt = 160\nvmo_up_to_ft = 9000\n", 5, "belongs to vmo"},
        Fault{"[speeds]\nvno_kt = 120\nvne_kt = 160\n", "", 0, "either vne_kt"},
        // Settings of the flaps
        Fault{"position = 1\n", "position = 0.9\n", 11, "of the last setting must be 1"},
        Fault{"position = 0\n", "position = 0.2\n", 7, "of the first setting must be 0"},
        Fault{"position = 1\n", "position = 0\n", 11, "at least 0.05 more than that of the setting before it"},
        Fault{"position = 1\n", "position = 0.04\n", 11, "at least 0.05 more"},
        Fault{"position = 1\n", "position = 30\n", 11, "'position' must be a number from 0 to 1"},
        Fault{"limit_kt = 90", "limit_kt = 170", 12, "must not be above that of the setting before it"},
        Fault{"stall_mps = 20", "stall_mps = 26", 13, "must not be above that of the setting before it"},
        Fault{"stall_kt = 50", "stall_kt = 50\nlimit_kt = 90", 9, "at position 0 it is vne or vmo"},
        Fault{"stall_kt = 50", "stall_kt = 50\nlimit = 90", 9, "at position 0 it is vne or vmo"},
        Fault{"name = 'FULL'", "name = 'EXTENDED'", 10, "must be 1 to 7 characters"},
        Fault{"limit_kt = 90\n", "", 9, "'limit_kt' is missing"},
        // Flags
        Fault{"name = 'R'", "name = 'ROT'", 15, "one or two upper-case letters or digits"},
        Fault{"name = 'R'", "name = 'r'", 15, "one or two upper-case letters or digits"},
        Fault{"name = 'R'", "name = ''", 15, "one or two upper-case letters or digits"},
        Fault{"speed_kt = 55\n", "speed_kt = 55\n[[flag]]\nname = 'R'\nspeed_kt = 60\n", 18, "is that of another flag"},
        // The rest
        Fault{"name = 'own'", "name = ''", 1, "must be 1 to 31 characters"}, Fault{"name = 'own'\n", "", 1, "'name' is missing"},
        Fault{"name = 'own'", "name = 'own'\nmass_kg = 1100", 2, "unknown key 'mass_kg'"},
        Fault{"speed_kt = 55", "speed_kt = 55\n[low_speed]\ncaution_factor = 1", 18, "'caution_factor' must be a number"},
        Fault{"speed_kt = 55", "speed_kt = 55\n[eye]\nup_m = 200", 18, "'up_m' must be a number from -100 to 100"},
        Fault{"speed_kt = 55", "speed_kt = 55\n[eye]\ndown_m = 2", 18, "unknown key 'eye.down_m'"},
        Fault{"speed_kt = 55", "speed_kt = 55\n[turn]\nexcessive_bank_deg = 90", 18, "'excessive_bank_deg' must be a number"},
        Fault{"[speeds]", "[speeds", 2, "mend the TOML there"}));

TEST(AircraftSettings, TooManySettingsAndFlagsAreRefused) {
    std::string flags = kSound, settings = kSound.substr(0, kSound.find("[[flaps]]\nname = 'FULL'"));
    const auto setting = [](int n, const char* position) {
        return "[[flaps]]\nname = '" + std::to_string(n) + "'\nposition = " + position + "\nlimit_kt = 90\nstall_kt = 40\n";
    };
    for (int n = 1; n < 10; ++n) flags += "[[flag]]\nname = '" + std::to_string(n) + "'\nspeed_kt = 80\n";
    EXPECT_EQ(error_of(flags), "") << "ten of them";
    EXPECT_THAT(error_of(flags + "[[flag]]\nname = 'Z'\nspeed_kt = 80\n"), HasSubstr("one flag too many; keep at most 10"));
    for (int n = 1; n < 7; ++n) settings += setting(n, ("0." + std::to_string(n)).c_str());
    EXPECT_EQ(error_of(settings + setting(7, "1")), "") << "eight of them";
    EXPECT_THAT(error_of(settings + setting(7, "0.7") + setting(8, "1")), HasSubstr("one setting too many; keep at most 8"));
    EXPECT_THAT(error_of("name = 'x'\n[speeds]\nvne_kt = 100\n"), HasSubstr("'flaps' must be stated"));
    EXPECT_EQ(error_of("name = 'x'\n[speeds]\nvne_kt = 100\n[[flaps]]\nname = 'UP'\nposition = 0\nstall_kt = 40\n"), "")
        << "an aircraft without flaps";
}

TEST(AircraftSettings, TheClassIsOneOfFour) {
    EXPECT_EQ(sound().aircraft_class, flight::AircraftClass::unstated);
    for (std::size_t n = 0; n < flight::kAircraftClassNames.size(); ++n) {
        const std::string name(flight::kAircraftClassNames[n]);
        if (name == "helicopter") continue;
        const auto read = load_aircraft("class = '" + name + "'\n" + kSound, "own.toml");
        ASSERT_TRUE(read.ok()) << read.error().message.view();
        EXPECT_EQ(static_cast<std::size_t>(read.value().aircraft_class), n);
    }
    EXPECT_THAT(error_of("class = 'balloon'\n" + kSound), HasSubstr("light, jet, helicopter"));
}

TEST(AircraftSettings, AHelicopterHasNeitherFlapsNorAStallSpeed) {
    const std::string helicopter = "name = 'x'\nclass = 'helicopter'\n[speeds]\nvne_kt = 150\n";
    const auto read = load_aircraft(helicopter, "own.toml");
    ASSERT_TRUE(read.ok()) << read.error().message.view();
    ASSERT_EQ(read.value().flaps.size(), 1u);
    EXPECT_EQ(read.value().flaps[0].stall_mps, 0);
    EXPECT_DOUBLE_EQ(read.value().flaps[0].limit_mps, 150 * kKnot);
    EXPECT_THAT(error_of("class = 'helicopter'\n" + kSound), HasSubstr("a helicopter has none, remove it"));
}

TEST(AircraftSettings, TheShippedAircraftAreSoundAndSaidToBeInvented) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(test_support::source_dir() + "/configs/aircraft")) {
        if (entry.path().extension() != ".toml") continue;
        const std::string text = source_file("configs/aircraft/" + entry.path().filename().string());
        const auto read = load_aircraft(text, entry.path().filename().string());
        ASSERT_TRUE(read.ok()) << read.error().message.view();
        EXPECT_EQ(read.value().name.view(), entry.path().stem().string());
        EXPECT_THAT(text, HasSubstr("INVENTED"));
        EXPECT_FALSE(read.value().flags.empty());
        names.insert(std::string(read.value().name.view()));
    }
    EXPECT_EQ(names, (std::set<std::string>{"glider", "helicopter", "jet", "light_piston", "turboprop"}));
}

/// Keys that the reader asks for, and a page that must have a row for each.
TEST(AircraftSettings, EveryKeyOfTheReaderIsInTheReadme) {
    const std::string source = source_file("render_core/design/aircraft_settings.cpp");
    const std::string readme = source_file("configs/aircraft/README.md");
    const std::regex asked(R"re((?:\.(?:number|text|choose|section|table_count)\(|read_speed\(\w+, )"([a-z_]+)")re");
    std::set<std::string> keys;
    for (std::sregex_iterator at(source.begin(), source.end(), asked), end; at != end; ++at) keys.insert((*at)[1]);
    EXPECT_GE(keys.size(), 18u);
    const auto is_in_readme = [&readme](const std::string& key) {
        const bool is_speed = readme.find("`" + key + "_kt`, `" + key + "_mps`") != std::string::npos;
        return is_speed || readme.find("`" + key + "`") != std::string::npos || readme.find(key + "]") != std::string::npos;
    };
    for (const std::string& key : keys) EXPECT_TRUE(is_in_readme(key)) << key;
    EXPECT_FALSE(is_in_readme("mass")) << "a control";
}

}  // namespace
}  // namespace tedavis::design::test_aircraft_settings
