#include "host_sim/contract/contract_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/host_sim/contract/contract_samples.hpp"

namespace tedavis::host_sim::test_contract_report {
namespace {

using test_support::most_of;
using test_support::series_of;
using ::testing::HasSubstr;
using ::testing::Not;

JudgedContract judged(const ContractCondition& condition, std::initializer_list<std::optional<double>> values) {
    return judge_contract(test_support::contract_of({condition}), test_support::run_of_seconds(values.size()), series_of(values));
}

TEST(ContractReport, AFailureHasWhenHowFarAndWhere) {
    const JudgedContract broken = judged(most_of("calm", 0.5), {0.1, 0.6, 0.9});
    const auto json = contract_json(broken);
    EXPECT_EQ(json.at("holds"), false);
    ASSERT_EQ(json.at("failures").size(), 1u);
    const auto& failure = json["failures"][0];
    EXPECT_EQ(failure.at("condition"), "calm");
    EXPECT_EQ(failure.at("time_s"), 1.0);
    EXPECT_EQ(failure.at("value"), 0.6);
    EXPECT_EQ(failure.at("limit"), 0.5);
    EXPECT_EQ(failure.at("region").at("name"), "upper left");
    EXPECT_EQ(failure["region"].at("box"), (std::vector<int>{10, 20, 30, 40}));
    EXPECT_EQ(failure.at("worst").at("time_s"), 2.0);
    EXPECT_EQ(failure["worst"].at("value"), 0.9);
    EXPECT_EQ(failure.at("broken_s"), 2.0);
    const std::string text = contract_text(broken);
    for (const char* part : {"does not hold c.toml (0 of 1 conditions, 3 frames)", "broken", "calm <= 0.500",
                             "first 0.600 at 1.0 s", "worst 0.900 at 2.0 s (upper left, what)", "broken for 2.0 s"})
        EXPECT_THAT(text, HasSubstr(part));
}

TEST(ContractReport, WhatHoldsIsToldWithItsTightestMoment) {
    const JudgedContract kept = judged(most_of("calm", 0.5), {0.1, {}, 0.4});
    const auto json = contract_json(kept);
    EXPECT_EQ(json.at("holds"), true);
    EXPECT_TRUE(json.at("failures").empty());
    const auto& condition = json.at("conditions").at(0);
    EXPECT_EQ(condition.at("most"), 0.5);
    EXPECT_EQ(condition.at("frames"), 2);
    EXPECT_EQ(condition.at("tightest").at("time_s"), 2.0);
    EXPECT_EQ(condition.at("values"), nlohmann::ordered_json::parse("[0.1, null, 0.4]"));
    EXPECT_EQ(json.at("times_s").size(), 3u);
    EXPECT_THAT(contract_text(kept), HasSubstr("out/run: holds c.toml (1 of 1 conditions, 3 frames)"));
    EXPECT_THAT(contract_text(kept), HasSubstr("at its tightest 0.400 at 2.0 s (upper left, what), 2 frames"));
}

TEST(ContractReport, WhatWasNotMeasuredHasNoNumbersButAReason) {
    ContractCondition condition = most_of("rank", 3);
    condition.phases = {"approach", "cruise"};
    const auto json = contract_json(judged(condition, {{}, {}}));
    ASSERT_EQ(json.at("failures").size(), 1u);
    const auto& failure = json["failures"][0];
    for (const char* key : {"time_s", "value", "region", "worst"}) EXPECT_TRUE(failure.at(key).is_null()) << key;
    EXPECT_EQ(failure.at("why"), "no frame in approach, cruise has what it measures");
    condition.is_optional = true;
    const JudgedContract passed = judged(condition, {{}, {}});
    EXPECT_TRUE(contract_json(passed).at("failures").empty());
    EXPECT_THAT(contract_text(passed), HasSubstr("passed over"));
    auto readings = series_of({1.0, 1.0});
    readings[1][0] = missing_reading("no mask; make one");
    const JudgedContract missing =
        judge_contract(test_support::contract_of({condition}), test_support::run_of_seconds(2), readings);
    EXPECT_THAT(contract_text(missing),
                HasSubstr("not measured        rank <= 3.000: 1 frame could not be measured: no mask; make one"));
    EXPECT_EQ(contract_json(missing)["failures"][0]["why"], "1 frame could not be measured: no mask; make one");
}

TEST(ContractReport, ARankThatNoPlaceHasIsNone) {
    ContractCondition condition = most_of("noticed", 3);
    condition.measure = ContractMeasure::obstacle_rank;
    const JudgedContract broken = judged(condition, {std::numeric_limits<double>::infinity(), 2.0});
    EXPECT_TRUE(contract_json(broken)["failures"][0]["value"].is_null());
    EXPECT_THAT(contract_text(broken), HasSubstr("noticed <= 3: worst none at 0.0 s"));
    EXPECT_THAT(contract_text(broken), Not(HasSubstr("inf")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_contract_report
