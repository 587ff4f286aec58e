#include "host_sim/replay/scene_findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/commands/scene.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_scene_findings {
namespace {

using ::testing::HasSubstr;

class SceneFindings : public ::testing::Test {
protected:
    SceneFindings() {
        folder_.write("masts.csv", "lon,lat,height\n9.8,46.8,40\n10.0,46.9,30\n");
        const std::string scene = folder_.write("s.toml",
                                                "name = 's'\n[[layer]]\nname = 'masts'\nsource = 'masts.csv'\nrole = "
                                                "'obstacle'\n[[layer.attribute]]\nname = 'height'\n");
        EXPECT_EQ(test_support::run_command([&](Console& console) {
                      return run_scene_build({scene, database_}, console);
                  }).code,
                  0);
    }
    test_support::TemporaryFolder folder_;
    std::string database_ = folder_.file("s.sdb");
};

TEST_F(SceneFindings, AFlightNearTheDataHasNone) {
    EXPECT_TRUE(scene_findings(database_, extent_of_scene(database_), {46.5, 47, 9, 10}).empty());
    EXPECT_TRUE(scene_findings(database_, extent_of_scene(database_), {48, 48, 9, 10}).empty()) << "in reach";
    EXPECT_TRUE(scene_findings(database_, extent_of_scene(database_), GeoExtent()).empty())
        << "a flight without a position is another finding";
    EXPECT_TRUE(scene_findings("", extent_of_scene(""), {46.5, 47, 9, 10}).empty());
}

TEST_F(SceneFindings, DataElsewhereAreSaid) {
    const Findings found = scene_findings(database_, extent_of_scene(database_), {36.4, 36.7, -84.4, -84});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].name, "scene.elsewhere");
    EXPECT_THAT(found[0].text, HasSubstr("they cover 46.800 .. 46.900 N, 9.800 .. 10.000 E, the flight 36.400 .. 36.700 N"));
    test_support::expect_user_error([&] { (void)extent_of_scene(folder_.file("none.sdb")); }, "none.sdb");
}

}  // namespace
}  // namespace tedavis::host_sim::test_scene_findings
