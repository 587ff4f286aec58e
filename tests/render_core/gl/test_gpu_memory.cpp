#include "render_core/gl/gpu_memory.hpp"

#include <gtest/gtest.h>

#include "render_core/base/budget_shortage.hpp"

#include <cstdint>
#include <limits>

namespace tedavis::gl::test_gpu_memory {
namespace {

base::BudgetLine line_of(std::uint64_t bytes) {
    base::BudgetLine line;
    line.name = "probe";
    line.bytes = bytes;
    return line;
}

TEST(GpuMemory, TakesUntilTheLineIsFullAndRefusesTheRest) {
    base::BudgetLine line = line_of(100);
    EXPECT_TRUE(try_take(line, 60));
    EXPECT_TRUE(try_take(line, 40));
    EXPECT_FALSE(try_take(line, 1));
    EXPECT_EQ(line.use.refused, 1u);
    give_back(line, 40);
    EXPECT_TRUE(try_take(line, 40));
    EXPECT_EQ(line.use.high_water, 100u);
}

TEST(GpuMemory, HugeRequestsDoNotWrapAround) {
    base::BudgetLine line = line_of(100);
    ASSERT_TRUE(try_take(line, 50));
    EXPECT_FALSE(try_take(line, std::numeric_limits<std::uint64_t>::max()));
    EXPECT_FALSE(try_take(line, std::numeric_limits<std::uint64_t>::max() - 49));
    EXPECT_EQ(line.use.in_use, 50u);
}

TEST(GpuMemory, GivingBackMoreThanTakenStopsTheProgram) {
    base::BudgetLine line = line_of(100);
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_DEATH(give_back(line, 1), "bytes <= line.use.in_use");
}

TEST(GpuMemory, SentenceNamesTheLineAndTheNumbers) {
    base::BudgetLine line = line_of(100);
    ASSERT_TRUE(try_take(line, 90));
    EXPECT_EQ(base::shortage_error(line, 30).message.view(),
              "the budget line 'probe' has 10 of 100 bytes left and 30 are needed; raise the line in the device file");
}

}  // namespace
}  // namespace tedavis::gl::test_gpu_memory
