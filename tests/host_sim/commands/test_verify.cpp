#include "host_sim/commands/verify.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <limits>
#include <sstream>

#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_verify {
namespace {

using test_support::CommandRun;
using ::testing::HasSubstr;

const std::string kCruise =
    "[[step]]\nat_s = 1\nphase = \"cruise\"\n[[expect]]\nat_s = 3\nphase = \"cruise\"\nphase_source = \"can\"\n";

CommandRun verify(const VerifyOptions& options, bool json = false) {
    return test_support::run_command([&](Console& console) { return run_verify(options, console); }, json);
}

class Verify : public ::testing::Test {
protected:
    CommandRun verify_text(const std::string& text, bool json = false) {
        VerifyOptions options;
        options.scripts = {place_.write("a.toml", text)};
        options.output = place_.file("out");
        options.junit = place_.file("r.xml");
        return verify(options, json);
    }
    bool has(const std::string& name) const { return std::filesystem::exists(place_.file(name)); }
    test_support::TemporaryFolder place_;
};

TEST_F(Verify, WhatHoldsEndsWithZero) {
    const CommandRun run = verify_text(kCruise);
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.results, HasSubstr("1 of 1 expectations hold"));
    EXPECT_FALSE(has("out/a.png"));
    EXPECT_THAT(place_.read("r.xml"), HasSubstr("failures=\"0\""));
}

TEST_F(Verify, WhatDoesNotHoldEndsWithOneAndItsPicture) {
    const CommandRun fails = verify_text(kCruise + "[[expect]]\nat_s = 2.5\nphase_source = \"motion\"\n", true);
    EXPECT_EQ(fails.code, 1);
    const auto failed = fails.json()["tests"][0]["expectations"][1];
    EXPECT_EQ(failed["found"], "can");
    EXPECT_NEAR(failed["failed_s"].get<double>(), 2.5, 0.05);
    EXPECT_TRUE(has("out/a.png"));
    EXPECT_EQ(nlohmann::json::parse(place_.read("out/a.json"))["phase_source"], "can");
    EXPECT_THAT(place_.read("r.xml"), HasSubstr("<failure message="));
}

/// The times of expectations are those of the steps, also on a bus that is dead at first.
TEST_F(Verify, ADeadBusAtTheStartIsNotValidYet) {
    const std::string steps =
        "[input]\nlasts_s = 30\n[[step]]\nat_s = 0\nstop = [\"all\"]\n[[step]]\nat_s = 5\nsend = [\"all\"]\n";
    EXPECT_EQ(verify_text(steps + "[[expect]]\nat_s = 1\nsignals = { pitch = \"missing\" }\n[[expect]]\nat_s = 6\nsignals = "
                                  "{ pitch = \"valid\" }\n")
                  .code,
              0);
    EXPECT_EQ(verify_text(steps + "[[expect]]\nat_s = 1\nsignals = { pitch = \"valid\" }\n").code, 1);
}

/// Without a heading the track stands for it; frames that are not drawn say so, too.
TEST_F(Verify, ElementsAreThoseOfTheFrame) {
    const std::string script =
        "[[step]]\nat_s = 2\nstop = [\"heading\"]\n[[expect]]\nat_s = 1\nelements = { heading = \"normal\" }\n[[expect]]\nat_s = "
        "6\nelements = { heading = \"";
    EXPECT_EQ(verify_text(script + "substituted\" }\n").code, 0);
    const CommandRun run = verify_text(script + "normal\" }\n");
    EXPECT_EQ(run.code, 1);
    EXPECT_THAT(run.results,
                HasSubstr("at 6.000 s elements: expected heading normal, found heading substituted (true_heading.lost"));
    EXPECT_THAT(run.results, HasSubstr("out/a.png shows 6.000 s ("));
}

TEST_F(Verify, FaultsAreAllToldAndNothingIsFlown) {
    const CommandRun run = verify_text("titel = \"x\"\n[[expect]]\nat_s = 1\nphase = \"crus\"\n");
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.notes, HasSubstr("a.toml:1: unknown key 'titel'"));
    EXPECT_THAT(run.notes, HasSubstr("a.toml:4: 'phase': there is no 'crus'; say cruise"));
    EXPECT_EQ(run.results, "");
    EXPECT_FALSE(has("out"));
}

/// Whoever reads results alone finds the fault, and nothing of an earlier run.
TEST_F(Verify, AFaultIsInTheResultsAndNoEarlierOneIsLeft) {
    ASSERT_EQ(verify_text(kCruise + "[[expect]]\nat_s = 2.5\nphase_source = \"motion\"\n").code, 1);
    ASSERT_TRUE(has("out/a.png"));
    VerifyOptions options;
    options.scripts = {place_.write("a.toml", "titel = \"x\"\n" + kCruise), place_.write("b.toml", kCruise)};
    options.output = place_.file("out");
    options.junit = place_.file("r.xml");
    const CommandRun run = verify(options, true);
    EXPECT_EQ(run.code, 2);
    const auto json = run.json();
    EXPECT_EQ(json["holds"], false);
    EXPECT_THAT(json["tests"][0]["fault"].get<std::string>(), HasSubstr("a.toml:1: unknown key 'titel'"));
    EXPECT_EQ(json["tests"][1]["fault"], nullptr);
    EXPECT_THAT(json["tests"][1]["left_out"].get<std::string>(), HasSubstr("another script is wrong"));
    const std::string xml = place_.read("r.xml");
    EXPECT_THAT(xml, HasSubstr("<error message="));
    EXPECT_THAT(xml, HasSubstr("unknown key"));
    EXPECT_THAT(xml, ::testing::Not(HasSubstr("<failure")));
    EXPECT_FALSE(has("out/a.png"));
    EXPECT_FALSE(has("out/a.json"));
}

/// Also where the scripts cannot even be read.
TEST_F(Verify, AMissingScriptLeavesNoEarlierResult) {
    ASSERT_EQ(verify_text(kCruise).code, 0);
    VerifyOptions options;
    options.scripts = {place_.file("none.toml")};
    options.junit = place_.file("r.xml");
    EXPECT_THROW(static_cast<void>(verify(options)), UserError);
    EXPECT_FALSE(has("r.xml"));
    options.scripts = {"loss_of_heading"};
    test_support::expect_user_error([&] { static_cast<void>(verify(options)); },
                                    "loss_of_heading: there is no such file and no shipped script of this name; say "
                                    "loss_of_true_heading, ");
    options.scripts = {place_.file("loss_of_rol.toml")};
    test_support::expect_user_error([&] { static_cast<void>(verify(options)); }, "; say loss_of_roll, ");
}

/// At 30 frames a second none lies there: that is known before the flight.
TEST_F(Verify, ATimeWithoutAFrameIsAFault) {
    const CommandRun run = verify_text(kCruise + "[[expect]]\nafter_s = 1\nwithin_s = 0.01\nphase = \"cruise\"\n");
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.results, HasSubstr("a.toml:8: no frame lies within 0.01 s after 1 s: the device shows 30 a second; say "
                                       "within_s = 0.034 or more\n"));
    EXPECT_THAT(run.results, HasSubstr("0 of 1 script is judged, 1 script is wrong\n"));
    EXPECT_EQ(run.notes.find("no frame lies"), std::string::npos) << "it is told once";
}

TEST_F(Verify, ParametersComeFromTheCommandLine) {
    const std::string script =
        "[parameters]\nwanted = \"cruise\"\n[[step]]\nat_s = 1\nphase = \"cruise\"\n[[expect]]\nat_s = 3\nphase = \"$wanted\"\n";
    VerifyOptions options;
    options.scripts = {place_.write("a.toml", script)};
    EXPECT_EQ(verify(options).code, 0);
    options.parameters = {"wanted=ground"};
    EXPECT_EQ(verify(options).code, 1);
    options.parameters = {"other=ground"};
    EXPECT_THAT(verify(options).notes, HasSubstr("--set other: no script has such a parameter; there are: wanted"));
    options.parameters = {"wanted"};
    test_support::expect_user_error([&] { static_cast<void>(verify(options)); }, "--set wanted");
}

/// Each is told with its script and line, none hides another, and the others are flown.
TEST_F(Verify, InputsThatCannotBePlayedAreAllTold) {
    place_.write("empty.log", "");
    const std::string expect = "[[expect]]\nat_s = 1\nphase = \"cruise\"\n";
    VerifyOptions options;
    options.junit = place_.file("r.xml");
    options.scripts = {place_.write("a.toml", "\n[input]\nlog = \"empty.log\"\n" + expect), place_.write("b.toml", kCruise),
                       place_.write("c.toml", "[input]\nlog = \"empty.log\"\n" + expect)};
    const CommandRun run = verify(options);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.results, HasSubstr("a.toml:2: "));
    EXPECT_THAT(run.results, HasSubstr("c.toml:1: "));
    EXPECT_THAT(run.results, HasSubstr("1 of 1 expectations hold, 1 of 3 scripts are judged"));
    const std::string xml = place_.read("r.xml");
    EXPECT_THAT(xml, HasSubstr("<error message="));
    EXPECT_THAT(xml, HasSubstr("failures=\"0\" errors=\"0\""));
}

TEST_F(Verify, AParameterIsOneOfAnyScript) {
    VerifyOptions options;
    options.scripts = {place_.write("a.toml",
                                    "[parameters]\nwanted = \"ground\"\n[[step]]\nat_s = 1\nphase = \"cruise\"\n"
                                    "[[expect]]\nat_s = 3\nphase = \"$wanted\"\n"),
                       place_.write("b.toml", kCruise)};
    options.parameters = {"wanted=cruise"};
    EXPECT_EQ(verify(options).code, 0);
}

TEST_F(Verify, AnEarlierPictureIsNotLeft) {
    EXPECT_EQ(verify_text(kCruise + "[[expect]]\nat_s = 2.5\nphase_source = \"motion\"\n").code, 1);
    EXPECT_TRUE(has("out/a.png"));
    EXPECT_EQ(verify_text(kCruise).code, 0);
    EXPECT_FALSE(has("out/a.png"));
    EXPECT_FALSE(has("out/a.json"));
}

TEST_F(Verify, AFolderStandsForItsScripts) {
    std::filesystem::create_directory(place_.file("tests"));
    std::filesystem::create_directory(place_.file("tests/common"));
    place_.write("tests/b.toml", kCruise);
    place_.write("tests/a.toml", kCruise);
    place_.write("tests/common/c.toml", "no toml at all");
    VerifyOptions options;
    options.scripts = {place_.file("tests")};
    const auto json = verify(options, true).json();
    ASSERT_EQ(json["tests"].size(), 2u);
    EXPECT_THAT(json["tests"][0]["script"].get<std::string>(), HasSubstr("a.toml"));
    options.scripts = {place_.file("tests/none")};
    EXPECT_THROW(static_cast<void>(verify(options)), UserError);
}

/// Ctrl-C, here while the first log of steps is indexed, a file that the user does not know: the results say what was not flown,
/// and one sentence says why.
TEST_F(Verify, AnInterruptedRunHasNotPassed) {
    const std::string sentence = "interrupted; a flight test that was not flown to its end has not passed";
    VerifyOptions options;
    options.scripts = {place_.write("a.toml", kCruise), place_.write("b.toml", kCruise)};
    options.junit = place_.file("r.xml");
    const InterruptGuard interrupt;
    std::raise(SIGINT);
    const CommandRun run = verify(options, true);
    EXPECT_EQ(run.code, kInterruptedExitCode);
    EXPECT_EQ(run.notes, "tedavis: " + sentence + "\n");
    EXPECT_EQ(run.json()["holds"], false);
    for (const auto& test : run.json()["tests"]) EXPECT_EQ(test["fault"], sentence);
    EXPECT_EQ(run.json()["tests"].size(), 2u);
    EXPECT_THAT(place_.read("r.xml"), HasSubstr("<error message=\"" + sentence));
}

/// The ctest of the shipped suite.
TEST(ShippedFlightTests, AllHold) {
    const CommandRun run = verify({}, true);
    EXPECT_EQ(run.code, 0);
    const auto result = run.json();
    ASSERT_FALSE(result["tests"].empty());
    for (const auto& test : result["tests"])
        for (const auto& expectation : test["expectations"]) {
            EXPECT_TRUE(expectation["holds"].get<bool>())
                << test["script"] << " line " << expectation["line"] << ": " << expectation.dump();
        }
}

/// Indented blocks of a page that expect something.
std::vector<std::string> examples_of(const std::string& page) {
    std::vector<std::string> blocks;
    std::string block;
    std::istringstream lines(page + "\nend\n");
    for (std::string line; std::getline(lines, line);) {
        const bool is_indented = line.compare(0, 4, "    ") == 0;
        if (is_indented || (line.empty() && !block.empty())) {
            block += (is_indented ? line.substr(4) : "") + "\n";
            continue;
        }
        if (block.find("[[expect]]") != std::string::npos) blocks.push_back(block);
        block.clear();
    }
    return blocks;
}

/// Whoever follows the guide gets tests that pass.
TEST_F(Verify, TheGuidesExamplesHold) {
    const auto examples = examples_of(read_file(test_support::source_dir() + "/configs/flight_tests/README.md"));
    ASSERT_EQ(examples.size(), 4u);
    for (const std::string& example : examples) {
        const CommandRun run = verify_text(example);
        EXPECT_EQ(run.code, 0) << example << run.notes << run.results;
    }
}

/// A copy of the shipped tests and what they name, in which a file is changed.
class SeededFault : public ::testing::Test {
protected:
    SeededFault() {
        namespace fs = std::filesystem;
        const std::string root = test_support::source_dir() + "/configs";
        fs::create_directories(place_.file("configs"));
        for (const char* folder : {"flight_tests", "switches", "buses", "designs", "devices", "palettes", "contracts"})
            fs::copy(root + "/" + folder, place_.file(std::string("configs/") + folder), fs::copy_options::recursive);
        setenv("TEDAVIS_ROOT", place_.path().c_str(), 1);
    }
    ~SeededFault() override { unsetenv("TEDAVIS_ROOT"); }
    void change(const std::string& file, const std::string& from, const std::string& to) {
        std::string text = place_.read(file);
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << file << " has no " << from;
        place_.write(file, text.replace(at, from.size(), to));
    }
    /// The first expectation of a script that does not hold: "3.2 s: phase approach"; empty where all hold.
    std::string found_by(const std::string& script) {
        VerifyOptions options;
        options.scripts = {place_.file("configs/flight_tests/" + script + ".toml")};
        const CommandRun run = verify(options, true);
        const auto result = run.json();
        std::string found;
        double first_s = std::numeric_limits<double>::infinity();
        for (const auto& one : result["tests"][0]["expectations"]) {
            if (one["holds"].get<bool>() || one["failed_s"].get<double>() >= first_s) continue;
            first_s = one["failed_s"].get<double>();
            char time[24];
            std::snprintf(time, sizeof time, "%.1f s: ", first_s);
            found = time + one["key"].get<std::string>() + " " + one["found"].get<std::string>();
        }
        EXPECT_EQ(run.code, found.empty() ? 0 : 1);
        return found;
    }
    test_support::TemporaryFolder place_;
};

TEST_F(SeededFault, NoneIsFoundWhereThereIsNone) {
    for (const char* script : {"switch_phases", "message_faults", "panel_faults", "panel_bounce", "loss_of_pitch",
                               "message_time_out", "silent_bus", "coded_panel_faults", "designs_without_scene"})
        EXPECT_EQ(found_by(script), "") << script;
}

TEST_F(SeededFault, AShiftedIdentifierOfThePhaseIsFound) {
    change("configs/buses/canaerospace.toml", "status_identifier = 1830", "status_identifier = 1829");
    EXPECT_EQ(found_by("message_faults"), "1.0 s: phase unknown");
}

TEST_F(SeededFault, AShiftedPhaseOfAPanelIsFound) {
    change("configs/switches/one_hot.toml", "phase = \"cruise\"", "phase = \"approach\"");
    EXPECT_EQ(found_by("switch_phases"), "2.1 s: phase approach");
}

TEST_F(SeededFault, ADoubledTimeOutIsFound) {
    change("configs/buses/canaerospace.toml", "pitch = [0.3, 1.0]", "pitch = [0.6, 2.0]");
    EXPECT_EQ(found_by("loss_of_pitch"), "5.3 s: flags terrain.missing");
}

TEST_F(SeededFault, ADoubledTimeOutOfThePhaseIsFound) {
    EXPECT_EQ(found_by("message_time_out"), "");
    change("configs/buses/canaerospace.toml", "timeout_s = 3.0", "timeout_s = 6.0");
    EXPECT_EQ(found_by("message_time_out"), "8.2 s: phase_source can");
}

TEST_F(SeededFault, ARemovedDebounceIsFound) {
    change("configs/switches/one_hot.toml", "debounce_ms = 30", "debounce_ms = 0");
    EXPECT_EQ(found_by("panel_bounce"), "7.0 s: phase cruise");
}

TEST_F(SeededFault, AShorterOrLongerDebounceIsFound) {
    change("configs/switches/one_hot.toml", "debounce_ms = 30", "debounce_ms = 12");
    EXPECT_EQ(found_by("panel_bounce"), "7.0 s: phase cruise");
    change("configs/switches/one_hot.toml", "debounce_ms = 12", "debounce_ms = 90");
    EXPECT_EQ(found_by("switch_phases"), "1.1 s: phase ground");
}

TEST_F(SeededFault, ASlightlyOtherFreshnessIsFound) {
    change("configs/buses/canaerospace.toml", "pitch = [0.3, 1.0]", "pitch = [0.22, 1.08]");
    EXPECT_EQ(found_by("loss_of_pitch"), "5.3 s: signals pitch stale");
    change("configs/buses/canaerospace.toml", "pitch = [0.22, 1.08]", "pitch = [0.3, 1.08]");
    EXPECT_EQ(found_by("loss_of_pitch"), "6.0 s: flags pitch.stale, terrain.missing");
}

TEST_F(SeededFault, ALongerTimeOutOfTheClockIsFound) {
    EXPECT_EQ(found_by("silent_bus"), "");
    change("configs/buses/canaerospace.toml", "timeout_s = 10", "timeout_s = 14");
    EXPECT_THAT(found_by("silent_bus"), ::testing::StartsWith("14.1 s: flags latitude.lost"));
}

TEST_F(SeededFault, ADoubledSettlingOfThePanelIsFound) {
    change("configs/switches/one_hot.toml", "settle_ms = 200", "settle_ms = 2000");
    EXPECT_EQ(found_by("panel_faults"), "2.3 s: flags terrain.missing");
}

TEST_F(SeededFault, ASwappedDesignIsFound) {
    change("configs/designs/default.toml", "takeoff = \"takeoff\"", "takeoff = \"approach\"");
    change("configs/designs/default.toml", "\napproach = \"approach\"", "\napproach = \"takeoff\"");
    EXPECT_EQ(found_by("designs_without_scene"), "2.0 s: design approach");
}

}  // namespace
}  // namespace tedavis::host_sim::test_verify
