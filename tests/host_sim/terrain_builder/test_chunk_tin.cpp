#include "host_sim/terrain_builder/chunk_tin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/host_sim/terrain_builder/tin_check.hpp"

namespace tedavis::host_sim::test_chunk_tin {
namespace {

using terrain::PostClass;
using test_support::expect_sound_tin;
using test_support::largest_tin_error_m;
using test_support::same_post;
using test_support::same_tin;
using test_support::tin_ground;
using test_support::tin_ground_input;
using test_support::tin_input_of;
using test_support::tin_triangles_of;
using test_support::TinHeight;
using test_support::TinTriangle;

TEST(ChunkTin, APlaneNeedsNoVertexButTheBorder) {
    TinInput input = tin_input_of(64, 48, 8, [](double i, double j) { return 3 * i - 2 * j + 11; });
    input.tolerance_m = 0.01;
    const Tin tin = make_chunk_tin(input);
    EXPECT_EQ(tin.vertices.size(), input.border.size());
    EXPECT_NEAR(tin.candidate_error_m, 0, 1e-9);
    expect_sound_tin(input, tin);
    input.candidates[1000].height_m += 1;
    const Tin bent = make_chunk_tin(input);
    EXPECT_GT(bent.vertices.size(), input.border.size()) << "a control: one post off the plane";
    EXPECT_LE(largest_tin_error_m(input, bent), 0.01);
}

TEST(ChunkTin, NoPostIsFurtherFromTheMeshThanTheTolerance) {
    std::size_t before = 0;
    for (const double tolerance_m : {60.0, 20.0, 6.0}) {
        const TinInput input = tin_ground_input(tolerance_m);
        const Tin tin = make_chunk_tin(input);
        expect_sound_tin(input, tin);
        EXPECT_NEAR(tin.candidate_error_m, largest_tin_error_m(input, tin), 1e-9);
        EXPECT_LE(tin.candidate_error_m, tolerance_m);
        EXPECT_GT(tin.vertices.size(), before) << "a finer mesh has more";
        before = tin.vertices.size();
        TinInput tampered = input;
        tampered.candidates[5000].height_m += 2 * static_cast<float>(tolerance_m);
        EXPECT_GT(largest_tin_error_m(tampered, tin), tolerance_m) << "a control: the oracle sees a changed height";
    }
    EXPECT_LT(before, 127u * 127u / 2) << "not simply every post";
}

TEST(ChunkTin, WithNoToleranceEveryPostThatBendsIsAVertex) {
    std::mt19937 random(5);
    TinInput input = tin_input_of(24, 24, 24, [&](double, double) { return random() % 1000; });
    const Tin tin = make_chunk_tin(input);
    expect_sound_tin(input, tin);
    EXPECT_EQ(tin.candidate_error_m, 0);
    EXPECT_GT(tin.vertices.size(), 4 + 23u * 23u * 95 / 100);
}

TEST(ChunkTin, DoesNotDependOnTheOrderOfCandidatesNorOnRepeatedOnes) {
    TinInput input = tin_ground_input(4);
    const Tin tin = make_chunk_tin(input);
    std::mt19937 random(6);
    std::shuffle(input.candidates.begin(), input.candidates.end(), random);
    EXPECT_TRUE(same_tin(tin, make_chunk_tin(input)));
    const std::vector<TinPost> once = input.candidates;
    input.candidates.insert(input.candidates.end(), once.begin(), once.end());
    input.candidates.insert(input.candidates.end(), input.border.begin(), input.border.end());
    input.candidates.push_back({50, 0, 1e6f, PostClass::land});
    EXPECT_TRUE(same_tin(tin, make_chunk_tin(input))) << "candidates on the sides are left out";
}

TEST(ChunkTin, MirroredAndTurnedGroundNeedsAsManyTriangles) {
    const auto size_of = [](const TinHeight& height) {
        TinInput input = tin_input_of(128, 128, 4, height);
        input.tolerance_m = 3;
        const Tin tin = make_chunk_tin(input);
        expect_sound_tin(input, tin);
        return static_cast<double>(tin.triangles.size());
    };
    const double straight = size_of([](std::uint32_t i, std::uint32_t j) { return tin_ground().at(i, j); });
    // Ties fall differently: not exactly as many.
    EXPECT_NEAR(size_of([](std::uint32_t i, std::uint32_t j) { return tin_ground().at(128 - i, j); }), straight, 0.02 * straight);
    EXPECT_NEAR(size_of([](std::uint32_t i, std::uint32_t j) { return tin_ground().at(j, 128 - i); }), straight, 0.02 * straight);
    EXPECT_NEAR(size_of([](std::uint32_t i, std::uint32_t j) { return -tin_ground().at(i, j); }), straight, 0.02 * straight);
}

TEST(ChunkTin, TheCapacityIsKept) {
    TinInput input = tin_ground_input(1);
    const Tin whole = make_chunk_tin(input);
    for (const std::uint32_t capacity : {0u, 129u, 200u, 1000u}) {
        input.max_vertices = capacity;
        const Tin tin = make_chunk_tin(input);
        expect_sound_tin(input, tin);
        EXPECT_EQ(tin.vertices.size(), std::max<std::size_t>(capacity, input.border.size()));
        EXPECT_GT(tin.candidate_error_m, 1);
        EXPECT_NEAR(tin.candidate_error_m, largest_tin_error_m(input, tin), 1e-9) << "it says what it could not do";
        EXPECT_TRUE(std::equal(tin.vertices.begin(), tin.vertices.end(), whole.vertices.begin(), same_post));
    }
}

double sagitta_m(const void* radius_m, std::uint32_t posts_east, std::uint32_t posts_south, std::uint32_t) {
    const double chord_m = 30 * std::hypot(posts_east, posts_south);
    return chord_m * chord_m / (8 * *static_cast<const double*>(radius_m));
}

TEST(ChunkTin, TrianglesTooLargeForTheCurvedEarthAreSplit) {
    TinInput input = tin_input_of(512, 512, 64, [](double, double) { return 0; });
    const double radius_m = 6371000;
    input.tolerance_m = 0.5;
    EXPECT_EQ(make_chunk_tin(input).vertices.size(), input.border.size()) << "a control: no curvature, no split";
    input.curvature_m = sagitta_m;
    input.context = &radius_m;
    const Tin tin = make_chunk_tin(input);
    expect_sound_tin(input, tin);
    EXPECT_LE(tin.candidate_error_m, 0.5);
    EXPECT_LT(tin.vertices.size(), input.border.size() + 80);
    for (const TinTriangle& t : tin_triangles_of(tin)) {
        const auto [west, east] = std::minmax({t.a.i, t.b.i, t.c.i});
        const auto [north, south] = std::minmax({t.a.j, t.b.j, t.c.j});
        EXPECT_LE(sagitta_m(&radius_m, east - west, south - north, 0), 0.5);
    }
}

TEST(ChunkTin, CurvatureAddsToWhatLiesBelowOnly) {
    const double flat_m = 2;
    const auto count = [&](double height_m) {
        TinInput input = tin_input_of(8, 8, 1, [&](std::uint32_t i, std::uint32_t j) { return i == 4 && j == 4 ? height_m : 0; });
        input.tolerance_m = 3;
        input.curvature_m = [](const void* sagitta, std::uint32_t, std::uint32_t, std::uint32_t) {
            return *static_cast<const double*>(sagitta);
        };
        input.context = &flat_m;
        return make_chunk_tin(input).vertices.size() - input.border.size();
    };
    EXPECT_EQ(count(1.5), 1u) << "the mesh can lie 3.5 m below the hill";
    EXPECT_EQ(count(-1.5), 0u) << "but not that far from the hollow";
    EXPECT_GT(count(-3.5), 0u);
}

TEST(ChunkTin, ALargeChunkOfManyPosts) {
    const auto wave = [](double i, double j) {
        return 40 * std::sin(i / 90) * std::cos(j / 70) + 10 * std::sin((i + 2 * j) / 23);
    };
    TinInput input = tin_input_of(1024, 512, 32, wave);
    input.tolerance_m = 4;
    input.max_vertices = 3072;
    const Tin tin = make_chunk_tin(input);
    expect_sound_tin(input, tin);
    EXPECT_LE(tin.candidate_error_m, 4);
    EXPECT_LT(tin.vertices.size(), 3072u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_chunk_tin
