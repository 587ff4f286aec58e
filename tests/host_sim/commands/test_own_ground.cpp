#include "host_sim/commands/own_ground.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_own_ground {
namespace {

TEST(OwnGround, IsBuiltIntoTheFolderAndSaysNoResult) {
    const test_support::TemporaryFolder folder;
    std::string scene;
    const auto run = test_support::run_command([&](Console& console) {
        scene = build_own_scene(shipped_root() + "/configs/scenes/jacksboro.toml", folder.path(), console);
        return 0;
    });
    EXPECT_EQ(run.results, "");
    EXPECT_EQ(scene, folder.path() + "/scene.sdb");
    EXPECT_FALSE(read_file(scene).empty());
}

TEST(OwnGround, WhatCannotBeReadIsRefused) {
    const test_support::TemporaryFolder folder;
    const auto build = [&](auto make) {
        return [&, make] { test_support::run_command([&](Console& console) { return make(console).empty() ? 1 : 0; }); };
    };
    test_support::expect_user_error(build([&](Console& console) {
                                        return build_own_terrain({"none.tif", false}, folder.path(), console);
                                    }),
                                    "none.tif");
    test_support::expect_user_error(build([&](Console& console) { return build_own_scenario("none", folder.path(), console); }),
                                    "none");
}

}  // namespace
}  // namespace tedavis::host_sim::test_own_ground
