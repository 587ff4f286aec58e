#include "host_sim/flight_test/nearest_names.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_nearest_names {
namespace {

TEST(NearestNames, CountsEdits) {
    EXPECT_EQ(edit_distance("", ""), 0u);
    EXPECT_EQ(edit_distance("pitch", ""), 5u);
    EXPECT_EQ(edit_distance("pitch", "pitch"), 0u);
    EXPECT_EQ(edit_distance("pich", "pitch"), 1u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u) << "the textbook's example";
    EXPECT_EQ(edit_distance("sitting", "kitten"), 3u) << "symmetric";
}

TEST(NearestNames, NamesTheNearestFirst) {
    EXPECT_EQ(nearest_names("rol", {"pitch", "roll", "yaw", "role"}), "roll, role or yaw");
    EXPECT_EQ(nearest_names("x", {"one"}), "one");
    EXPECT_EQ(nearest_names("x", {}), "");
}

TEST(NearestNames, AWordOfANameIsNear) {
    EXPECT_EQ(nearest_names("airsped", {"pitch", "roll", "indicated_airspeed"}).substr(0, 18), "indicated_airspeed");
}

}  // namespace
}  // namespace tedavis::host_sim::test_nearest_names
