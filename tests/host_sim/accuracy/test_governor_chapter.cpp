#include "host_sim/accuracy/governor_chapter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/flights/six_levels.hpp"

namespace tedavis::host_sim::test_governor_chapter {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

GovernorChoice made_choice() {
    GovernorChoice choice;
    choice.costs = "costs<1>.toml";
    choice.device = "es3-mid";
    choice.renderer = "llvmpipe";
    choice.flight = "the default flight";
    choice.levels = test_support::six_levels();
    choice.deadline_ms = 33;
    choice.frames = {60, 0, 0, 15, 0, 5};
    choice.missed = 2;
    return choice;
}

TEST(GovernorChapter, HasARowAndAMarkForEachLevel) {
    const std::string html = governor_chapter(made_choice());
    EXPECT_THAT(html, HasSubstr("costs&lt;1&gt;.toml"));
    EXPECT_THAT(html, HasSubstr("deadline of 33 ms"));
    EXPECT_THAT(html, HasSubstr("2 of them exceed"));
    EXPECT_THAT(html, HasSubstr("<th>the design&#39;s picture</th>"));
    EXPECT_THAT(html, HasSubstr("<td class='n'>75.0 %</td>")) << "60 of 80";
    EXPECT_THAT(html, HasSubstr("silhouettes"));
    for (int n = 1; n < 6; ++n) EXPECT_THAT(html, HasSubstr("level " + std::to_string(n)));
    EXPECT_THAT(html, HasSubstr("error, px"));
    EXPECT_THAT(html, HasSubstr("error, CIEDE2000"));
}

TEST(GovernorChapter, LevelsThatAreNotThereHaveNoRow) {
    GovernorChoice choice = made_choice();
    choice.levels.count = 2;
    EXPECT_THAT(governor_chapter(choice), Not(HasSubstr("level 2")));
    EXPECT_THAT(governor_text(choice), HasSubstr("level 1: 50.000 ms, 1.4 px, 0.5 CIEDE2000, 0 frames (0.0 %)"));
    EXPECT_THAT(governor_text(choice), Not(HasSubstr("level 2")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_governor_chapter
