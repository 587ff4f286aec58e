#include "tests/layering/twin_rule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::tests::layering {
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

}  // namespace
}  // namespace tedavis::tests::layering
