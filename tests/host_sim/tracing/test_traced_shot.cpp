#include "host_sim/tracing/traced_shot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/commands/trace.hpp"
#include "platform/threads/thread_workers.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_traced_shot {
namespace {

class TracedShotTest : public ::testing::Test {
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

TEST_F(TracedShotTest, IsTheSameWithAndWithoutTheStreamAndForEveryNumberOfWorkers) {
    for (const TracePreset preset : kTracePresets) {
        TracedShotPlan direct = plan();
        direct.is_direct = true;
        const raytrace::TraceSettings settings = settings_of(preset);
        const TracedShot called = draw_traced_shot(*ground, settings, direct, alone());
        EXPECT_EQ(called.rounds, 0u);
        for (const std::uint32_t threads : {1u, 2u, 3u, 7u}) {
            TracedShotPlan streamed = plan();
            streamed.block_words = 64;
            const auto workers = platform::make_thread_workers({threads, nullptr});
            const TracedShot shot = draw_traced_shot(*ground, settings, streamed, *workers.value());
            EXPECT_EQ(shot.pixels.pixels, called.pixels.pixels) << to_string(preset) << ' ' << threads;
            EXPECT_GT(shot.rounds, 0u);
        }
    }
}

TEST_F(TracedShotTest, ShowsGroundBelowAndSkyAbove) {
    TracedShotPlan level = plan();
    level.pose.pitch_deg = 0;
    const TracedShot shot = draw_traced_shot(*ground, settings_of(TracePreset::time), level, alone());
    const auto color = [&](std::uint32_t x, std::uint32_t y) { return &shot.pixels.pixels[4 * (y * 160 + x)]; };
    EXPECT_GT(color(80, 2)[2], color(80, 2)[0]) << "blue above";
    EXPECT_NE(std::memcmp(color(80, 2), color(80, 117), 3), 0);
    EXPECT_GT(shot.ground_share, 0.1);
    EXPECT_LT(shot.ground_share, 0.9);
    EXPECT_EQ(color(3, 3)[3], 255);
    EXPECT_GT(shot.pieces, 5u);
}

TEST_F(TracedShotTest, SaysWhatItTakes) {
    const TracedShot fast = draw_traced_shot(*ground, settings_of(TracePreset::time), plan(), alone());
    const TracedShot best = draw_traced_shot(*ground, settings_of(TracePreset::quality), plan(), alone());
    ASSERT_EQ(fast.items.size(), 1u);
    EXPECT_EQ(fast.items[0].name, "maximum mipmap");
    EXPECT_GT(best.bytes(), fast.bytes());
    EXPECT_NE(fast.pixels.pixels, best.pixels.pixels);
    EXPECT_THAT(describe(settings_of(TracePreset::quality)), ::testing::HasSubstr("apertures"));
    raytrace::TraceSettings searched = settings_of(TracePreset::time);
    searched.search = {raytrace::SearchKind::ray, 64, 12};
    EXPECT_EQ(describe(searched), "two triangles a cell, Lambert, search by ray (64 steps, 12 halvings)");
}

TEST_F(TracedShotTest, RefusesWhatItCannotSee) {
    TracedShotPlan polar = plan();
    polar.pose.latitude_deg = 89.99;
    test_support::expect_user_error([&] { (void)draw_traced_shot(*ground, settings_of(TracePreset::time), polar, alone()); },
                                    "pole");
}

}  // namespace
}  // namespace tedavis::host_sim::test_traced_shot
