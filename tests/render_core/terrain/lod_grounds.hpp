/// Grounds for selections of chunks, and what holds of every selection over them.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/support/terrain/selection.hpp"
#include "tests/support/terrain/tdb_writer.hpp"
#include "tests/support/terrain/terrain_views.hpp"

namespace tedavis::test_support {

inline double rough_height(double i, double j) {
    return 1200 + 500 * std::sin(i * 0.021) * std::cos(j * 0.017) + 30 * std::sin(i * 0.13 + j * 0.11) +
           0.6 * std::sin(i * 1.9) * std::cos(j * 2.3);
}

inline const WrittenTdb& rough_region() {
    static const WrittenTdb tdb([] {
        TdbSpec spec;
        spec.columns = 417;
        spec.rows = 353;
        spec.step_lon_deg = spec.step_lat_deg = 1 / 3600.0;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return rough_height(i, j); };
        return spec;
    }());
    return tdb;
}

/// Coarse posts, so that high mountains: the error is in what lies between them.
inline const WrittenTdb& rough_world() {
    static const WrittenTdb tdb([] {
        TdbSpec spec = whole_earth(321, 161);
        spec.levels = 3;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 3000 + 2500 * std::sin(i * 0.7) * std::cos(j * 0.9); };
        return spec;
    }());
    return tdb;
}

inline std::vector<terrain::View> views_of(const WrittenTdb& tdb, int count, unsigned seed = 7) {
    return some_views(tdb, count, seed, tdb.lattice().is_closed() ? 400 : 1);
}

/// Every `stride`th post in view lies under exactly one chosen chunk.
inline void expect_covered_once(const WrittenTdb& tdb, const terrain::View& view, const Selection& selection,
                                std::uint32_t stride) {
    for (std::uint32_t j = 1; j + 2 < tdb.lattice().rows(); j += stride)
        for (std::uint32_t i = 0; i + 1 < tdb.lattice().columns(); i += stride) {
            if (!project(view, tdb.position(i, j)).visible) continue;
            int covering = 0;
            for (const terrain::SelectedChunk& chunk : selection.chunks) {
                const terrain::PostRange posts = tdb.lattice().posts_of(chunk.key);
                covering += i >= posts.i0 && i < posts.i1 && j >= posts.j0 && j < posts.j1 ? 1 : 0;
            }
            ASSERT_EQ(covering, 1) << "post " << i << ", " << j;
        }
}

/// Neighbours differ by one level at most, and the finer ones know it.
inline void expect_balanced(const WrittenTdb& tdb, const Selection& selection) {
    std::set<std::uint64_t> chosen;
    for (const terrain::SelectedChunk& chunk : selection.chunks) chosen.insert(chunk.key.packed());
    for (const terrain::SelectedChunk& chunk : selection.chunks)
        for (const terrain::EdgeBit side : {terrain::kEdgeNorth, terrain::kEdgeEast, terrain::kEdgeSouth, terrain::kEdgeWest}) {
            terrain::ChunkKey beside = tdb.lattice().neighbour(chunk.key, side);
            if (beside == terrain::kNoChunk) {
                EXPECT_EQ(chunk.coarser_edges & side, 0);
                continue;
            }
            EXPECT_EQ(chosen.count(beside.packed()) != 0 && (chunk.coarser_edges & side) != 0, false);
            for (std::uint32_t up = 1; beside.level + 1 < tdb.lattice().levels(); ++up) {
                beside = beside.parent();
                if (chosen.count(beside.packed()) == 0) continue;
                EXPECT_EQ(up, 1u) << "levels differ by more than one";
                EXPECT_NE(chunk.coarser_edges & side, 0);
            }
        }
}

}  // namespace tedavis::test_support
