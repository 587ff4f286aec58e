#include "host_sim/csv_cells.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::host_sim::test_csv_cells {
namespace {

using ::testing::ElementsAre;

TEST(CsvCells, SplitsAndTrims) {
    EXPECT_THAT(csv_cells("a, \"b\" ,,\tc d\r"), ElementsAre("a", "b", "", "c d"));
    EXPECT_THAT(csv_cells(""), ElementsAre(""));
    EXPECT_THAT(csv_cells(","), ElementsAre("", ""));
}

TEST(CsvCells, NumbersAreWholeCells) {
    EXPECT_EQ(number_in("-1.5e2"), -150);
    for (const char* none : {"", "1 2", "1.5x", "nan", "inf", "0x10", "1,5", "1e999"}) EXPECT_FALSE(number_in(none)) << none;
}

}  // namespace
}  // namespace tedavis::host_sim::test_csv_cells
