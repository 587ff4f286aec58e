// Two oracles that know nothing of each other: our reference and Embree, over the same heights.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/raytrace/embree_grid.hpp"
#include "tests/support/raytrace/reference_trace.hpp"
#include "tests/support/terrain/fractal_heights.hpp"

namespace tedavis::raytrace::test_reference_embree {
namespace {

using test_support::EmbreeGrid;
using test_support::EmbreeMesh;
using test_support::HeightField;
using test_support::ReferenceHit;
using test_support::ReferenceTracer;

/// How many answers of 40,000 differ, and are no close calls.
int differences(const HeightField<std::int16_t>& asked, const HeightField<std::int16_t>& meshed, EmbreeMesh mesh,
                CellSurface surface) {
    const ReferenceTracer<std::int16_t> reference(asked.grid(), surface);
    const EmbreeGrid embree(meshed.grid(), 1, mesh, 2);
    std::mt19937 bits(11);
    const auto in = [&](double low, double high) { return static_cast<float>(low + (high - low) * (bits() * 0x1p-32)); };
    int different = 0;
    for (int n = 0; n < 40000; ++n) {
        const float o[3] = {in(0, 60), in(0, 60), in(31, 60)}, d[3] = {in(-1, 1), in(-1, 1), in(-1, -0.1)};
        const Ray ray{{o[0], o[1], o[2]}, {d[0], d[1], d[2]}};
        const ReferenceHit hit = reference.trace(ray);
        if (hit.margin < 1e-5L) continue;
        const float other = embree.trace(o, d);
        const bool is_same = hit.side == HitSide::none ? other == INFINITY : std::abs(other - hit.t) < 1e-4L * (1 + hit.t);
        different += !is_same;
    }
    return different;
}

TEST(ReferenceAndEmbree, AgreeOverSteepCells) {
    HeightField<std::int16_t> field = test_support::rough_heights(61, 61, 30, 5);
    EXPECT_EQ(differences(field, field, EmbreeMesh::grid, CellSurface::two_triangles), 0);
    EXPECT_EQ(differences(field, field, EmbreeMesh::triangles, CellSurface::two_triangles), 0);
    // The bilinear patch is another surface, and cells divided the other way another still.
    EXPECT_GT(differences(field, field, EmbreeMesh::grid, CellSurface::bilinear), 1000);
    HeightField<std::int16_t> changed = field;
    changed.at(30, 30) = 60;
    EXPECT_GT(differences(field, changed, EmbreeMesh::grid, CellSurface::two_triangles), 0);
}

}  // namespace
}  // namespace tedavis::raytrace::test_reference_embree
