#include "render_core/draw/data/obstacle_color.hpp"

#include <gtest/gtest.h>

#include <limits>

#include <algorithm>

#include "render_core/design/warning_bands.hpp"
#include "render_core/draw/data/obstacle_solids.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_obstacle_color {
namespace {

using test_support::ElementOfTest;
using test_support::SolidRoomOfTest;

constexpr design::Color kOwn{10, 120, 130, 255};

bool is(design::Color a, design::Color b) {
    return a.red == b.red && a.green == b.green && a.blue == b.blue && a.alpha == b.alpha;
}

/// Of three masts the first is met after 20 s, the second after 40 s.
policy::ObstacleAlerts alerts_of_masts() {
    policy::ObstacleAlerts alerts;
    alerts.add(3, 0, 20, std::numeric_limits<double>::infinity());
    alerts.add(3, 1, 40, std::numeric_limits<double>::infinity());
    return alerts;
}

ElementInput input_with(ElementOfTest& test, const policy::ObstacleAlerts* alerts, std::uint16_t layer_number) {
    ElementInput input = test.input();
    return {input.element, input.group,           input.layer,   input.ground, input.missing,  input.time_ns, input.has_date,
            input.eye,     input.metres_per_px_m, input.has_age, input.foci,   input.own_ship, alerts,        layer_number};
}

TEST(ObstacleColor, IsThatOfTheAlertOnlyForWhatIsInTheWay) {
    ElementOfTest test(test_support::small_points());
    const policy::ObstacleAlerts alerts = alerts_of_masts();
    const ElementInput input = input_with(test, &alerts, 3), other = input_with(test, &alerts, 2), calm = test.input();
    EXPECT_TRUE(is(obstacle_color(input, 0, kOwn), design::kWarningGround));
    EXPECT_TRUE(is(obstacle_color(input, 1, kOwn), design::kCautionGround));
    EXPECT_TRUE(is(obstacle_color(input, 2, kOwn), kOwn)) << "another mast";
    EXPECT_TRUE(is(obstacle_color(other, 0, kOwn), kOwn)) << "another layer";
    EXPECT_TRUE(is(obstacle_color(calm, 0, kOwn), kOwn)) << "no alert";
}

std::size_t vertices_of(const SolidBatch& batch, design::Color color) {
    return static_cast<std::size_t>(std::count_if(batch.vertices().begin(), batch.vertices().end(), [&](const SolidVertex& one) {
        return one.rgba[0] == color.red && one.rgba[1] == color.green && one.rgba[2] == color.blue;
    }));
}

TEST(ObstacleColor, SolidsHaveItBetweenTheirWhiteBands) {
    ElementOfTest test(test_support::small_points());
    const policy::ObstacleAlerts alerts = alerts_of_masts();
    SolidRoomOfTest alerted, calm;
    static_cast<void>(add_obstacle_points(alerted.batch, alerted.mesh, input_with(test, &alerts, 3)));
    static_cast<void>(add_obstacle_points(calm.batch, calm.mesh, test.input()));
    EXPECT_GT(vertices_of(alerted.batch, design::kWarningGround), 0u);
    EXPECT_GT(vertices_of(alerted.batch, design::kCautionGround), 0u);
    EXPECT_EQ(vertices_of(calm.batch, design::kWarningGround) + vertices_of(calm.batch, design::kCautionGround), 0u) << "control";
}

}  // namespace
}  // namespace tedavis::draw::test_obstacle_color
