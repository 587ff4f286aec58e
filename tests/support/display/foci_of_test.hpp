/// Foci of tests: stated in one line, found in a scene.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

#include "render_core/display/planner/foci_plan.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::test_support {

inline design::FocusSettings focus_of(const std::string& line) {
    const auto focus = design::read_focus(line);
    EXPECT_TRUE(focus.ok()) << line << ": " << focus.error().message.view();
    return focus.ok() ? focus.value() : design::FocusSettings{};
}

/// The own ship over 46.8 N 9.8 E, 3000 m over the ellipsoid, on its way east at 50 m/s.
inline flight::OwnShipEstimate own_ship_of_test() {
    flight::OwnShipEstimate own;
    own.position = {base::radians(46.8), base::radians(9.8), {3000}};
    own.velocity_east_mps = 50;
    own.state = base::SignalState::valid;
    return own;
}

class FociOfTest {
public:
    explicit FociOfTest(std::initializer_list<std::string> lines, const scene::Scene* scene = nullptr,
                        const flight::FlightTime& time = {})
        : own_ship(own_ship_of_test()) {
        for (const std::string& line : lines) EXPECT_TRUE(foci.try_push_back(focus_of(line)));
        plan_again(scene, time);
    }
    FociOfTest(const FociOfTest&) = delete;
    FociOfTest& operator=(const FociOfTest&) = delete;
    void plan_again(const scene::Scene* scene = nullptr, const flight::FlightTime& time = {}) {
        plan = display::plan_foci(foci, {own_ship, own_ship.position.height.m, scene, time, ground, hazard});
    }
    [[nodiscard]] const draw::FrameFoci& frame() const { return plan.foci; }
    [[nodiscard]] const scene::FocusRegion& region(std::size_t n = 0) const { return plan.foci.regions[n]; }

    design::FocusList foci;
    flight::OwnShipEstimate own_ship;
    LevelGround ground;
    const earth::Geodetic* hazard = nullptr;
    display::FociPlan plan;
};

}  // namespace tedavis::test_support
