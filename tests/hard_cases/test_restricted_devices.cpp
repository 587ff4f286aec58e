// The default flight, by one design that asks for every effect of the view, on the devices that can do least: the record lists
// what gives way and why, and no call is made that the device does not have. A table that lacks one call fails the run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "host_sim/commands/replay.hpp"
#include "host_sim/scenario/scenario_scene.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/default_flight.hpp"
#include "tests/support/programs/command_run.hpp"

namespace tedavis::test_restricted_devices {
namespace {

using ::testing::HasSubstr;

std::string default_scene() {
    const std::string name = "configs/scenarios/default.toml";
    const host_sim::Scenario scenario =
        host_sim::parse_scenario(test_support::source_file(name), test_support::source_dir() + "/" + name);
    const host_sim::GeoidEgm96 geoid = host_sim::GeoidEgm96::installed();  // the flight keeps a reference
    const host_sim::ScenarioFlight flight(scenario, scenario.seed, geoid);
    const auto bytes =
        host_sim::sdb_bytes(host_sim::make_scenario_scene(scenario, flight, scenario.seed, [](auto, auto, auto) {}).draft);
    return {bytes.begin(), bytes.end()};
}

class RestrictedDevices : public ::testing::Test {
protected:
    RestrictedDevices() {
        const test_support::RecordedFlight flight = test_support::default_flight();
        options_.log = folder_.write("flight.log", flight.log);
        options_.switches = folder_.write("flight.switches", flight.switch_log);
        options_.picture.terrain = folder_.write("terrain.tdb", {terrain_.image.begin(), terrain_.image.end()});
        options_.picture.scene = folder_.write("scene.sdb", default_scene());
        options_.picture.size = host_sim::PictureSize{320, 240};
        options_.picture.with.add(effects::Effect::aerial_perspective);
        options_.picture.with.add(effects::Effect::depth_of_field);
        options_.picture.with.add(effects::Effect::antialiasing);
        options_.picture.with.add(effects::Effect::saliency);
        options_.output = folder_.file("run");
        options_.step_s = 40;
        options_.frames = host_sim::FrameOutput::hash;
    }

    test_support::CommandRun fly(const std::string& device) {
        options_.picture.device = device;
        return test_support::run_command([&](host_sim::Console& console) { return host_sim::run_replay(options_, console); },
                                         true);
    }

    /// The effects that the last run left out or replaced, with the reasons.
    std::map<std::string, std::set<std::string>> given_up() const {
        std::map<std::string, std::set<std::string>> all;
        std::ifstream records(options_.output + "/frames.jsonl");
        for (std::string line; std::getline(records, line);) {
            const nlohmann::json record = nlohmann::json::parse(line);
            for (const auto& effect : record["effects"])
                if (effect["state"] != "run")
                    all[effect["name"]].insert(effect["reason"].get<std::string>() + " > " +
                                               effect.value("replaced_by", std::string()));
        }
        return all;
    }

    test_support::TemporaryFolder folder_;
    test_support::DefaultTerrain terrain_;
    host_sim::ReplayOptions options_;
};

TEST_F(RestrictedDevices, FlyTheDefaultFlightWithinTheirTables) {
    const auto on_desktop = fly("desktop");
    EXPECT_EQ(on_desktop.code, 0) << on_desktop.notes;
    const auto kept = given_up();
    for (const char* effect : {"aerial_perspective", "depth_of_field", "antialiasing", "silhouettes", "saliency"})
        for (const std::string& reason : kept.count(effect) != 0 ? kept.at(effect) : std::set<std::string>())
            EXPECT_THAT(reason, ::testing::Not(HasSubstr("the device"))) << effect;
    for (const char* device : {"es2-small", "sc2"}) {
        const auto run = fly(device);
        EXPECT_EQ(run.code, 0) << device << ": " << run.notes;
        EXPECT_EQ(run.json()["gl_calls_outside_device"], 0) << device;
        EXPECT_EQ(run.json()["heap_allocations_after_start"], 0) << device;
        auto gave = given_up();
        EXPECT_THAT(gave["aerial_perspective"], ::testing::Contains(HasSubstr("> haze"))) << device;
        for (const char* effect : {"depth_of_field", "antialiasing"})
            EXPECT_THAT(gave[effect], ::testing::Contains(HasSubstr("the device has no"))) << device << ", " << effect;
        EXPECT_EQ(gave["silhouettes"].count("the device has no 24-bit depth off screen > ridges"), device == std::string("sc2"));
        EXPECT_EQ(gave["saliency"].count("the device cannot copy what it has drawn > "), device == std::string("sc2"));
    }
}

TEST_F(RestrictedDevices, FailTheRunThatMakesACallOutsideTheTable) {
    std::string device = test_support::source_file("configs/devices/sc2.toml");
    const std::string_view calls = "calls = \"sc2\"\n";
    ASSERT_NE(device.find(calls), std::string::npos);
    device.insert(device.find(calls) + calls.size(), "never = [\"DepthMask\"]\n");
    options_.to_s = 40;
    const auto run = fly(folder_.write("less.toml", device));
    EXPECT_EQ(run.code, host_sim::kCheckFailedExitCode);
    EXPECT_GT(run.json()["gl_calls_outside_device"], 0);
    EXPECT_THAT(run.notes, HasSubstr("the first kind glDepthMask: the device does not have the call"));
}

}  // namespace
}  // namespace tedavis::test_restricted_devices
