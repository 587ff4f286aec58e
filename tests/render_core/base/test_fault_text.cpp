#include "render_core/base/fault_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::base::test_fault_text {
namespace {

TEST(FaultText, SaysWhatWhereAndWhatToDo) {
    EXPECT_EQ(fault_text("is damaged", 40, "get a whole copy").view(), "is damaged (offset 40); get a whole copy");
    EXPECT_EQ(fault_text("is", UINT64_MAX, "do").view(), "is (offset 18446744073709551615); do");
    EXPECT_TRUE(fault_text("is", 0, std::string(300, 'x')).cut()) << "and no more than fits";
}

TEST(FaultText, IsTakenFromBehindItsBeginning) {
    EXPECT_EQ(text_behind("the file ", "the file is damaged"), "is damaged");
    EXPECT_EQ(text_behind("the file ", "the device is small"), "");
    EXPECT_EQ(text_behind("the file ", "the"), "");
    EXPECT_EQ(text_behind("", "all"), "all");
}

}  // namespace
}  // namespace tedavis::base::test_fault_text
