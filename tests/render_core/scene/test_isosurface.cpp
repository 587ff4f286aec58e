#include "render_core/scene/isosurface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <set>

#include "tests/render_core/scene/post_topology.hpp"
#include "tests/support/scene/surface_topology.hpp"
#include "tests/support/scene/volume_surface.hpp"

namespace tedavis::scene::test_isosurface {
namespace {

using test_support::MadeSurface;
using test_support::noise_volume;
using test_support::PostTopology;
using test_support::sampled_volume;
using test_support::surface_of;
using test_support::SurfaceMaker;
using test_support::SurfaceTopology;
using test_support::topology_of;
using test_support::Volume;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

SurfaceTopology topology(const MadeSurface& surface) { return topology_of(surface.indices, surface.vertices.size()); }

/// A ball of radius 1 in a cube from -1.3 to 1.3, off the grid's symmetry.
struct Ball {
    glm::dvec3 middle;
    double spacing;

    explicit Ball(std::uint32_t side) : middle((side - 1) / 2.0 + 0.17, (side - 1) / 2.0 - 0.11, (side - 1) / 2.0 + 0.05) {
        spacing = 2.6 / (side - 1);
    }
    [[nodiscard]] double distance(const glm::dvec3& place) const { return spacing * glm::length(place - middle); }
    [[nodiscard]] Volume sampled(std::uint32_t side) const {
        return sampled_volume(side, side, side, [this](const glm::dvec3& p) { return 1 - distance(p); });
    }
};

/// Everything that every surface keeps to.
void expect_sound(const MadeSurface& surface, bool closed = true) {
    const SurfaceTopology found = topology(surface);
    EXPECT_EQ(found.crowded_edges, 0u);
    EXPECT_EQ(found.clashing_edges, 0u);
    EXPECT_EQ(found.collapsed, 0u);
    EXPECT_EQ(found.unused_vertices, 0u);
    EXPECT_TRUE(found.is_closed() || !closed);
    for (std::size_t n = 0; n < surface.triangles(); ++n) ASSERT_GT(glm::length(surface.across(n)), 1e-9) << "triangle " << n;
    for (const IsosurfaceVertex& vertex : surface.vertices)
        ASSERT_NEAR(glm::length(glm::dvec3(vertex.normal)), 1, 1e-6) << "which is not so for NaN";
}

TEST(Isosurface, ABallIsClosedAndFacesOutwards) {
    const Ball ball(24);
    const MadeSurface surface = surface_of(ball.sampled(24), 0);
    expect_sound(surface);
    const SurfaceTopology found = topology(surface);
    EXPECT_EQ(found.euler_number(), 2);
    EXPECT_EQ(found.pieces, 1u);
    EXPECT_EQ(surface.progress, IsosurfaceProgress::done);
    EXPECT_EQ(surface.counts.cells, 23u * 23 * 23);
    for (const IsosurfaceVertex& vertex : surface.vertices) {
        const glm::dvec3 outwards = glm::normalize(glm::dvec3(vertex.position) - ball.middle);
        EXPECT_GT(glm::dot(glm::dvec3(vertex.normal), outwards), 0.99);
    }
    for (std::size_t n = 0; n < surface.triangles(); ++n)
        EXPECT_GT(glm::dot(surface.across(n), surface.corner(n, 0) - ball.middle), 0);
}

TEST(Isosurface, ErrorsOfABallFallWithTheSquareOfTheSpacing) {
    double last_distance = 0, last_volume = 0, last_area = 0;
    for (const std::uint32_t side : {16u, 32u, 64u}) {
        const Ball ball(side);
        const MadeSurface surface = surface_of(ball.sampled(side), 0);
        double distance = 0;
        for (const IsosurfaceVertex& vertex : surface.vertices)
            distance = std::max(distance, std::abs(ball.distance(glm::dvec3(vertex.position)) - 1));
        const double scale = ball.spacing, pi = 3.14159265358979;
        const double volume = std::abs(surface.enclosed() * scale * scale * scale / (4 * pi / 3) - 1);
        const double area = std::abs(surface.area() * scale * scale / (4 * pi) - 1);
        EXPECT_LT(distance, 0.5 * scale * scale);
        if (last_distance > 0) {
            const double order = 2;
            EXPECT_NEAR(std::log2(last_distance / distance), order, 0.35);
            EXPECT_NEAR(std::log2(last_volume / volume), order, 0.2);
            EXPECT_NEAR(std::log2(last_area / area), order, 0.35);
        }
        last_distance = distance;
        last_volume = volume;
        last_area = area;
    }
}

TEST(Isosurface, ATorusHasEulerNumberZero) {
    const MadeSurface surface = surface_of(sampled_volume(40, 38, 20,
                                                          [](const glm::dvec3& p) {
                                                              const double ring = std::hypot(p.x - 19.3, p.y - 18.6) - 12;
                                                              return 5 - std::hypot(ring, p.z - 9.4);
                                                          }),
                                           0);
    expect_sound(surface);
    EXPECT_EQ(topology(surface).euler_number(), 0);
    EXPECT_EQ(topology(surface).pieces, 1u);
}

TEST(Isosurface, TouchingBallsAreOneWhereTheyShareAPostAndTwoJustAbove) {
    const Volume balls = sampled_volume(21, 11, 11, [](const glm::dvec3& p) {
        return 4 - std::min(glm::length(p - glm::dvec3(6, 5, 5)), glm::length(p - glm::dvec3(14, 5, 5)));
    });
    ASSERT_EQ(Volume(balls).at(10, 5, 5), 0) << "they touch at a post";
    for (int run = 0; run < 2; ++run) {
        const MadeSurface touching = surface_of(balls, 0), apart = surface_of(balls, 1e-6f);
        expect_sound(touching);
        expect_sound(apart);
        EXPECT_EQ(topology(touching).pieces, 1u);
        EXPECT_EQ(topology(touching).euler_number(), 2);
        EXPECT_EQ(topology(apart).pieces, 2u);
        EXPECT_EQ(topology(apart).euler_number(), 4);
    }
}

TEST(Isosurface, NoiseKeepsTheTopologyOfItsPosts) {
    for (unsigned seed = 1; seed <= 4; ++seed)
        for (const float level : {0.15f, 0.5f, 0.85f}) {
            const Volume volume = noise_volume(14, seed);
            const MadeSurface surface = surface_of(volume, level);
            expect_sound(surface);
            PostTopology oracle(volume, level);
            EXPECT_EQ(topology(surface).euler_number(), oracle.surface_euler_number());
            EXPECT_EQ(topology(surface).pieces, oracle.surface_pieces());
            EXPECT_EQ(surface.vertices.size(), oracle.crossings.size());
        }
}

TEST(Isosurface, VerticesLieWhereEdgesCrossTheLevel) {
    const Volume volume = noise_volume(9, 7);
    const MadeSurface surface = surface_of(volume, 0.4f);
    const PostTopology oracle(volume, 0.4f);
    std::set<std::array<double, 3>> found;
    for (const IsosurfaceVertex& vertex : surface.vertices) {
        const glm::dvec3 p(vertex.position);
        const auto near = oracle.crossings.lower_bound({p.x - 1e-6, p.y - 1, p.z - 1});
        bool is_there = false;
        for (auto it = near; it != oracle.crossings.end() && (*it)[0] <= p.x + 1e-6; ++it)
            if (std::abs((*it)[1] - p.y) < 1e-6 && std::abs((*it)[2] - p.z) < 1e-6) {
                is_there = true;
                found.insert(*it);
            }
        EXPECT_TRUE(is_there);
    }
    EXPECT_EQ(found.size(), oracle.crossings.size());
}

TEST(Isosurface, PlateausAtTheLevelKeepAreaAndNormals) {
    std::mt19937 random(3);
    for (const std::uint32_t far : {0u, 1900u}) {
        Volume volume(far + 12, 12, 12, -1);  // far out, floats have fewer digits left
        for (std::uint32_t z = 1; z < 11; ++z)
            for (std::uint32_t y = 1; y < 11; ++y)
                for (std::uint32_t x = far + 1; x < far + 11; ++x) volume.at(x, y, z) = static_cast<float>(random() % 3) - 1;
        const MadeSurface surface = surface_of(volume, 0);
        expect_sound(surface);
        PostTopology oracle(volume, 0);
        EXPECT_EQ(topology(surface).euler_number(), oracle.surface_euler_number());
        EXPECT_EQ(surface.vertices.size(), oracle.crossings.size());
    }
}

TEST(Isosurface, AVertexWithoutGradientTakesTheNormalOfATriangle) {
    // One thin layer of posts above the level: central differences across it vanish.
    Volume volume(8, 8, 9, -1);
    for (std::uint32_t y = 0; y < 8; ++y)
        for (std::uint32_t x = 0; x < 8; ++x) volume.at(x, y, 3) = volume.at(x, y, 5) = volume.at(x, y, 7) = 1;
    const MadeSurface surface = surface_of(volume, 0);
    expect_sound(surface, false);
    int flat = 0;
    for (const IsosurfaceVertex& vertex : surface.vertices)
        if (vertex.position.z > 4 && vertex.position.z < 5) {
            EXPECT_NEAR(vertex.normal.z, -1, 1e-6) << "towards the lower slice";
            ++flat;
        }
    EXPECT_GT(flat, 64);
}

TEST(Isosurface, EmptyAndConstantVolumesHaveNone) {
    for (const float value : {-1.0f, 0.0f, 1.0f}) {
        const MadeSurface surface = surface_of(Volume(5, 4, 3, value), 0);
        EXPECT_EQ(surface.progress, IsosurfaceProgress::done);
        EXPECT_EQ(surface.triangles(), 0u);
        EXPECT_EQ(surface.counts.cells, 4u * 3 * 2);
    }
    for (const Volume& volume : {Volume(0, 0, 0), Volume(1, 5, 5), Volume(5, 5, 1, 1)}) {
        SurfaceMaker maker(5, 5);
        ASSERT_EQ(maker.builder.begin(volume.view(), 0, {}), IsosurfaceError::none);
        EXPECT_EQ(maker.builder.step(10), IsosurfaceProgress::done);
        EXPECT_EQ(maker.builder.counts().cells, 0u);
    }
}

TEST(Isosurface, CellsWithMissingPostsStayOpen) {
    const Ball ball(16);
    const Volume whole = ball.sampled(16);
    for (const float missing : {kNan, std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()}) {
        Volume holed = whole;
        holed.at(8, 8, 12) = missing;
        const MadeSurface surface = surface_of(holed, 0), closed = surface_of(whole, 0);
        EXPECT_EQ(surface.counts.missing_cells, 8u);
        EXPECT_LT(surface.triangles(), closed.triangles());
        expect_sound(surface, false);
        EXPECT_EQ(topology(surface).split_vertices, 0u);
        EXPECT_GT(topology(surface).border_edges, 3u);
        EXPECT_EQ(topology(surface).euler_number(), 1) << "one hole in a ball";
    }
    const MadeSurface none = surface_of(Volume(6, 6, 6, kNan), 0);
    EXPECT_EQ(none.counts.missing_cells, 125u);
    EXPECT_EQ(none.triangles(), 0u);
}

TEST(Isosurface, ABorderOfTheGridIsTheOnlyPlaceThatIsOpen) {
    const MadeSurface surface =
        surface_of(sampled_volume(9, 9, 9, [](const glm::dvec3& p) { return p.z + 0.3 * p.x - 4.47; }), 0);
    const SurfaceTopology found = topology(surface);
    EXPECT_TRUE(found.is_oriented_manifold());
    EXPECT_EQ(found.euler_number(), 1) << "a disc";
    for (const IsosurfaceVertex& vertex : surface.vertices)
        EXPECT_NEAR(vertex.position.z + 0.3 * vertex.position.x, 4.47, 2e-6) << "a plane is met exactly";
}

TEST(Isosurface, StepsOfAnySizeGiveTheSameBits) {
    Volume volume = noise_volume(12, 5);
    volume.at(4, 4, 4) = kNan;
    SurfaceMaker maker(12, 12);
    const MadeSurface whole = maker.make(volume, 0.5f, ~std::uint64_t{0}, 20000, 100000);
    ASSERT_EQ(whole.progress, IsosurfaceProgress::done);
    for (const std::uint64_t step : {1u, 7u, 11u, 121u, 1000u}) {
        const MadeSurface stepped = maker.make(volume, 0.5f, step, 20000, 100000);
        ASSERT_EQ(stepped.vertices.size(), whole.vertices.size());
        EXPECT_EQ(std::memcmp(stepped.vertices.data(), whole.vertices.data(), whole.vertices.size() * sizeof(IsosurfaceVertex)),
                  0);
        EXPECT_EQ(stepped.indices, whole.indices);
        EXPECT_EQ(stepped.counts.missing_cells, whole.counts.missing_cells);
    }
}

TEST(Isosurface, AStepVisitsNoMoreThanItsCells) {
    const Volume volume = noise_volume(10, 5);
    SurfaceMaker maker(10, 10);
    MadeSurface made;
    ASSERT_EQ(maker.builder.begin(volume.view(), 0.5f, {made.vertices, made.indices}), IsosurfaceError::none);
    EXPECT_EQ(maker.builder.cells_left(), 729u);
    EXPECT_EQ(maker.builder.step(0), IsosurfaceProgress::more);
    EXPECT_EQ(maker.builder.counts().cells, 0u);
    maker.builder.step(100);
    EXPECT_EQ(maker.builder.counts().cells, 100u);
    EXPECT_EQ(maker.builder.cells_left(), 629u);
}

TEST(Isosurface, SurfacesInABuilderDoNotKnowEachOther) {
    SurfaceMaker used(14, 14), fresh(9, 9);
    ASSERT_TRUE(used.make(noise_volume(14, 1), 0.5f, 100, 30000, 200000).triangles() > 0);
    for (unsigned seed = 1; seed < 4; ++seed) {
        const MadeSurface again = used.make(noise_volume(9, seed), 0.5f, 100, 30000, 200000);
        const MadeSurface first = fresh.make(noise_volume(9, seed), 0.5f, 100, 30000, 200000);
        expect_sound(again);
        EXPECT_EQ(again.indices, first.indices);
    }
}

TEST(Isosurface, AFullOutputKeepsWholeCellsAndCountsTheRest) {
    const Volume volume = noise_volume(10, 2);
    SurfaceMaker maker(10, 10);
    const MadeSurface whole = maker.make(volume, 0.5f, 50, 20000, 100000);
    for (const auto& [vertices, indices] : {std::pair<std::size_t, std::size_t>{700, 100000}, {20000, 3001}, {0, 0}, {2, 3}}) {
        const MadeSurface cut = maker.make(volume, 0.5f, 50, vertices, indices);
        EXPECT_EQ(cut.progress, IsosurfaceProgress::full);
        EXPECT_LE(cut.vertices.size(), vertices);
        EXPECT_EQ(cut.triangles() + cut.counts.triangles_left_out, whole.triangles());
        EXPECT_EQ(topology(cut).unused_vertices, 0u);
        EXPECT_TRUE(std::equal(cut.indices.begin(), cut.indices.end(), whole.indices.begin()));
    }
    const MadeSurface fits = maker.make(volume, 0.5f, 50, whole.vertices.size(), whole.indices.size());
    EXPECT_EQ(fits.progress, IsosurfaceProgress::done);
    EXPECT_EQ(fits.indices, whole.indices);
}

TEST(Isosurface, FullIsSaidByTheStepThatMeetsIt) {
    const Volume volume = noise_volume(10, 2);
    SurfaceMaker maker(10, 10);
    std::vector<IsosurfaceVertex> vertices(50);
    std::vector<std::uint32_t> indices(300);
    ASSERT_EQ(maker.builder.begin(volume.view(), 0.5f, {vertices, indices}), IsosurfaceError::none);
    EXPECT_EQ(maker.builder.step(200), IsosurfaceProgress::full);
    EXPECT_GT(maker.builder.cells_left(), 0u);
    EXPECT_GT(maker.builder.counts().triangles_left_out, 0u);
}

TEST(Isosurface, WhatCannotBeIsRefused) {
    SurfaceMaker maker(6, 6);
    ASSERT_TRUE(maker.started());
    const Volume good(6, 6, 6), wide(7, 6, 6);
    VolumeView lacking = good.view();
    lacking.nz = 7;
    VolumeView long_one = good.view();
    long_one.nz = kMaxIsosurfaceSide + 1;
    EXPECT_EQ(maker.builder.begin(lacking, 0, {}), IsosurfaceError::wrong_number_of_values);
    EXPECT_EQ(maker.builder.begin(long_one, 0, {}), IsosurfaceError::side_too_long);
    EXPECT_EQ(maker.builder.begin(wide.view(), 0, {}), IsosurfaceError::memory_too_small);
    EXPECT_EQ(maker.builder.begin(good.view(), kNan, {}), IsosurfaceError::level_not_finite);
    EXPECT_EQ(maker.builder.step(100), IsosurfaceProgress::done) << "nothing was begun";
    std::vector<std::uint8_t> memory(IsosurfaceBuilder::bytes_needed(6, 6) - 100);
    base::Arena arena(memory.data(), memory.size());
    IsosurfaceBuilder builder;
    EXPECT_FALSE(builder.start(arena, 6, 6));
    EXPECT_FALSE(builder.start(arena, kMaxIsosurfaceSide + 1, 1));
    EXPECT_EQ(builder.begin(good.view(), 0, {}), IsosurfaceError::memory_too_small);
}

TEST(Isosurface, ExtremeValuesStayFinite) {
    const float most = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
    for (const auto& [low, high] : {std::pair<float, float>{-most, most}, {0, least}, {-least, 0}}) {
        Volume volume(6, 6, 6, low);
        volume.at(2, 3, 3) = volume.at(3, 3, 3) = high;
        const MadeSurface surface = surface_of(volume, high);
        expect_sound(surface);
        EXPECT_EQ(topology(surface).euler_number(), 2);
    }
}

TEST(Isosurface, TheCheckFindsAFlippedTriangleAndOneThatIsGone) {
    MadeSurface surface = surface_of(Ball(12).sampled(12), 0);
    ASSERT_TRUE(topology(surface).is_closed());
    std::swap(surface.indices[30], surface.indices[31]);
    EXPECT_EQ(topology(surface).clashing_edges, 3u);
    EXPECT_FALSE(topology(surface).is_oriented_manifold());
    surface.indices.erase(surface.indices.begin() + 30, surface.indices.begin() + 33);
    EXPECT_EQ(topology(surface).clashing_edges, 0u);
    EXPECT_EQ(topology(surface).border_edges, 3u);
    EXPECT_FALSE(topology(surface).is_closed());
}

}  // namespace
}  // namespace tedavis::scene::test_isosurface
