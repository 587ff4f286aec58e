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

constexpr std::int64_t kHour_ns = 3'600'000'000'000, kData_ns = 438'288 * kHour_ns;  // 2020-01-01T00:00:00Z

Findings at(const std::vector<LayerTimes>& layers, double begin_h, double end_h) {
    const auto hour = [](double n) { return base::Time{kData_ns} + base::Duration::from_seconds(3600 * n); };
    return time_findings("s.sdb", layers, hour(begin_h), hour(end_h));
}

TEST(SceneTimes, DataOfAnotherTimeThanTheWholeFlightAreSaid) {
    const LayerTimes radar{"radar", kData_ns, kData_ns + 2 * kHour_ns, kData_ns - kHour_ns, kData_ns + 5 * kHour_ns};
    for (const auto& [begin_h, end_h] : {std::pair{0.5, 1.0}, {-9.0, -1.0}, {5.0, 7.0}, {-9.0, 9.0}})
        EXPECT_TRUE(at({radar}, begin_h, end_h).empty()) << begin_h;
    EXPECT_EQ(at({radar}, -9, -1.1).size(), 1u);
    const Findings late = at({radar, radar}, 5.5, 7);
    ASSERT_EQ(late.size(), 2u) << "one for each layer";
    EXPECT_EQ(late[0].name, "scene.other_time");
    EXPECT_EQ(late[0].text,
              "the data of the layer radar of s.sdb are from 2020-01-01T00:00:00Z to 2020-01-01T02:00:00Z, and the "
              "flight is from 2020-01-01T05:30:00Z to 2020-01-01T07:00:00Z: none of them is of its time");
    EXPECT_THAT(at({{"radar", kData_ns, kData_ns, kData_ns, kData_ns}}, 3, 4)[0].text,
                HasSubstr("are of 2020-01-01T00:00:00Z, and the flight"));
}

TEST_F(SceneFindings, WhatStandsForYearsHasNoTimes) {
    EXPECT_TRUE(times_of_scene(database_).empty());
    EXPECT_TRUE(times_of_scene("").empty());
    folder_.write("samples.csv", "lon,lat,height\n9.8,46.8,40\n10.0,46.9,30\n");
    const auto times = [&](const std::string& more, const std::string& role) {
        const std::string scene = folder_.write(
            "t.toml", "name = 't'\n[[layer]]\nname = 'samples'\nsource = 'samples.csv'\nrole = '" + role +
                          "'\ndata_time = '2020-01-01T00:00:00Z'\n" + more + "[[layer.attribute]]\nname = 'height'\n");
        EXPECT_EQ(test_support::run_command([&](Console& console) {
                      return run_scene_build({scene, folder_.file("t.sdb")}, console);
                  }).code,
                  0);
        return times_of_scene(folder_.file("t.sdb"));
    };
    EXPECT_TRUE(times("", "obstacle").empty()) << "masts are not of a moment";
    const auto stated = times("", "sample"), valid = times("valid_hours = 3\n", "sample");
    ASSERT_EQ(stated.size(), 1u);
    EXPECT_EQ(stated[0].layer, "samples");
    EXPECT_EQ(stated[0].first_ns, kData_ns);
    EXPECT_EQ(stated[0].from_ns, kData_ns - kHour_ns);
    EXPECT_EQ(stated[0].until_ns, kData_ns + 24 * kHour_ns);
    ASSERT_EQ(valid.size(), 1u);
    EXPECT_EQ(valid[0].until_ns, kData_ns + 3 * kHour_ns);
}

}  // namespace
}  // namespace tedavis::host_sim::test_scene_findings
