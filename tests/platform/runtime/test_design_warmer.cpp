#include "platform/runtime/design_warmer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "platform/runtime/display_host.hpp"
#include "render_core/base/units.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/gl/readback.hpp"
#include "tests/support/files/compiled_memory.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::platform::test_design_warmer {
namespace {

using flight::Scenario;

constexpr int kFrames = 40;
constexpr base::Time kNow{1'700'000'000'000'000'000};

/// Three phases have a design of their own; that of cruise waits for a scene.
struct Designs {
    Designs() {
        for (const auto& [scenario, name] : {std::pair{Scenario::takeoff, "takeoff"}, std::pair{Scenario::approach, "approach"},
                                             std::pair{Scenario::cruise, "cruise"}})
            EXPECT_TRUE(phases.add({{scenario, 0}, design::DesignFileName(name)}, test_support::shipped_design(name)));
    }
    design::DesignSettings first = test_support::shipped_design("default");
    design::PhaseDesigns phases;
};

/// Over the terrain of the self-test.
class WarmedDisplay {
public:
    explicit WarmedDisplay(const Designs& designs) {
        const std::string terrain = test_support::source_dir() + "/target/self_test_data/terrain.tdb";
        DisplayHostSettings settings;
        settings.display.device = test_support::shipped_device("es3-mid");
        settings.display.design = designs.first;
        settings.display.phases = &designs.phases;
        settings.display.width_px = 200;
        settings.display.height_px = 150;
        settings.terrain.path = terrain.c_str();
        EXPECT_FALSE(host_.start(settings));
        const terrain::FileHeader& h = display().planner().terrain_database()->header();
        place_ = {base::radians(h.north_deg - 0.5 * (h.rows - 1) * h.step_lat_deg),
                  base::radians(h.west_deg + 0.5 * (h.columns - 1) * h.step_lon_deg),
                  {static_cast<double>(h.max_height_m) + 300}};
    }
    [[nodiscard]] display::Display& display() { return host_.display(); }
    [[nodiscard]] bool warm(DesignWarmer& warmer, int frame) {
        return warmer.draw_next(display(), host_.surface(), input_of(frame));
    }
    /// Terrain arrives by the number of frames, of which warming adds some: now all of it is there before the first one.
    void settle() {
        const display::PlannerMemory begun = display().memory();
        for (const int frame : {0, kFrames - 1}) {
            display().memory().cut();
            display::settle(display(), input_of(frame));
        }
        display().memory() = begun;
    }
    [[nodiscard]] std::vector<std::uint8_t> pixels() {
        std::vector<std::uint8_t> rgba(std::size_t{4} * host_.surface().width() * host_.surface().height());
        EXPECT_TRUE(
            gl::read_pixels(display().gl(), host_.surface().width(), host_.surface().height(), {rgba.data(), rgba.size()}));
        return rgba;
    }
    std::vector<std::uint8_t> frame(int number) {
        display().plan(input_of(number));
        display().draw(host_.surface());
        return pixels();
    }

private:
    /// Cruise, then from its middle on approach.
    [[nodiscard]] flight::FrameInput input_of(int frame) const {
        using flight::Signal;
        flight::FrameInput input;
        input.time = kNow + base::Duration::milliseconds(33 * frame);
        const double heading_rad = base::radians(30 + 0.1 * frame);
        for (const auto& [signal, value] :
             {std::pair{Signal::latitude, place_.latitude_rad}, std::pair{Signal::longitude, place_.longitude_rad},
              std::pair{Signal::ellipsoid_height, place_.height.m}, std::pair{Signal::true_heading, heading_rad},
              std::pair{Signal::pitch, 0.05}, std::pair{Signal::roll, 0.0}, std::pair{Signal::baro_altitude, place_.height.m},
              std::pair{Signal::indicated_airspeed, 60.0}})
            input.state[signal] = {value, input.time};
        input.state.own_ship.position = place_;
        input.state.own_ship.height_is_geometric = true;
        input.state.own_ship.at = input.time;
        input.state.own_ship.state = base::SignalState::valid;
        input.phase.phase.scenario = frame < kFrames / 2 ? Scenario::cruise : Scenario::approach;
        input.phase.presented = input.phase.phase;
        input.phase.source = flight::PhaseSource::can;
        return input;
    }

    DisplayHost host_;
    earth::Geodetic place_;
};

TEST(DesignWarmer, DrawsEachDesignThatAPhaseShowsOnce) {
    const Designs designs;
    WarmedDisplay warmed(designs);
    DesignWarmer warmer;
    EXPECT_FALSE(warmer.is_done()) << "it has not begun";
    warmer.begin(warmed.display().planner());
    (void)warmed.frame(0);
    std::vector<std::string> drawn;
    while (warmed.warm(warmer, 0)) {
        drawn.emplace_back(warmed.display().record().design.view());
        EXPECT_EQ(warmer.is_done(), drawn.size() == 4);
    }
    ASSERT_EQ(drawn.size(), 4u) << "without a scene cruise shows the first design; the last one is the fade";
    EXPECT_EQ(std::set<std::string>(drawn.begin(), drawn.begin() + 3).size(), 3u);
    for (const std::string& name : drawn) EXPECT_NE(name, designs.phases.at(3).name.view());
    warmer.begin(warmed.display().planner());
    EXPECT_FALSE(warmer.is_done()) << "it draws them again where it is asked to";
}

TEST(DesignWarmer, LeavesTheFramesThatAreShownAsTheyWouldBe) {
    const Designs designs;
    std::vector<std::vector<std::uint8_t>> cold;
    {
        WarmedDisplay display(designs);
        display.settle();
        for (int frame = 0; frame < kFrames; ++frame) cold.push_back(display.frame(frame));
    }
    WarmedDisplay display(designs);
    display.settle();
    DesignWarmer warmer;
    warmer.begin(display.display().planner());
    int warmed = 0;
    for (int frame = 0; frame < kFrames; ++frame) {
        EXPECT_EQ(display.frame(frame), cold[static_cast<std::size_t>(frame)]) << frame;
        if (frame % 3 != 2 || !display.warm(warmer, frame)) continue;
        const bool is_another = warmed > 0 && warmed < 3;
        EXPECT_EQ(display.pixels() != cold[static_cast<std::size_t>(frame)], is_another) << "control: it was drawn";
        ++warmed;
    }
    EXPECT_EQ(warmed, 4);
    EXPECT_NE(cold.front(), cold.back()) << "control: the phases differ";
}

/// What the driver compiles for the first frame of another phase.
std::uint64_t compiled_by_the_change(bool is_warm) {
    const Designs designs;
    WarmedDisplay display(designs);
    for (int frame = 0; frame < 3; ++frame) (void)display.frame(frame);
    DesignWarmer warmer;
    warmer.begin(display.display().planner());
    while (is_warm && display.warm(warmer, 2)) {
    }
    (void)display.frame(3);
    const std::uint64_t before = test_support::compiled_bytes();
    for (int frame = kFrames / 2; frame < kFrames; ++frame) (void)display.frame(frame);
    return test_support::compiled_bytes() - before;
}

TEST(DesignWarmer, NothingIsCompiledForTheChangeOfAPhase) {
    EXPECT_GT(compiled_by_the_change(false), 0u) << "control: a cold design";
    EXPECT_EQ(compiled_by_the_change(true), 0u);
}

}  // namespace
}  // namespace tedavis::platform::test_design_warmer
