#include "render_core/draw/data/runway_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/data/ground_section.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/drawn_surface.hpp"
#include "tests/support/draw/built_element.hpp"
#include "tests/support/terrain/resident_tdb.hpp"
#include "tests/support/terrain/selection.hpp"
#include "tests/support/terrain/terrain_views.hpp"

namespace tedavis::draw::test_runway_surface {
namespace {

using test_support::ElementOfTest;
using test_support::WrittenTdb;

const WrittenTdb& region() {
    static const WrittenTdb tdb([] {
        test_support::TdbSpec spec;
        spec.columns = spec.rows = 129;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) {
            return 600 + 60 * std::sin(i * 0.11) * std::cos(j * 0.09) + 3 * std::sin(i * 1.3 + j * 0.7);
        };
        return spec;
    }());
    return tdb;
}

/// The selection of a view at a level of detail, as ground.
class SelectedGround final : public scene::Ground {
public:
    SelectedGround(const WrittenTdb& tdb, const terrain::View& view, double tau_px) : tdb_(tdb) {
        test_support::ResidentTdb catalogue(tdb);
        terrain::LodSettings settings;
        settings.tau_px = tau_px;
        EXPECT_TRUE(selection_.select(catalogue, view, settings).within_budget);
    }
    double height_m(double latitude_rad, double longitude_rad) override {
        const terrain::LatticePoint at = tdb_.lattice().point(latitude_rad, longitude_rad);
        const auto i = static_cast<std::uint32_t>(std::lround(at.i)), j = static_cast<std::uint32_t>(std::lround(at.j));
        return tdb_.height_m(i, j) + WrittenTdb::undulation_m(latitude_rad);
    }
    double drawn_height_m(double latitude_rad, double longitude_rad) override {
        const terrain::LatticePoint point = tdb_.lattice().point(latitude_rad, longitude_rad);
        const terrain::SelectedChunk* chunk =
            terrain::chunk_under(tdb_.lattice(), {selection_.chunks.data(), selection_.chunks.size()}, point);
        if (chunk == nullptr) return std::nan("");
        const auto vertices = tdb_.vertices(chunk->key);
        const auto indices = tdb_.indices(chunk->key, chunk->coarser_edges);
        const terrain::DrawnPoint drawn = terrain::drawn_point(
            tdb_.database(), {chunk, {vertices.data(), vertices.size()}, {indices.data(), indices.size()}}, point);
        return drawn.found ? earth::from_ecef(drawn.position).height.m : std::nan("");
    }
    double undulation_m(double latitude_rad, double) override { return WrittenTdb::undulation_m(latitude_rad); }
    [[nodiscard]] std::size_t chunks() const { return selection_.chunks.size(); }

private:
    const WrittenTdb& tdb_;
    test_support::Selection selection_;
};

/// The true surface in the place of the drawn one.
class TrueGround final : public scene::Ground {
public:
    explicit TrueGround(scene::Ground& ground) : ground_(ground) {}
    double height_m(double latitude_rad, double longitude_rad) override { return ground_.height_m(latitude_rad, longitude_rad); }
    double undulation_m(double latitude_rad, double longitude_rad) override {
        return ground_.undulation_m(latitude_rad, longitude_rad);
    }

private:
    scene::Ground& ground_;
};

host_sim::LayerDraft runway_layer() {
    host_sim::LayerDraft layer;
    layer.name = "runways";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::runway;
    layer.points = {test_support::scene_point(46.95, 9.03, 0), test_support::scene_point(46.955, 9.045, 0)};
    layer.starts = {0, 2};
    return layer;
}

struct Seat {
    double lowest_m = 1e9, highest_m = -1e9;  ///< of a corner over the drawn ground, beyond what the header states
};

/// Of all corners of all sections, over the drawn ground below each.
Seat seat_of(SelectedGround& ground, scene::Ground& seat_ground, const glm::dvec3& eye, double turn_deg) {
    ElementOfTest test(runway_layer());
    const ElementInput made = test.input();
    const ElementInput input{made.element, 0, made.layer, seat_ground, made.missing, 0, false, eye};
    const scene::ScenePoint first = test_support::scene_point(46.95, 9.05, 0);
    const double turn = base::radians(turn_deg);
    const scene::ScenePoint last = moved(first, {1500 * std::sin(turn), 1500 * std::cos(turn)});
    RunwaySurface surface;
    EXPECT_TRUE(surface.build(input, first, last, 45));
    EXPECT_NEAR(surface.length_m(), 1500, 1);
    Seat seat;
    for (std::size_t n = 0; n < surface.sections(); ++n) {
        double over_m[3], ground_m[3];
        for (int side = -1; side <= 1; ++side) {
            const earth::Geodetic at = earth::from_ecef(surface.at(surface.along_m(n), side * surface.half_width_m()));
            ground_m[side + 1] = ground.drawn_height_m(at.latitude_rad, at.longitude_rad);
            over_m[side + 1] = at.height.m - ground_m[side + 1];
        }
        const double fall_m = *std::max_element(ground_m, ground_m + 3) - *std::min_element(ground_m, ground_m + 3);
        for (const double over : over_m) {
            seat.lowest_m = std::min(seat.lowest_m, over);
            seat.highest_m = std::max(seat.highest_m, over - fall_m - kRunwayLift_m);
        }
    }
    return seat;
}

/// At every level of detail; a corner is never below the drawn ground, and above it by no more than the lift and the ground's
/// fall across the runway. Control: seated on the true surface, corners are below the coarse ground.
TEST(RunwaySurface, P28EveryCornerIsSeatedOnTheDrawnGroundAtEveryLevelOfDetail) {
    constexpr double kTolerance_m = 0.05;  // sections are level by the axes of the runway's middle
    const terrain::View view = test_support::view_from(region(), 60, 100, 400, 0, -10);
    bool control_fails = false;
    std::size_t most_chunks = 0, fewest_chunks = 1u << 20;
    for (const double tau_px : {0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
        SelectedGround ground(region(), view, tau_px);
        TrueGround true_ground(ground);
        most_chunks = std::max(most_chunks, ground.chunks());
        fewest_chunks = std::min(fewest_chunks, ground.chunks());
        for (const double turn_deg : {0.0, 37.0, 90.0, 200.0}) {
            const Seat seat = seat_of(ground, ground, view.eye, turn_deg);
            EXPECT_GE(seat.lowest_m, kRunwayLift_m - kTolerance_m) << tau_px << ", " << turn_deg;
            EXPECT_LE(seat.highest_m, kTolerance_m) << tau_px << ", " << turn_deg;
            control_fails = control_fails || seat_of(ground, true_ground, view.eye, turn_deg).lowest_m < -0.5;
        }
    }
    EXPECT_GT(most_chunks, fewest_chunks) << "there are several levels of detail";
    EXPECT_TRUE(control_fails);
}

TEST(RunwaySurface, SectionsAreFewFromAfarAndNeverTooMany) {
    ElementOfTest test(runway_layer());
    const auto sections = [&](double length_m, double distance_m) {
        const scene::ScenePoint first = test_support::scene_point(46.8, 9.8, 0), last = moved(first, {0, length_m});
        const earth::Geodetic eye{first.latitude_rad, first.longitude_rad, {distance_m}};
        ElementInput input = test.input();
        input.eye = earth::to_ecef(eye);
        RunwaySurface surface;
        return surface.build(input, first, last, 30) ? surface.sections() : 0;
    };
    EXPECT_EQ(sections(1500, 100), 31u);
    EXPECT_EQ(sections(1500, 20'000), 3u);
    for (double length_m = 200; length_m < kMaxRunway_m; length_m += 170) {
        EXPECT_GE(sections(length_m, 50), 2u);
        EXPECT_LE(sections(length_m, 50), kMaxRunwaySections);
    }
    EXPECT_EQ(sections(100, 50), 0u);
    EXPECT_EQ(sections(9000, 50), 0u);
}

TEST(RunwaySurface, WhereNoGroundIsKnownTheDataSayTheHeight) {
    ElementOfTest test(runway_layer());
    test.ground.is_known = false;
    const scene::ScenePoint first = test_support::scene_point(46.8, 9.8, 500), last = moved(first, {0, 1000});
    RunwaySurface surface;
    EXPECT_TRUE(surface.build(test.input(), first, last, 30));
    EXPECT_NEAR(earth::from_ecef(surface.at(500, 0)).height.m, 500 + 50 + kRunwayLift_m, 0.1);
    scene::ScenePoint unknown = first;
    unknown.height_m = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(surface.build(test.input(), unknown, moved(unknown, {0, 1000}), 30));
}

}  // namespace
}  // namespace tedavis::draw::test_runway_surface
