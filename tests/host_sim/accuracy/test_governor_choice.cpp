#include "host_sim/accuracy/governor_choice.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "host_sim/replay/display_session.hpp"
#include "render_core/display/calibration_subject.hpp"
#include "tests/host_sim/accuracy/knob_errors.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/even_costs.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_governor_choice {
namespace {

/// Every frame costs 9 ms for each effect that runs but ridges; a further level gives up silhouettes, for which ridges may stand.
std::string costs_with_two_levels(const PictureOptions& options) {
    DisplaySession session(options, true);
    std::string costs = test_support::even_costs(display::calibration_subject(session.display()));
    const std::string ridges = "[cost.ridges]\nfixed_ms = 9";
    costs.replace(costs.find(ridges), ridges.size(), "[cost.ridges]\nfixed_ms = 0");
    return costs +
           "[[quality]]\ntau_factor = 2\ndetail_factor = 0.5\ngiven_up = ['silhouettes']\nms = 5\nerror_px = 2\nerror_color = "
           "1\n";
}

TEST(GovernorChoice, CountsTheFramesOfEachLevel) {
    const test_support::ShippedKnobGround shipped;
    const KnobFlight flight(shipped.quick().ground);
    const test_support::TemporaryFolder folder;
    PictureOptions picture;
    picture.terrain = shipped.quick().ground.path();
    picture.size = PictureSize{96, 64};
    const std::string costs = folder.write("costs.toml", costs_with_two_levels(picture));
    GovernorChoicePlan plan;
    plan.rate_hz = 0.2;
    const auto frames_at = [&](double deadline_ms) {
        plan.deadline_ms = deadline_ms;
        return governor_choice(costs, picture, flight, plan);
    };
    const auto total = static_cast<std::uint64_t>(flight.duration_s() * plan.rate_hz);
    const GovernorChoice ample = frames_at(1e6), scarce = frames_at(1);
    EXPECT_EQ(ample.levels.count, 2u);
    EXPECT_EQ(ample.frames[0], total) << "a deadline with room has the design's picture all along";
    EXPECT_EQ(ample.missed, 0u);
    EXPECT_EQ(std::accumulate(scarce.frames.begin(), scarce.frames.end(), std::uint64_t{0}), total);
    EXPECT_GT(scarce.frames[1], 0u);
    EXPECT_EQ(scarce.missed, total) << "even the cheaper one is too dear";
}

TEST(GovernorChoice, CostsOfAnotherRendererAreRefused) {
    const test_support::ShippedKnobGround shipped;
    const KnobFlight flight(shipped.quick().ground);
    const test_support::TemporaryFolder folder;
    PictureOptions picture;
    picture.size = PictureSize{96, 64};
    const auto choose = [&](const std::string& text) {
        static_cast<void>(governor_choice(folder.write("c.toml", text), picture, flight, {}));
    };
    test_support::expect_user_error([&] { choose("device = 'x'\n"); }, "c.toml");
    test_support::expect_user_error(
        [&] {
            choose(test_support::even_costs({"es3-mid", "another", 96, 64}));
        },
        "'another', not for");
}

}  // namespace
}  // namespace tedavis::host_sim::test_governor_choice
