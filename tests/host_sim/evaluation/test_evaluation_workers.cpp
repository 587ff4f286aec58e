#include "host_sim/evaluation/evaluation_workers.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_evaluation_workers {
namespace {

TEST(EvaluationWorkers, HasAsManyThreadsAsAreAskedFor) {
    EXPECT_EQ(evaluation_workers(3)->concurrency(), 3u);
    EXPECT_GE(evaluation_workers(0)->concurrency(), 1u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_evaluation_workers
