#include "host_sim/version.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace tedavis::host_sim::test_version {
namespace {

TEST(Version, HasThreeNumbers) {
    int major = -1, minor = -1, patch = -1;
    char rest = 0;
    EXPECT_EQ(std::sscanf(version(), "%d.%d.%d%c", &major, &minor, &patch, &rest), 3);
}

TEST(Version, NamesTheCommit) {
    const std::string name = commit();
    const std::size_t digits = name.find_first_not_of("0123456789abcdef");
    const bool is_commit = digits == std::string::npos ? name.size() >= 12 : name.substr(digits) == "+" && digits >= 12;
    EXPECT_TRUE(is_commit || name == "unknown") << name;
}

}  // namespace
}  // namespace tedavis::host_sim::test_version
