#include "tests/layering/twin_rule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/layering/source_file.hpp"

namespace tedavis::tests::layering::test_twin_rule {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(TwinRule, NamesTheTestOfASource) {
    EXPECT_EQ(twin_of("bus/candump/line_reader.cpp"), "tests/bus/candump/test_line_reader.cpp");
}

TEST(TwinRule, FindsASourceWithoutItsTest) {
    EXPECT_THAT(twin_findings({"bus/a.cpp", "tests/bus/test_b.cpp"}), ElementsAre(HasSubstr("tests/bus/test_a.cpp")));
    EXPECT_THAT(twin_findings({"bus/a.cpp", "tests/test_a.cpp"}), ElementsAre(HasSubstr("bus/a.cpp:1")));
}

TEST(TwinRule, AsksNothingOfHeadersRootsAndTests) {
    EXPECT_THAT(twin_findings({"bus/a.cpp", "tests/bus/test_a.cpp", "bus/b.hpp", "host_sim/main.cpp", "tests/support/c.cpp"}),
                IsEmpty());
}

TEST(TwinRule, PiecesOfOnePictureShareItsTest) {
    const std::string piece = "render_core/draw/symbology/heading.cpp";
    EXPECT_THAT(twin_findings({piece}), ElementsAre(HasSubstr("test_symbology.cpp")));
    EXPECT_THAT(twin_findings({piece, "tests/render_core/draw/symbology/test_symbology.cpp"}), IsEmpty());
}

TEST(TwinRule, HoldsOverTheTree) {
    std::set<std::string> paths;
    for (const SourceFile& file : read_tree(TEDAVIS_SOURCE_DIR)) paths.insert(file.path);
    EXPECT_THAT(twin_findings(paths), IsEmpty());
}

}  // namespace
}  // namespace tedavis::tests::layering::test_twin_rule
