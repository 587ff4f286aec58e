#include "host_sim/name_choices.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tedavis::host_sim::test_name_choices {
namespace {

TEST(NameChoices, AreNamedUpToTwelve) {
    std::vector<std::string> names;
    EXPECT_EQ(name_choices(names), "none");
    for (int n = 1; n <= 12; ++n) names.push_back(std::to_string(n));
    EXPECT_EQ(name_choices(names), "1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12");
    names.insert(names.end(), {"13", "14"});
    EXPECT_EQ(name_choices(names), "1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 and 2 more");
}

}  // namespace
}  // namespace tedavis::host_sim::test_name_choices
