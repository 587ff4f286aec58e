#include "render_core/perception/condition_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "tests/support/perception/synthetic_picture.hpp"

namespace tedavis::perception::test_condition_watch {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
using Series = std::vector<std::optional<double>>;  // a value a second

ConditionVerdict watched(const ConditionLimit& limit, const Series& series) {
    ConditionWatch watch(limit);
    for (std::size_t n = 0; n < series.size(); ++n) {
        const auto time_s = static_cast<double>(n);
        if (series[n])
            watch.add({time_s, *series[n], static_cast<std::uint32_t>(n)});
        else
            watch.skip(time_s);
    }
    watch.end(static_cast<double>(series.size()));
    return watch.verdict();
}

TEST(ConditionWatch, ASingleValueBeyondTheLimitBreaksIt) {
    const ConditionVerdict kept = watched({true, 0.5, 0}, {0.1, 0.5, 0.4});
    EXPECT_FALSE(kept.is_broken);
    EXPECT_EQ(kept.measured, 3u);
    EXPECT_EQ(kept.tightest.place, 1u) << "also where it holds";
    const ConditionVerdict broken = watched({true, 0.5, 0}, {0.1, 0.6, 0.9, 0.2, 0.7});
    EXPECT_TRUE(broken.is_broken);
    EXPECT_EQ(broken.first.time_s, 1);
    EXPECT_EQ(broken.first.value, 0.6);
    EXPECT_EQ(broken.worst.place, 2u);
    EXPECT_EQ(broken.beyond, 3u);
    EXPECT_EQ(broken.longest_s, 2);
    EXPECT_EQ(broken.broken_s, 3);
}

TEST(ConditionWatch, ALeastValueIsTheMirrorOfAMostOne) {
    const Series series = {3.0, 1.0, {}, 0.5, 0.5, 4.0};
    Series mirrored;
    for (const auto& value : series) mirrored.push_back(value ? std::optional<double>(-*value) : std::nullopt);
    const ConditionVerdict least = watched({false, 2, 1.5}, series), most = watched({true, -2, 1.5}, mirrored);
    EXPECT_EQ(least.is_broken, most.is_broken);
    EXPECT_EQ(least.first.place, most.first.place);
    EXPECT_EQ(least.worst.place, 3u);
    EXPECT_EQ(least.worst.place, most.worst.place);
    EXPECT_EQ(least.broken_s, most.broken_s);
}

TEST(ConditionWatch, WhatIsTooBriefDoesNotCount) {
    const ConditionLimit limit{true, 1, 2};
    EXPECT_FALSE(watched(limit, {0.0, 9.0, 0.0, 9.0, 0.0}).is_broken);
    EXPECT_EQ(watched(limit, {0.0, 9.0, 0.0, 9.0, 0.0}).beyond, 2u);
    const ConditionVerdict broken = watched(limit, {0.0, 9.0, 0.0, 2.0, 3.0, 0.0});
    EXPECT_TRUE(broken.is_broken) << "two values stand for two seconds";
    EXPECT_EQ(broken.first.place, 3u) << "the brief one before is not the first";
    EXPECT_EQ(broken.worst.place, 4u) << "nor the worst";
    EXPECT_EQ(broken.tightest.place, 1u);
    EXPECT_FALSE(watched(limit, {9.0, {}, 9.0}).is_broken) << "what is not measured is a pause";
    EXPECT_TRUE(watched(limit, {0.0, 9.0, 9.0}).is_broken) << "the last one stands until the end";
}

TEST(ConditionWatch, NothingMeasuredIsNeitherKeptNorBroken) {
    for (const Series& series : {Series{}, Series{{}, {}}}) {
        EXPECT_FALSE(watched({true, 1, 0}, series).is_broken);
        EXPECT_EQ(watched({true, 1, 0}, series).measured, 0u);
    }
}

TEST(ConditionWatch, WhatIsNoNumberIsBeyondEveryLimit) {
    for (const bool is_most : {true, false}) {
        const ConditionVerdict verdict = watched({is_most, 1, 0}, {1.0, kNaN, 1.0});
        EXPECT_TRUE(verdict.is_broken);
        EXPECT_EQ(verdict.worst.place, 1u);
        EXPECT_TRUE(std::isnan(verdict.tightest.value));
    }
    EXPECT_TRUE(watched({true, 1, 0}, {std::numeric_limits<double>::infinity()}).is_broken);
}

/// Straight from the definition: every stretch without a pause, one after the other.
ConditionVerdict by_stretches(const ConditionLimit& limit, const Series& series) {
    ConditionVerdict verdict;
    for (std::size_t begin = 0; begin < series.size(); ++begin) {
        if (begin > 0 && series[begin - 1] && *series[begin - 1] > limit.limit) continue;
        std::size_t end = begin, worst = begin;
        for (; end < series.size() && series[end] && *series[end] > limit.limit; ++end)
            if (*series[end] > *series[worst]) worst = end;
        if (end == begin || static_cast<double>(end - begin) < limit.for_s) continue;
        if (!verdict.is_broken) verdict.first.place = static_cast<std::uint32_t>(begin);
        if (!verdict.is_broken || *series[worst] > *series[verdict.worst.place])
            verdict.worst.place = static_cast<std::uint32_t>(worst);
        verdict.is_broken = true;
        verdict.broken_s += static_cast<double>(end - begin);
    }
    return verdict;
}

TEST(ConditionWatch, JudgesAnySeriesAsItsStretchesSay) {
    int broken = 0;
    for (std::uint32_t n = 0; n < 400; ++n) {
        Series series;
        for (std::uint32_t i = 0; i < 20; ++i) {
            const std::uint32_t drawn = test_support::scrambled(i, n, 11) % 8;
            series.push_back(drawn == 0 ? std::nullopt : std::optional<double>(drawn));
        }
        const ConditionLimit limit{true, 4, static_cast<double>(n % 4)};
        const ConditionVerdict judged = watched(limit, series), expected = by_stretches(limit, series);
        ASSERT_EQ(judged.is_broken, expected.is_broken) << n;
        broken += judged.is_broken ? 1 : 0;
        if (!judged.is_broken) continue;
        EXPECT_EQ(judged.first.place, expected.first.place) << n;
        EXPECT_EQ(judged.worst.place, expected.worst.place) << n;
        EXPECT_EQ(judged.broken_s, expected.broken_s) << n;
    }
    EXPECT_GT(broken, 100);
    EXPECT_LT(broken, 390);
}

}  // namespace
}  // namespace tedavis::perception::test_condition_watch
