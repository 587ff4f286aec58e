#include "host_sim/version.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace tedavis::host_sim::test_version {
namespace {

TEST(Version, HasThreeNumbers) {
    int major = -1, minor = -1, patch = -1;
    char rest = 0;
    EXPECT_EQ(std::sscanf(version(), "%d.%d.%d%c", &major, &minor, &patch, &rest), 3);
}

}  // namespace
}  // namespace tedavis::host_sim::test_version
