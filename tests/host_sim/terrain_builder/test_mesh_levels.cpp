#include "host_sim/terrain_builder/mesh_levels.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host_sim/terrain_builder/tdb_image.hpp"
#include "tests/support/synthetic_raster.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::kChunkCells;
using terrain::LatticeTriangle;
using terrain::LatticeVertex;

/// One chunk of two levels: 65 x 65 posts with heights from a formula.
template <class F>
Lattice lattice_of(F height) {
    Lattice lattice;
    lattice.levels = 2;
    lattice.columns = lattice.rows = lattice.raster_columns = lattice.raster_rows = 2 * kChunkCells + 1;
    lattice.cell_m = 0.01;  // the Earth is flat over it
    for (std::int64_t j = 0; j < lattice.rows; ++j)
        for (std::int64_t i = 0; i < lattice.columns; ++i) lattice.surface_m.push_back(static_cast<float>(height(i, j)));
    lattice.post_class.assign(lattice.surface_m.size(), terrain::PostClass::land);
    return lattice;
}

Lattice rough_lattice(std::uint32_t seed) {
    std::mt19937 random(seed);
    return lattice_of([&](std::int64_t, std::int64_t) { return static_cast<double>(random() % 10000) / 100; });
}

/// Two triangles a cell, joined along (i+1,j)-(i,j+1).
double true_height(const Lattice& lattice, double x, double y) {
    const auto i = std::min(static_cast<std::int64_t>(x), lattice.columns - 2),
               j = std::min(static_cast<std::int64_t>(y), lattice.rows - 2);
    const double u = x - static_cast<double>(i), v = y - static_cast<double>(j);
    const auto post = [&](std::int64_t a, std::int64_t b) { return double{lattice.surface_m[lattice.at(i + a, j + b)]}; };
    if (u + v <= 1) return post(0, 0) + u * (post(1, 0) - post(0, 0)) + v * (post(0, 1) - post(0, 0));
    return post(1, 1) + (1 - u) * (post(0, 1) - post(1, 1)) + (1 - v) * (post(1, 0) - post(1, 1));
}

struct Extremes {
    double above = 0, below = 0;
};

/// Oracle: the two surfaces compared every eighth of a cell, by barycentric coordinates.
Extremes sampled(const Lattice& lattice, const LatticeTriangle& t) {
    const auto height = [&](LatticeVertex v) { return double{lattice.surface_m[lattice.at(v.i, v.j)]}; };
    const auto d = [](std::int64_t x) { return static_cast<double>(x); };
    const double area = d(t.b.i - t.a.i) * d(t.c.j - t.a.j) - d(t.c.i - t.a.i) * d(t.b.j - t.a.j);
    Extremes extremes;
    const auto first_i = std::min({t.a.i, t.b.i, t.c.i}), last_i = std::max({t.a.i, t.b.i, t.c.i});
    const auto first_j = std::min({t.a.j, t.b.j, t.c.j}), last_j = std::max({t.a.j, t.b.j, t.c.j});
    for (double y = d(first_j); y <= d(last_j); y += 0.125) {
        for (double x = d(first_i); x <= d(last_i); x += 0.125) {
            const double wb = ((x - d(t.a.i)) * d(t.c.j - t.a.j) - d(t.c.i - t.a.i) * (y - d(t.a.j))) / area;
            const double wc = (d(t.b.i - t.a.i) * (y - d(t.a.j)) - (x - d(t.a.i)) * d(t.b.j - t.a.j)) / area;
            if (wb < -1e-9 || wc < -1e-9 || wb + wc > 1 + 1e-9) continue;
            const double drawn = (1 - wb - wc) * height(t.a) + wb * height(t.b) + wc * height(t.c);
            const double difference = drawn - true_height(lattice, x, y);
            extremes.above = std::max(extremes.above, difference);
            extremes.below = std::max(extremes.below, -difference);
        }
    }
    return extremes;
}

TEST(MeshLevels, ErrorsOfTrianglesAreThoseOfDenseSampling) {
    const Lattice lattice = rough_lattice(4);
    for (const std::int64_t side : {2, 4, 8, 16}) {
        for (std::int64_t j = 0; j + side < 40; j += 2 * side) {
            for (const bool second : {false, true}) {
                const LatticeTriangle whole = terrain::square_triangle(j, j, side, second);
                for (const LatticeTriangle& t : {whole, whole.half_at_a(), whole.half_at_b(), whole.half_at_a().half_at_b()}) {
                    const SignedError measured = measure_triangle(lattice, t);
                    const Extremes expected = sampled(lattice, t);
                    EXPECT_NEAR(measured.above_m, expected.above, 1e-4) << side;
                    EXPECT_NEAR(measured.below_m, expected.below, 1e-4) << side;
                    EXPECT_FALSE(measured.mixed);
                }
            }
        }
    }
}

TEST(MeshLevels, APlaneHasNoErrorButTheEarthsCurvature) {
    Lattice plane =
        lattice_of([](std::int64_t i, std::int64_t j) { return 3.0 * static_cast<double>(i) - 0.5 * static_cast<double>(j); });
    const LatticeTriangle t = terrain::square_triangle(0, 0, 64, false);
    EXPECT_NEAR(measure_triangle(plane, t).above_m, 0, 1e-4);
    EXPECT_NEAR(measure_triangle(plane, t).below_m, 0, 1e-4);
    plane.cell_m = 30;
    const double chord_m = 64 * std::sqrt(2.0) * 30, radius_m = 6371000;
    EXPECT_NEAR(measure_triangle(plane, t).above_m, 0, 1e-4);
    EXPECT_NEAR(measure_triangle(plane, t).below_m, radius_m * (1 - std::cos(chord_m / radius_m / 2)), 1e-3);
}

TEST(MeshLevels, SagittaIsNeverLessThanThatOfAnyPlaceOnEarth) {
    constexpr double kLeastRadius_m = 6335439;  // of the meridian at the equator
    for (double chord_m = 10; chord_m < 1e6; chord_m *= 3)
        EXPECT_GE(sagitta_m(chord_m),
                  kLeastRadius_m - std::sqrt(kLeastRadius_m * kLeastRadius_m - chord_m * chord_m / 4) - chord_m * 1e-3);
    EXPECT_NEAR(sagitta_m(1000), 0.0197, 0.0001);
}

TEST(MeshLevels, TrianglesOverVoidsAndLandAreMixed) {
    Lattice lattice = rough_lattice(1);
    const auto make_void = [&](std::int64_t i, std::int64_t j) {
        lattice.post_class[lattice.at(i, j)] = terrain::PostClass::void_;
    };
    const LatticeTriangle t = terrain::square_triangle(8, 8, 8, false);
    EXPECT_FALSE(measure_triangle(lattice, t).mixed);
    make_void(40, 40);
    EXPECT_FALSE(measure_triangle(lattice, t).mixed) << "elsewhere";
    make_void(10, 13);
    EXPECT_TRUE(measure_triangle(lattice, t).mixed);
    for (std::int64_t j = 0; j < 30; ++j)
        for (std::int64_t i = 0; i < 30; ++i) make_void(i, j);
    EXPECT_FALSE(measure_triangle(lattice, t).mixed) << "nothing but void needs no split";
}

TEST(MeshLevels, ErrorsAreNestedAndCoverTheirTriangles) {
    const Lattice lattice = rough_lattice(2);
    const std::vector<float> errors = measure_errors(lattice);
    const auto inside = [&](LatticeVertex v) { return v.i >= 0 && v.j >= 0 && v.i < lattice.columns && v.j < lattice.rows; };
    for (std::int64_t j = 0; j < lattice.rows; ++j) {
        for (std::int64_t i = 0; i < lattice.columns; ++i) {
            const LatticeVertex v{i, j};
            if ((i == 0 && j == 0) || terrain::lattice_scale(v) >= 2 * std::int64_t{kChunkCells}) continue;
            const terrain::VertexParents parents = terrain::parents_of(v);
            for (const LatticeVertex parent : {parents.first, parents.second}) {
                if (!inside(parent) || (parent.i == 0 && parent.j == 0)) continue;
                if (terrain::lattice_scale(parent) >= 2 * std::int64_t{kChunkCells}) continue;
                ASSERT_GE(errors[lattice.at(parent.i, parent.j)], errors[lattice.at(i, j)]) << i << "," << j;
            }
        }
    }
    const LatticeTriangle t = terrain::square_triangle(16, 16, 16, false);
    const LatticeVertex middle = t.middle();
    const Extremes of_t = sampled(lattice, t);
    EXPECT_GE(errors[lattice.at(middle.i, middle.j)], std::max(of_t.above, of_t.below) - 1e-4);
}

TEST(MeshLevels, MeasuringStopsWhenToldTo) {
    struct Stop {};
    int pulses = 0;
    EXPECT_THROW((void)measure_errors(rough_lattice(5),
                                      [&pulses] {
                                          if (++pulses == 3) throw Stop{};
                                      }),
                 Stop);
}

TEST(MeshLevels, LevelsKeepWhatIsAboveTheToleranceWithItsParentsAndCorners) {
    const TerrainModel model = make_model(test_support::make_rough_raster(257, 257), {});
    const Lattice& lattice = model.lattice;
    ASSERT_GE(lattice.levels, 3u);
    std::size_t left_out = 0;
    for (std::int64_t j = 0; j < lattice.rows; ++j) {
        for (std::int64_t i = 0; i < lattice.columns; ++i) {
            const std::size_t n = lattice.at(i, j);
            const std::uint8_t kept = model.levels[n];
            for (std::uint32_t level = 0; level < lattice.levels; ++level) {
                const bool in_mesh = kept != kNeverNeeded && kept >= level;
                ASSERT_TRUE(in_mesh || model.errors_m[n] <= model.tolerance_m[level]) << i << "," << j << " level " << level;
                const std::int64_t side = std::int64_t{kChunkCells} << level;
                ASSERT_TRUE(in_mesh || i % side != 0 || j % side != 0) << "a corner of a chunk";
                left_out += in_mesh ? 0 : 1;
            }
            if (kept == kNeverNeeded || (i == 0 && j == 0)) continue;
            if (terrain::lattice_scale({i, j}) >= std::int64_t{kChunkCells} << (lattice.levels - 1)) continue;
            const terrain::VertexParents parents = terrain::parents_of({i, j});
            for (const LatticeVertex p : {parents.first, parents.second}) {
                if (p.i < 0 || p.j < 0 || p.i >= lattice.columns || p.j >= lattice.rows) continue;
                const std::uint8_t of_parent = model.levels[lattice.at(p.i, p.j)];
                ASSERT_TRUE(of_parent != kNeverNeeded && of_parent >= kept) << i << "," << j;
            }
        }
    }
    EXPECT_GT(left_out, 50000u) << "a control: the coarse levels do leave posts out";
}

TEST(MeshLevels, AToleranceOfZeroKeepsEveryPostThatBends) {
    const Lattice lattice = rough_lattice(3);
    std::array<float, 16> none{};
    const std::vector<std::uint8_t> levels = assign_levels(lattice, measure_errors(lattice), none);
    EXPECT_EQ(std::count(levels.begin(), levels.end(), kNeverNeeded), 0);
    std::array<float, 16> huge;
    huge.fill(1e20f);
    const std::vector<std::uint8_t> few = assign_levels(lattice, measure_errors(lattice), huge);
    EXPECT_LT(std::count_if(few.begin(), few.end(), [](std::uint8_t level) { return level != kNeverNeeded; }), 50);
}

}  // namespace
}  // namespace tedavis::host_sim
