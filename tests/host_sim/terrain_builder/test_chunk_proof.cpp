#include "host_sim/terrain_builder/chunk_proof.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>

#include "tests/host_sim/terrain_builder/true_surface.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_chunk_proof {
namespace {

using namespace terrain;
using test_support::BuiltDatabase;
using test_support::BuiltMesh;
using test_support::TrueSurface;

struct Found {
    double above_m = 0, below_m = 0;
    int samples = 0;
};

/// Places on the drawn triangles, as a graphics processor would draw them from the file, against the true surface.
Found sample(const BuiltMesh& mesh, const TrueSurface& truth, int steps) {
    Found found;
    const auto place = [&](std::uint16_t n, int axis) {
        const ChunkVertex& v = mesh.vertices[n];
        return mesh.entry.centre_m[axis] + double{axis == 0 ? v.x : axis == 1 ? v.y : v.z};
    };
    for (std::size_t n = 0; n < mesh.indices.size(); n += 3)
        for (int a = 0; a <= steps; ++a)
            for (int b = 0; a + b <= steps; ++b) {
                const double wa = a / double(steps), wb = b / double(steps), wc = 1 - wa - wb;
                double p[3];
                for (int axis = 0; axis < 3; ++axis)
                    p[axis] = wa * place(mesh.indices[n], axis) + wb * place(mesh.indices[n + 1], axis) +
                              wc * place(mesh.indices[n + 2], axis);
                double lat = 0, lon = 0, height = 0;
                GeographicLib::Geocentric::WGS84().Reverse(p[0], p[1], p[2], lat, lon, height);
                const auto ground = truth.at(lat, lon);
                if (!ground) continue;
                ++found.samples;
                found.above_m = std::max(found.above_m, height - *ground);
                found.below_m = std::max(found.below_m, *ground - height);
            }
    return found;
}

/// Sides where a coarser chunk can be drawn: what is beyond has another parent.
std::uint8_t sides_beside_other_parents(const Lattice& lattice, const ChunkKey& key) {
    std::uint8_t sides = 0;
    for (const EdgeBit side : {kEdgeNorth, kEdgeEast, kEdgeSouth, kEdgeWest}) {
        const ChunkKey neighbour = lattice.neighbour(key, side);
        const bool other = key.level + 1 < lattice.levels() && neighbour != kNoChunk && neighbour.parent() != key.parent();
        if (other) sides = static_cast<std::uint8_t>(sides | side);
    }
    return sides;
}

/// Every chunk beside every combination of coarser neighbours; what it reaches of what it states, at least once.
void expect_stated_errors_hold(const Raster& raster, bool closed, int steps, std::uint32_t first_level = 0) {
    const BuiltDatabase built(raster);
    const TrueSurface truth(raster, closed);
    double tightest = 0;
    for (const ChunkKey& key : built.chunks()) {
        if (key.level < first_level) continue;
        SCOPED_TRACE("chunk " + std::to_string(key.level) + "/" + std::to_string(key.i) + "/" + std::to_string(key.j));
        const std::uint8_t sides = sides_beside_other_parents(built.lattice(), key);
        for (std::uint8_t mask = 0; mask < 16; ++mask) {
            if ((mask & ~sides) != 0) continue;
            const BuiltMesh mesh(built, key, mask);
            const Found found = sample(mesh, truth, mask == 0 ? steps : 2);
            const ChunkEntry& e = mesh.entry;
            const double above_m = mask == 0 ? e.above_m : std::max(e.above_m, e.strip_above_m),
                         below_m = mask == 0 ? e.below_m : std::max(e.below_m, e.strip_below_m);
            EXPECT_LE(found.above_m, above_m) << "mask " << int{mask};
            EXPECT_LE(found.below_m, below_m) << "mask " << int{mask};
            if (key.level > 0 && mask == 0) tightest = std::max(tightest, found.below_m / below_m);
            EXPECT_GT(found.samples, 0);
        }
    }
    EXPECT_GT(tightest, 0.5) << "stated errors have little to do with the real ones";
}

TEST(ChunkProof, HoldsOverRoughTerrain) { expect_stated_errors_hold(test_support::make_rough_raster(97, 80), false, 6); }

/// What exact chunks state is honest and not much more than is found; a vertex that went a little further would be found. Gentle
/// slopes: on steep ones the bound of what curvature moves sideways is most of it.
TEST(ChunkProof, ExactChunksStateLittleMoreThanTheirRounding) {
    const Raster raster = test_support::make_raster(
        97, 80, [](std::uint32_t i, std::uint32_t j) { return 1500 + 30.0f * std::sin(i * 0.4f) * std::cos(j * 0.3f); });
    const BuiltDatabase built(raster);
    const TrueSurface truth(raster, false);
    double tightest = 0;
    for (const ChunkKey& key : built.chunks()) {
        if (key.level != 0) continue;
        BuiltMesh mesh(built, key, 0);
        const ChunkEntry& e = mesh.entry;
        const Found found = sample(mesh, truth, 4);
        EXPECT_LE(found.above_m, e.above_m);
        EXPECT_LE(found.below_m, e.below_m);
        tightest = std::max(tightest, found.above_m / e.above_m);
        ChunkVertex& moved = mesh.vertices[e.border_count + 3u];
        moved.x -= 2.5f * e.axes[6] * e.above_m;
        moved.y -= 2.5f * e.axes[7] * e.above_m;
        moved.z -= 2.5f * e.axes[8] * e.above_m;
        EXPECT_GT(sample(mesh, truth, 4).above_m, e.above_m);
    }
    EXPECT_GT(tightest, 0.25);
}

TEST(ChunkProof, HoldsFarNorthWithCellsOfManyKilometres) {
    const Raster raster = test_support::make_raster(
        90, 70, [](std::uint32_t i, std::uint32_t j) { return 2000 + 1500.0f * std::sin(i * 0.3f) * std::cos(j * 0.2f); }, 5, 75,
        0.25);
    expect_stated_errors_hold(raster, false, 6);
}

TEST(ChunkProof, HoldsRoundTheEarthAndAtItsPoles) {
    const auto height = [](std::uint32_t i, std::uint32_t j) {
        return 3000 + 2000.0f * std::sin(i * 0.35f) * std::cos(j * 0.5f) + 300.0f * static_cast<float>((i * 7 + j * 13) % 5);
    };
    expect_stated_errors_hold(test_support::make_raster(180, 90, height, -179, 89, 2), true, 5);
    expect_stated_errors_hold(test_support::make_raster(72, 36, height, -177.5, 87.5, 5), true, 5);
}

TEST(ChunkProof, HoldsOverTheAntimeridian) {
    const Raster raster = test_support::make_raster(
        80, 70, [](std::uint32_t i, std::uint32_t j) { return 100.0f * static_cast<float>((i * i + 3 * j * j) % 11); }, 179.2,
        -16, 0.02);
    expect_stated_errors_hold(raster, false, 6);
}

/// More than a unit across: chunks above the units are measured by another way.
TEST(ChunkProof, HoldsAboveTheUnits) {
    expect_stated_errors_hold(test_support::make_rough_raster(1100, 34), false, 12, kUnitLevel);
    expect_stated_errors_hold(test_support::make_rough_raster(34, 1100), false, 12, kUnitLevel);
}

TEST(ChunkProof, HoldsBesideVoids) {
    const Raster raster = test_support::make_raster(100, 90, [](std::uint32_t i, std::uint32_t j) {
        const bool hole = (i > 30 && i < 52 && j > 20 && j < 37) || (i == 70 && j == 32) || i == 64;
        return hole ? std::nanf("") : 500 + 40.0f * static_cast<float>((i * 5 + j * 3) % 9);
    });
    expect_stated_errors_hold(raster, false, 6);
}

}  // namespace
}  // namespace tedavis::host_sim::test_chunk_proof
