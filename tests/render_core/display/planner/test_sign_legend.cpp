#include "render_core/display/planner/sign_legend.hpp"

#include <gtest/gtest.h>

#include <string>

#include "render_core/display/planner/element_legends.hpp"
#include "tests/support/display/grey_palettes.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::display::test_sign_legend {
namespace {

using design::DataTechnique;
using design::ElementUncertainty;
using scene::LayerRole;

host_sim::LayerDraft layer_of(LayerRole role, scene::LayerShape shape, float accuracy_m = 0) {
    host_sim::LayerDraft layer;
    layer.name = "one";
    layer.role = role;
    layer.shape = shape;
    layer.position_accuracy_m = accuracy_m;
    for (int n = 0; n < 3; ++n) layer.points.push_back({0.8 + 0.001 * n, 0.17 + 0.001 * (n % 2), 100, 0, scene::kNoTime});
    if (shape != scene::LayerShape::points) layer.starts = {0, 3};
    return layer;
}

/// What the entry says of one element over one layer, a row after a ";".
std::string said(const host_sim::LayerDraft& layer, const design::DataElement& element, ElementState state = ElementState::shown,
                 const design::DesignSettings& design = {}) {
    const test_support::LoadedScene loaded(layer);
    ElementReport report;
    report.state = state;
    report.element = &element;
    report.layer = &loaded.layer();
    report.count.drawn = 1;
    report.cues[0].drawn = element.cues.line_spacing_m > 0 ? 1 : 0;
    ElementReports reports;
    EXPECT_TRUE(reports.try_push_back(report));
    draw::DataLegends legends;
    add_sign_legend(reports, design, legends);
    std::string text;
    if (legends.empty()) return text;
    EXPECT_FALSE(legends[0].has_scale);
    for (const draw::LegendSample& sample : legends[0].signs) text += std::string(sample.text.view()) + ";";
    return text;
}

design::DataElement element_of(DataTechnique technique, ElementUncertainty uncertainty = ElementUncertainty::none) {
    design::DataElement element;
    element.technique = technique;
    element.uncertainty = uncertainty;
    return element;
}

TEST(SignLegend, WhatIsEmptyHasNoSign) {
    host_sim::LayerDraft nobody = layer_of(LayerRole::trajectory, scene::LayerShape::lines);
    nobody.points.clear();
    nobody.starts = {0};
    EXPECT_EQ(said(nobody, element_of(DataTechnique::tube)), "");
    EXPECT_EQ(said(nobody, element_of(DataTechnique::billboard)), "");
}

TEST(SignLegend, VerticalLinesSayHowFarApartTheyAre) {
    design::DataElement tube = element_of(DataTechnique::tube);
    const auto flight = layer_of(LayerRole::trajectory, scene::LayerShape::lines);
    EXPECT_EQ(said(flight, tube), "TRAJECTORY;");
    tube.cues.line_spacing_m = 926;
    EXPECT_EQ(said(flight, tube), "TRAJECTORY;LINES 0.5 NM;");
    tube.cues.line_spacing_m = 1000;
    EXPECT_EQ(said(flight, tube), "TRAJECTORY;LINES 1000 M;");
    tube.technique = DataTechnique::ribbon;
    EXPECT_EQ(said(flight, tube), "LINES 1000 M;");
}

TEST(SignLegend, TheSurfaceGridSaysHowFarApartItsLinesAre) {
    const auto air = layer_of(LayerRole::wind, scene::LayerShape::points);
    design::DataElement surface = element_of(DataTechnique::isosurface);
    surface.grid = true;
    design::DesignSettings design;
    EXPECT_EQ(said(air, surface, ElementState::shown, design), "") << "a device may have forbidden it";
    design.terrain.style.grid.spacing_m = 926;
    EXPECT_EQ(said(air, surface, ElementState::shown, design), "GRID 0.5 NM;");
    design.terrain.style.grid.height_spacing_m = 60.96;
    EXPECT_EQ(said(air, surface, ElementState::shown, design), "GRID 0.5 NM;GRID VERT 200 FT;") << "in place of its own lines";
    design.symbology.units = base::DisplayUnits::metric;
    design.terrain.style.grid.spacing_m = 2500;
    EXPECT_EQ(said(air, surface, ElementState::shown, design), "GRID 2500 M;GRID VERT 61 M;");
    surface.grid = false;
    EXPECT_EQ(said(air, surface, ElementState::shown, design), "LINES 305 M;");
}

TEST(SignLegend, AreasAndTubesSayHowFarTheyMayBeOff) {
    const auto no_go = element_of(DataTechnique::prism, ElementUncertainty::widening);
    EXPECT_EQ(said(layer_of(LayerRole::no_go, scene::LayerShape::areas, 300), no_go), "NO-GO;LIMIT 95 %;");
    EXPECT_EQ(said(layer_of(LayerRole::no_go, scene::LayerShape::areas), no_go), "NO-GO;LIMIT \xC2\xB1 ?;") << "nobody knows";
    EXPECT_EQ(said(layer_of(LayerRole::no_go, scene::LayerShape::areas, 300), element_of(DataTechnique::prism)), "NO-GO;");
    const auto tube = element_of(DataTechnique::tube, ElementUncertainty::widening);
    EXPECT_EQ(said(layer_of(LayerRole::trajectory, scene::LayerShape::lines, 20), tube), "TRAJECTORY;PATH 95 %;");
    const auto pathway = element_of(DataTechnique::pathway, ElementUncertainty::widening);
    EXPECT_EQ(said(layer_of(LayerRole::trajectory, scene::LayerShape::lines, 20), pathway), "TRAJECTORY;PATH 95 %;");
    EXPECT_EQ(said(layer_of(LayerRole::trajectory, scene::LayerShape::lines), pathway), "TRAJECTORY;PATH \xC2\xB1 ?;");
    EXPECT_EQ(said(layer_of(LayerRole::trajectory, scene::LayerShape::lines), element_of(DataTechnique::space_time)),
              "TRAJECTORY;1 H: 3281 FT;");
    EXPECT_EQ(said(layer_of(LayerRole::no_go, scene::LayerShape::areas), no_go, ElementState::out_of_date), "");
    EXPECT_EQ(said(layer_of(LayerRole::building, scene::LayerShape::areas), no_go), "") << "a house is a house";
}

TEST(SignLegend, WidthsSayWhatTheyStandFor) {
    host_sim::LayerDraft way = layer_of(LayerRole::trajectory, scene::LayerShape::lines);
    host_sim::AttributeDraft wind;
    wind.name = "wind";
    wind.title = "Wind";
    wind.of = scene::AttributeOf::point;
    wind.values = {1, 2, 3};
    way.attributes.push_back(wind);
    auto tube = element_of(DataTechnique::tube);
    tube.size_attribute = "wind";
    EXPECT_EQ(said(way, tube), "TRAJECTORY;WIDTH: WIND;262 FT: 3;") << "the default radius is 40 m";
    way.attributes[0].unit = "m/s";
    tube.size_m = 76.2;
    EXPECT_EQ(said(way, tube), "TRAJECTORY;WIDTH: WIND;500 FT: 5.83 KT;");
}

TEST(SignLegend, DiagramsSayWhetherTheyAreLinesOrBars) {
    host_sim::LayerDraft air = layer_of(LayerRole::sample, scene::LayerShape::points);
    host_sim::AttributeDraft warmth;
    warmth.name = "temperature";
    warmth.unit = "K";
    warmth.of = scene::AttributeOf::feature;
    warmth.values = {263.15F, 270.15F, 274.15F};
    air.attributes.push_back(warmth);
    EXPECT_EQ(said(air, element_of(DataTechnique::diagram)), "BARS MIN-MAX;");
    for (scene::ScenePoint& point : air.points) point = air.points[0];
    EXPECT_EQ(said(air, element_of(DataTechnique::diagram)), "LINE: TEMPERATURE;-10..1 °C;VERTICAL: HEIGHT;");
}

TEST(SignLegend, LinesOnSurfacesAndSignsOfWind) {
    host_sim::LayerDraft air = layer_of(LayerRole::wind, scene::LayerShape::points);
    design::DataElement surface = element_of(DataTechnique::isosurface);
    EXPECT_EQ(said(air, surface), "LINES 1000 FT;");
    surface.detail = 0.4;
    EXPECT_EQ(said(air, surface), "") << "of little detail there are none";
    EXPECT_EQ(said(air, element_of(DataTechnique::arrows)), "RING: CALM;STAR IN RING: VARIABLE;CROSS: MISSING;");
    design::DataElement colored = element_of(DataTechnique::arrows);
    colored.by_color.attribute = "speed";
    EXPECT_EQ(said(air, colored), "");
}

TEST(SignLegend, SignsOfObstaclesAndTraffic) {
    host_sim::LayerDraft masts = layer_of(LayerRole::obstacle, scene::LayerShape::points);
    host_sim::AttributeDraft kind;
    kind.name = "kind";
    kind.scale = scene::AttributeScale::nominal;
    kind.of = scene::AttributeOf::feature;
    kind.classes = {"mast", "turbine", "crane"};
    kind.values = {2, 0, 2};
    masts.attributes.push_back(kind);
    EXPECT_EQ(said(masts, element_of(DataTechnique::billboard)), "MAST;CRANE;") << "those that there are";
    EXPECT_EQ(said(masts, element_of(DataTechnique::billboard, ElementUncertainty::dashed_rim)), "? UNKNOWN;MAST;CRANE;")
        << "no uncertainty is stated";
    masts.attributes[0].uncertainty_kind = scene::UncertaintyKind::percent;
    masts.attributes[0].uncertainty_full = 100;
    masts.attributes[0].uncertainty_all = scene::Uncertainty::from_level(0.3);
    EXPECT_EQ(said(masts, element_of(DataTechnique::billboard, ElementUncertainty::dashed_rim)),
              "UNCERTAIN;? UNKNOWN;MAST;CRANE;");
    EXPECT_EQ(said(layer_of(LayerRole::traffic, scene::LayerShape::lines), element_of(DataTechnique::billboard)),
              "TRAFFIC;TFC 6 NM 1200 FT;STALE TFC;");
    design::DesignSettings metric;
    metric.symbology.units = base::DisplayUnits::metric;
    EXPECT_EQ(said(layer_of(LayerRole::traffic, scene::LayerShape::lines), element_of(DataTechnique::billboard),
                   ElementState::shown, metric),
              "TRAFFIC;TFC 11 KM 366 M;STALE TFC;");
    EXPECT_EQ(said(layer_of(LayerRole::place, scene::LayerShape::points), element_of(DataTechnique::billboard)), "");
    for (const DataTechnique technique : {DataTechnique::billboard, DataTechnique::solid})
        EXPECT_EQ(said(layer_of(LayerRole::place, scene::LayerShape::points, 500),
                       element_of(technique, ElementUncertainty::ellipsoid)),
                  "POS 95 %;");
}

TEST(SignLegend, StandsBehindTheScales) {
    const test_support::LoadedScene loaded(layer_of(LayerRole::no_go, scene::LayerShape::areas));
    const test_support::LoadedScene air(test_support::small_scene());
    auto no_go = element_of(DataTechnique::prism), spheres = element_of(DataTechnique::spheres);
    spheres.by_color.attribute = "temperature";
    spheres.by_color.scale.palette = test_support::grey_palette();
    ElementReports reports;
    ElementReport report;
    report.state = ElementState::shown;
    report.count.drawn = 1;
    report.element = &no_go;
    report.layer = &loaded.layer();
    EXPECT_TRUE(reports.try_push_back(report));
    report.element = &spheres;
    report.layer = &air.scene().layers()[0];
    report.slot = 0;
    EXPECT_TRUE(reports.try_push_back(report));
    draw::DataLegends legends;
    add_element_legends(reports, {}, {}, {}, legends);
    ASSERT_EQ(legends.size(), 2u);
    EXPECT_TRUE(legends[0].has_scale);
    EXPECT_FALSE(legends[1].has_scale);
}

TEST(SignLegend, LabelsThatAreLeftOutAreCountedOnDemand) {
    const test_support::LoadedScene loaded(layer_of(LayerRole::place, scene::LayerShape::points));
    const design::DataElement element = element_of(DataTechnique::billboard);
    ElementReports reports;
    for (const ElementState state : {ElementState::shown, ElementState::shown, ElementState::out_of_date}) {
        ElementReport report;
        report.state = state;
        report.element = &element;
        report.layer = &loaded.layer();
        report.suppressed_labels = 6;
        EXPECT_TRUE(reports.try_push_back(report));
    }
    const auto said_by = [&](const design::DesignSettings& design) {
        draw::DataLegends legends;
        add_sign_legend(reports, design, legends);
        return legends.empty() ? std::string() : std::string(legends[0].signs[0].text.view());
    };
    design::DesignSettings asking;
    EXPECT_EQ(said_by(asking), "");
    asking.labels.show_suppressed = true;
    EXPECT_EQ(said_by(asking), "12 LABELS HIDDEN");
    for (ElementReport& report : reports) report.suppressed_labels = 0;
    EXPECT_EQ(said_by(asking), "") << "nothing is left out";
}

}  // namespace
}  // namespace tedavis::display::test_sign_legend
