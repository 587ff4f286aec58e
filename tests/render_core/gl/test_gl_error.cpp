#include "render_core/gl/gl_error.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace tedavis::gl::test_gl_error {
namespace {

TEST(MakeError, JoinsItsParts) { EXPECT_EQ(make_error("a ", "b", " c", ".").sentence.view(), "a b c."); }

TEST(MakeError, CutsWhatDoesNotFit) {
    const std::string part(700, 'x');
    const GlError error = make_error(part, part);
    EXPECT_TRUE(error.sentence.cut());
    EXPECT_EQ(error.sentence.size(), 1023u);
}

TEST(Digits, AgreeWithTheStandardLibrary) {
    for (std::uint64_t value :
         {std::uint64_t{0}, std::uint64_t{9}, std::uint64_t{10}, std::uint64_t{4096}, std::numeric_limits<std::uint64_t>::max()})
        EXPECT_EQ(std::string(digits(value).view()), std::to_string(value));
}

}  // namespace
}  // namespace tedavis::gl::test_gl_error
