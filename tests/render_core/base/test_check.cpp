#include "render_core/base/check.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "render_core/base/fixed_vector.hpp"

namespace tedavis::base::test_check {
namespace {

TEST(Check, a_true_condition_costs_nothing_and_is_evaluated_once) {
    int evaluations = 0;
    TEDAVIS_CHECK(++evaluations == 1);
    EXPECT_EQ(evaluations, 1);
}

TEST(CheckDeathTest, a_false_condition_names_itself_and_its_place) {
    EXPECT_DEATH(TEDAVIS_CHECK(1 + 1 == 3), "test_check\\.cpp:[0-9]+: broken invariant: 1 \\+ 1 == 3");
}

TEST(CheckDeathTest, the_composition_root_may_install_its_own_stop) {
    const auto install_and_fail = [] {
        set_fatal_stop([](const char* condition, const char*, int) {
            std::fprintf(stderr, "event log: %s\n", condition);
            std::_Exit(7);
        });
        TEDAVIS_CHECK(false);
    };
    EXPECT_EXIT(install_and_fail(), testing::ExitedWithCode(7), "event log: false");
}

TEST(CheckDeathTest, a_stop_that_returns_still_stops) {
    const auto install_and_fail = [] {
        set_fatal_stop([](const char*, const char*, int) {});
        TEDAVIS_CHECK(false);
    };
    EXPECT_DEATH(install_and_fail(), "");
}

TEST(CheckDeathTest, null_restores_the_default) {
    const auto restore_and_fail = [] {
        set_fatal_stop([](const char*, const char*, int) {});
        set_fatal_stop(nullptr);
        TEDAVIS_CHECK(false);
    };
    EXPECT_DEATH(restore_and_fail(), "broken invariant: false");
}

}  // namespace
}  // namespace tedavis::base::test_check
