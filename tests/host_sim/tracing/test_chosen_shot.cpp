#include "host_sim/tracing/chosen_shot.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "host_sim/commands/trace.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_chosen_shot {
namespace {

class ChosenShotTest : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        files = new test_support::FlownFiles;
        ground = new TracedGround(files->terrain, alone());
    }
    static void TearDownTestSuite() {
        delete ground;
        delete files;
    }
    static base::Workers& alone() {
        static base::SerialWorkers workers;
        return workers;
    }
    static TracedShotPlan plan() {
        TracedShotPlan plan;
        plan.pose = usual_pose(*ground);
        plan.width = 160;
        plan.height = 120;
        plan.rounds = 1;
        return plan;
    }
    static inline test_support::FlownFiles* files = nullptr;
    static inline TracedGround* ground = nullptr;
};

std::uint32_t regions_of(const ChosenFrame& frame) { return std::accumulate(frame.regions.begin(), frame.regions.end(), 0u); }

TEST_F(ChosenShotTest, ADeadlineThatNothingKeepsGivesTheCheapestAndSaysSo) {
    ChoicePlan choice;
    choice.deadline_ms = 1e-6;
    choice.frames = 2;
    const ChosenShot chosen = draw_chosen_shot(*ground, plan(), choice, alone());
    EXPECT_FALSE(chosen.frames.back().keeps_deadline);
    EXPECT_EQ(chosen.frames.back().regions[0], regions_of(chosen.frames.back()));
    EXPECT_DOUBLE_EQ(chosen.frames.back().error, chosen.levels.front().error);
    const TracedShot cheapest = draw_traced_shot(*ground, choice_levels()[0], plan(), alone());
    EXPECT_EQ(chosen.shot.pixels.pixels, cheapest.pixels.pixels);
}

TEST_F(ChosenShotTest, ADeadlineThatIsFarAwayGivesTheBestWhereThereIsGround) {
    ChoicePlan choice;
    choice.deadline_ms = 1e9;
    choice.frames = 2;
    const ChosenShot chosen = draw_chosen_shot(*ground, plan(), choice, alone());
    EXPECT_TRUE(chosen.frames.back().keeps_deadline);
    EXPECT_LT(chosen.frames.back().error, 0.01 * chosen.levels.front().error);
    EXPECT_GT(chosen.frames.back().regions[2], 0u);
}

TEST_F(ChosenShotTest, AQualityIsReachedWithNoMoreThanItTakes) {
    ChoicePlan choice;
    choice.frames = 3;
    const ChosenShot best = draw_chosen_shot(*ground, plan(), choice, alone());
    choice.most_error = 0.5 * best.levels.front().error;
    const ChosenShot chosen = draw_chosen_shot(*ground, plan(), choice, alone());
    EXPECT_LT(chosen.frames.back().error, best.levels.front().error);
    EXPECT_GT(chosen.frames.back().error, best.frames.back().error);
    EXPECT_LT(chosen.frames.back().regions[2], best.frames.back().regions[2]);
}

TEST_F(ChosenShotTest, LevelsGetBetter) {
    ChoicePlan choice;
    choice.frames = 1;
    const ChosenShot chosen = draw_chosen_shot(*ground, plan(), choice, alone());
    ASSERT_EQ(chosen.levels.size(), choice_levels().size());
    EXPECT_GT(chosen.levels[0].error, chosen.levels[1].error);
    EXPECT_GT(chosen.levels[1].error, chosen.levels[2].error);
    EXPECT_EQ(chosen.levels[2].error, 0);
}

}  // namespace
}  // namespace tedavis::host_sim::test_chosen_shot
