#include "host_sim/commands/scenario.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bus/candump/candump_log_source.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/scene_builder/open_scene.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_scenario {
namespace {

using test_support::CommandRun;
using test_support::expect_user_error;
using test_support::run_command;

CommandRun build(const ScenarioBuildOptions& options) {
    return run_command([&](Console& console) { return run_scenario_build(options, console); }, true);
}

/// The shipped scenario with another scene file.
std::string replaced_scene(const std::string& name) {
    const std::string shipped = "scene = \"jacksboro\"";
    std::string text = read_file(test_support::source_dir() + "/configs/scenarios/default.toml");
    return text.replace(text.find(shipped), shipped.size(), "scene = \"" + name + "\"");
}

TEST(ScenarioCommand, LeavesALogASwitchLogAndAManifest) {
    const test_support::TemporaryFolder place;
    const CommandRun run = build({"default", place.file("a/b"), {}});
    EXPECT_EQ(run.code, 0);
    const auto json = run.json();
    EXPECT_EQ(json, nlohmann::json::parse(place.read("a/b/scenario.json")));
    EXPECT_EQ(json["synthetic"], true) << "invented flights say so";
    EXPECT_EQ(json["seed"], 1);
    EXPECT_EQ(json["legs"].size(), 16u);
    const std::string log = place.read("a/b/flight.log");
    bus::CandumpLogSource source({log.data(), log.size()});
    std::array<bus::CanFrame, 256> frames;
    while (source.read(base::Time{INT64_MAX}, {frames.data(), frames.size()}) > 0) {
    }
    EXPECT_EQ(json["frames"], source.statistics().frames);
    EXPECT_EQ(source.statistics().malformed, 0u);
    EXPECT_GT(place.read("a/b/flight.switches").size(), 100u);
}

TEST(ScenarioCommand, LeavesASceneThatTheBoardReads) {
    const test_support::TemporaryFolder place;
    const auto json = build({"default", place.file("a"), {}}).json();
    EXPECT_EQ(json["scene"], "scene.sdb");
    const OpenScene open(place.file("a/scene.sdb"));
    EXPECT_EQ(open.scene().layers().size(), json["layers"].size());
    EXPECT_THAT(open.scene().header().origin, ::testing::HasSubstr("not for navigation"));
    EXPECT_EQ(open.scene().header().revision, 1u);
    for (const char* name : {"flight", "wind", "storm", "radar", "no_go", "obstacles"})
        EXPECT_NE(open.scene().find(name), nullptr) << name;
}

TEST(ScenarioCommand, EqualSeedsGiveEqualBytesAndTheOptionReplacesTheFiles) {
    const test_support::TemporaryFolder place;
    for (const char* name : {"a", "b"}) EXPECT_EQ(build({"default", place.file(name), 7}).code, 0);
    EXPECT_EQ(build({"default", place.file("c"), 8}).json()["seed"], 8);
    EXPECT_EQ(place.read("a/flight.log"), place.read("b/flight.log"));
    EXPECT_EQ(place.read("a/flight.switches"), place.read("b/flight.switches"));
    EXPECT_NE(place.read("a/flight.log"), place.read("c/flight.log"));
    EXPECT_EQ(place.read("a/scene.sdb"), place.read("b/scene.sdb"));
    EXPECT_NE(place.read("a/scene.sdb"), place.read("c/scene.sdb"));
}

TEST(ScenarioCommand, ReplacesItsOwnFilesOnly) {
    const test_support::TemporaryFolder place;
    const std::string mine = "my own notes\n";
    EXPECT_EQ(build({"default", place.file("a"), {}}).code, 0);
    EXPECT_EQ(build({"default", place.file("a"), {}}).code, 0);
    const std::string log = place.read("a/flight.log");
    for (const char* const name : {"flight.log", "flight.switches", "scene.sdb", "scenario.json"}) {
        const std::string before = place.read(std::string("a/") + name);
        place.write(std::string("a/") + name, mine);
        expect_user_error(
            [&] {
                (void)build({"default", place.file("a"), 8});
            },
            std::string("a/") + name + ": is there already and is no");
        EXPECT_EQ(place.read(std::string("a/") + name), mine);
        place.write(std::string("a/") + name, before);
    }
    EXPECT_EQ(place.read("a/flight.log"), log) << "the others stay as they were";
}

TEST(ScenarioCommand, LeavesNothingWhereItRefuses) {
    const test_support::TemporaryFolder place;
    std::string text = read_file(test_support::source_dir() + "/configs/scenarios/default.toml");
    text.replace(text.find("\"one_hot\""), 9, "\"nowhere\"");
    const std::string path = place.write("s.toml", text);
    expect_user_error(
        [&] {
            (void)build({path, place.file("out"), {}});
        },
        "nowhere: no such file and no shipped one of switches");
    const std::string lost = place.write("lost.toml", replaced_scene("nosuch"));
    expect_user_error([&] { (void)build({lost, place.file("out"), {}}); }, "lost.toml:");
    const std::string broken = place.write("broken.toml", replaced_scene("./scene.toml"));
    place.write("scene.toml", "name = \"s\"\n[[layer]]\nname = \"a\"\nsource = \"nothing.csv\"\n");
    expect_user_error([&] { (void)build({broken, place.file("out"), {}}); }, "nothing.csv");
    expect_user_error([&] { (void)build({"nosuch", place.file("out"), {}}); }, "nosuch: no such file");
    expect_user_error([&] { (void)build({"default", path + "/out", {}}); }, "s.toml/out: this folder cannot be made");
    EXPECT_EQ(place.entries(), 4u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_scenario
