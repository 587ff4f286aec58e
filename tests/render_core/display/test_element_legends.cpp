#include "render_core/display/element_legends.hpp"

#include <gtest/gtest.h>

#include "tests/support/grey_palettes.hpp"
#include "tests/support/loaded_scene.hpp"

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
        add_element_legends(all, design_, {}, legends);
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
    EXPECT_EQ(shown[0].unit.view(), "K");
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
    EXPECT_EQ(shown[0].uncertainty[1].text.view(),
              "\xC2\xB1"
              "4 K");
    EXPECT_EQ(shown[0].uncertainty[1].color, (design::Color{1, 2, 3}));
    EXPECT_EQ(shown[0].uncertainty[2].color, shown[0].uncertainty[1].color) << "never as sure";
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
