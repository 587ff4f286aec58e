// The designs of the phases, one after the other on one display.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "host_sim/scene_builder/sdb_writer.hpp"
#include "render_core/display/display.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/display/hills_display.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::display::test_frame_planner_designs {
namespace {

using flight::FlightPhase;
using flight::Scenario;
using test_support::HeadlessDisplay;

constexpr std::uint32_t kWidth = 320, kHeight = 240;
constexpr FlightPhase kCruise{Scenario::cruise, 0};

design::DesignSettings own_design(const char* name) {
    design::DesignSettings design = test_support::shipped_design("default");
    design.name = name;
    design.symbology.legend = false;  // each has its own
    design.effects.fade_s = 0.2;
    return design;
}

/// Sketched, other than the first in technique, output and palette.
design::DesignSettings sketched() {
    design::DesignSettings design = own_design("sketched");
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.terrain.style.sketch = {};
    design.terrain.style.sketch.contours = 1;
    return design;
}

struct PhasedHills {
    explicit PhasedHills(const char* device = "es3-mid", double fade_s = 0.2, const design::PrioritySettings& priority = {},
                         base::ByteSource* scene = nullptr)
        : own(own_design("own")), other(sketched()) {
        own.effects.fade_s = other.effects.fade_s = fade_s;
        other.priority = priority;
        EXPECT_TRUE(phases->add({kCruise, "sketched"}, other));
        headless = std::make_unique<HeadlessDisplay>("egl", test_support::shipped_device(device), kWidth, kHeight, &bytes, own,
                                                     test_support::as_it_is, scene, phases.get());
    }
    void update(FlightPhase phase, double seconds) {
        const flight::PhaseStatus status = flight::stated_phase(phase, flight::PhaseSource::can);
        headless->display().plan({state, status, test_support::kHillsNow + base::Duration::from_seconds(seconds)});
    }
    std::vector<std::uint8_t> at(FlightPhase phase, double seconds) {
        update(phase, seconds);
        return test_support::drawn_pixels(*headless);
    }
    /// Of a design alone, all arrived.
    std::vector<std::uint8_t> alone(const design::DesignSettings& design, FlightPhase phase, double seconds,
                                    const char* device = "es3-mid") {
        headless->surface().release_current();  // one is current at a time
        std::vector<std::uint8_t> pixels;
        {
            HeadlessDisplay display("egl", device, kWidth, kHeight, &bytes, design);
            const base::Time now = test_support::kHillsNow + base::Duration::from_seconds(seconds);
            pixels = test_support::settled_pixels(display, state, now, flight::stated_phase(phase, flight::PhaseSource::can));
        }
        EXPECT_TRUE(headless->surface().make_current());
        headless->display().gl().activate();
        return pixels;
    }
    void settle(FlightPhase phase) {
        display::settle(headless->display(),
                        {state, flight::stated_phase(phase, flight::PhaseSource::can), test_support::kHillsNow});
    }

    test_support::MemoryBytes bytes{test_support::hills().image};
    design::DesignSettings own, other;
    std::unique_ptr<design::PhaseDesigns> phases = std::make_unique<design::PhaseDesigns>();
    flight::AircraftState state = test_support::aircraft_over_hills(1600);
    std::unique_ptr<HeadlessDisplay> headless;
};

int greatest_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int most = 0;
    for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, std::abs(int{a[n]} - int{b[n]}));
    return most;
}

TEST(DisplayDesigns, EachPhaseHasThePictureOfItsDesignAlone) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        PhasedHills hills(device, 0);
        hills.settle(flight::kTakeoffStart);
        const auto own = hills.at(flight::kTakeoffStart, 0.01), other = hills.at(kCruise, 0.02), again = hills.at({}, 0.03);
        EXPECT_EQ(own, hills.alone(hills.own, flight::kTakeoffStart, 0.01, device)) << device;
        EXPECT_EQ(other, hills.alone(hills.other, kCruise, 0.02, device)) << device;
        EXPECT_EQ(again, hills.alone(hills.own, {}, 0.03, device)) << device;
        EXPECT_GT(greatest_difference(own, other), 50) << "control: the designs differ on " << device;
        EXPECT_EQ(hills.headless->display().gl().denied().total, 0u);
    }
}

/// Without data the ground would be plain for nothing.
TEST(DisplayDesigns, OneThatPutsDataFirstWaitsForAScene) {
    const std::vector<std::uint8_t> bytes = host_sim::sdb_bytes(test_support::small_scene());
    test_support::MemoryBytes scene(bytes);
    design::PrioritySettings data_first, terrain_first;
    data_first.is_stated = terrain_first.is_stated = true;
    data_first.weights.of = {0.3, 1, 0.3, 1, 1, 1, 1, 1};
    terrain_first.weights.of = {1, 0.3, 0.3, 1, 1, 1, 1, 1};
    const auto changes = [](const design::PrioritySettings& priority, base::ByteSource* with) {
        PhasedHills hills("es3-mid", 0, priority, with);
        hills.settle(kCruise);
        (void)hills.at(kCruise, 0.01);
        return hills.headless->display().record().design.view() == "sketched";
    };
    EXPECT_FALSE(changes(data_first, nullptr));
    EXPECT_TRUE(changes(data_first, &scene));
    EXPECT_TRUE(changes(terrain_first, nullptr));
    EXPECT_TRUE(changes({}, nullptr)) << "without priorities none comes before terrain";
}

TEST(DisplayDesigns, ATurnBeginsWithTheFrameAsItWasAndFadesIntoTheNext) {
    PhasedHills hills;
    hills.settle(flight::kTakeoffStart);
    const auto own = hills.at(flight::kTakeoffStart, 0.02);
    const auto kept = hills.at(kCruise, 0.04);
    const FrameRecord& record = hills.headless->display().record();
    EXPECT_EQ(record.phase.phase, kCruise) << "the record says so at once";
    EXPECT_EQ(record.design.view(), "sketched");
    EXPECT_EQ(record.earlier_share, 1);
    EXPECT_TRUE(hills.headless->display().memory().must_be_drawn());
    EXPECT_EQ(kept, hills.alone(hills.own, kCruise, 0.04)) << "to a bit";
    const auto half = hills.at(kCruise, 0.14);
    EXPECT_NEAR(hills.headless->display().record().earlier_share, 0.5, 1e-9);
    EXPECT_FALSE(hills.headless->display().memory().must_be_drawn());
    const auto is = hills.at(kCruise, 0.34);
    EXPECT_EQ(hills.headless->display().record().earlier_share, 0);
    EXPECT_EQ(is, hills.alone(hills.other, kCruise, 0.34));
    std::size_t apart = 0;
    for (std::size_t n = 0; n < half.size(); ++n) apart += std::abs(half[n] - 0.5 * (kept[n] + is[n])) > 1.6 ? 1 : 0;
    EXPECT_LT(apart, half.size() / 200) << "symbology is the new design's alone";
}

TEST(DisplayDesigns, TheFrameThatIsKeptIsDrawnOnce) {
    PhasedHills hills;
    hills.settle(flight::kTakeoffStart);
    static_cast<void>(hills.at(flight::kTakeoffStart, 0.02));
    const std::uint32_t draws = hills.headless->display().gl().frame().draws;
    static_cast<void>(hills.at(kCruise, 0.04));
    EXPECT_LE(hills.headless->display().gl().frame().draws, draws + 2) << "and put there";
}

TEST(DisplayDesigns, InAWarningThePictureTurnsAtOnce) {
    PhasedHills hills;
    hills.state = test_support::aircraft_over_hills(1600, 30, 40);  // unusual
    hills.settle(flight::kTakeoffStart);
    static_cast<void>(hills.at(flight::kTakeoffStart, 0.02));
    const auto turned = hills.at(kCruise, 0.04);
    EXPECT_FALSE(hills.headless->display().memory().must_be_drawn());
    EXPECT_EQ(turned, hills.alone(hills.other, kCruise, 0.04));
}

TEST(DisplayDesigns, ATurnEndsWhereAWarningBegins) {
    PhasedHills hills;
    hills.settle(flight::kTakeoffStart);
    static_cast<void>(hills.at(flight::kTakeoffStart, 0.02));
    static_cast<void>(hills.at(kCruise, 0.04));
    hills.state = test_support::aircraft_over_hills(1600, 30, 40);
    EXPECT_EQ(hills.at(kCruise, 0.06), hills.alone(hills.other, kCruise, 0.06));
}

TEST(DisplayDesigns, NeedWhatTheyHaveInCommon) {
    const auto phases = std::make_unique<design::PhaseDesigns>();
    design::DesignSettings airy = own_design("airy");
    airy.sky.air.is_shown = true;
    ASSERT_TRUE(phases->add({kCruise, "airy"}, airy));
    test_support::MemoryBytes bytes{test_support::hills().image};
    try {
        HeadlessDisplay display("egl", test_support::shipped_device("desktop"), kWidth, kHeight, &bytes, own_design("own"),
                                test_support::as_it_is, nullptr, phases.get());
        ADD_FAILURE() << "it started";
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("'own' and 'airy' follow one another"), std::string::npos) << error.what();
    }
}

/// What a display does with antialiasing, in a word of its record; "": nobody asks for it.
std::string antialiasing_of(const Display& display) {
    for (const EffectRecord& effect : display.record().effects)
        if (effect.name.view() == "antialiasing") return effect.state == EffectState::run ? "run" : "not run";
    return "";
}

TEST(DisplayDesigns, SmoothEdgesWhereTheDeviceCanAffordIt) {
    using design::Antialiasing;
    struct Case {
        const char* device;
        Antialiasing stated;
        const char* expected;
    };
    const Case cases[] = {{"desktop", Antialiasing::by_device, "run"}, {"desktop", Antialiasing::off, ""},
                          {"es3-mid", Antialiasing::by_device, ""},    {"es3-mid", Antialiasing::on, "run"},
                          {"es2-small", Antialiasing::by_device, ""},  {"es2-small", Antialiasing::on, "not run"}};
    test_support::MemoryBytes bytes{test_support::hills().image};
    for (const Case& one : cases) {
        design::DesignSettings design = own_design("own");
        design.effects.antialiasing = one.stated;
        HeadlessDisplay headless("egl", one.device, kWidth, kHeight, &bytes, design);
        static_cast<void>(
            test_support::settled_pixels(headless, test_support::aircraft_over_hills(1600), test_support::kHillsNow));
        EXPECT_EQ(antialiasing_of(headless.display()), one.expected) << one.device;
    }
}

/// Bytes of off-screen pictures that a desktop's display of this design takes at its start.
std::uint64_t started_targets(const design::DesignSettings& design, std::uint32_t width_px, std::uint32_t height_px) {
    test_support::MemoryBytes bytes{test_support::hills().image};
    HeadlessDisplay headless("egl", test_support::shipped_device("desktop"), width_px, height_px, &bytes, design);
    return headless.display().planner().budget().find(effects::kRenderTargets)->use.in_use;
}

/// Besides the pictures of silhouettes and of the fade: in its own size with a map of shadows, and at four times as many pixels.
TEST(DisplayDesigns, TheDesktopsBudgetHoldsSmoothedEdges) {
    const effects::DeviceSettings desktop = test_support::shipped_device("desktop");
    const std::uint32_t width_px = desktop.width_px, height_px = desktop.height_px;
    design::DesignSettings design = own_design("own");
    ASSERT_EQ(design.effects.antialiasing, design::Antialiasing::by_device);
    EXPECT_LE(started_targets(design, 2 * width_px, 2 * height_px), desktop.budget.find(effects::kRenderTargets)->bytes);
    design.effects.shadows.on_ground = 0.5;
    const std::uint64_t smoothed = started_targets(design, width_px, height_px);
    design.effects.antialiasing = design::Antialiasing::off;
    const std::uint64_t picture = std::uint64_t{8} * width_px * height_px;
    EXPECT_EQ(smoothed - started_targets(design, width_px, height_px), picture) << "color and depth";
}

TEST(DisplayDesigns, OthersMayBeTakenWhereTheirProgramsAreThere) {
    PhasedHills hills("es3-mid", 0);
    hills.settle(kCruise);
    static_cast<void>(hills.at(kCruise, 0.01));
    design::DesignSettings brighter = hills.other;
    brighter.terrain.style.plain = {250, 250, 240};
    const auto phases = std::make_unique<design::PhaseDesigns>();
    ASSERT_TRUE(phases->add({kCruise, "brighter"}, brighter));
    ASSERT_TRUE(hills.headless->display().set_design(hills.own, phases.get()));
    EXPECT_EQ(hills.at(kCruise, 0.02), hills.alone(brighter, kCruise, 0.02));
    brighter.terrain.style.sketch.hatching = 1;
    const auto hatched = std::make_unique<design::PhaseDesigns>();
    ASSERT_TRUE(hatched->add({kCruise, "hatched"}, brighter));
    EXPECT_FALSE(hills.headless->display().set_design(hills.own, hatched.get()));
}

}  // namespace
}  // namespace tedavis::display::test_frame_planner_designs
