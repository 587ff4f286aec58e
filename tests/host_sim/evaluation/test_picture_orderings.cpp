#include "host_sim/evaluation/picture_orderings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/shipped_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_picture_orderings {
namespace {

using ::testing::HasSubstr;

PictureOrderings read(const std::string& text) {
    const test_support::TemporaryFolder folder;
    return read_orderings(folder.write("o.toml", text));
}

const char* const kThree = R"(title = "t"
[[ordering]]
title = "more"
measure = "clutter"
more = "a/x.png"
less = "a/y.png"
thesis = [0.3, 0.2]
[[ordering]]
title = "alike"
measure = "clutter"
more = "a/x.png"
less = "a/y.png"
alike_within = 0.05
[[ordering]]
title = "eye"
measure = "share.data"
more = "a/y.png"
less = "a/x.png"
)";

std::vector<OrderedPicture> pictures(double x, double y) {
    return {{"/run/a/x.png", x, {{"terrain", 0.7}, {"data", 0.1}}}, {"a/y.png", y, {{"terrain", 0.5}, {"data", 0.3}}}};
}

std::vector<OrderingState> states(const PictureOrderings& orderings, const std::vector<OrderedPicture>& pictures) {
    std::vector<OrderingState> states;
    for (const JudgedOrdering& one : judged(orderings, pictures)) states.push_back(one.state);
    return states;
}

TEST(PictureOrderings, HoldOrDiffer) {
    using S = OrderingState;
    const PictureOrderings orderings = read(kThree);
    EXPECT_EQ(states(orderings, pictures(0.3, 0.2)), (std::vector<S>{S::holds, S::differs, S::holds}));
    EXPECT_EQ(states(orderings, pictures(0.2, 0.3)), (std::vector<S>{S::differs, S::differs, S::holds}));
    EXPECT_EQ(states(orderings, pictures(0.21, 0.2)), (std::vector<S>{S::holds, S::holds, S::holds}));
    EXPECT_EQ(states(orderings, pictures(0.2, 0.2)), (std::vector<S>{S::differs, S::holds, S::holds})) << "equal is not more";
}

TEST(PictureOrderings, WhatWasNotMeasuredIsNotJudged) {
    using S = OrderingState;
    const PictureOrderings orderings = read(kThree);
    EXPECT_EQ(states(orderings, {}), (std::vector<S>{S::missing, S::missing, S::missing}));
    std::vector<OrderedPicture> without = pictures(0.3, 0.2);
    without[0].shares.clear();
    EXPECT_EQ(states(orderings, without), (std::vector<S>{S::holds, S::differs, S::missing}));
    std::vector<OrderedPicture> others = pictures(0.3, 0.2);
    others[0].file = "extra/x.png";
    others[1].file = "ba/y.png";
    EXPECT_EQ(states(orderings, others), (std::vector<S>{S::missing, S::missing, S::missing})) << "whole parts of a path";
}

TEST(PictureOrderings, AreToldInTextAndJson) {
    const auto all = judged(read(kThree), pictures(0.3, 0.2));
    const std::string text = orderings_text(all);
    EXPECT_THAT(text, HasSubstr("0.30 -> 0.20   0.300 -> 0.200   holds    more (clutter)"));
    EXPECT_THAT(text, HasSubstr("more -> less   0.300 -> 0.200   differs  alike (clutter)"));
    const auto json = orderings_json(all);
    ASSERT_EQ(json.size(), 3u);
    EXPECT_EQ(json[0].at("state"), "holds");
    EXPECT_EQ(json[0].at("reported"), (std::vector<double>{0.3, 0.2}));
    EXPECT_TRUE(json[1].at("reported").is_null());
    EXPECT_EQ(json[2].at("measure"), "share.data");
    EXPECT_THAT(orderings_text(judged(read(kThree), {})), HasSubstr("not measured"));
}

TEST(PictureOrderings, WhatIsWrongIsSaidWithItsLine) {
    const auto refused = [](const std::string& text, const std::string& words) {
        test_support::expect_user_error([&] { static_cast<void>(read(text)); }, words);
    };
    refused("title = \"t\"\n", "has no [[ordering]]");
    refused("[canny]\nsigma = 1\nlow = 20\nhigh = 10\n", "o.toml:3: 'low' must not be above 'high'");
    refused("[[ordering]]\ntitle = \"a\"\nmeasure = \"share.clouds\"\nmore = \"a\"\nless = \"b\"\n",
            "o.toml:3: 'measure' must be");
    refused("[[ordering]]\ntitle = \"a\"\nmeasure = \"clutter\"\nmore = \"a\"\n", "'less' is missing");
    refused("[[ordering]]\ntitle = \"a\"\nmeasure = \"clutter\"\nmore = \"a\"\nless = \"b\"\nthesis = [0.2]\n", "thesis");
}

TEST(PictureOrderings, TheShippedOnesAreThoseOfTheThesis) {
    const PictureOrderings shipped = read_orderings(resolve_config("thesis", "orderings"));
    ASSERT_TRUE(shipped.canny.has_value());
    EXPECT_TRUE(shipped.canny->is_valid());
    std::vector<std::array<double, 2>> reported;
    for (const PictureOrdering& ordering : shipped.orderings)
        if (ordering.reported) reported.push_back(*ordering.reported);
    EXPECT_EQ(reported, (std::vector<std::array<double, 2>>{
                            {0.25, 0.18}, {0.18, 0.18}, {0.35, 0.25}, {0.43, 0.32}, {0.34, 0.18}, {0.30, 0.28}}));
}

}  // namespace
}  // namespace tedavis::host_sim::test_picture_orderings
