#include "tests/layering/name_rule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::tests::layering::test_name_rule {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(NameRule, RefusesNamesThatTheFieldHasAnotherWordFor) {
    EXPECT_THAT(name_findings({"bus/a.hpp", "int a;\nFlownWay way;"}), ElementsAre(HasSubstr("bus/a.hpp:2: ")));
    EXPECT_THAT(name_findings({"bus/a.hpp", "const int kMostFrames = 1;"}), ElementsAre(HasSubstr("kMaxFrames")));
    EXPECT_THAT(name_findings({"bus/a.hpp", "f(kLeast, kLeast_px);"}), ElementsAre(HasSubstr("kMin"), HasSubstr("kMin_px")));
}

TEST(NameRule, SpellsColorInOneWay) {
    EXPECT_THAT(name_findings({"bus/a.hpp", "int sky_colour;"}), ElementsAre(HasSubstr("sky_color here")));
    EXPECT_THAT(name_findings({"bus/a.hpp", "bool Colours = is_coloured;"}),
                ElementsAre(HasSubstr("Colors"), HasSubstr("is_colored")));
    EXPECT_THAT(name_findings({"bus/a.hpp", "int kColourOfColour;"}), ElementsAre(HasSubstr("kColorOfColor here")));
    const std::string allowed[] = {"int sky_color;", "// the colour of the sky", "f(\"sky_colour\");", "int colonel;"};
    for (const std::string& code : allowed) EXPECT_THAT(name_findings({"bus/a.hpp", code}), IsEmpty()) << code;
}

TEST(NameRule, LeavesOtherWordsAlone) {
    const std::string allowed[] = {"FlownWays w;", "// a FlownWay", "const char* s = \"kMost\";", "kMostly = 1;",
                                   "least = most;"};
    for (const std::string& code : allowed) EXPECT_THAT(name_findings({"bus/a.hpp", code}), IsEmpty()) << code;
}

TEST(NameRule, HoldsOverTheTree) {
    for (const SourceFile& file : read_tree(TEDAVIS_SOURCE_DIR)) EXPECT_THAT(name_findings(file), IsEmpty());
}

}  // namespace
}  // namespace tedavis::tests::layering::test_name_rule
