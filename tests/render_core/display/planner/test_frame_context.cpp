#include "render_core/display/planner/frame_context.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace tedavis::display::test_frame_context {
namespace {

class FrameContextTest : public ::testing::Test {
protected:
    FrameContextTest() {
        frame_->shown = &design_;
        frame_->altitude_msl_m = 1950;
        frame_->heights = {100, 900};
        frame_->picture.camera.haze_per_m = 1e-4;
    }
    design::DesignSettings design_;
    std::unique_ptr<PlannedFrame> frame_ = std::make_unique<PlannedFrame>();
};

TEST_F(FrameContextTest, IsWhatWasPlanned) {
    const FrameContext context = context_of(*frame_, frame_->picture.camera);
    EXPECT_EQ(&context.design, &design_);
    EXPECT_EQ(context.aircraft_msl_m, 1950);
    EXPECT_EQ(context.heights.highest_m, 900);
    EXPECT_EQ(context.haze_per_m, 0) << "the plan of effects has no haze";
    EXPECT_EQ(context.foci, nullptr);
    frame_->draws_foci = true;
    EXPECT_EQ(context_of(*frame_, frame_->picture.camera).foci, &frame_->foci_plan.foci.regions);
}

TEST_F(FrameContextTest, OnlyTheOrthographicViewIsOblique) {
    design_.view.mode = design::ViewMode::map;
    EXPECT_FALSE(make_map_input(context_of(*frame_, frame_->picture.camera), frame_->state).is_oblique);
    design_.view.mode = design::ViewMode::orthographic;
    design_.view.look_down_rad = 0.5;
    const draw::MapInput map = make_map_input(context_of(*frame_, frame_->picture.camera), frame_->state);
    EXPECT_TRUE(map.is_oblique);
    EXPECT_EQ(map.look_down_rad, 0.5);
    EXPECT_TRUE(std::isnan(map.above_ground_m)) << "nobody knows it";
}

TEST_F(FrameContextTest, HeightsAreThoseOfTheDatabase) {
    terrain::FileHeader header{};
    header.min_height_m = -7;
    header.max_height_m = 4810;
    EXPECT_EQ(height_span(header).lowest_m, -7);
    EXPECT_EQ(height_span(header).highest_m, 4810);
}

}  // namespace
}  // namespace tedavis::display::test_frame_context
