// This program is linked with the planner, and with no GL module: what a plan calls needs none. It flies without terrain.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "render_core/display/planner/frame_planner.hpp"

namespace tedavis::plan_without_gl::test_plan_without_gl {
namespace {

using flight::Signal;

constexpr std::size_t kSymbologyBytes = 1u << 22;

flight::FrameInput input_at(double pitch_rad) {
    flight::FrameInput input;
    input.time = base::Time{} + base::Duration::from_seconds(10);
    for (const Signal signal : {Signal::pitch, Signal::roll, Signal::true_heading}) input.state[signal] = {0.1, input.time};
    input.state[Signal::pitch] = {pitch_rad, input.time};
    return input;
}

class WithoutGl : public testing::Test {
protected:
    void SetUp() override {
        display::DisplaySettings settings;
        settings.width_px = 320;
        settings.height_px = 240;
        ASSERT_FALSE(planner.take_designs(settings, memory));
        ASSERT_FALSE(planner.start_symbology(arena));
        const draw::DrawnDesign only = draw::drawn_as(planner.design_at(0), {}, false);
        planner.start_memory({&only, 1}, memory);
        ASSERT_FALSE(planner.start_scene(nullptr, {scene, slices}, 0));
        planner.follow_painter({}, {&only, 1});
    }

    std::vector<unsigned char> bytes = std::vector<unsigned char>(kSymbologyBytes);
    base::Arena arena{bytes.data(), bytes.size()}, scene, slices;
    display::PlannerMemory memory;
    display::FramePlanner planner;
    std::unique_ptr<display::PlannedFrame> frame = std::make_unique<display::PlannedFrame>();
};

TEST_F(WithoutGl, AFrameIsPlanned) {
    display::PlannerMemory other = memory;
    planner.plan(input_at(0.1), memory, *frame);
    EXPECT_EQ(memory.frames, 1u);
    EXPECT_FALSE(frame->decisions.show_terrain) << "there is none";
    const auto vertices = planner.symbology().vertices();
    ASSERT_FALSE(vertices.empty());
    const std::vector<draw::QuadVertex> first(vertices.begin(), vertices.end());
    const auto same = [&first](const base::Span<const draw::QuadVertex>& now) {
        return now.size() == first.size() && std::memcmp(now.data(), first.data(), first.size() * sizeof(draw::QuadVertex)) == 0;
    };
    planner.plan(input_at(0.1), other, *frame);
    EXPECT_EQ(other.frames, 1u);
    EXPECT_TRUE(same(planner.symbology().vertices())) << "from a copy of the same memory";
    planner.plan(input_at(0.2), other, *frame);
    EXPECT_FALSE(same(planner.symbology().vertices())) << "control: another pitch";
}

}  // namespace
}  // namespace tedavis::plan_without_gl::test_plan_without_gl
