// Triangulations of chunks that are held against the surface between the posts.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "host_sim/terrain_builder/surface_error.hpp"
#include "tests/host_sim/terrain_builder/tin_check.hpp"

namespace tedavis::host_sim::test_chunk_tin_misses {
namespace {

using terrain::PostClass;
using test_support::expect_sound_tin;
using test_support::tin_ground;
using test_support::tin_ground_input;
using test_support::tin_input_of;
using test_support::tin_triangles_of;
using test_support::TinTriangle;

/// The true surface of a chunk.
struct Truth {
    std::uint32_t posts;  // a side
    std::vector<float> surface_m;
    std::vector<PostClass> classes;

    explicit Truth(std::uint32_t side, std::vector<float> heights)
        : posts(side), surface_m(std::move(heights)), classes(surface_m.size(), PostClass::land) {}

    [[nodiscard]] PlacedError error(const TinPost& a, const TinPost& b, const TinPost& c) const {
        const PostWindowView view{0, 0, posts, posts, surface_m.data(), classes.data()};
        return placed_triangle_error(view, {a.i, a.j, a.height_m}, {b.i, b.j, b.height_m}, {c.i, c.j, c.height_m});
    }
    [[nodiscard]] double worst_m(const Tin& tin) const {
        double worst = 0;
        for (const TinTriangle& t : tin_triangles_of(tin)) worst = std::max(worst, error(t.a, t.b, t.c).error.largest_m());
        return worst;
    }
    static TinMiss miss(const void* truth, const TinPost& a, const TinPost& b, const TinPost& c) {
        const PlacedError placed = static_cast<const Truth*>(truth)->error(a, b, c);
        return {placed.error.largest_m(), placed.i, placed.j};
    }
};

TEST(ChunkTin, MissesBetweenPostsAreMended) {
    const Truth truth(129, tin_ground().height_m);
    for (const double tolerance_m : {20.0, 6.0, 2.0}) {
        TinInput input = tin_ground_input(tolerance_m, 1);
        const Tin without = make_chunk_tin(input);
        EXPECT_GT(truth.worst_m(without), 1.05 * tolerance_m) << "a control: near at posts is not near everywhere";
        input.miss = Truth::miss;
        input.context = &truth;
        input.miss_tolerance_m = tolerance_m;
        const Tin tin = make_chunk_tin(input);
        expect_sound_tin(input, tin);
        EXPECT_LE(truth.worst_m(tin), tolerance_m);
        EXPECT_LE(tin.candidate_error_m, tolerance_m);
        EXPECT_LT(tin.triangles.size(), 1.4 * static_cast<double>(without.triangles.size()));
        input.max_vertices = static_cast<std::uint32_t>(without.vertices.size()) + 5;
        EXPECT_EQ(make_chunk_tin(input).vertices.size(), input.max_vertices);
    }
}

TEST(ChunkTin, MissesAreMendedWhereverTheGroundIsRough) {
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        std::mt19937 random(seed);
        std::vector<float> heights;
        for (int n = 0; n < 41 * 41; ++n) heights.push_back(static_cast<float>(random() % 100 * (random() % 8 == 0 ? 10 : 1)));
        const Truth truth(41, heights);
        TinInput input = tin_input_of(40, 40, 1, [&](std::uint32_t i, std::uint32_t j) { return heights[j * 41 + i]; });
        input.tolerance_m = input.miss_tolerance_m = 5.0 * seed;
        input.miss = Truth::miss;
        input.context = &truth;
        ASSERT_LE(truth.worst_m(make_chunk_tin(input)), input.miss_tolerance_m) << seed;
    }
}

TEST(ChunkTin, AMissIsFollowedUntilNoCandidateIsLeft) {
    // The triangle at the north-west corner misses, and no candidate is near enough to change it.
    TinInput input = tin_input_of(8, 8, 1, [](double, double) { return 0; });
    input.candidates = {{5, 5, 0, PostClass::land}, {6, 6, 0, PostClass::land}};
    input.miss_tolerance_m = 1;
    input.miss = [](const void*, const TinPost& a, const TinPost& b, const TinPost& c) {
        const bool at_corner = a.i + a.j == 0 || b.i + b.j == 0 || c.i + c.j == 0;
        return TinMiss{at_corner ? 2.0 : 1.0, 0, 0};
    };
    const Tin tin = make_chunk_tin(input);
    expect_sound_tin(input, tin);
    ASSERT_EQ(tin.vertices.size(), input.border.size() + 2);
    EXPECT_EQ(tin.vertices[input.border.size()].i, 5) << "the nearest first";
}

TEST(ChunkTin, MissesAwayFromAllCandidatesAreMendedWithTheNearest) {
    // Candidates are those of a coarser mesh; the truth has all posts.
    const Truth truth(129, tin_ground().height_m);
    TinInput input = tin_ground_input(6, 2);
    const Tin finer = make_chunk_tin(tin_ground_input(3, 2));
    input.candidates.assign(finer.vertices.begin() + static_cast<std::ptrdiff_t>(input.border.size()), finer.vertices.end());
    const Tin blind = make_chunk_tin(input);
    input.miss = Truth::miss;
    input.context = &truth;
    input.miss_tolerance_m = 8;
    const Tin tin = make_chunk_tin(input);
    expect_sound_tin(input, tin);
    EXPECT_GT(tin.vertices.size(), blind.vertices.size());
    EXPECT_LE(truth.worst_m(tin), std::max(8.0, truth.worst_m(finer)) + 1e-9);
    EXPECT_GT(truth.worst_m(blind), truth.worst_m(tin)) << "a control";
    input.miss_tolerance_m = 0;
    EXPECT_EQ(make_chunk_tin(input).vertices.size(), finer.vertices.size()) << "ends when all are taken";
}

}  // namespace
}  // namespace tedavis::host_sim::test_chunk_tin_misses
