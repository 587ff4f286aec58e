#include "host_sim/evaluation/layer_names_beside.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_layer_names_beside {
namespace {

using ::testing::ElementsAre;

TEST(LayerNamesBeside, StandInTheRecordOfAShot) {
    const test_support::TemporaryFolder place;
    (void)place.write("a.json", R"({"frame":0,"layers":["terrain","labels"]})");
    EXPECT_TRUE(layer_names_beside(place.file("a.png")).empty()) << "without a mask nothing is named";
    (void)place.write("a.layers.png", "x");
    EXPECT_THAT(layer_names_beside(place.file("a.png")), ElementsAre("terrain", "labels"));
    (void)place.write("a.json", "no json");
    EXPECT_TRUE(layer_names_beside(place.file("a.png")).empty());
}

TEST(LayerNamesBeside, StandInTheRecordOfASheet) {
    const test_support::TemporaryFolder place;
    (void)place.write("a.layers.png", "x");
    (void)place.write("sheet.json", R"({"layers":["terrain","grid"]})");
    EXPECT_THAT(layer_names_beside(place.file("a.png")), ElementsAre("terrain", "grid"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_layer_names_beside
