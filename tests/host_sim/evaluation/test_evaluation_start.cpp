#include "host_sim/evaluation/evaluation_start.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_evaluation_start {
namespace {

TEST(EvaluationStart, HasAsManyThreadsAsAreAskedFor) {
    EXPECT_EQ(evaluation_workers(3)->concurrency(), 3u);
    EXPECT_GE(evaluation_workers(0)->concurrency(), 1u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_evaluation_start
