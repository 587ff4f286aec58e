#include "host_sim/contract/judge_contract.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/host_sim/contract/contract_samples.hpp"

namespace tedavis::host_sim::test_judge_contract {
namespace {

using test_support::contract_of;
using test_support::most_of;
using test_support::run_of_seconds;
using test_support::series_of;

JudgedContract judged(const ContractCondition& condition, std::initializer_list<std::optional<double>> values,
                      std::size_t frames = 0) {
    return judge_contract(contract_of({condition}), run_of_seconds(frames == 0 ? values.size() : frames), series_of(values));
}

TEST(JudgeContract, HoldsWhereEveryConditionDoes) {
    const JudgedContract kept = judged(most_of("calm", 0.5), {0.1, 0.4, 0.2});
    EXPECT_TRUE(kept.holds());
    EXPECT_EQ(kept.conditions[0].state, ConditionState::holds);
    EXPECT_EQ(kept.conditions[0].tightest.value, 0.4);
    const JudgedContract broken = judged(most_of("calm", 0.5), {0.1, 0.6, 0.9});
    EXPECT_FALSE(broken.holds());
    EXPECT_EQ(broken.conditions[0].state, ConditionState::broken);
    EXPECT_EQ(broken.conditions[0].first.value, 0.6);
    EXPECT_EQ(broken.conditions[0].worst.value, 0.9);
    EXPECT_EQ(broken.conditions[0].verdict.worst.time_s, 2);
}

TEST(JudgeContract, OneBrokenConditionIsEnough) {
    auto readings = series_of({0.1, 0.2});
    for (auto& of_frame : readings) of_frame.push_back(test_support::reading_of(0.7));
    const JudgedContract both = judge_contract(contract_of({most_of("a", 0.5), most_of("b", 0.5)}), run_of_seconds(2), readings);
    EXPECT_TRUE(both.conditions[0].is_kept());
    EXPECT_FALSE(both.conditions[1].is_kept());
    EXPECT_FALSE(both.holds());
}

TEST(JudgeContract, WhatWasNotMeasuredIsNotShownToHold) {
    ContractCondition condition = most_of("rank", 3);
    EXPECT_EQ(judged(condition, {{}, {}}).conditions[0].state, ConditionState::absent);
    EXPECT_FALSE(judged(condition, {{}, {}}).holds());
    condition.is_optional = true;
    EXPECT_EQ(judged(condition, {{}, {}}).conditions[0].state, ConditionState::passed);
    EXPECT_TRUE(judged(condition, {{}, {}}).holds());
    EXPECT_FALSE(judged(condition, {{}, 4.0}).holds()) << "what was measured counts";
}

TEST(JudgeContract, ARunThatLacksWhatIsNeededDoesNotPassEvenIfItIsOptional) {
    ContractCondition condition = most_of("share", 3);
    condition.is_optional = true;
    auto readings = series_of({1.0, 1.0, 1.0});
    readings[1][0] = missing_reading("no mask");
    const JudgedContract judged = judge_contract(contract_of({condition}), run_of_seconds(3), readings);
    EXPECT_FALSE(judged.holds());
    EXPECT_EQ(judged.conditions[0].state, ConditionState::missing);
    EXPECT_EQ(judged.conditions[0].missing, 1u);
    EXPECT_EQ(judged.conditions[0].first.words, "no mask");
    EXPECT_TRUE(std::isnan(judged.conditions[0].values[1]));
    readings[2][0].value = 5;
    EXPECT_EQ(judge_contract(contract_of({condition}), run_of_seconds(3), readings).conditions[0].state, ConditionState::broken)
        << "what is known to be broken says more";
}

TEST(JudgeContract, APictureStandsUntilTheNextOne) {
    EXPECT_TRUE(judged(most_of("calm", 0.5, 1.5), {0.1, 0.9, 0.1}).holds());
    EXPECT_FALSE(judged(most_of("calm", 0.5, 1.5), {0.1, 0.9, 0.9, 0.1}).holds());
    EXPECT_TRUE(judged(most_of("calm", 0.5, 1.5), {0.1, 0.1, 0.9}).holds()) << "the last as long as the one before";
    EXPECT_FALSE(judged(most_of("calm", 0.5, 1), {0.1, 0.1, 0.9}).holds());
    EXPECT_FALSE(judged(most_of("calm", 0.5, 1), {0.9}).holds()) << "a single picture stands for a second";
}

TEST(JudgeContract, APartOfAFlightIsNotShownToHold) {
    const JudgedContract part = judged(most_of("calm", 0.5), {0.1, 0.2}, 5);
    EXPECT_TRUE(part.interrupted);
    EXPECT_TRUE(part.conditions[0].is_kept());
    EXPECT_FALSE(part.holds());
    EXPECT_EQ(part.times_s, (std::vector<double>{0, 1}));
}

}  // namespace
}  // namespace tedavis::host_sim::test_judge_contract
