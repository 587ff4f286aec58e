#include "host_sim/scenario/example_approach.hpp"

#include <gtest/gtest.h>

#include "render_core/policy/failure_policy.hpp"
#include "tests/support/flights/default_flight.hpp"

namespace tedavis::host_sim::test_example_approach {
namespace {

using policy::Element;
using policy::ElementShow;

TEST(ExampleApproach, ShowsEveryElement) {
    const test_support::DefaultTerrain terrain;
    test_support::MemoryBytes bytes(terrain.image);
    test_support::HeadlessDisplay headless("egl", "es3-mid", 320, 240, &bytes);
    flight::FrameInput frame = example_approach(headless.display());
    policy::DisplayConditions conditions;
    conditions.terrain = policy::TerrainSource::ready;
    conditions.phase = frame.phase;
    const auto decide = [&] {
        return policy::decide_display(frame.state, frame.time, conditions, design::default_design_settings());
    };
    const policy::DisplayDecisions decisions = decide();
    for (std::size_t n = 0; n < policy::kElementCount; ++n) EXPECT_EQ(decisions.elements[n].show, ElementShow::normal) << n;
    EXPECT_FALSE(decisions.unusual_attitude);
    frame.state[flight::Signal::selected_heading] = {};
    EXPECT_NE(decide()[Element::selected_heading].show, ElementShow::normal) << "control";
}

}  // namespace
}  // namespace tedavis::host_sim::test_example_approach
