#include "host_sim/number_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::host_sim::test_number_list {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(NumberList, ReadsEveryPart) {
    EXPECT_THAT(parse_number_list("9.6,-46.5,1e2,.25", ','), ElementsAre(9.6, -46.5, 100, 0.25));
    EXPECT_THAT(parse_number_list("1024x768", 'x'), ElementsAre(1024, 768));
    EXPECT_THAT(parse_number_list("7", ','), ElementsAre(7));
}

TEST(NumberList, AnyPartThatIsNoNumberSpoilsAll) {
    for (const char* text : {"", ",", "1,", ",1", "1,,2", "1, 2", "1;2", "1,2m", "nan,1", "1,inf", "1,1e999", "1x2"})
        EXPECT_THAT(parse_number_list(text, ','), IsEmpty()) << text;
}

}  // namespace
}  // namespace tedavis::host_sim::test_number_list
