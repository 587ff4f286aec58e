#include "host_sim/commands/record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <sstream>

#include "host_sim/commands/convert.hpp"
#include "host_sim/commands/verify.hpp"
#include "host_sim/flight_test/read_flight_test.hpp"
#include "host_sim/flight_test/step_log.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/user_error.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_record {
namespace {

using test_support::CommandRun;
using ::testing::HasSubstr;

/// A message, a switch, a signal that is lost and comes back.
const std::string kSteps =
    "[[step]]\nat_s = 0\nphase = \"ground\"\n[[step]]\nat_s = 4\nphase = \"cruise\"\n[[step]]\nat_s = 9\nswitch = \"APPROACH\"\n"
    "[[step]]\nat_s = 12\nstop = [\"pitch\"]\n[[step]]\nat_s = 16\nsend = [\"pitch\"]\n[[expect]]\nat_s = 20\nphase = "
    "\"approach\"\n";

CommandRun record(const RecordOptions& options, bool json = false) {
    return test_support::run_command([&](Console& console) { return run_record(options, console); }, json);
}

class Record : public ::testing::Test {
protected:
    Record() {
        options_.input = place_.file("steps.log");
        options_.output = place_.file("s.toml");
    }
    void make_steps(const std::string& steps = kSteps) {
        ScriptFaults faults;
        const FlightTest test = read_flight_test(place_.write("steps.toml", steps), {}, faults);
        ASSERT_TRUE(faults.empty());
        std::ostringstream log;
        write_step_log(test, log, "steps.log");
        place_.write("steps.log", log.str());
        if (const std::string edges = step_switch_log(test); !edges.empty())
            options_.switches = place_.write("steps.switches", edges);
    }
    CommandRun verify() const {
        VerifyOptions options;
        options.scripts = {place_.file("s.toml")};
        return test_support::run_command([&](Console& console) { return run_verify(options, console); }, true);
    }
    /// The first expectation that fails, by its time.
    static nlohmann::json first_failure(const CommandRun& run) {
        nlohmann::json first;
        const nlohmann::json json = run.json();
        for (const auto& one : json["tests"][0]["expectations"])
            if (!one["holds"].get<bool>() && (first.is_null() || one["failed_s"] < first["failed_s"])) first = one;
        return first;
    }
    void change(const std::string& file, const std::string& from, const std::string& to) const {
        std::string text = place_.read(file);
        std::size_t count = 0;
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()), ++count)
            text.replace(at, from.size(), to);
        ASSERT_GT(count, 0u) << from;
        place_.write(file, text);
    }
    test_support::TemporaryFolder place_;
    RecordOptions options_;
};

TEST_F(Record, AFlightOfStepsIsExpectedAsItIs) {
    make_steps();
    const CommandRun run = record(options_, true);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.json()["left_out"], nullptr);
    const std::string script = place_.read("s.toml");
    for (const char* said : {"log = \"./steps.log\"", "switch_log = \"./steps.switches\"", "phase = \"cruise\"",
                             "phase_source = \"switch\"", "pitch = \"lost\"", "pitch becomes stale", "pitch becomes valid"})
        EXPECT_THAT(script, HasSubstr(said)) << script;
    const CommandRun holds = verify();
    EXPECT_EQ(holds.code, 0) << holds.results << script;
    EXPECT_EQ(holds.json()["tests"][0]["expectations"].size(), run.json()["expectations"].get<std::size_t>());
}

/// The negative controls: a log, a panel and a loss that are others than at the recording.
TEST_F(Record, AnotherPhaseOnTheBusIsFoundWhereItComes) {
    make_steps();
    ASSERT_EQ(record(options_).code, 0);
    std::size_t changed = 0;
    std::istringstream lines(place_.read("steps.log"));
    std::string other;
    for (std::string line; std::getline(lines, line); other += line + "\n") {
        const std::size_t at = line.find("726#");  // message 1830; its fifth byte is the phase's code: 1E, cruise
        if (at == std::string::npos || line.compare(at + 12, 2, "1E") != 0) continue;
        line.replace(at + 12, 2, "14");
        ++changed;
    }
    ASSERT_GT(changed, 0u);
    place_.write("steps.log", other);
    const CommandRun run = verify();
    EXPECT_EQ(run.code, 1);
    const auto failure = first_failure(run);
    EXPECT_EQ(failure["key"], "phase") << failure;
    EXPECT_EQ(failure["found"], "takeoff");
    EXPECT_NEAR(failure["failed_s"].get<double>(), 5.5, 0.6) << "stated at 4 s, believed after 1 s, and the margin";
}

TEST_F(Record, AnotherPanelIsFoundWhereItIsThrown) {
    make_steps();
    std::filesystem::copy_file(test_support::source_dir() + "/configs/switches/one_hot.toml", place_.file("panel.toml"));
    options_.switch_config = place_.file("panel.toml");
    ASSERT_EQ(record(options_).code, 0);
    EXPECT_THAT(place_.read("s.toml"), HasSubstr("switches = \"./panel.toml\""));
    ASSERT_EQ(verify().code, 0);
    change("panel.toml", "phase = \"approach\"", "phase = \"takeoff\"");
    const auto failure = first_failure(verify());
    EXPECT_EQ(failure["found"], "takeoff") << failure;
    EXPECT_NEAR(failure["failed_s"].get<double>(), 9.3, 0.5);
}

TEST_F(Record, ASwappedDesignIsFound) {
    make_steps();
    const std::string designs = test_support::source_dir() + "/configs/designs";
    std::filesystem::copy(designs, place_.file("designs"), std::filesystem::copy_options::recursive);
    std::filesystem::copy(designs + "/../palettes", place_.file("palettes"), std::filesystem::copy_options::recursive);
    options_.design = place_.file("designs/default.toml");
    ASSERT_EQ(record(options_).code, 0);
    ASSERT_EQ(verify().code, 0);
    change("designs/default.toml", "\napproach = \"approach\"", "\napproach = \"takeoff\"");
    const auto failure = first_failure(verify());
    EXPECT_EQ(failure["key"], "design") << failure;
    EXPECT_EQ(failure["found"], "takeoff");
}

/// A flight as a receiver records it: uneven fixes that scatter, at the ground, off it and climbing.
std::string recorded_csv() {
    std::string text = "time,latitude_deg,longitude_deg,height_msl_m,ground_speed_mps,track_deg\n";
    double north_m = 0, height_m = 500, time_s = 1586684820;
    for (int n = 0; n < 70; ++n) {
        const double step_s = n % 7 == 3 ? 2 : 1, speed = n < 15 ? 0 : std::min(2.5 * (n - 15), 45.0);
        north_m += speed * step_s;
        height_m += (speed > 40 ? 3.5 : 0) * step_s;
        time_s += step_s;
        char line[160];
        std::snprintf(line, sizeof line, "%.0f,%.7f,%.7f,%.1f,%.1f,%.1f\n", time_s, 46.5 + (north_m + n % 3 * 0.4) / 111180,
                      9.75 + n % 2 * 3e-6, height_m + n % 5 * 0.3, speed, n % 4 * 0.5);
        text += line;
    }
    return text;
}

TEST_F(Record, ARecordedFlightIsExpectedAsItIs) {
    ConvertOptions convert;
    convert.flight = place_.write("f.csv", recorded_csv());
    convert.output = place_.file("f.log");
    ASSERT_EQ(test_support::run_command([&](Console& console) { return run_convert(convert, console); }).code, 0);
    options_.input = place_.file("f.log");
    ASSERT_EQ(record(options_).code, 0);
    EXPECT_THAT(place_.read("s.toml"), HasSubstr("phase_source = \"motion\""));
    const CommandRun run = verify();
    EXPECT_EQ(run.code, 0) << run.results << place_.read("s.toml");
}

/// A scenario and a terrain are named, not where they were built.
TEST_F(Record, APartOfTheShippedFlightIsExpectedAsItIs) {
    options_.input = "default";
    options_.terrain = "jacksboro";
    options_.from_s = 100;
    options_.to_s = 112;
    const CommandRun recorded = record(options_, true);
    ASSERT_EQ(recorded.code, 0);
    EXPECT_NEAR(recorded.json()["from_s"].get<double>(), 100, 0.05);
    EXPECT_NEAR(recorded.json()["to_s"].get<double>(), 112, 0.05);
    const std::string script = place_.read("s.toml");
    EXPECT_THAT(script, HasSubstr("scenario = \"default\""));
    EXPECT_THAT(script, HasSubstr("terrain = \"jacksboro\""));
    EXPECT_THAT(script, HasSubstr("the phase becomes cruise, its source becomes switch, the design becomes cruise"));
    const CommandRun run = verify();
    EXPECT_EQ(run.code, 0) << run.results << script;
}

/// Without edits. In the first two there is a scene and no terrain, at the ground and in flight; in the third the flag
/// terrain.tau_raised is there for two frames; in the last two obstacles are watched for, and are not.
TEST_F(Record, StretchesOfTheShippedFlightHoldUnedited) {
    const struct {
        const char* terrain;
        double from_s, to_s;
        const char* says;
    } kStretches[] = {{"", 0, 4, "phase = \"ground\""},
                      {"", 150, 154, "phase = \"approach"},
                      {"jacksboro", 134, 138, "terrain.tau_raised goes"},
                      {"jacksboro", 0, 4, "obstacle_alert = \"not_watching\""},
                      {"jacksboro", 120, 124, "obstacle_alert = \"none\""}};
    options_.input = "default";
    options_.yes = true;
    for (const auto& stretch : kStretches) {
        options_.terrain = stretch.terrain;
        options_.from_s = stretch.from_s;
        options_.to_s = stretch.to_s;
        ASSERT_EQ(record(options_).code, 0);
        const std::string script = place_.read("s.toml");
        EXPECT_THAT(script, HasSubstr(stretch.says)) << stretch.from_s;
        const CommandRun run = verify();
        EXPECT_EQ(run.code, 0) << stretch.from_s << " " << run.results << script;
    }
}

/// From a sub-phase to its own scenario, and back.
TEST_F(Record, AScenarioAfterItsSubPhaseIsExpectedAsItIs) {
    const std::string steps =
        "[[step]]\nat_s = 0\nphase = \"approach.final\"\n[[step]]\nat_s = 4\nphase = \"approach\"\n"
        "[[step]]\nat_s = 9\nphase = \"approach.final\"\n[[expect]]\nat_s = 14\nphase = \"approach\"\n";
    make_steps(steps);
    ASSERT_EQ(record(options_).code, 0);
    const std::string script = place_.read("s.toml");
    EXPECT_THAT(script, HasSubstr("phase = \"approach.none\""));
    EXPECT_EQ(verify().code, 0) << script;
    std::filesystem::remove(place_.file("steps.log"));
    const std::size_t at = steps.find("phase = \"approach\"");
    make_steps(std::string(steps).replace(at, 18, "phase = \"approach.final\""));
    EXPECT_EQ(first_failure(verify())["expected"], "approach.none") << "a display that stays with the sub-phase is found";
}

TEST_F(Record, SingleTimesAreExpectedAsTheyAre) {
    make_steps();
    options_.at_s = {14, 2, 2};
    EXPECT_EQ(record(options_, true).json()["expectations"], 2);
    const std::string script = place_.read("s.toml");
    EXPECT_LT(script.find("at_s = 2\nphase = \"ground\""), script.find("at_s = 14\nphase = \"approach.none\""));
    EXPECT_THAT(script, HasSubstr("signals.pitch = \"lost\""));
    EXPECT_EQ(verify().code, 0) << script;
}

TEST_F(Record, AScriptThatIsThereStays) {
    make_steps();
    options_.at_s = {2};
    place_.write("s.toml", "edited by hand");
    test_support::expect_user_error([&] { static_cast<void>(record(options_)); }, "replace it with --yes");
    EXPECT_EQ(place_.read("s.toml"), "edited by hand");
    options_.yes = true;
    EXPECT_EQ(record(options_).code, 0);
    EXPECT_EQ(verify().code, 0);
    options_.output = options_.input;
    test_support::expect_user_error([&] { static_cast<void>(record(options_)); }, "is also an input");
}

TEST_F(Record, WhatCannotBeRecordedIsRefusedAndNothingIsWritten) {
    make_steps();
    const auto refused = [&](const RecordOptions& options, const std::string& words) {
        test_support::expect_user_error([&] { static_cast<void>(record(options)); }, words);
        EXPECT_FALSE(std::filesystem::exists(options.output));
        EXPECT_FALSE(std::filesystem::exists(options.output + ".part"));
    };
    RecordOptions wrong = options_;
    wrong.from_s = 500;
    refused(wrong, "500 s: there is no frame, since the input ends");
    wrong.from_s = 5;
    wrong.to_s = 4;
    refused(wrong, "--to lies before --from");
    wrong = options_;
    wrong.at_s = {1, 90};
    refused(wrong, "90 s: there is no frame");
    wrong = options_;
    wrong.to_s = 0.05;
    refused(wrong, "too short to expect anything");
    wrong = options_;
    wrong.input = place_.file("none.log");
    refused(wrong, "none.log");
    wrong.input = "no_such_scenario";
    wrong.switches.clear();
    refused(wrong, "no_such_scenario");
    wrong = options_;
    wrong.design = "no_such_design";
    refused(wrong, "no_such_design");
    wrong.design = place_.write("$design.toml", "");
    EXPECT_THROW(static_cast<void>(record(wrong)), UserError);
    EXPECT_FALSE(std::filesystem::exists(wrong.output));
}

TEST_F(Record, AnInterruptedRecordingWritesNothing) {
    make_steps();
    const InterruptGuard interrupt;
    std::raise(SIGINT);
    EXPECT_THROW(static_cast<void>(record(options_)), Interrupted);
    EXPECT_FALSE(std::filesystem::exists(options_.output));
    EXPECT_FALSE(std::filesystem::exists(options_.output + ".part"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_record
