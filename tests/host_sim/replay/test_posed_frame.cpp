#include "host_sim/replay/posed_frame.hpp"

#include <gtest/gtest.h>

#include "render_core/base/hash.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_posed_frame {
namespace {

TEST(PosedFrame, IsSettledAndHashed) {
    const test_support::FlownFiles files;
    const PictureOptions options = files.options("unused").picture;
    const AircraftPose pose{47.03, 9.68, 2500, 40, -6, 12};
    const flight::PhaseStatus cruise =
        flight::stated_phase(flight::phase_from_name("cruise").phase, flight::PhaseSource::switches);
    std::uint64_t hash = 0;
    {
        DisplaySession session(options, false);
        const FrameResult result = posed_frame(session, pose, cruise);
        EXPECT_EQ(result.record.terrain.pending, 0u) << "all that it asks for is there";
        EXPECT_GT(result.record.terrain.triangles, 100u);
        EXPECT_EQ(result.record.phase.phase.code(), cruise.phase.code());
        EXPECT_EQ(result.record.time.ns, kPosedTime.ns);
        const RgbaPicture picture = upright(session.pixels());
        EXPECT_EQ(result.hash, base::frame_hash(picture.pixels.data(), picture.width, picture.height, false));
        EXPECT_GE(result.timing.total_ms, result.timing.plan_ms);
        hash = result.hash;
    }
    DisplaySession again(options, false);
    EXPECT_EQ(posed_frame(again, pose, cruise).hash, hash);
    AircraftPose turned = pose;
    turned.heading_deg += 5;
    EXPECT_NE(posed_frame(again, turned, cruise).hash, hash);
}

}  // namespace
}  // namespace tedavis::host_sim::test_posed_frame
