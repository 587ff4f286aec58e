#include "render_core/draw/symbology/bank_scale.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_bank_scale {
namespace {

using policy::Element;
using policy::ElementShow;
using test_support::BatchStore;
using test_support::scene_input;
using test_support::scene_state;
using test_support::text_of;

struct Screen {
    std::uint32_t width, height;
};
constexpr Screen kScreens[] = {{640, 480}, {1280, 720}, {480, 640}};

bool has_color(const QuadVertex& v, design::Color color) {
    return v.rgba[0] == color.red && v.rgba[1] == color.green && v.rgba[2] == color.blue;
}

/// Middle of the slip indicator: what is drawn in the pointer's color and lies deeper than its base.
double slip_x(const SymbologyInput& input, const Screen& screen) {
    const Layout layout = make_layout(screen.width, screen.height, 96);
    BatchStore store;
    build_bank_scale(Painter(store.batch, layout), input);
    const double base = static_cast<double>(bank_scale_radius(layout) - 1.15f * layout.text_px);
    double left = 1e9, right = -1e9;
    for (const QuadVertex& v : store.batch.vertices()) {
        const Point c = layout.screen.center();
        if (!has_color(v, test_support::day_color(SymbolRole::reference)) || static_cast<double>(c.y - v.y) > base) continue;
        left = std::min(left, static_cast<double>(v.x)), right = std::max(right, static_cast<double>(v.x));
    }
    return right < left ? NAN : (left + right) / 2;
}

SymbologyInput slipping(const Screen& screen, double acceleration_mps2) {
    SymbologyInput input = scene_input(scene_state(10, 0, 0), screen.width, screen.height);
    input.decisions[Element::slip].show = ElementShow::normal;
    input.guidance.slip_mps2 = acceleration_mps2;
    return input;
}

TEST(BankScale, P10TheSlipIndicatorMovesAwayFromTheAcceleration) {
    for (const Screen& screen : kScreens) {
        const double middle = screen.width / 2.0, t = static_cast<double>(make_layout(screen.width, screen.height, 96).text_px);
        EXPECT_NEAR(slip_x(slipping(screen, 0), screen), middle, 0.5) << "coordinated";
        EXPECT_NEAR(slip_x(slipping(screen, -kSlipWidth_mps2), screen), middle + 1.3 * t, 1.0) << "slipping to the right";
        EXPECT_LT(slip_x(slipping(screen, kSlipWidth_mps2), screen), middle - t) << "the control: the other side";
        EXPECT_EQ(slip_x(slipping(screen, 5), screen), slip_x(slipping(screen, 50), screen)) << "it stays on the picture";
        SymbologyInput absent = slipping(screen, 0);
        absent.decisions[Element::slip].show = ElementShow::absent;
        EXPECT_TRUE(std::isnan(slip_x(absent, screen)));
    }
}

TEST(BankScale, P10LostSlipIsSaidInItsPlace) {
    const Layout layout = make_layout(640, 480, 96);
    for (const ElementShow show : {ElementShow::flagged, ElementShow::failed}) {
        SymbologyInput input = slipping(kScreens[0], 0);
        input.decisions[Element::slip].show = show;
        BatchStore store;
        build_bank_scale(Painter(store.batch, layout), input);
        EXPECT_NE(text_of(store.batch).find(show == ElementShow::failed ? "SLIP" : "STALE"), std::string::npos);
        EXPECT_TRUE(std::isnan(slip_x(input, kScreens[0])));
    }
}

TEST(BankScale, P09ExcessiveBankIsAmberAndSaid) {
    for (const Screen& screen : kScreens) {
        const Layout layout = make_layout(screen.width, screen.height, 96);
        for (const double roll : {-50.0, -40.0, 40.0, 50.0}) {
            BatchStore store;
            build_bank_scale(Painter(store.batch, layout), scene_input(scene_state(10, 0, roll), screen.width, screen.height));
            const auto vertices = store.batch.vertices();
            const bool is_amber = std::any_of(vertices.begin(), vertices.end(), [](const QuadVertex& v) {
                return has_color(v, test_support::day_color(SymbolRole::caution));
            });
            EXPECT_EQ(is_amber, std::abs(roll) > 45) << roll;
            EXPECT_EQ(text_of(store.batch).find("BANK") != std::string::npos, std::abs(roll) > 45) << roll;
        }
    }
}

TEST(BankScale, P08TicksStandAtTheUsualAngles) {
    const Layout layout = make_layout(640, 480, 96);
    SymbologyInput input = slipping(kScreens[0], 0);
    BatchStore store;
    build_bank_scale(Painter(store.batch, layout), input);
    const Point c = layout.screen.center();
    const double radius = static_cast<double>(bank_scale_radius(layout)), t = static_cast<double>(layout.text_px);
    for (const int degrees : {10, 20, 30, 45, 60})
        for (const int side : {-1, 1}) {
            const double angle = base::radians(side * degrees), out = radius + (degrees % 30 == 0 ? 0.8 : 0.45) * t;
            const double x = static_cast<double>(c.x) + out * std::sin(angle),
                         y = static_cast<double>(c.y) - out * std::cos(angle);
            const auto vertices = store.batch.vertices();
            EXPECT_TRUE(std::any_of(vertices.begin(), vertices.end(), [&](const QuadVertex& v) {
                return has_color(v, test_support::day_color(SymbolRole::scale)) &&
                       std::hypot(static_cast<double>(v.x) - x, static_cast<double>(v.y) - y) < 3;
            })) << side * degrees;
        }
}

}  // namespace
}  // namespace tedavis::draw::test_bank_scale
