#include "host_sim/comparison/comparison_json.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/comparison/made_runs.hpp"

namespace tedavis::host_sim::test_comparison_json {
namespace {

TEST(ComparisonJson, HasBothValuesOfEachInstant) {
    ComparedRun a = made_run("a", 10), b = with_log(made_run("b", 10, 0.5), "a.log");
    for (std::size_t n = 0; n < 10; ++n) b.frames[n].values[kAltitude] = 2000 + 10 * static_cast<double>(n);
    b.frames[2].values[kLabelsPlaced] = 8;
    const auto json = comparison_json(compared_runs(a, b, {}));
    EXPECT_EQ(json.begin().key(), "comparison") << "files are told by their first key";
    ASSERT_EQ(json["instants"].size(), 9u);
    const auto& instant = json["instants"][1];
    EXPECT_EQ(instant["a"]["frame"], 2);
    EXPECT_EQ(instant["position_in_b"], 1.5);
    EXPECT_EQ(instant["a"]["altitude"], 1000);
    EXPECT_EQ(instant["b"]["altitude"], 2015) << "between two frames";
    EXPECT_EQ(instant["b"]["labels_placed"], 8) << "of the nearest frame";
    EXPECT_TRUE(instant["a"]["crowded_regions"].is_null());
    EXPECT_EQ(json["alignment"]["by"], "time");
    EXPECT_EQ(json["alignment"]["without_counterpart"], 1);
    EXPECT_EQ(json["equal"], false);
    EXPECT_EQ(json["differences"][0]["quantity"], "altitude");
    EXPECT_EQ(comparison_json(compared_runs(a, a, {}))["equal"], true);
}

TEST(ComparisonJson, SaysWhatIsNotKnownAndNotSearched) {
    ComparedRun a = made_run("a", 8000), b = made_run("b", 10);
    for (ComparedFrame& frame : b.frames) frame.hash = "0000000000000000";
    for (ComparedFrame& frame : b.frames) frame.values[kAltitude] = kUnknown;
    const RunComparison runs = compared_runs(a, b, {Alignment::place, 3000});
    const auto json = comparison_json(runs);
    EXPECT_EQ(json["alignment"]["stride_a"], 3);
    EXPECT_EQ(json["alignment"]["stride_b"], 1);
    EXPECT_EQ(json["alignment"]["searched"], 2667);
    EXPECT_EQ(json["alignment"]["without_counterpart"], 2667 - runs.aligned.instants.size());
    EXPECT_EQ(json["known_pictures"], 0);
    EXPECT_EQ(json["equal_pictures"], 0);
    EXPECT_EQ(json["known_by_one"]["altitude"], runs.aligned.instants.size());
    EXPECT_EQ(json["instants"][0]["a"]["hash"], "5f");
    EXPECT_TRUE(json["instants"][0]["b"]["hash"].is_null());
}

}  // namespace
}  // namespace tedavis::host_sim::test_comparison_json
