#include "render_core/raytrace/search/node_walk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/support/files/hard_case.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_node_walk {
namespace {

using test_support::Dice;
using Cells = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Cells cells_of(const Ray& ray, std::uint32_t columns, std::uint32_t rows) {
    Cells cells;
    for (NodeWalk walk(ray, columns, rows); walk.is_inside(); walk.leave(0)) {
        cells.emplace_back(walk.column(), walk.row());
        EXPECT_LT(cells.size(), 2 * (columns + rows) + 4);
        if (cells.size() > 10000) break;
    }
    return cells;
}

/// Whether a walk misses a cell in which a fine sample of the ray lies, well away from grid lines.
bool misses_a_cell(const Ray& ray, const Cells& walked, std::uint32_t columns, std::uint32_t rows) {
    const std::set<std::pair<std::uint32_t, std::uint32_t>> known(walked.begin(), walked.end());
    for (double t = 0; t < 40; t += 0.01) {
        const double x = ray.origin.x + t * ray.direction.x, y = ray.origin.y + t * ray.direction.y;
        const double from_line = std::min(std::abs(x - std::round(x)), std::abs(y - std::round(y)));
        if (x < 0 || y < 0 || x >= columns || y >= rows || from_line < 1e-9) continue;
        if (known.count({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)}) == 0) return true;
    }
    return false;
}

/// The naive walk: the cell is the floor of the place, in floats, and the next place is where the ray leaves this cell. Empty
/// where the walk does not end.
Cells cells_by_floor(const Ray& ray, std::uint32_t columns, std::uint32_t rows) {
    const glm::vec3 origin(ray.origin), direction = ray.direction;
    const std::int64_t ends[2] = {columns, rows};
    Cells cells;
    float t = 0;
    for (int steps = 0; steps < 1000; ++steps) {
        std::int64_t cell[2];
        float next = std::numeric_limits<float>::infinity();
        bool is_inside = true, is_past = false;
        for (int axis = 0; axis < 2; ++axis) {
            cell[axis] = static_cast<std::int64_t>(std::floor(origin[axis] + t * direction[axis]));
            is_inside = is_inside && cell[axis] >= 0 && cell[axis] < ends[axis];
            is_past = is_past || (direction[axis] > 0   ? cell[axis] >= ends[axis]
                                  : direction[axis] < 0 ? cell[axis] < 0
                                                        : !is_inside);
            const auto line = static_cast<float>(cell[axis] + (direction[axis] > 0 ? 1 : 0));
            if (direction[axis] != 0) next = std::min(next, (line - origin[axis]) / direction[axis]);
        }
        if (is_past) return cells;
        if (is_inside) cells.emplace_back(static_cast<std::uint32_t>(cell[0]), static_cast<std::uint32_t>(cell[1]));
        t = next;
    }
    return {};
}

/// Rays from posts and from anywhere, along lines, diagonals and in other directions.
Ray some_ray(Dice& dice, int n) {
    Ray ray;
    ray.origin = {dice.between(-5, 18), dice.between(-5, 12), 0};
    ray.direction = {static_cast<float>(dice.between(-1, 1)), static_cast<float>(dice.between(-1, 1)), 0};
    if (n % 3 == 0) ray.origin = {std::floor(ray.origin.x), std::floor(ray.origin.y), 0};
    if (n % 6 == 0) ray.direction = {dice.below(2) == 0 ? 1.F : -1.F, float(int(dice.below(3)) - 1), 0};
    return ray;
}

TEST(NodeWalk, AWalkByTheFloorOfThePlaceDoesNotEndOrMissesCells) {
    Dice dice(4);
    int ours = 0, naive = 0, endless = 0;
    for (int n = 0; n < 3000; ++n) {
        const Ray ray = some_ray(dice, n);
        ours += misses_a_cell(ray, cells_of(ray, 13, 7), 13, 7) ? 1 : 0;
        const Cells walked = cells_by_floor(ray, 13, 7);
        naive += misses_a_cell(ray, walked, 13, 7) ? 1 : 0;
        endless += walked.empty() && !cells_of(ray, 13, 7).empty() ? 1 : 0;
    }
    EXPECT_EQ(ours, 0);
    EXPECT_GT(naive, 100) << "control";
    EXPECT_GT(endless, 100) << "the place on a line is before it or behind it";
    test_support::record_worst("A19", ours);
    test_support::record_control("A19", naive);
}

/// The naive test of a box: slabs by a reciprocal, min and max. A place on a slab times infinity is no number, and the same time
/// by two reciprocals is two times.
bool meets_by_slabs(const Ray& ray, double columns, double rows) {
    const double ends[2] = {columns, rows};
    float from = 0, to = std::numeric_limits<float>::infinity();
    for (int axis = 0; axis < 2; ++axis) {
        const float inverse = 1 / ray.direction[axis];
        const float to_first = static_cast<float>(0 - ray.origin[axis]) * inverse,
                    to_last = static_cast<float>(ends[axis] - ray.origin[axis]) * inverse;
        from = std::max(from, std::min(to_first, to_last));
        to = std::min(to, std::max(to_first, to_last));
    }
    return from <= to;
}

/// The same exactly: the numbers of the rays below are small fractions, whose quotients are equal where they should be.
bool meets_exactly(const Ray& ray, double columns, double rows) {
    const double ends[2] = {columns, rows};
    long double from = 0, to = std::numeric_limits<long double>::infinity();
    for (int axis = 0; axis < 2; ++axis) {
        const long double d = ray.direction[axis], origin = ray.origin[axis];
        if (d == 0 && (origin < 0 || origin > ends[axis])) return false;
        if (d == 0) continue;
        from = std::max(from, std::min(-origin / d, (ends[axis] - origin) / d));
        to = std::min(to, std::max(-origin / d, (ends[axis] - origin) / d));
    }
    return from <= to;
}

/// Rays of whole numbers, and rays aimed at a corner of the grid.
Ray lattice_ray(Dice& dice, bool is_corner) {
    Ray ray;
    const auto whole = [&](std::uint32_t count, int least) { return static_cast<double>(dice.below(count)) + least; };
    ray.origin = {whole(22, -4), whole(16, -4), 0};
    const float zero = dice.below(2) == 0 ? 0.F : -0.F;
    const auto component = [&] { return dice.below(3) == 0 ? zero : static_cast<float>(whole(7, -3)); };
    ray.direction = {component(), component(), -1};
    if (!is_corner) return ray;
    ray.direction = {static_cast<float>(whole(4000, 1) / 256), static_cast<float>(-whole(4000, 1) / 256), -1};
    const double times = whole(64, 1) / 16;
    ray.origin = glm::dvec3(13, 7, 0) - times * glm::dvec3(ray.direction.x, ray.direction.y, 0);
    return ray;
}

TEST(NodeWalk, SlabsByReciprocalsMissGridsThatAreMet) {
    for (const bool is_corner : {false, true}) {
        Dice dice(is_corner ? 6 : 5);
        int met = 0, ours = 0, naive = 0;
        for (int n = 0; n < 300'000; ++n) {
            const Ray ray = lattice_ray(dice, is_corner);
            const bool is_hit = meets_exactly(ray, 13, 7);
            met += is_hit ? 1 : 0;
            ours += NodeWalk(ray, 13, 7).is_inside() != is_hit ? 1 : 0;
            naive += is_hit && !meets_by_slabs(ray, 13, 7) ? 1 : 0;
        }
        EXPECT_GT(met, 50'000);
        EXPECT_EQ(ours, 0) << is_corner;
        EXPECT_GT(naive, met / 1000) << "control";
        if (!is_corner) continue;
        test_support::record_worst("A18", 100.0 * ours / met);
        test_support::record_control("A18", 100.0 * naive / met);
    }
}

TEST(NodeWalk, GoesThroughEveryCellThatFineSamplesFind) {
    Dice dice(1);
    for (int n = 0; n < 3000; ++n) {
        Ray ray;
        ray.origin = {dice.between(-5, 18), dice.between(-5, 12), 0};
        ray.direction = {static_cast<float>(dice.between(-1, 1)), static_cast<float>(dice.between(-1, 1)), 0};
        const Cells walked = cells_of(ray, 13, 7);
        ASSERT_FALSE(misses_a_cell(ray, walked, 13, 7)) << n;
        for (std::size_t k = 1; k < walked.size(); ++k)
            ASSERT_EQ(std::abs(int(walked[k].first) - int(walked[k - 1].first)) +
                          std::abs(int(walked[k].second) - int(walked[k - 1].second)),
                      1);
    }
}

TEST(NodeWalk, StretchesOfNeighbouringCellsMeet) {
    Dice dice(2);
    for (int n = 0; n < 2000; ++n) {
        Ray ray;
        ray.origin = {dice.between(-5, 18), dice.between(-5, 12), 3};
        ray.direction = {static_cast<float>(dice.between(-1, 1)), static_cast<float>(dice.between(-1, 1)), -0.1f};
        if (n % 3 == 0) ray.origin = {std::floor(ray.origin.x), std::floor(ray.origin.y), 3};  // through posts, along lines
        if (n % 6 == 0) ray.direction = {float(int(dice.below(3)) - 1), float(int(dice.below(3)) - 1), -0.1f};
        NodeWalk walk(ray, 13, 7);
        if (!walk.is_inside()) continue;
        CellRay last = walk.in_cell();
        for (walk.leave(0); walk.is_inside(); walk.leave(0)) {
            const CellRay next = walk.in_cell();
            ASSERT_EQ(next.from.t, last.to.t);
            ASSERT_EQ(next.from.z, last.to.z);
            ASSERT_EQ(next.from.place.column + next.from.place.u, last.to.place.column + last.to.place.u);
            ASSERT_EQ(next.from.place.row + next.from.place.v, last.to.place.row + last.to.place.v);
            last = next;
        }
    }
}

TEST(NodeWalk, CoarserNodesHoldTheSameCells) {
    Dice dice(3);
    for (int n = 0; n < 2000; ++n) {
        Ray ray;
        ray.origin = {dice.between(-5, 50), dice.between(-5, 40), 0};
        ray.direction = {static_cast<float>(dice.between(-1, 1)), static_cast<float>(dice.between(-1, 1)), 0};
        const Cells fine = cells_of(ray, 45, 37);
        std::size_t at = 0;
        for (NodeWalk walk(ray, 45, 37); walk.is_inside(); walk.leave(2)) {
            // All cells of the node come next in the fine walk.
            ASSERT_LT(at, fine.size());
            ASSERT_EQ(fine[at], std::pair(walk.column(), walk.row()));
            while (at < fine.size() && fine[at].first >> 2 == walk.column() >> 2 && fine[at].second >> 2 == walk.row() >> 2) ++at;
        }
        ASSERT_EQ(at, fine.size());
    }
}

TEST(NodeWalk, ParallelRaysOnTheBorderAreInside) {
    for (const double x : {0.0, 5.0, 13.0}) {
        Ray ray;
        ray.origin = {x, -2, 0};
        ray.direction = {0, 1, 0};
        EXPECT_EQ(cells_of(ray, 13, 7).size(), 7u) << x;
    }
    Ray beside;
    beside.origin = {-0.001, -2, 0};
    beside.direction = {-0.f, 1, 0};
    EXPECT_TRUE(cells_of(beside, 13, 7).empty());
    Ray down;
    down.origin = {13, 7, 100};
    down.direction = {0, 0, -1};
    EXPECT_EQ(cells_of(down, 13, 7), (Cells{{12, 6}}));
}

TEST(NodeWalk, KeepsToTheRaysOwnEnds) {
    Ray ray;
    ray.origin = {2.5, 3.5, 0};
    ray.direction = {1, 0, 0};
    ray.from = 1;
    ray.to = 2.2f;
    EXPECT_EQ(cells_of(ray, 13, 7), (Cells{{3, 3}, {4, 3}}));
}

}  // namespace
}  // namespace tedavis::raytrace::test_node_walk
