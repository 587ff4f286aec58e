#include "render_core/raytrace/search/node_walk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

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

TEST(NodeWalk, GoesThroughEveryCellThatFineSamplesFind) {
    Dice dice(1);
    for (int n = 0; n < 3000; ++n) {
        Ray ray;
        ray.origin = {dice.between(-5, 18), dice.between(-5, 12), 0};
        ray.direction = {static_cast<float>(dice.between(-1, 1)), static_cast<float>(dice.between(-1, 1)), 0};
        const Cells walked = cells_of(ray, 13, 7);
        const std::set<std::pair<std::uint32_t, std::uint32_t>> known(walked.begin(), walked.end());
        for (double t = 0; t < 40; t += 0.01) {
            const double x = ray.origin.x + t * ray.direction.x, y = ray.origin.y + t * ray.direction.y;
            const double from_line = std::min(std::abs(x - std::round(x)), std::abs(y - std::round(y)));
            if (x < 0 || y < 0 || x >= 13 || y >= 7 || from_line < 1e-9) continue;
            ASSERT_EQ(known.count({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y)}), 1u) << n;
        }
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
