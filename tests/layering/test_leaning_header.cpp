// The control of the headers that the build compiles alone: one with a fault is refused.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace tedavis::tests::layering::test_leaning_header {
namespace {

bool compiles(const std::string& arguments) {
    const std::string command = TEDAVIS_COMPILER " -std=c++17 -fsyntax-only " + arguments +
                                " -x c++ " TEDAVIS_SOURCE_DIR "/tests/layering/seeded_leaning_header.hpp 2>/dev/null";
    return std::system(command.c_str()) == 0;
}

TEST(LeaningHeader, IsRefusedAloneAndTakenBehindWhatItLeansOn) {
    EXPECT_FALSE(compiles(""));
    EXPECT_TRUE(compiles("-include cstdint"));
}

}  // namespace
}  // namespace tedavis::tests::layering::test_leaning_header
