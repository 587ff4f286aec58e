#include "host_sim/terrain_builder/chunk_tin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "host_sim/terrain_builder/surface_error.hpp"
#include "tests/support/fractal_square.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::PostClass;
using Height = std::function<double(std::uint32_t, std::uint32_t)>;

/// A chunk with every post a candidate and every `step`-th border post a vertex.
TinInput input_of(std::uint32_t last_i, std::uint32_t last_j, std::uint32_t step, const Height& height) {
    TinInput input;
    input.last_i = last_i;
    input.last_j = last_j;
    input.max_vertices = 65536;
    const auto post = [&](std::uint32_t i, std::uint32_t j) {
        return TinPost{static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j), static_cast<float>(height(i, j)),
                       PostClass::land};
    };
    for (std::uint32_t i = 0; i < last_i; i += step) input.border.push_back(post(i, 0));
    for (std::uint32_t j = 0; j < last_j; j += step) input.border.push_back(post(last_i, j));
    for (std::uint32_t i = last_i; i > 0; i -= std::min(i, step)) input.border.push_back(post(i, last_j));
    for (std::uint32_t j = last_j; j > 0; j -= std::min(j, step)) input.border.push_back(post(0, j));
    for (std::uint32_t j = 1; j < last_j; ++j)
        for (std::uint32_t i = 1; i < last_i; ++i) input.candidates.push_back(post(i, j));
    return input;
}

const test_support::FractalSquare& fractal() {
    static const test_support::FractalSquare terrain = test_support::fractal_square(129, 7);
    return terrain;
}

TinInput fractal_input(double tolerance_m, std::uint32_t step = 4) {
    TinInput input = input_of(128, 128, step, [](std::uint32_t i, std::uint32_t j) { return fractal().at(i, j); });
    input.tolerance_m = tolerance_m;
    return input;
}

struct Triangle {
    TinPost a, b, c;
};

std::vector<Triangle> triangles_of(const Tin& tin) {
    std::vector<Triangle> triangles;
    for (std::size_t n = 0; n < tin.triangles.size(); n += 3)
        triangles.push_back(
            {tin.vertices[tin.triangles[n]], tin.vertices[tin.triangles[n + 1]], tin.vertices[tin.triangles[n + 2]]});
    return triangles;
}

/// Twice the area, positive when counter-clockwise seen from above: j runs south.
std::int64_t turn_of(const TinPost& a, const TinPost& b, const TinPost& c) {
    return (std::int64_t{b.j} - a.j) * (std::int64_t{c.i} - a.i) - (std::int64_t{b.i} - a.i) * (std::int64_t{c.j} - a.j);
}

bool holds(const Triangle& t, const TinPost& p) {
    return turn_of(t.a, t.b, p) >= 0 && turn_of(t.b, t.c, p) >= 0 && turn_of(t.c, t.a, p) >= 0;
}

/// Oracle: every triangle at every post that it holds, by barycentric coordinates.
double largest_error_m(const TinInput& input, const Tin& tin) {
    std::map<std::pair<int, int>, const TinPost*> posts;
    for (const TinPost& p : input.candidates) posts[{p.j, p.i}] = &p;
    long double largest = 0;
    for (const Triangle& t : triangles_of(tin)) {
        const auto [north, south] = std::minmax({t.a.j, t.b.j, t.c.j});
        for (auto at = posts.lower_bound({north, 0}); at != posts.end() && at->first.first <= south; ++at) {
            const TinPost& p = *at->second;
            if (p.post_class == PostClass::void_ || !holds(t, p)) continue;
            const auto area = static_cast<long double>(turn_of(t.a, t.b, t.c));
            const long double drawn = (t.a.height_m * static_cast<long double>(turn_of(p, t.b, t.c)) +
                                       t.b.height_m * static_cast<long double>(turn_of(t.a, p, t.c)) +
                                       t.c.height_m * static_cast<long double>(turn_of(t.a, t.b, p))) /
                                      area;
            largest = std::max(largest, std::abs(drawn - p.height_m));
        }
    }
    return static_cast<double>(largest);
}

bool same_post(const TinPost& a, const TinPost& b) {
    return a.i == b.i && a.j == b.j && a.height_m == b.height_m && a.post_class == b.post_class;
}

bool same_tin(const Tin& a, const Tin& b) {
    return a.triangles == b.triangles && a.candidate_error_m == b.candidate_error_m && a.vertices.size() == b.vertices.size() &&
           std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), same_post);
}

void expect_sound(const TinInput& input, const Tin& tin) {
    ASSERT_LE(tin.vertices.size(), std::max<std::size_t>(input.max_vertices, input.border.size()));
    ASSERT_TRUE(std::equal(input.border.begin(), input.border.end(), tin.vertices.begin(), same_post)) << "the border first";
    for (std::size_t n = input.border.size(); n < tin.vertices.size(); ++n) {
        const TinPost& v = tin.vertices[n];
        ASSERT_TRUE(v.i > 0 && v.j > 0 && v.i < input.last_i && v.j < input.last_j) << "a new vertex on a side";
    }
    std::int64_t area = 0;
    std::set<std::pair<std::uint16_t, std::uint16_t>> sides;
    for (std::size_t n = 0; n < tin.triangles.size(); n += 3) {
        const std::uint16_t* t = &tin.triangles[n];
        const std::int64_t own = turn_of(tin.vertices[t[0]], tin.vertices[t[1]], tin.vertices[t[2]]);
        ASSERT_GT(own, 0);
        area += own;
        for (int k = 0; k < 3; ++k) ASSERT_TRUE(sides.insert({t[k], t[(k + 1) % 3]}).second);
    }
    EXPECT_EQ(area, 2 * std::int64_t{input.last_i} * input.last_j);
    EXPECT_EQ(tin.triangles.size() / 3, 2 * tin.vertices.size() - 2 - input.border.size()) << "Euler";
    for (std::size_t n = 0; n < input.border.size(); ++n) {
        const auto a = static_cast<std::uint16_t>(n), b = static_cast<std::uint16_t>((n + 1) % input.border.size());
        EXPECT_TRUE(sides.count({b, a}) == 1 && sides.count({a, b}) == 0) << "neighbours of the border share a side";
    }
}

TEST(ChunkTin, APlaneNeedsNoVertexButTheBorder) {
    TinInput input = input_of(64, 48, 8, [](double i, double j) { return 3 * i - 2 * j + 11; });
    input.tolerance_m = 0.01;
    const Tin tin = make_chunk_tin(input);
    EXPECT_EQ(tin.vertices.size(), input.border.size());
    EXPECT_NEAR(tin.candidate_error_m, 0, 1e-9);
    expect_sound(input, tin);
    input.candidates[1000].height_m += 1;
    const Tin bent = make_chunk_tin(input);
    EXPECT_GT(bent.vertices.size(), input.border.size()) << "a control: one post off the plane";
    EXPECT_LE(largest_error_m(input, bent), 0.01);
}

TEST(ChunkTin, NoPostIsFurtherFromTheMeshThanTheTolerance) {
    std::size_t before = 0;
    for (const double tolerance_m : {60.0, 20.0, 6.0}) {
        const TinInput input = fractal_input(tolerance_m);
        const Tin tin = make_chunk_tin(input);
        expect_sound(input, tin);
        EXPECT_NEAR(tin.candidate_error_m, largest_error_m(input, tin), 1e-9);
        EXPECT_LE(tin.candidate_error_m, tolerance_m);
        EXPECT_GT(tin.vertices.size(), before) << "a finer mesh has more";
        before = tin.vertices.size();
        TinInput tampered = input;
        tampered.candidates[5000].height_m += 2 * static_cast<float>(tolerance_m);
        EXPECT_GT(largest_error_m(tampered, tin), tolerance_m) << "a control: the oracle sees a changed height";
    }
    EXPECT_LT(before, 127u * 127u / 2) << "not simply every post";
}

TEST(ChunkTin, WithNoToleranceEveryPostThatBendsIsAVertex) {
    std::mt19937 random(5);
    TinInput input = input_of(24, 24, 24, [&](double, double) { return random() % 1000; });
    const Tin tin = make_chunk_tin(input);
    expect_sound(input, tin);
    EXPECT_EQ(tin.candidate_error_m, 0);
    EXPECT_GT(tin.vertices.size(), 4 + 23u * 23u * 95 / 100);
}

TEST(ChunkTin, DoesNotDependOnTheOrderOfCandidatesNorOnRepeatedOnes) {
    TinInput input = fractal_input(4);
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
    const auto size_of = [](const Height& height) {
        TinInput input = input_of(128, 128, 4, height);
        input.tolerance_m = 3;
        const Tin tin = make_chunk_tin(input);
        expect_sound(input, tin);
        return static_cast<double>(tin.triangles.size());
    };
    const double straight = size_of([](std::uint32_t i, std::uint32_t j) { return fractal().at(i, j); });
    // Ties fall differently: not exactly as many.
    EXPECT_NEAR(size_of([](std::uint32_t i, std::uint32_t j) { return fractal().at(128 - i, j); }), straight, 0.02 * straight);
    EXPECT_NEAR(size_of([](std::uint32_t i, std::uint32_t j) { return fractal().at(j, 128 - i); }), straight, 0.02 * straight);
    EXPECT_NEAR(size_of([](std::uint32_t i, std::uint32_t j) { return -fractal().at(i, j); }), straight, 0.02 * straight);
}

TEST(ChunkTin, TheCapacityIsKept) {
    TinInput input = fractal_input(1);
    const Tin whole = make_chunk_tin(input);
    for (const std::uint32_t capacity : {0u, 129u, 200u, 1000u}) {
        input.max_vertices = capacity;
        const Tin tin = make_chunk_tin(input);
        expect_sound(input, tin);
        EXPECT_EQ(tin.vertices.size(), std::max<std::size_t>(capacity, input.border.size()));
        EXPECT_GT(tin.candidate_error_m, 1);
        EXPECT_NEAR(tin.candidate_error_m, largest_error_m(input, tin), 1e-9) << "it says what it could not do";
        EXPECT_TRUE(std::equal(tin.vertices.begin(), tin.vertices.end(), whole.vertices.begin(), same_post));
    }
}

/// Triangles that hold void candidates inside and have no void corner.
std::size_t hidden_voids(const TinInput& input, const Tin& tin) {
    std::size_t hidden = 0;
    for (const Triangle& t : triangles_of(tin)) {
        const bool shown =
            t.a.post_class == PostClass::void_ || t.b.post_class == PostClass::void_ || t.c.post_class == PostClass::void_;
        for (const TinPost& p : input.candidates)
            hidden += !shown && p.post_class == PostClass::void_ && turn_of(t.a, t.b, p) > 0 && turn_of(t.b, t.c, p) > 0 &&
                              turn_of(t.c, t.a, p) > 0
                          ? 1
                          : 0;
    }
    return hidden;
}

TEST(ChunkTin, TrianglesOverVoidsHaveAVoidVertex) {
    TinInput input = fractal_input(10);
    for (TinPost& post : input.candidates) {
        const int di = post.i - 70, dj = post.j - 40;
        const bool lake = di * di + 3 * dj * dj < 900, alone = (post.i * 7 + post.j * 13) % 401 == 0;
        if (lake || alone) post.post_class = PostClass::void_;
        if (lake) post.height_m = 5000;  // filled anyhow: no error
    }
    const Tin tin = make_chunk_tin(input);
    expect_sound(input, tin);
    EXPECT_EQ(hidden_voids(input, tin), 0u);
    EXPECT_LE(largest_error_m(input, tin), 10);
    std::size_t void_vertices = 0;
    for (const TinPost& v : tin.vertices) void_vertices += v.post_class == PostClass::void_ ? 1 : 0;
    EXPECT_LT(void_vertices, 700u) << "not all of the 1632 voids";
    TinInput shuffled = input;
    std::mt19937 random(8);
    std::shuffle(shuffled.candidates.begin(), shuffled.candidates.end(), random);
    EXPECT_TRUE(same_tin(tin, make_chunk_tin(shuffled)));
    input.max_vertices = 140;
    EXPECT_GT(hidden_voids(input, make_chunk_tin(input)), 0u) << "a control: the capacity does not reach";
}

TEST(ChunkTin, AVoidEverywhereIsNoReasonToRefine) {
    TinInput input = input_of(32, 32, 32, [](double i, double) { return 100 * std::sin(i); });
    for (TinPost& post : input.candidates) post.post_class = PostClass::void_;
    const Tin tin = make_chunk_tin(input);
    expect_sound(input, tin);
    EXPECT_EQ(tin.vertices.size(), 5u) << "one vertex shows all triangles";
    EXPECT_EQ(tin.vertices[4].i, 11) << "nearest to a triangle's middle";
    EXPECT_EQ(tin.vertices[4].j, 11);
    for (TinPost& post : input.border) post.post_class = PostClass::void_;
    EXPECT_EQ(make_chunk_tin(input).vertices.size(), 4u);
}

TEST(ChunkTin, OfTwoVoidsEquallyNearTheNorthernOneIsTaken) {
    TinInput input = input_of(32, 32, 32, [](double, double) { return 0; });
    const TinPost north{12, 10, 0, PostClass::void_}, south{10, 12, 0, PostClass::void_};
    for (const auto& candidates : {std::vector<TinPost>{north, south}, std::vector<TinPost>{south, north}}) {
        input.candidates = candidates;
        const Tin tin = make_chunk_tin(input);
        ASSERT_EQ(tin.vertices.size(), 5u);
        EXPECT_TRUE(same_post(tin.vertices[4], north));
    }
}

double sagitta_m(const void* radius_m, std::uint32_t posts_east, std::uint32_t posts_south, std::uint32_t) {
    const double chord_m = 30 * std::hypot(posts_east, posts_south);
    return chord_m * chord_m / (8 * *static_cast<const double*>(radius_m));
}

TEST(ChunkTin, TrianglesTooLargeForTheCurvedEarthAreSplit) {
    TinInput input = input_of(512, 512, 64, [](double, double) { return 0; });
    const double radius_m = 6371000;
    input.tolerance_m = 0.5;
    EXPECT_EQ(make_chunk_tin(input).vertices.size(), input.border.size()) << "a control: no curvature, no split";
    input.curvature_m = sagitta_m;
    input.context = &radius_m;
    const Tin tin = make_chunk_tin(input);
    expect_sound(input, tin);
    EXPECT_LE(tin.candidate_error_m, 0.5);
    EXPECT_LT(tin.vertices.size(), input.border.size() + 80);
    for (const Triangle& t : triangles_of(tin)) {
        const auto [west, east] = std::minmax({t.a.i, t.b.i, t.c.i});
        const auto [north, south] = std::minmax({t.a.j, t.b.j, t.c.j});
        EXPECT_LE(sagitta_m(&radius_m, east - west, south - north, 0), 0.5);
    }
}

TEST(ChunkTin, CurvatureAddsToWhatLiesBelowOnly) {
    const double flat_m = 2;
    const auto count = [&](double height_m) {
        TinInput input = input_of(8, 8, 1, [&](std::uint32_t i, std::uint32_t j) { return i == 4 && j == 4 ? height_m : 0; });
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
        for (const Triangle& t : triangles_of(tin)) worst = std::max(worst, error(t.a, t.b, t.c).error.largest_m());
        return worst;
    }
    static TinMiss miss(const void* truth, const TinPost& a, const TinPost& b, const TinPost& c) {
        const PlacedError placed = static_cast<const Truth*>(truth)->error(a, b, c);
        return {placed.error.largest_m(), placed.i, placed.j};
    }
};

TEST(ChunkTin, MissesBetweenPostsAreMended) {
    const Truth truth(129, fractal().height_m);
    for (const double tolerance_m : {20.0, 6.0, 2.0}) {
        TinInput input = fractal_input(tolerance_m, 1);
        const Tin without = make_chunk_tin(input);
        EXPECT_GT(truth.worst_m(without), 1.05 * tolerance_m) << "a control: near at posts is not near everywhere";
        input.miss = Truth::miss;
        input.context = &truth;
        input.miss_tolerance_m = tolerance_m;
        const Tin tin = make_chunk_tin(input);
        expect_sound(input, tin);
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
        TinInput input = input_of(40, 40, 1, [&](std::uint32_t i, std::uint32_t j) { return heights[j * 41 + i]; });
        input.tolerance_m = input.miss_tolerance_m = 5.0 * seed;
        input.miss = Truth::miss;
        input.context = &truth;
        ASSERT_LE(truth.worst_m(make_chunk_tin(input)), input.miss_tolerance_m) << seed;
    }
}

TEST(ChunkTin, AMissIsFollowedUntilNoCandidateIsLeft) {
    // The triangle at the north-west corner misses, and no candidate is near enough to change it.
    TinInput input = input_of(8, 8, 1, [](double, double) { return 0; });
    input.candidates = {{5, 5, 0, PostClass::land}, {6, 6, 0, PostClass::land}};
    input.miss_tolerance_m = 1;
    input.miss = [](const void*, const TinPost& a, const TinPost& b, const TinPost& c) {
        const bool at_corner = a.i + a.j == 0 || b.i + b.j == 0 || c.i + c.j == 0;
        return TinMiss{at_corner ? 2.0 : 1.0, 0, 0};
    };
    const Tin tin = make_chunk_tin(input);
    expect_sound(input, tin);
    ASSERT_EQ(tin.vertices.size(), input.border.size() + 2);
    EXPECT_EQ(tin.vertices[input.border.size()].i, 5) << "the nearest first";
}

TEST(ChunkTin, MissesAwayFromAllCandidatesAreMendedWithTheNearest) {
    // Candidates are those of a coarser mesh; the truth has all posts.
    const Truth truth(129, fractal().height_m);
    TinInput input = fractal_input(6, 2);
    const Tin finer = make_chunk_tin(fractal_input(3, 2));
    input.candidates.assign(finer.vertices.begin() + static_cast<std::ptrdiff_t>(input.border.size()), finer.vertices.end());
    const Tin blind = make_chunk_tin(input);
    input.miss = Truth::miss;
    input.context = &truth;
    input.miss_tolerance_m = 8;
    const Tin tin = make_chunk_tin(input);
    expect_sound(input, tin);
    EXPECT_GT(tin.vertices.size(), blind.vertices.size());
    EXPECT_LE(truth.worst_m(tin), std::max(8.0, truth.worst_m(finer)) + 1e-9);
    EXPECT_GT(truth.worst_m(blind), truth.worst_m(tin)) << "a control";
    input.miss_tolerance_m = 0;
    EXPECT_EQ(make_chunk_tin(input).vertices.size(), finer.vertices.size()) << "ends when all are taken";
}

TEST(ChunkTin, ALargeChunkOfManyPosts) {
    const auto wave = [](double i, double j) {
        return 40 * std::sin(i / 90) * std::cos(j / 70) + 10 * std::sin((i + 2 * j) / 23);
    };
    TinInput input = input_of(1024, 512, 32, wave);
    input.tolerance_m = 4;
    input.max_vertices = 3072;
    const Tin tin = make_chunk_tin(input);
    expect_sound(input, tin);
    EXPECT_LE(tin.candidate_error_m, 4);
    EXPECT_LT(tin.vertices.size(), 3072u);
}

}  // namespace
}  // namespace tedavis::host_sim
