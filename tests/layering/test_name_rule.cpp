#include "tests/layering/name_rule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::tests::layering::test_name_rule {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

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

TEST(PhraseRule, FindsPhrasesInCommentsAndPages) {
    EXPECT_THAT(phrase_findings({"bus/a.hpp", "int a;\n/// What gives way."}), ElementsAre(HasSubstr("bus/a.hpp:2: ")));
    EXPECT_THAT(phrase_findings({"bus/a.hpp", "int a;  ///< after a Turn of\n        ///< designs"}),
                ElementsAre(HasSubstr("bus/a.hpp:1: \"turn of designs\"")));
    EXPECT_THAT(phrase_findings({"bus/a.hpp", "/* it gave way */ int a; // gave way"}), SizeIs(2));
    EXPECT_THAT(phrase_findings({"bus/README.md", "# Bus\nThe own flown\nway, in \"\"."}), ElementsAre(HasSubstr(":2: ")));
}

TEST(PhraseRule, LeavesOtherTextsAlone) {
    const std::string allowed[] = {"f(\"gives way\");",       "int gives; int way;",  "// gives ways",
                                   "// it follows from that", "R\"(// gives way)\";", "// nothing follows, from nothing"};
    for (const std::string& code : allowed) EXPECT_THAT(phrase_findings({"bus/a.hpp", code}), IsEmpty()) << code;
}

TEST(PhraseRule, HoldsOverTheProductAndItsPages) {
    const auto is_of_tests = [](const SourceFile& file) { return starts_with(file.path, "tests/"); };
    for (const SourceFile& file : read_tree(TEDAVIS_SOURCE_DIR)) {
        if (is_of_tests(file)) continue;
        EXPECT_THAT(phrase_findings(file), IsEmpty());
    }
    const auto pages = read_pages(TEDAVIS_SOURCE_DIR);
    ASSERT_GT(pages.size(), 20u);
    for (const SourceFile& page : pages) EXPECT_THAT(phrase_findings(page), IsEmpty());
}

}  // namespace
}  // namespace tedavis::tests::layering::test_name_rule
