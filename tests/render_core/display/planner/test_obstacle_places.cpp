#include "render_core/display/planner/obstacle_places.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/display/free_view.hpp"
#include "tests/support/draw/built_element.hpp"
#include "tests/support/scene/scene_drafts.hpp"
#include "tests/support/terrain/drawn_meshes.hpp"
#include "tests/support/terrain/selection.hpp"

namespace tedavis::display::test_obstacle_places {
namespace {

using test_support::LevelGround;
using test_support::LoadedScene;
using test_support::WrittenTdb;

constexpr double kLatitude_deg = 46.7, kLongitude_deg = 9.8, kGround_m = 550, kSpeed_mps = 100;
constexpr std::uint32_t kWidth = 320, kHeight = 240;

/// Metres north and east of where the way begins; 100 m high, over the plain.
scene::ScenePoint mast(double north_m, double east_m) {
    const double latitude = base::radians(kLatitude_deg);
    return {latitude + north_m / earth::meridian_radius_m(latitude),
            base::radians(kLongitude_deg) + east_m / (earth::prime_vertical_radius_m(latitude) * std::cos(latitude)),
            static_cast<float>(kGround_m + 100), 0, scene::kNoTime};
}

host_sim::LayerDraft layer_of(const std::vector<scene::ScenePoint>& points) {
    host_sim::LayerDraft layer;
    layer.name = "masts";
    layer.role = scene::LayerRole::obstacle;
    layer.height_datum = scene::HeightDatum::msl;
    layer.points = points;
    for (std::size_t n = 0; n < points.size(); ++n) layer.names.push_back("Mast " + std::to_string(n + 1));
    return layer;
}

/// Flies north over the plain, 90 s ahead, 500 m aside.
class Flown {
public:
    explicit Flown(const host_sim::LayerDraft& draft) : scene_({"one", "a test", 1, {draft}}) {
        const double latitude = base::radians(kLatitude_deg), longitude = base::radians(kLongitude_deg);
        ground_.height = kGround_m + WrittenTdb::undulation_m(latitude);
        way_ = {{latitude, longitude, {700}}, kSpeed_mps, 0, 0};
        eye_.view = test_support::free_view(earth::to_ecef({latitude, longitude, {700}}),
                                            earth::body_axes(latitude, longitude, 0, 0, 0), kWidth, kHeight, 10);
    }
    /// As solids, or not at all.
    void show_solids(bool are_drawn) {
        element_.role = scene::LayerRole::obstacle;
        element_.technique = design::DataTechnique::solid;
        ElementReport report;
        report.state = ElementState::shown;
        report.element = &element_;
        report.layer = &layer();
        report.count.drawn = are_drawn ? 1 : 0;
        reports_.clear();
        EXPECT_TRUE(reports_.try_push_back(report));
    }
    ObstaclePlaces places(terrain::LineOfSight* sight = nullptr) {
        policy::HazardWatch watch(settings_, way_, ground_, 0);
        return obstacle_places({scene_.scene(), {}, ground_, eye_, sight, reports_, labels_}, watch);
    }
    [[nodiscard]] const scene::Layer& layer() const { return scene_.scene().layers()[0]; }
    [[nodiscard]] const terrain::View& view() const { return eye_.view; }
    void turn(double heading_deg) {
        const double latitude = base::radians(kLatitude_deg), longitude = base::radians(kLongitude_deg);
        eye_.view =
            test_support::free_view(earth::to_ecef({latitude, longitude, {700}}),
                                    earth::body_axes(latitude, longitude, base::radians(heading_deg), 0, 0), kWidth, kHeight, 10);
    }

private:
    LoadedScene scene_;
    design::PrioritySettings settings_;
    LevelGround ground_;
    policy::PredictedTrack way_;
    draw::SignView eye_;
    design::DataElement element_;
    ElementReports reports_;
    ElementLabels labels_;
};

TEST(ObstaclePlaces, OnlyWhatLiesOnTheWayCountsTheSoonestFirst) {
    Flown flown(layer_of({mast(5000, 0), mast(3000, 100), mast(4000, 3000), mast(-3000, 0), mast(20000, 0)}));
    const ObstaclePlaces places = flown.places();
    ASSERT_EQ(places.size(), 2u) << "aside, behind and beyond are none";
    EXPECT_EQ(places[0].name.view(), "Mast 2");
    EXPECT_EQ(places[0].feature, 1u);
    EXPECT_NEAR(places[0].ahead_s, 25, 4);
    EXPECT_EQ(places[1].name.view(), "Mast 1");
    EXPECT_GT(places[1].ahead_s, places[0].ahead_s);
}

TEST(ObstaclePlaces, OtherLayersAreNone) {
    host_sim::LayerDraft places = layer_of({mast(3000, 0)});
    places.role = scene::LayerRole::place;
    EXPECT_EQ(Flown(places).places().size(), 0u);
}

TEST(ObstaclePlaces, SolidsAreBoxesFromTheTopToTheGround) {
    Flown flown(layer_of({mast(3000, 100)}));
    flown.show_solids(true);
    const ObstaclePlace place = flown.places()[0];
    EXPECT_EQ(place.state, ObstacleState::drawn);
    const double focal_px = flown.view().focal_px;
    EXPECT_NEAR(place.box.center().x, 160 + focal_px * 100 / 3000, 1);
    EXPECT_NEAR(place.box.height, std::max(16.0, focal_px * 100 / 3000), 1);
    EXPECT_NEAR(place.box.y, 120 + focal_px * (700 - 50 - 650) / 3000, 8)
        << "of an eye 50 m over its top, or the geoid's height less";
}

TEST(ObstaclePlaces, WhatIsNotShownIsLeftOut) {
    Flown flown(layer_of({mast(3000, 0)}));
    EXPECT_EQ(flown.places()[0].state, ObstacleState::left_out);
    flown.show_solids(false);
    EXPECT_EQ(flown.places()[0].state, ObstacleState::left_out) << "the element draws none of it";
    EXPECT_FALSE(flown.places()[0].box.empty()) << "where it would be";
}

TEST(ObstaclePlaces, WhatTheEyeDoesNotLookAtIsOutOfView) {
    Flown flown(layer_of({mast(3000, 0)}));
    flown.show_solids(true);
    for (const double heading_deg : {90.0, 180.0, 270.0}) {
        flown.turn(heading_deg);
        EXPECT_EQ(flown.places()[0].state, ObstacleState::out_of_view) << heading_deg;
    }
}

TEST(ObstaclePlaces, WhatStandsBehindARidgeIsHidden) {
    const WrittenTdb ridge([] {
        test_support::TdbSpec spec;
        spec.columns = spec.rows = 129;
        spec.west_deg = 9.7;
        spec.north_deg = 46.85;
        spec.step_lon_deg = spec.step_lat_deg = 1 / 600.0;
        spec.height_m = [](std::uint32_t, std::uint32_t j) { return j == 60 ? 1500.0 : kGround_m; };  // 5.5 km to the north
        return spec;
    }());
    Flown flown(layer_of({mast(3000, 0), mast(7500, 0)}));
    flown.show_solids(true);
    test_support::MeshesOfTest meshes(ridge);
    test_support::ResidentTdb catalogue(ridge);
    test_support::Selection selection;
    EXPECT_TRUE(selection.select(catalogue, flown.view(), {}).within_budget);
    terrain::LineOfSight sight(ridge.lattice(), {selection.chunks.data(), selection.chunks.size()}, meshes, flown.view());
    const ObstaclePlaces places = flown.places(&sight);
    ASSERT_EQ(places.size(), 2u);
    EXPECT_EQ(places[0].state, ObstacleState::drawn) << "before the ridge";
    EXPECT_EQ(places[1].state, ObstacleState::hidden);
    EXPECT_EQ(flown.places()[1].state, ObstacleState::drawn) << "without the ridge";
}

TEST(ObstaclePlaces, OfManyTheSoonestAreKept) {
    std::vector<scene::ScenePoint> points;
    for (int n = 0; n < 30; ++n) points.push_back(mast(8500 - 250 * n, 10 * n));
    const ObstaclePlaces places = Flown(layer_of(points)).places();
    ASSERT_EQ(places.size(), kMaxObstaclePlaces);
    for (std::size_t n = 1; n < places.size(); ++n) EXPECT_LE(places[n - 1].ahead_s, places[n].ahead_s);
    EXPECT_GE(places.back().feature, 30 - 3 * kMaxObstaclePlaces) << "of the last ones, which are nearest";
}

}  // namespace
}  // namespace tedavis::display::test_obstacle_places
