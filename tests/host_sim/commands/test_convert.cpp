#include "host_sim/commands/convert.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "bus/candump/candump_log_source.hpp"
#include "bus/state/state_assembler.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_convert {
namespace {

using flight::Signal;
using test_support::CommandRun;
using test_support::expect_user_error;
using test_support::run_command;
using ::testing::HasSubstr;
using ::testing::Not;

/// Forty fixes northwards at 50 m/s; `heights` names and fills the height columns.
std::string csv(const std::string& names, const std::string& values) {
    std::string text = "time,latitude_deg,longitude_deg," + names + "\n";
    for (int i = 0; i < 40; ++i)
        text += std::to_string(1586684820 + i) + "," + std::to_string(46.5 + i * 50.0 / 111180) + ",9.75," + values + "\n";
    return text;
}

class ConvertCommand : public ::testing::Test {
protected:
    CommandRun convert(const std::string& text, ConvertOptions options = {}) {
        options.flight = place_.write("f.csv", text);
        options.output = place_.file("f.log");
        return run_command([&](Console& console) { return run_convert(options, console); }, true);
    }
    /// What a listener on the bus knows half a minute into the flight.
    [[nodiscard]] flight::AircraftState state() const {
        const std::string log = place_.read("f.log");
        bus::CandumpLogSource source({log.data(), log.size()});
        std::vector<bus::CanFrame> frames(100'000);
        const base::Time now{1586684850'000'000'000};
        frames.resize(source.read(now, {frames.data(), frames.size()}));
        const auto assembler = std::make_unique<bus::StateAssembler>();
        assembler->feed({frames.data(), frames.size()});
        return assembler->snapshot(now).state;
    }
    test_support::TemporaryFolder place_;
};

TEST_F(ConvertCommand, SpeedsThatThePositionsContradictAreSpokenOf) {
    constexpr const char* kSaid = "note: speed: of 40 of 40 fixes the recorded speed contradicts the recorded positions";
    EXPECT_THAT(convert(csv("height_msl_m,ground_speed_mps,track_deg", "2000,90,0")).notes, HasSubstr(kSaid));
    EXPECT_THAT(convert(csv("height_msl_m,ground_speed_mps,track_deg", "2000,50,0")).notes, Not(HasSubstr("contradicts")));
}

TEST_F(ConvertCommand, GnssHeightsAboveSeaLevelGoToTheEllipsoid) {
    const CommandRun run = convert(csv("height_msl_m", "2000"));
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.json(), nlohmann::json::parse(place_.read("f.log.json"))) << "the companion file says the same";
    EXPECT_EQ(run.json()["gnss_datum"], "msl_egm96");
    EXPECT_EQ(run.json()["derived"]["height_is_geometric"], true);
    EXPECT_THAT(run.json()["derived"]["heading"].get<std::string>(), HasSubstr("derived: the track"));
    EXPECT_THAT(run.json()["derived"]["roll"].get<std::string>(), HasSubstr("derived: bank"));
    EXPECT_TRUE(run.json()["qnh_hpa"].is_null());
    EXPECT_THAT(run.notes, Not(HasSubstr("degraded")));
    const flight::AircraftState known = state();
    EXPECT_NEAR(known[Signal::ellipsoid_height].value_or(0), 2000 + 49.6, 2) << "the geoid lies about 50 m up in the Engadin";
    EXPECT_NEAR(known[Signal::ground_speed].value_or(0), 50, 0.1);
    EXPECT_NEAR(known[Signal::true_heading].value_or(1), 0, 1e-3);
}

TEST_F(ConvertCommand, EllipsoidHeightsStayAsTheyAre) {
    EXPECT_EQ(convert(csv("height_ellipsoid_m", "2000")).json()["gnss_datum"], "wgs84_ellipsoid");
    EXPECT_NEAR(state()[Signal::ellipsoid_height].value_or(0), 2000, 0.01);
}

TEST_F(ConvertCommand, BarometricHeightsAloneAreFlagged) {
    const CommandRun run = convert(csv("pressure_altitude_m", "1800"));
    EXPECT_EQ(run.json()["derived"]["height_is_geometric"], false);
    EXPECT_THAT(run.notes, HasSubstr("terrain will be shown as degraded and flagged"));
    const flight::AircraftState known = state();
    EXPECT_NEAR(known[Signal::standard_altitude].value_or(0), 1800, 0.01);
    EXPECT_FALSE(known[Signal::ellipsoid_height].received());
    EXPECT_FALSE(known[Signal::baro_altitude].received());
}

TEST_F(ConvertCommand, AQnhMakesThemAltitudes) {
    ConvertOptions options;
    options.qnh_hpa = 1023.25;
    const CommandRun run = convert(csv("pressure_altitude_m", "1800"), options);
    EXPECT_EQ(run.json()["qnh_hpa"], 1023.25);
    EXPECT_THAT(run.notes, Not(HasSubstr("degraded")));
    const flight::AircraftState known = state();
    EXPECT_NEAR(known[Signal::baro_setting].value_or(0), 102325, 1);
    EXPECT_NEAR(known[Signal::baro_altitude].value_or(0), 1800 + 81, 3) << "8.3 m a hectopascal at sea level, less above";
    EXPECT_FALSE(known[Signal::ellipsoid_height].received()) << "an altitude on QNH is no geometric height";
}

TEST_F(ConvertCommand, GeometryIsAssumedOnlyWhenAsked) {
    ConvertOptions options;
    options.assume_geometric = true;
    EXPECT_EQ(convert(csv("pressure_altitude_m", "1800"), options).json()["derived"]["height_is_geometric"], true);
    EXPECT_NEAR(state()[Signal::ellipsoid_height].value_or(0), 1800 + 49.6, 2);
}

TEST_F(ConvertCommand, RecordedAttitudeIsSaidToBeRecorded) {
    const CommandRun run = convert(csv("height_msl_m,heading_deg,pitch_deg,roll_deg", "2000,7,3,-5"));
    EXPECT_THAT(run.json()["derived"]["heading"].get<std::string>(), HasSubstr("recorded where complete"));
    EXPECT_NEAR(state()[Signal::roll].value_or(0), base::radians(-5), 1e-6);
    EXPECT_NEAR(state()[Signal::true_heading].value_or(0), base::radians(7), 1e-6);
}

TEST_F(ConvertCommand, ConvertsToTheSameBytesAgain) {
    (void)convert(csv("height_msl_m", "2000"));
    const std::string first = place_.read("f.log");
    (void)convert(csv("height_msl_m", "2000"));
    EXPECT_EQ(place_.read("f.log"), first);
}

TEST_F(ConvertCommand, OtherFilesAreNotReplaced) {
    const std::string mine = "my own notes\n";
    for (const char* const name : {"f.log", "f.log.json"}) {
        place_.write(name, mine);
        expect_user_error([&] { (void)convert(csv("height_msl_m", "2000")); },
                          std::string(name) + ": is there already and is no");
        EXPECT_EQ(place_.read(name), mine);
        std::filesystem::remove(place_.file(name));
    }
    EXPECT_EQ(place_.entries(), 1u) << "only the flight itself";
}

TEST_F(ConvertCommand, LeavesNothingWhereItRefuses) {
    ConvertOptions options;
    for (const double qnh : {0.0, 860.0, 1100.0, std::nan("")}) {
        options.qnh_hpa = qnh;
        expect_user_error([&] { (void)convert(csv("height_msl_m", "2000"), options); }, "a QNH lies within 870..1085 hPa");
    }
    expect_user_error([&] { (void)convert("time,latitude_deg,longitude_deg\n0,1,2\n"); }, "f.csv: no two fixes");
    EXPECT_EQ(place_.entries(), 1u) << "only the flight itself";
}

}  // namespace
}  // namespace tedavis::host_sim::test_convert
