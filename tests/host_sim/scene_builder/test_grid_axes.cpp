#include "host_sim/scene_builder/grid_axes.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_grid_axes {
namespace {

using test_support::expect_user_error;

TEST(GridAxes, PlanesAreSortedByTimeAndLevel) {
    const std::vector<GridPlane> planes{{1, 20, 500.0}, {2, 20, 700.0}, {3, 10, 500.0}, {4, 10, 700.0}};
    const GridAxes axes = sort_planes(planes, {}, "f");
    EXPECT_EQ(axes.times_ns, (std::vector<std::int64_t>{10, 20}));
    EXPECT_EQ(axes.levels, (std::vector<double>{500, 700}));
    ASSERT_EQ(axes.members.size(), 4u);
    const int bands[] = {3, 4, 1, 2};
    for (std::size_t n = 0; n < 4; ++n) {
        ASSERT_EQ(axes.members[n].size(), 1u);
        EXPECT_EQ(axes.members[n][0].band, bands[n]);
    }
}

TEST(GridAxes, TimesAreChosenBothEndsIncluded) {
    const std::vector<GridPlane> planes{{1, 10, {}}, {2, 20, {}}, {3, 30, {}}, {4, 40, {}}};
    EXPECT_EQ(sort_planes(planes, {20, 30, {}, false}, "f").times_ns, (std::vector<std::int64_t>{20, 30}));
    expect_user_error([&] { (void)sort_planes(planes, {41, {}, {}, false}, "f"); }, "f: has no grid at every time");
    expect_user_error(
        [&] {
            (void)sort_planes({{1, 0, 500.0}, {2, 0, 850.0}}, {{}, {}, {700}, false}, "f");
        },
        "it has levels 500, 850 and times from 1970-01-01T00:00:00Z to 1970-01-01T00:00:00Z (1); tedavis scene look f");
}

TEST(GridAxes, MembersShareATime) {
    const std::vector<GridPlane> planes{{1, 10, {}}, {2, 10, {}}, {3, 10, {}}};
    PlaneChoice members;
    members.has_members = true;
    EXPECT_EQ(sort_planes(planes, members, "f").members[0].size(), 3u);
    expect_user_error([&] { (void)sort_planes(planes, {}, "f"); }, "3 grids of one time and level");
    EXPECT_EQ(sort_planes({{1, {}, {}}}, {}, "f").members.size(), 1u) << "a file without times or levels";
}

TEST(GridAxes, DataAreOfTheirOwnTimesOrOfTheirLastRun) {
    const auto data_time = [](const std::vector<GridPlane>& planes) { return data_time_of(sort_planes(planes, {}, "f")); };
    EXPECT_EQ(data_time({{1, 10, {}}, {2, 20, {}}, {3, 30, {}}}), 30) << "a series of measurements";
    EXPECT_EQ(data_time({{1, 10, {}, 5}, {2, 20, {}, 5}, {3, 30, {}, 5}}), 5) << "one forecast";
    EXPECT_EQ(data_time({{1, 10, {}, 10}, {2, 20, {}, 20}}), 20) << "analyses, computed when they hold";
    EXPECT_EQ(data_time({{1, 10, {}, 5}, {2, 20, {}, 15}, {3, 30, {}, 15}}), 15) << "the last of two runs";
    EXPECT_EQ(data_time({{1, 10, {}, 5}}), 10) << "one time: its age counts from there";
    EXPECT_EQ(data_time({{1, {}, {}, 5}}), std::nullopt);
}

TEST(GridAxes, AMissingLevelIsSaid) {
    expect_user_error(
        [] {
            (void)sort_planes({{1, 10, 500.0}, {2, 10, 700.0}, {3, 20, 500.0}}, {}, "f");
        },
        "at every time and level");
}

}  // namespace
}  // namespace tedavis::host_sim::test_grid_axes
