#include "host_sim/commands/option_checks.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_option_checks {
namespace {

bool passes(const CLI::Validator& check, std::string text) { return check(text).empty(); }

TEST(OptionChecks, AboveZeroAreFiniteNumbersAboveIt) {
    for (const char* good : {"1", "0.001", "1e9"}) EXPECT_TRUE(passes(above_zero(), good)) << good;
    for (const char* bad : {"0", "-1", "nan", "inf", "x"}) EXPECT_FALSE(passes(above_zero(), bad)) << bad;
}

TEST(OptionChecks, FromZeroAreNumbersFromItOn) {
    for (const char* good : {"0", "7", "0.5"}) EXPECT_TRUE(passes(from_zero(), good)) << good;
    for (const char* bad : {"-0.1", "nan"}) EXPECT_FALSE(passes(from_zero(), bad)) << bad;
}

}  // namespace
}  // namespace tedavis::host_sim::test_option_checks
