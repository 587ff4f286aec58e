#include "render_core/display/planner/element_legends.hpp"

#include <gtest/gtest.h>

#include "tests/support/display/grey_palettes.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::display::test_element_legends {
namespace {

class ElementLegends : public ::testing::Test {
protected:
    ElementLegends() : scene_(test_support::small_scene()) {
        element_.by_color.attribute = "temperature";
        element_.by_color.scale.palette = test_support::grey_palette();
        element_.technique = design::DataTechnique::spheres;
    }
    ElementReport report(std::size_t layer = 0, ElementState state = ElementState::shown) const {
        ElementReport report;
        report.state = state;
        report.element = &element_;
        report.layer = &scene_.scene().layers()[layer];
        report.count.drawn = 3;
        report.slot = 0;
        return report;
    }
    [[nodiscard]] draw::DataLegends legends(std::initializer_list<ElementReport> reports) const {
        ElementReports all;
        for (const ElementReport& one : reports) EXPECT_TRUE(all.try_push_back(one));
        draw::DataLegends legends;
        add_element_legends(all, {}, design_, {}, legends);
        return legends;
    }

    test_support::LoadedScene scene_;
    design::DataElement element_;
    design::DesignSettings design_;
};

TEST_F(ElementLegends, AScaleIsExplainedOnce) {
    const draw::DataLegends shown = legends({report(), report()});
    ASSERT_EQ(shown.size(), 1u);
    EXPECT_EQ(shown[0].title.view(), "AIR TEMPERATURE");
    EXPECT_EQ(shown[0].unit.view(), "°C");
    EXPECT_EQ(shown[0].offset, -273.15);
    EXPECT_EQ(shown[0].scale.palette.name.view(), "grey");
    EXPECT_TRUE(shown[0].uncertainty.empty()) << "it is not shown";
}

TEST_F(ElementLegends, WhatIsNotThereHasNone) {
    EXPECT_TRUE(legends({report(0, ElementState::out_of_date)}).empty());
    EXPECT_TRUE(legends({report(1)}).empty()) << "masts have no temperature";
    ElementReport hidden = report();
    hidden.count = {0, 0, 12};
    EXPECT_TRUE(legends({hidden}).empty());
    element_.technique = design::DataTechnique::billboard;
    EXPECT_EQ(legends({hidden}).size(), 1u) << "signs find their room after the legends";
    element_.by_color.attribute = "";
    EXPECT_TRUE(legends({report()}).empty()) << "a plain colour";
}

TEST_F(ElementLegends, FadingSaysHowTheLeastSureLooks) {
    element_.uncertainty = design::ElementUncertainty::transparency;
    element_.uncertainty_strength = 1;
    design_.terrain.style.plain = {1, 2, 3};
    const draw::DataLegends shown = legends({report()});
    ASSERT_EQ(shown[0].uncertainty.size(), 3u);
    EXPECT_EQ(shown[0].uncertainty[1].text.view(), "±4 °C");
    EXPECT_EQ(shown[0].uncertainty[1].color, (design::Color{1, 2, 3}));
    EXPECT_EQ(shown[0].uncertainty[2].color, draw::GlyphStyle().unknown) << "neither sure nor unsure";
    ElementReport surface = report();
    surface.slot = GlyphElements::kSlots;
    element_.technique = design::DataTechnique::prism;
    const draw::LegendSample cut = legends({surface})[0].uncertainty[2];
    EXPECT_EQ(cut.look, draw::SampleLook::cut_stripes);
    EXPECT_EQ(cut.under, (design::Color{1, 2, 3})) << "of the ground behind it";
    element_.technique = design::DataTechnique::billboard;
    EXPECT_EQ(legends({surface})[0].uncertainty[2].look, draw::SampleLook::question);
}

TEST_F(ElementLegends, NothingIsSureWhereTheDataStateNoUncertainty) {
    element_.uncertainty = design::ElementUncertainty::transparency;
    host_sim::LayerDraft unstated = test_support::small_grid(), unknown = unstated;
    unstated.attributes[0].uncertainty_kind = scene::UncertaintyKind::none;
    unstated.attributes[0].uncertainties.clear();
    unknown.attributes[0].uncertainties.clear();
    unknown.attributes[0].uncertainty_all = scene::Uncertainty();
    for (const host_sim::LayerDraft& layer : {unstated, unknown}) {
        const test_support::LoadedScene scene({"one", "a test", 1, {layer}});
        ElementReport one = report();
        one.layer = &scene.scene().layers()[0];
        const draw::DataLegends shown = legends({one});
        ASSERT_EQ(shown[0].uncertainty.size(), 1u);
        EXPECT_EQ(shown[0].uncertainty[0].text.view(), draw::kUnknownText);
    }
    EXPECT_EQ(legends({report()})[0].uncertainty[0].text.view(), "CERTAIN") << "control";
}

TEST(ElementLegendsOf, ValuesThatWereMadeOfAnotherLayersHaveItsTimeAndSource) {
    constexpr std::int64_t kHour_ns = 3'600'000'000'000, kNow_ns = 472'000 * kHour_ns;
    host_sim::SceneDraft draft = test_support::small_scene();
    host_sim::LayerDraft& flight = draft.layers[1];
    flight.source = "flight.igc";
    flight.data_time_ns = kNow_ns;
    host_sim::LayerDraft& wind = draft.layers[2];
    wind.source = "wind.nc";
    wind.data_time_ns = kNow_ns - 2 * kHour_ns;
    host_sim::AttributeDraft made;
    made.name = "head_wind";
    made.unit = "m/s";
    made.of = scene::AttributeOf::feature;
    made.values.assign(flight.points.size(), 1);
    flight.attributes.push_back(made);
    design::DataElement element;
    element.technique = design::DataTechnique::tube;
    element.by_color.attribute = "head_wind";
    element.by_color.scale.palette = test_support::grey_palette();
    const auto said = [&](const char* derived_from, std::optional<std::int64_t> time_ns) {
        flight.attributes.back().derived_from = derived_from;
        flight.attributes.back().derived_time_ns = time_ns;
        const test_support::LoadedScene loaded(draft);
        ElementReport report;
        report.state = ElementState::shown;
        report.element = &element;
        report.layer = &loaded.scene().layers()[1];
        report.count.drawn = 1;
        ElementReports reports;
        EXPECT_TRUE(reports.try_push_back(report));
        draw::DataLegends legends;
        add_element_legends(reports, loaded.scene().layers(), {}, {base::Time{kNow_ns}, true, true}, legends);
        return std::string(legends[0].source.view()) + " " + std::string(draw::time_and_age(legends[0]).view());
    };
    EXPECT_EQ(said("", {}), "FLIGHT.IGC 16:00Z 0 MIN") << "its own";
    EXPECT_EQ(said(wind.name.c_str(), {}), "WIND.NC 14:00Z STALE 2 H");
    EXPECT_EQ(said(wind.name.c_str(), kNow_ns - kHour_ns / 3), "WIND.NC 15:40Z 20 MIN") << "of a stated time";
}

TEST_F(ElementLegends, GlyphsOfUncertaintyHaveTheScaleOfTheirLevels) {
    element_.uncertainty = design::ElementUncertainty::tetrahedra;
    const draw::DataLegends shown = legends({report()});
    ASSERT_EQ(shown.size(), 2u);
    EXPECT_EQ(shown[1].title.view(), "AIR TEMPERATURE \xC2\xB1");
    EXPECT_EQ(shown[1].factor, 4) << "a level of 1 in the attribute's unit";
    element_.technique = design::DataTechnique::uncertainty_only;
    EXPECT_EQ(legends({report()}).size(), 1u);
}

TEST_F(ElementLegends, BothSidesOfATubeAreExplained) {
    element_.technique = design::DataTechnique::tube;
    element_.by_second_color = element_.by_color;
    element_.by_second_color.scale.palette.name = "other";
    EXPECT_EQ(legends({report()}).size(), 2u);
}

}  // namespace
}  // namespace tedavis::display::test_element_legends
