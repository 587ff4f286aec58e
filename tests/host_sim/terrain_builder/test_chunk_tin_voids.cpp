// Triangulations of chunks that have posts without data.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/host_sim/terrain_builder/tin_check.hpp"

namespace tedavis::host_sim::test_chunk_tin_voids {
namespace {

using terrain::PostClass;
using test_support::expect_sound_tin;
using test_support::largest_tin_error_m;
using test_support::same_post;
using test_support::same_tin;
using test_support::tin_ground_input;
using test_support::tin_input_of;
using test_support::tin_triangles_of;
using test_support::TinTriangle;
using test_support::turn_of;

/// Triangles that hold void candidates inside and have no void corner.
std::size_t hidden_voids(const TinInput& input, const Tin& tin) {
    std::size_t hidden = 0;
    for (const TinTriangle& t : tin_triangles_of(tin)) {
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
    TinInput input = tin_ground_input(10);
    for (TinPost& post : input.candidates) {
        const int di = post.i - 70, dj = post.j - 40;
        const bool lake = di * di + 3 * dj * dj < 900, alone = (post.i * 7 + post.j * 13) % 401 == 0;
        if (lake || alone) post.post_class = PostClass::void_;
        if (lake) post.height_m = 5000;  // filled anyhow: no error
    }
    const Tin tin = make_chunk_tin(input);
    expect_sound_tin(input, tin);
    EXPECT_EQ(hidden_voids(input, tin), 0u);
    EXPECT_LE(largest_tin_error_m(input, tin), 10);
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
    TinInput input = tin_input_of(32, 32, 32, [](double i, double) { return 100 * std::sin(i); });
    for (TinPost& post : input.candidates) post.post_class = PostClass::void_;
    const Tin tin = make_chunk_tin(input);
    expect_sound_tin(input, tin);
    EXPECT_EQ(tin.vertices.size(), 5u) << "one vertex shows all triangles";
    EXPECT_EQ(tin.vertices[4].i, 11) << "nearest to a triangle's middle";
    EXPECT_EQ(tin.vertices[4].j, 11);
    for (TinPost& post : input.border) post.post_class = PostClass::void_;
    EXPECT_EQ(make_chunk_tin(input).vertices.size(), 4u);
}

TEST(ChunkTin, OfTwoVoidsEquallyNearTheNorthernOneIsTaken) {
    TinInput input = tin_input_of(32, 32, 32, [](double, double) { return 0; });
    const TinPost north{12, 10, 0, PostClass::void_}, south{10, 12, 0, PostClass::void_};
    for (const auto& candidates : {std::vector<TinPost>{north, south}, std::vector<TinPost>{south, north}}) {
        input.candidates = candidates;
        const Tin tin = make_chunk_tin(input);
        ASSERT_EQ(tin.vertices.size(), 5u);
        EXPECT_TRUE(same_post(tin.vertices[4], north));
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_chunk_tin_voids
