#include "host_sim/accuracy/knobs/recorded_poses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/input_file.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_recorded_poses {
namespace {

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

RecordedPoses read(const std::string& log, const std::string& switches = "") {
    std::ostringstream results, notes;
    Console console{results, notes, true, false};
    return read_recorded_poses({log, "canaerospace", switches, "one_hot"}, files().terrain, console);
}

/// The log without the frames of some identifiers.
std::string log_without(const std::vector<std::string>& identifiers, const std::string& name) {
    std::istringstream lines(read_file(files().log));
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        bool is_left_out = false;
        for (const std::string& identifier : identifiers)
            is_left_out = is_left_out || line.find(" " + identifier + "#") != std::string::npos;
        if (!is_left_out) kept += line + "\n";
    }
    return files().folder.write(name, kept);
}

TEST(RecordedPoses, AreWhereTheFlightIsByItsFormula) {
    const RecordedPoses recorded = read(files().log);
    const test_support::FlownCircle flown;
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    ASSERT_GT(recorded.valid.size(), 60u) << "eight seconds, ten a second";
    EXPECT_EQ(recorded.step_s, 0.1);
    for (const AircraftPose& pose : recorded.valid) {
        const auto truth = *flown.at(flown.begin() + (pose.time - base::Time{}));
        EXPECT_NEAR(base::radians(pose.latitude_deg), truth[flight::Signal::latitude], 2e-7) << "a metre";
        EXPECT_NEAR(base::radians(pose.longitude_deg), truth[flight::Signal::longitude], 2e-7);
        const double undulation_m = geoid.undulation(base::radians(pose.latitude_deg), base::radians(pose.longitude_deg)).m;
        EXPECT_NEAR(pose.altitude_msl_m + undulation_m, truth[flight::Signal::ellipsoid_height], 1);
        EXPECT_NEAR(pose.pitch_deg, -8, 0.1);
        EXPECT_NEAR(pose.roll_deg, -15, 0.1);
        EXPECT_NEAR(std::sin(base::radians(pose.heading_deg) - truth[flight::Signal::true_heading]), 0, 0.01);
    }
    EXPECT_GT(std::abs(recorded.valid.front().latitude_deg - recorded.valid.back().latitude_deg), 1e-3) << "control: it moves";
}

TEST(RecordedPoses, TellFlightsAndSwitchLogsApart) {
    const std::uint64_t identity = read(files().log).identity;
    EXPECT_EQ(read(files().log).identity, identity);
    EXPECT_NE(read(files().folder.write("longer.log", read_file(files().log) + "\n")).identity, identity);
    const std::string switches = files().folder.write("f.switches", "# tedavis switch log 1\n");
    EXPECT_NE(read(files().log, switches).identity, identity);
}

TEST(RecordedPoses, KeepThePhaseThatTheyHad) {
    const std::string begin = std::to_string(test_support::FlownCircle::kBegin_s);
    std::string text = "# tedavis switch log 1\n";
    for (const char* line : {"GROUND", "TAKEOFF", "CRUISE", "APPROACH", "GO_AROUND", "REPLAN", "AUTO"})
        text += "(" + begin + ".000000) panel." + line + (std::string(line) == "CRUISE" ? " 1\n" : " 0\n");
    text += "(" + std::to_string(test_support::FlownCircle::kBegin_s + 4) + ".000000) panel.CRUISE 0\n(" +
            std::to_string(test_support::FlownCircle::kBegin_s + 4) + ".000100) panel.APPROACH 1\n";
    const RecordedPoses recorded = read(files().log, files().folder.write("phases.switches", text));
    const auto phase_at = [&](double at_s) {
        const auto found = std::find_if(recorded.valid.begin(), recorded.valid.end(), [at_s](const AircraftPose& pose) {
            return (pose.time - base::Time{}).to_seconds() > at_s - 0.05;
        });
        return found->phase.scenario;
    };
    EXPECT_EQ(phase_at(3), flight::Scenario::cruise);
    EXPECT_EQ(phase_at(7), flight::Scenario::approach);
}

TEST(RecordedPoses, ALogWithoutAPositionIsRefused) {
    const std::string log = log_without({"40C", "40D", "40E"}, "nowhere.log");
    test_support::expect_user_error([&] { static_cast<void>(read(log)); }, "has no valid position at any instant");
    test_support::expect_user_error([&] { static_cast<void>(read(files().folder.file("none.log"))); }, "none.log");
    const test_support::FlownFiles away{test_support::FlownAway()};
    test_support::expect_user_error([&] { static_cast<void>(read(away.log)); }, "is nowhere over " + files().terrain);
}

}  // namespace
}  // namespace tedavis::host_sim::test_recorded_poses
