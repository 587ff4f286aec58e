#include "render_core/draw/symbology/adjacent_maps.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/data_legend_samples.hpp"
#include "tests/support/draw/symbology_scene.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::draw::test_adjacent_maps {
namespace {

using base::radians;
using design::AdjacentShows;
using scene::Uncertainty;
using scene::ValueState;
using test_support::BatchStore;
using test_support::LoadedScene;

constexpr design::Color kSign{200, 40, 200};

design::DataScale wind_scale(std::size_t limits = 0) { return test_support::classed_wind(limits).scale; }

/// A grid of 41 x 41 posts round 47 N 9 E, half a degree a side, whose value rises to the east and whose uncertainty to the
/// north.
host_sim::LayerDraft wide_grid() {
    host_sim::LayerDraft layer;
    layer.name = layer.title = "gusts";
    layer.shape = scene::LayerShape::grid;
    layer.grid = {radians(8.75), radians(47.25), radians(0.0125), radians(0.0125), 41, 41, 1, 1};
    host_sim::AttributeDraft gust;
    gust.name = gust.title = "gust";
    gust.uncertainty_kind = scene::UncertaintyKind::standard_deviation;
    gust.uncertainty_full = 4;
    for (int n = 0; n < 41 * 41; ++n) {
        gust.values.push_back(static_cast<float>(n % 41) / 2);
        gust.uncertainties.push_back(Uncertainty::from_level(1 - n / 41 / 40.0));
        gust.states.push_back(ValueState::valid);
    }
    for (int m = 0; m < 9; ++m) gust.members.emplace_back(gust.values.size(), static_cast<float>(2 * m));
    layer.attributes.push_back(gust);
    return layer;
}

AdjacentInput input_of(const LoadedScene& loaded, AdjacentShows shows = AdjacentShows::value) {
    AdjacentInput input;
    input.layer = &loaded.layer();
    input.attribute = &loaded.attribute();
    input.view.is_shown = true;
    input.view.shows = shows;
    input.view.range_m = 10'000;
    input.view.scale = wind_scale();
    input.latitude_rad = radians(47);
    input.longitude_rad = radians(9);
    input.sign = kSign;
    input.title = "GUST";
    return input;
}

TEST(AdjacentMaps, CellsShareTheRoomThatThereIs) {
    const LoadedScene loaded(wide_grid());
    AdjacentInput input = input_of(loaded);
    EXPECT_EQ(map_count(AdjacentInput()), 0u);
    EXPECT_EQ(map_count(input), 1u);
    EXPECT_EQ(cells_across(input, 500), design::kMaxCells);
    input.view.cells = 8;
    EXPECT_EQ(cells_across(input, 500), 8u);
    input.view.cells = design::kMaxCells;
    EXPECT_EQ(cells_across(input, 80), 20u) << "four pixels each at least";
    EXPECT_EQ(cells_across(input, 2), 1u);
    input.view.shows = AdjacentShows::members;
    EXPECT_EQ(map_count(input), 9u);
    for (std::uint32_t most = 1; most <= 9; ++most) {
        input.view.most_members = most;
        const std::uint32_t lines = cells_across(input, 500) + 1;
        EXPECT_EQ(map_count(input), most);
        EXPECT_LE(most * lines * lines, kAdjacentCells);
        EXPECT_GE(cells_across(input, 500), design::kMinCells);
    }
}

/// Against GeographicLib's geodesics: a corner of a cell is drawn where it lies from the own ship.
TEST(AdjacentMaps, PlacesAreDrawnWhereTheyAre) {
    const LoadedScene loaded(wide_grid());
    AdjacentInput input = input_of(loaded);
    const Rect box{100, 50, 120, 120};
    const GeographicLib::Geodesic& earth = GeographicLib::Geodesic::WGS84();
    for (const double latitude_deg : {-70.03, -12.0, 0.0, 47.0, 47.061, 65.5, 80.0}) {
        input.latitude_rad = radians(latitude_deg);
        const MapLattice lattice(input, box);
        for (std::uint32_t row = 1; row + 1 < lattice.rows(); ++row)
            for (std::uint32_t column = 1; column + 1 < lattice.columns(); ++column) {
                const Rect cell = lattice.box_of(column, row);
                double distance_m = 0, azimuth_deg = 0, back = 0;
                earth.Inverse(latitude_deg, 9, base::degrees(lattice.latitude_rad(row)),
                              base::degrees(lattice.longitude_rad(column)), distance_m, azimuth_deg, back);
                const double px = distance_m * 120 / 20'000;
                EXPECT_NEAR(static_cast<double>(cell.center().x), 160 + px * std::sin(radians(azimuth_deg)), 1.3) << latitude_deg;
                EXPECT_NEAR(static_cast<double>(cell.center().y), 110 - px * std::cos(radians(azimuth_deg)), 1.3) << latitude_deg;
            }
    }
}

TEST(AdjacentMaps, CellsCoverTheMapOnceWithWholePixels) {
    const LoadedScene loaded(wide_grid());
    AdjacentInput input = input_of(loaded);
    for (const double latitude_deg : {-88.0, 0.001, 47.0, 59.99, 89.99})
        for (const std::uint32_t cells : {4u, 17u, 25u})
            for (const float side : {20.0f, 83.0f, 240.0f}) {
                input.latitude_rad = radians(latitude_deg);
                input.longitude_rad = radians(179.999);
                input.view.cells = cells;
                const Rect box{7, 11, side, side};
                const MapLattice lattice(input, box);
                EXPECT_LE(lattice.columns(), cells + 1);
                EXPECT_LE(lattice.rows(), cells + 1);
                float area = 0;
                for (std::uint32_t row = 0; row < lattice.rows(); ++row)
                    for (std::uint32_t column = 0; column < lattice.columns(); ++column) {
                        const Rect cell = lattice.box_of(column, row);
                        EXPECT_TRUE(box.contains(cell));
                        EXPECT_EQ(cell.x, std::round(cell.x));
                        EXPECT_EQ(cell.width, std::round(cell.width));
                        if (column > 0) {
                            EXPECT_EQ(cell.x, lattice.box_of(column - 1, row).right());
                        }
                        if (row > 0) {
                            EXPECT_EQ(cell.y, lattice.box_of(column, row - 1).bottom());
                        }
                        area += cell.width * cell.height;
                    }
                EXPECT_EQ(area, side * side) << latitude_deg << " " << cells << " " << side;
            }
}

TEST(AdjacentMaps, TheLatticeStandsStillOnTheGround) {
    const LoadedScene loaded(wide_grid());
    AdjacentInput input = input_of(loaded);
    input.latitude_rad = radians(47.03);
    const MapLattice here(input, {0, 0, 100, 100});
    input.latitude_rad += 30 / 6'370'000.0;
    input.longitude_rad += 50 / 4'350'000.0;
    const MapLattice there(input, {0, 0, 100, 100});
    for (std::uint32_t n = 0; n < 20; ++n) {
        EXPECT_EQ(here.latitude_rad(n), there.latitude_rad(n));
        EXPECT_EQ(here.longitude_rad(n), there.longitude_rad(n));
    }
}

TEST(AdjacentMaps, ColorsAreThoseOfTheScaleAndSignsAreNone) {
    const LoadedScene loaded(wide_grid());
    AdjacentInput input = input_of(loaded);
    const scene::FieldValue sure{7.3, Uncertainty::from_level(0.25), ValueState::valid};
    for (const std::size_t limits : {0u, 5u}) {
        input.view.scale = wind_scale(limits);
        input.view.shows = AdjacentShows::value;
        EXPECT_EQ(cell_of(sure, input).color, scale_color(input.view.scale, 7.3));
        EXPECT_EQ(cell_of(sure, input).sign, CellSign::none);
        input.view.shows = AdjacentShows::uncertainty;
        EXPECT_EQ(cell_of(sure, input).color, scale_color(input.view.scale, sure.uncertainty.level()));
    }
    EXPECT_EQ(cell_of({7.3, {}, ValueState::valid}, input).sign, CellSign::unknown) << "and never certain";
    EXPECT_EQ(cell_of({7.3, Uncertainty::from_level(0), ValueState::interpolated}, input).sign, CellSign::interpolated);
    EXPECT_EQ(cell_of({}, input).sign, CellSign::missing);
    EXPECT_EQ(cell_of({std::nan(""), Uncertainty::from_level(0), ValueState::valid}, input).sign, CellSign::missing);
    input.view.shows = AdjacentShows::members;
    EXPECT_EQ(cell_of({7.3, {}, ValueState::valid}, input).sign, CellSign::none) << "says nothing of its uncertainty";
}

/// What a frame's batch holds, with the panel of a screen.
struct Built {
    explicit Built(const AdjacentInput& maps, std::uint32_t width = 640, std::uint32_t height = 480) {
        SymbologyInput input = test_support::scene_input(test_support::scene_state(30, 2, 0), width, height);
        input.adjacent = maps;
        layout = make_layout(width, height, 96, legend_need(input));
        build_adjacent_maps(Painter(store.batch, layout), input);
    }
    /// Quads of a colour.
    [[nodiscard]] int count(design::Color color) const {
        int vertices = 0;
        for (const QuadVertex& v : store.batch.vertices())
            vertices += v.rgba[0] == color.red && v.rgba[1] == color.green && v.rgba[2] == color.blue ? 1 : 0;
        return vertices / 4;
    }

    BatchStore store;
    Layout layout;
};

TEST(AdjacentMaps, EveryQuadOfTheMapHasTheColorOfTheValueInItsMiddle) {
    const LoadedScene loaded(wide_grid());
    const AdjacentInput maps = input_of(loaded);
    const Built built(maps);
    const AdjacentPlan plan = plan_adjacent(built.layout.adjacent, 1, built.layout.text_px);
    const MapLattice lattice(maps, plan.box_of(0));
    const auto vertices = built.store.batch.vertices();
    int found = 0;
    for (std::uint32_t row = 0; row < lattice.rows(); ++row)
        for (std::uint32_t column = 0; column < lattice.columns(); ++column) {
            const Rect cell = lattice.box_of(column, row);
            // A post is 0.0125 degrees, half a unit: the value is linear in the longitude.
            const double value = (base::degrees(lattice.longitude_rad(column)) - 8.75) / 0.025;
            const design::Color color = scale_color(maps.view.scale, value);
            for (std::size_t n = 0; n + 3 < vertices.size(); ++n) {
                if (vertices[n].x != cell.x - 1 || vertices[n].y != cell.y - 1 || vertices[n + 2].x != cell.right() + 1 ||
                    vertices[n + 2].y != cell.bottom() + 1)
                    continue;
                ++found;
                EXPECT_NEAR(vertices[n].rgba[0], color.red, 1);
                EXPECT_NEAR(vertices[n].rgba[1], color.green, 1);
                EXPECT_NEAR(vertices[n].rgba[2], color.blue, 1);
            }
        }
    EXPECT_EQ(found, static_cast<int>(lattice.rows() * lattice.columns()));
}

TEST(AdjacentMaps, MembersStandSideBySideWithTheirNumbersInOneScale) {
    const LoadedScene loaded(wide_grid());
    AdjacentInput maps = input_of(loaded, AdjacentShows::members);
    const Built built(maps, 1024, 768);
    const std::string text = test_support::text_of(built.store.batch);
    EXPECT_EQ(text.rfind("GUSTMEMBERSRNG5.4NMN", 0), 0u) << text;
    EXPECT_NE(text.find("123456789"), std::string::npos) << text;
    for (int m = 0; m < 9; ++m) EXPECT_GE(built.count(scale_color(maps.view.scale, 2.0 * m)), 36) << m;
    maps.view.most_members = 3;
    EXPECT_NE(test_support::text_of(Built(maps).store.batch).find("159"), std::string::npos) << "they keep their numbers";
}

TEST(AdjacentMaps, MissingAndUnknownCellsHaveTheirSignOnly) {
    host_sim::LayerDraft layer = wide_grid();
    const LoadedScene whole(layer);
    EXPECT_EQ(Built(input_of(whole)).count(kSign), 0);
    for (float& value : layer.attributes[0].values) value = std::numeric_limits<float>::quiet_NaN();
    layer.attributes[0].members.clear();
    const LoadedScene missing(layer);
    const Built dots(input_of(missing));
    EXPECT_GE(dots.count(kSign), 19 * 19);
    layer = wide_grid();
    for (Uncertainty& uncertainty : layer.attributes[0].uncertainties) uncertainty = {};
    const LoadedScene unknown(layer);
    const Built strokes(input_of(unknown, AdjacentShows::uncertainty));
    EXPECT_GE(strokes.count(kSign), 19 * 19);
    for (const double level : {0.0, 0.5, 1.0})
        EXPECT_EQ(strokes.count(scale_color(wind_scale(), level)), 0) << "no colour of the scale";
    AdjacentInput away = input_of(whole);
    away.longitude_rad = radians(20);
    EXPECT_GE(Built(away).count(kSign), 19 * 19) << "beyond the grid";
}

TEST(AdjacentMaps, StayInTheirPanelAndCoverNoSymbologyOnAnyScreen) {
    const LoadedScene loaded(wide_grid());
    for (const auto& [width, height] :
         {std::pair{320u, 240u}, {240u, 320u}, {640u, 480u}, {1024u, 768u}, {1080u, 1920u}, {1920u, 1080u}})
        for (const AdjacentShows shows : {AdjacentShows::uncertainty, AdjacentShows::members}) {
            const Built built(input_of(loaded, shows), width, height);
            ASSERT_FALSE(built.layout.adjacent.empty());
            EXPECT_EQ(built.store.batch.use().refused, 0u);
            for (const QuadVertex& v : built.store.batch.vertices())
                ASSERT_TRUE(built.layout.adjacent.shrunk(-3.0f).contains(Point{v.x, v.y})) << width << " " << v.x << " " << v.y;
        }
}

TEST(AdjacentMaps, AllSymbologyWithAllLegendsAndTheMostMapsFitsTheBatch) {
    host_sim::LayerDraft layer = wide_grid();
    layer.attributes[0].members.resize(scene::kMaxMembers, layer.attributes[0].members[0]);
    const LoadedScene loaded(layer);
    SymbologyInput input = test_support::scene_input(test_support::scene_state(30, 2, 0), 1920, 1080);
    input.legend.highest = 2000;
    using test_support::classed_wind;
    using test_support::land_cover;
    input.data_legends = test_support::list_of({classed_wind(15), land_cover(16), land_cover(16), classed_wind(15)});
    for (const auto& [width, height] :
         {std::pair{320u, 240u}, {640u, 480u}, {1024u, 768u}, {1080u, 1920u}, {1920u, 1080u}, {3840u, 2160u}})
        for (const std::uint32_t members : {0u, 1u, 4u, 9u, 16u}) {
            input.adjacent = input_of(loaded, members == 0 ? AdjacentShows::value : AdjacentShows::members);
            input.adjacent.view.most_members = members;
            BatchStore store;
            build_symbology(store.batch, input, make_layout(width, height, 96, legend_need(input)));
            EXPECT_EQ(store.batch.use().refused, 0u);
            EXPECT_LT(store.batch.use().high_water, kSymbologyVertices * 97 / 100) << width << " " << members;
        }
}

}  // namespace
}  // namespace tedavis::draw::test_adjacent_maps
