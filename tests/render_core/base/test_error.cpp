#include "render_core/base/error.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace tedavis::base::test_error {
namespace {

TEST(Error, IsOneWhereItHasAMessage) {
    EXPECT_FALSE(Error());
    EXPECT_TRUE(make_error("no"));
}

TEST(MakeError, JoinsItsParts) { EXPECT_EQ(make_error("a ", "b", " c", ".").message.view(), "a b c."); }

TEST(MakeError, CutsWhatDoesNotFit) {
    const std::string part(800, 'x');
    const Error error = make_error(part, part);
    EXPECT_TRUE(error.message.cut());
    EXPECT_EQ(error.message.size(), 1535u);
}

TEST(Digits, AgreeWithTheStandardLibrary) {
    for (std::uint64_t value :
         {std::uint64_t{0}, std::uint64_t{9}, std::uint64_t{10}, std::uint64_t{4096}, std::numeric_limits<std::uint64_t>::max()})
        EXPECT_EQ(std::string(digits(value).view()), std::to_string(value));
}

}  // namespace
}  // namespace tedavis::base::test_error
