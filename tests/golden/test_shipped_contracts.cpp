// The shipped contracts hold over the default flight, and a design that is bad in one way breaks the condition that says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host_sim/commands/contract.hpp"
#include "host_sim/commands/replay.hpp"
#include "host_sim/commands/scenario.hpp"
#include "host_sim/commands/terrain.hpp"
#include "host_sim/evaluation/flight_run.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/layer_mask.hpp"
#include "host_sim/replay/resolved_design.hpp"
#include "host_sim/toml_text.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"

namespace tedavis::test_shipped_contracts {
namespace {

using test_support::CommandRun;
using Names = std::vector<std::string>;

std::string root() { return test_support::source_dir(); }

/// What is replaced in a shipped design, all of it.
struct Change {
    std::string from, to;
};

/// Terrain and scenario of the demo, flown in parts.
class DefaultFlightRuns {
public:
    DefaultFlightRuns() {
        host_sim::TerrainBuildOptions build;
        build.rasters = {root() + "/configs/data/jacksboro_srtm3.tif"};
        build.output = place_.file("t.tdb");
        build.accuracy_m = 16;
        run([&](host_sim::Console& console) { return run_terrain_build(build, console); });
        host_sim::ScenarioBuildOptions scenario;
        scenario.output = place_.file("scenario");
        run([&](host_sim::Console& console) { return run_scenario_build(scenario, console); });
    }
    /// Returns the run's folder.
    std::string fly(const std::string& name, const std::string& design, double from_s, double to_s, double step_s) {
        host_sim::ReplayOptions options;
        options.log = place_.file("scenario/flight.log");
        options.switches = place_.file("scenario/flight.switches");
        options.picture.terrain = place_.file("t.tdb");
        options.picture.scene = place_.file("scenario/scene.sdb");
        options.picture.design = design;
        options.picture.size = {1024, 768};
        options.output = place_.file(name);
        options.from_s = from_s;
        options.to_s = to_s;
        options.step_s = step_s;
        options.layers = true;
        run([&](host_sim::Console& console) { return run_replay(options, console); });
        return options.output;
    }
    /// A shipped design, with all that it inherits, and changes, each of which must have something to change.
    std::string changed_design(const std::string& shipped, const std::vector<Change>& changes) const {
        std::string text = host_sim::toml_text(host_sim::resolved_design(root() + "/configs/designs/" + shipped + ".toml"));
        for (const Change& change : changes) {
            std::size_t at = text.find(change.from);
            EXPECT_NE(at, std::string::npos) << change.from;
            for (; at != std::string::npos; at = text.find(change.from, at + change.to.size()))
                text.replace(at, change.from.size(), change.to);
        }
        return place_.write(shipped + "_changed.toml", text);
    }

private:
    template <class Command>
    static void run(Command command) {
        EXPECT_EQ(test_support::run_command(command).code, 0);
    }
    test_support::TemporaryFolder place_;
};

/// Built once.
DefaultFlightRuns& flights() {
    static DefaultFlightRuns runs;
    return runs;
}

CommandRun contract(const std::string& run, const std::string& name) {
    return test_support::run_command(
        [&](host_sim::Console& console) {
            return run_contract(host_sim::ContractOptions{run, name, "", 0}, console);
        },
        true);
}

Names broken(const std::string& run, const std::string& name) {
    Names names;
    const auto json = contract(run, name).json();
    for (const auto& failure : json["failures"])
        if (!failure["time_s"].is_null()) names.push_back(failure["condition"]);
    return names;
}

/// Every seventeen seconds, so that each phase has pictures.
const std::string& default_run() {
    static const std::string run = flights().fly("default_run", "default", 1, 409, 17);
    return run;
}

TEST(ShippedContracts, HoldOverTheDefaultFlight) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(root() + "/configs/contracts")) {
        if (entry.path().extension() != ".toml") continue;
        const CommandRun judged = contract(default_run(), entry.path().string());
        EXPECT_EQ(judged.code, 0) << judged.results;
        const auto json = judged.json();
        for (const auto& condition : json["conditions"])
            EXPECT_EQ(condition["state"], "holds")
                << entry.path() << ": nothing is passed over in this flight: " << condition["condition"];
        ++count;
    }
    EXPECT_EQ(count, 6u);
}

/// Pixels of a layer within a box of the picture.
std::size_t pixels_within(const host_sim::FrameObstacle& obstacle, const host_sim::LayerMask& mask, const std::string& layer) {
    std::size_t count = 0;
    for (auto y = static_cast<std::uint32_t>(obstacle.box[1]); y < static_cast<std::uint32_t>(obstacle.box[3]); ++y)
        for (auto x = static_cast<std::uint32_t>(obstacle.box[0]); x < static_cast<std::uint32_t>(obstacle.box[2]); ++x)
            count += mask.names[mask.layers[std::size_t{y} * mask.width + x]] == layer ? 1 : 0;
    return count;
}

/// What the record says of obstacles is what the picture shows; instruments may lie over it.
TEST(ShippedContracts, RecordedObstaclesAreWhereTheirSignsAre) {
    const host_sim::FlightRun run = host_sim::read_flight_run(default_run());
    std::size_t seen = 0;
    for (const host_sim::FlightFrame& frame : run.frames) {
        const auto mask = host_sim::read_layer_mask(frame.picture, frame.layers, 1024, 768);
        ASSERT_TRUE(mask.has_value());
        for (const host_sim::FrameObstacle& obstacle : frame.obstacles.value()) {
            if (obstacle.state != "drawn") continue;
            const std::size_t labels = pixels_within(obstacle, *mask, "labels");
            EXPECT_GT(labels + pixels_within(obstacle, *mask, "symbology"), 100u) << obstacle.name << " at " << frame.time_s;
            seen += labels > 100 ? 1 : 0;
        }
    }
    EXPECT_GE(seen, 3u);
}

TEST(ShippedContracts, ADesignThatLeavesOutObstaclesBreaksTheirCondition) {
    const std::string design = flights().changed_design("approach", {{"role = \"obstacle\"\n", "layer = \"none\"\n"}});
    EXPECT_EQ(broken(flights().fly("blind", design, 379, 395, 4), "default"), Names{"obstacles on the way are noticed"});
}

/// Hatched and contoured ground under six levels of wind arrows; below the compass rose it is crowded.
TEST(ShippedContracts, AClutteredDesignIsNotCalm) {
    const std::string design =
        flights().changed_design("cruise", {{"plain_color = \"#8f8468\"", "plain_color = \"#ffffff\""},
                                            {"technique = \"lambert\"", "technique = \"none\""},
                                            {"contours = 0.35", "contours = 1.0\nhatching = 1.0"},
                                            {"contour_interval_m = 100", "contour_interval_m = 20"},
                                            {"line_color = \"#4a4230\"", "line_color = \"#000000\""},
                                            {"heights_m = [300, 1500]", "heights_m = [100, 300, 600, 900, 1200, 1500]"}});
    EXPECT_EQ(broken(flights().fly("cluttered", design, 116, 124, 4), "default"),
              (Names{"the picture is calm", "no region is crowded"}));
}

TEST(ShippedContracts, ColorsThatOnlyHueTellsApartBreakTheirCondition) {
    const std::string design = flights().changed_design("approach", {{"color = \"#a89c88\"", "color = \"#c86a2c\""},
                                                                     {"color = \"#e8e4d8\"", "color = \"#c86a2c\""},
                                                                     {"color = \"#60e0ff\"", "color = \"#8a9a2c\""}});
    EXPECT_EQ(broken(flights().fly("alike", design, 383, 391, 4), "default"),
              Names{"obstacles, areas and traffic are told apart"});
}

TEST(ShippedContracts, WarningsThatOnlyHueTellsApartBreakTheirCondition) {
    const std::string design = flights().changed_design(
        "approach",
        {{"enabled = false\nprofile = \"egpws\"",
          "enabled = true\nprofile = \"custom\"\n[[warning.band]]\nlower_ft = -100\ncolor = \"#e8a000\"\nstrength = 0.8\n"
          "[[warning.band]]\nlower_ft = -1000\ncolor = \"#a0c800\"\nstrength = 0.8"}});
    EXPECT_EQ(broken(flights().fly("hues", design, 383, 391, 4), "default"), Names{"warnings are told apart without hue"});
}

TEST(ShippedContracts, ACruiseWithoutItsDataBreaksTheConditionOnThem) {
    std::vector<Change> changes;
    for (const char* role : {"storm_cell", "trajectory", "wind", "sample", "no_go"})
        changes.push_back({"role = \"" + std::string(role) + "\"\n", "layer = \"none\"\n"});
    const std::string design = flights().changed_design("cruise", changes);
    EXPECT_EQ(broken(flights().fly("bare", design, 116, 124, 4), "default"), Names{"data draw the eye in cruise"});
}

}  // namespace
}  // namespace tedavis::test_shipped_contracts
