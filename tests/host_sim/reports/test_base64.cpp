#include "host_sim/reports/base64.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_base64 {
namespace {

// RFC 4648, section 10.
TEST(Base64, GivesTheStandardsTestVectors) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, UsesAllBitsOfAllBytes) {
    EXPECT_EQ(base64(std::string("\xFF\xFF\xFF", 3)), "////");
    EXPECT_EQ(base64(std::string("\0\0\0", 3)), "AAAA");
    EXPECT_EQ(base64(std::string("\xFB\xEF\xBE", 3)), "++++");
}

}  // namespace
}  // namespace tedavis::host_sim::test_base64
