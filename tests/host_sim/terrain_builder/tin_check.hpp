/// Inputs for a chunk's triangulation, and what must hold of every result, found without its code.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "host_sim/terrain_builder/chunk_tin.hpp"
#include "tests/support/terrain/fractal_square.hpp"

namespace tedavis::test_support {

using TinHeight = std::function<double(std::uint32_t, std::uint32_t)>;

/// A chunk with every post a candidate and every `step`-th border post a vertex.
inline host_sim::TinInput tin_input_of(std::uint32_t last_i, std::uint32_t last_j, std::uint32_t step, const TinHeight& height) {
    host_sim::TinInput input;
    input.last_i = last_i;
    input.last_j = last_j;
    input.max_vertices = 65536;
    const auto post = [&](std::uint32_t i, std::uint32_t j) {
        return host_sim::TinPost{static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j), static_cast<float>(height(i, j)),
                                 terrain::PostClass::land};
    };
    for (std::uint32_t i = 0; i < last_i; i += step) input.border.push_back(post(i, 0));
    for (std::uint32_t j = 0; j < last_j; j += step) input.border.push_back(post(last_i, j));
    for (std::uint32_t i = last_i; i > 0; i -= std::min(i, step)) input.border.push_back(post(i, last_j));
    for (std::uint32_t j = last_j; j > 0; j -= std::min(j, step)) input.border.push_back(post(0, j));
    for (std::uint32_t j = 1; j < last_j; ++j)
        for (std::uint32_t i = 1; i < last_i; ++i) input.candidates.push_back(post(i, j));
    return input;
}

inline const FractalSquare& tin_ground() {
    static const FractalSquare terrain = fractal_square(129, 7);
    return terrain;
}

inline host_sim::TinInput tin_ground_input(double tolerance_m, std::uint32_t step = 4) {
    host_sim::TinInput input =
        tin_input_of(128, 128, step, [](std::uint32_t i, std::uint32_t j) { return tin_ground().at(i, j); });
    input.tolerance_m = tolerance_m;
    return input;
}

struct TinTriangle {
    host_sim::TinPost a, b, c;
};

inline std::vector<TinTriangle> tin_triangles_of(const host_sim::Tin& tin) {
    std::vector<TinTriangle> triangles;
    for (std::size_t n = 0; n < tin.triangles.size(); n += 3)
        triangles.push_back(
            {tin.vertices[tin.triangles[n]], tin.vertices[tin.triangles[n + 1]], tin.vertices[tin.triangles[n + 2]]});
    return triangles;
}

/// Twice the area, positive when counter-clockwise seen from above: j runs south.
inline std::int64_t turn_of(const host_sim::TinPost& a, const host_sim::TinPost& b, const host_sim::TinPost& c) {
    return (std::int64_t{b.j} - a.j) * (std::int64_t{c.i} - a.i) - (std::int64_t{b.i} - a.i) * (std::int64_t{c.j} - a.j);
}

inline bool holds_post(const TinTriangle& t, const host_sim::TinPost& p) {
    return turn_of(t.a, t.b, p) >= 0 && turn_of(t.b, t.c, p) >= 0 && turn_of(t.c, t.a, p) >= 0;
}

/// Oracle: every triangle at every post that it holds_post, by barycentric coordinates.
inline double largest_tin_error_m(const host_sim::TinInput& input, const host_sim::Tin& tin) {
    std::map<std::pair<int, int>, const host_sim::TinPost*> posts;
    for (const host_sim::TinPost& p : input.candidates) posts[{p.j, p.i}] = &p;
    long double largest = 0;
    for (const TinTriangle& t : tin_triangles_of(tin)) {
        const auto [north, south] = std::minmax({t.a.j, t.b.j, t.c.j});
        for (auto at = posts.lower_bound({north, 0}); at != posts.end() && at->first.first <= south; ++at) {
            const host_sim::TinPost& p = *at->second;
            if (p.post_class == terrain::PostClass::void_ || !holds_post(t, p)) continue;
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

inline bool same_post(const host_sim::TinPost& a, const host_sim::TinPost& b) {
    return a.i == b.i && a.j == b.j && a.height_m == b.height_m && a.post_class == b.post_class;
}

inline bool same_tin(const host_sim::Tin& a, const host_sim::Tin& b) {
    return a.triangles == b.triangles && a.candidate_error_m == b.candidate_error_m && a.vertices.size() == b.vertices.size() &&
           std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), same_post);
}

inline void expect_sound_tin(const host_sim::TinInput& input, const host_sim::Tin& tin) {
    ASSERT_LE(tin.vertices.size(), std::max<std::size_t>(input.max_vertices, input.border.size()));
    ASSERT_TRUE(std::equal(input.border.begin(), input.border.end(), tin.vertices.begin(), same_post)) << "the border first";
    for (std::size_t n = input.border.size(); n < tin.vertices.size(); ++n) {
        const host_sim::TinPost& v = tin.vertices[n];
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

}  // namespace tedavis::test_support
