#include "host_sim/pack/pack_contents.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "host_sim/options/replay_config.hpp"
#include "tests/host_sim/pack/configured_flight.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_pack_contents {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> paths_of(const PackContents& contents) {
    std::vector<std::string> paths;
    for (const PackedFile& file : contents.files) paths.push_back(file.path);
    return paths;
}

TEST(PackContents, AllThatTheConfigurationNamesWithNamesOfThePack) {
    const ConfiguredFlight flight;
    static_cast<void>(flight.write("[replay]\nlog = 'flight.log'\nfrom_s = 2\nstep_s = 3\n[parameters]\ntau_px = 3\n"));
    const PackContents contents = pack_contents(load_replay_config(flight.config), flight.config);
    EXPECT_EQ(contents.title, "a board");
    for (const char* path : {"devices/es2-small.toml", "design/approach.toml", "buses/canaerospace.toml", "aircraft/jet.toml",
                             "switches/one_hot.toml", "terrain/terrain.tdb"})
        EXPECT_THAT(paths_of(contents), Contains(path));
    EXPECT_THAT(contents.config_text, HasSubstr("device = \"devices/es2-small.toml\""));
    EXPECT_THAT(contents.config_text, HasSubstr("step_s = 3"));
    EXPECT_THAT(contents.config_text, Not(HasSubstr("from_s"))) << "of the log that stays outside";
    EXPECT_THAT(contents.config_text, HasSubstr("tau_px = 3"));
    EXPECT_THAT(contents.config_text, HasSubstr("interface = \"can9\""));
    EXPECT_THAT(contents.config_text, Not(HasSubstr("flight.log")));
    EXPECT_THAT(contents.config_text, Not(HasSubstr("\"/"))) << "no absolute path";
    for (const PackedFile& file : contents.files)
        if (file.path == "terrain/terrain.tdb") {
            EXPECT_NE(file.sources, "") << "what the database says of its sources";
        }
}

/// A socket is no file of the pack.
TEST(PackContents, TheSocketForRecordsStaysWhereItIs) {
    const ConfiguredFlight flight;
    static_cast<void>(flight.write("[records]\nsocket = 'rec.sock'\n"));
    EXPECT_THAT(pack_contents(load_replay_config(flight.config), flight.config).config_text,
                HasSubstr("socket = \"" + flight.files.folder.file("rec.sock") + "\""));
}

TEST(PackContents, ASceneIsValidWhereAllOfItsLayersAre) {
    constexpr std::int64_t kDay_ns = 86'400'000'000'000;
    const ConfiguredFlight flight;
    static_cast<void>(flight.write("[scene]\ndatabase = 'area.sdb'\n"));
    SceneDraft draft = test_support::small_scene();
    const auto entry = [&] {
        const std::vector<unsigned char> bytes = sdb_bytes(draft);
        flight.files.folder.write("area.sdb", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        const PackedFiles files = pack_contents(load_replay_config(flight.config), flight.config).files;
        return *std::find_if(files.begin(), files.end(), [](const PackedFile& file) { return file.path == "scene/area.sdb"; });
    };
    EXPECT_EQ(entry().valid_from + entry().valid_until, "") << "control: none is stated";
    draft.layers[0].valid_from_ns = 20'000 * kDay_ns;
    draft.layers[0].valid_until_ns = 20'040 * kDay_ns;
    draft.layers[1].valid_from_ns = 20'010 * kDay_ns;
    draft.layers[1].valid_until_ns = 20'050 * kDay_ns;
    EXPECT_EQ(entry().valid_from, platform::day_of(20'010 * kDay_ns).view()) << "the latest begin";
    EXPECT_EQ(entry().valid_until, platform::day_of(20'040 * kDay_ns).view()) << "the earliest end";
}

TEST(PackContents, WhatABoardWouldRefuseIsRefused) {
    const ConfiguredFlight flight;
    const auto refused = [&](const std::string& tables, const std::string& words) {
        static_cast<void>(flight.write(tables));
        test_support::expect_user_error(
            [&] { static_cast<void>(pack_contents(load_replay_config(flight.config), flight.config)); }, words);
    };
    refused("[costs]\nfile = 'absent.toml'\n", "absent.toml");
    refused("[scene]\ndatabase = 'flight.log'\n", "flight.log");
    refused("[programs]\nfolder = 'absent'\n", "absent");
    refused("symbology = 1\n", "board.toml");
}

}  // namespace
}  // namespace tedavis::host_sim::test_pack_contents
