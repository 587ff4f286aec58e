#include "render_core/display/planner/symbology_plan.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/display/hills_display.hpp"

namespace tedavis::display::test_symbology_plan {
namespace {

constexpr std::uint32_t kWidth = 640, kHeight = 480;

struct Planned {
    explicit Planned(const design::DesignSettings& design) : design_(design) {
        decisions = policy::decide_display(state, test_support::kHillsNow, conditions, design_);
        record.time = test_support::kHillsNow;
    }
    /// False where a legend has no room.
    bool plan() {
        DrawContext frame{design_, decisions, camera, record, 2000, 2000};
        frame.heights = heights;
        plan_symbology({frame, state, aircraft, palette, kWidth, kHeight, over, data, data_plan, reports, legend}, batch, record);
        return record.flags.empty();
    }
    design::DesignSettings design_;
    flight::AircraftState state = test_support::aircraft_over_hills(2000);
    design::AircraftSettings aircraft;
    design::SymbologyPalette palette = design::kDaySymbology;
    policy::DisplayConditions conditions;
    policy::DisplayDecisions decisions;
    Camera camera;
    FrameRecord record;
    draw::HeightSpan heights{100, 2000};
    draw::SymbolGround over = draw::SymbolGround::perspective;
    SpatialData data;
    SpatialDataPlan data_plan;
    ElementReports reports;
    flight::LegendShow legend = flight::LegendShow::key;
    std::vector<draw::QuadVertex> vertices = std::vector<draw::QuadVertex>(draw::kSymbologyVertices);
    std::vector<std::uint16_t> indices = std::vector<std::uint16_t>(draw::kSymbologyIndices);
    draw::QuadBatch batch{{vertices.data(), vertices.size()}, {indices.data(), indices.size()}};
};

TEST(SymbologyPlan, FillsTheBatchWithTheSymbologyAnew) {
    Planned planned(test_support::shipped_design("default"));
    EXPECT_TRUE(planned.plan());
    const std::size_t first = planned.batch.vertices().size();
    EXPECT_GT(first, 500u);
    EXPECT_TRUE(planned.plan());
    EXPECT_EQ(planned.batch.vertices().size(), first);
    planned.over = draw::SymbolGround::moving;
    EXPECT_TRUE(planned.plan());
    EXPECT_LT(planned.batch.vertices().size(), first) << "on the way to the map no conformal symbol is true";
}

TEST(SymbologyPlan, SymbolsHaveTheColorsOfThePaletteThatIsGiven) {
    Planned planned(test_support::shipped_design("default"));
    const auto has = [&planned](design::Color color) {
        for (const draw::QuadVertex& vertex : planned.batch.vertices())
            if (vertex.rgba[0] == color.red && vertex.rgba[1] == color.green && vertex.rgba[2] == color.blue) return true;
        return false;
    };
    const auto& palettes = design::standard_symbology_palettes();
    for (const design::SymbologyLight light : {design::SymbologyLight::day, design::SymbologyLight::night}) {
        planned.palette = palettes.of(light);
        EXPECT_TRUE(planned.plan());
        const bool is_day = light == design::SymbologyLight::day;
        EXPECT_EQ(has(palettes.of(design::SymbologyLight::day).color(design::SymbolRole::reference)), is_day);
        EXPECT_EQ(has(palettes.of(design::SymbologyLight::night).color(design::SymbolRole::reference)), !is_day);
    }
}

TEST(SymbologyPlan, TextFollowsTheScreen) {
    Planned planned(test_support::shipped_design("default"));
    const DrawContext frame{planned.design_, planned.decisions, planned.camera, planned.record};
    EXPECT_EQ(text_px(frame, kWidth, kHeight),
              static_cast<double>(draw::make_layout(kWidth, kHeight, planned.design_.view.dpi).text_px));
    EXPECT_GT(text_px(frame, 2 * kWidth, 2 * kHeight), text_px(frame, kWidth, kHeight));
}

}  // namespace
}  // namespace tedavis::display::test_symbology_plan
