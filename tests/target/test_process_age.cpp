#include "target/process_age.hpp"

#include <gtest/gtest.h>
#include <time.h>

namespace tedavis::target::test_process_age {
namespace {

TEST(ProcessAge, TheStartIsTheTwentySecondField) {
    EXPECT_EQ(start_ticks("1234 (tedavis) S 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 98765 20 21"), 98765u);
    EXPECT_EQ(start_ticks("1234 (a b) c) d) S 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 98765 20 21"), 98765u)
        << "names may hold blanks and brackets";
    EXPECT_EQ(start_ticks("1234 (tedavis) S 1 2"), 0u);
    EXPECT_EQ(start_ticks(""), 0u);
    EXPECT_EQ(start_ticks("1234 (tedavis) S 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 x 20"), 0u);
}

TEST(ProcessAge, GrowsWithTheClock) {
    const base::Duration before = process_age();
    EXPECT_GE(before.ns, 0);
    timespec pause{0, 30'000'000};
    nanosleep(&pause, nullptr);
    EXPECT_GT(process_age().ns, before.ns) << "the clock's step is shorter";
}

}  // namespace
}  // namespace tedavis::target::test_process_age
