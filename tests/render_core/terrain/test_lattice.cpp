#include "render_core/terrain/lattice.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <set>
#include <tuple>

#include "render_core/base/units.hpp"

namespace tedavis::terrain::test_lattice {
namespace {

using base::radians;

FileHeader region(std::uint32_t columns, std::uint32_t rows, std::uint32_t levels) {
    FileHeader h{};
    h.west_deg = 9.5;
    h.north_deg = 47;
    h.step_lon_deg = h.step_lat_deg = 1 / 1200.0;
    h.columns = columns;
    h.rows = rows;
    h.levels = levels;
    return h;
}

/// 144 columns of cells: not a power of two, so that levels end in part chunks at the seam.
FileHeader world() {
    FileHeader h = region(145, 73, 3);
    h.west_deg = -180;
    h.step_lon_deg = h.step_lat_deg = 2.5;
    h.north_deg = 87.5;
    h.lattice_flags = kLatticeClosed | kLatticeNorthPole | kLatticeSouthPole;
    return h;
}

TEST(Lattice, PostsLieWhereGeographicLibPutsThem) {
    const Lattice lattice(region(1201, 801, 6));
    const GeographicLib::Geocentric& earth = GeographicLib::Geocentric::WGS84();
    for (const auto& [i, j, height] : {std::tuple{0u, 0u, 0.0}, {1200u, 800u, 4000.0}, {37u, 555u, -430.0}}) {
        double x, y, z;
        earth.Forward(47 - j / 1200.0, 9.5 + i / 1200.0, height, x, y, z);
        EXPECT_LT(glm::distance(lattice.position(i, j, height), glm::dvec3(x, y, z)), 1e-8);
    }
}

TEST(Lattice, APostIsFoundAtItsOwnPlace) {
    for (const FileHeader& h : {region(1201, 801, 6), world()}) {
        const Lattice lattice(h);
        for (std::uint32_t j = 0; j < h.rows; j += 7)
            for (std::uint32_t i = 0; i + 1 < h.columns; i += 11) {
                const LatticePoint point = lattice.point(lattice.latitude_rad(j), lattice.longitude_rad(i));
                ASSERT_TRUE(point.inside);
                EXPECT_NEAR(point.j, j, 1e-6);
                // Round the Earth the first meridian is also the last one.
                EXPECT_NEAR(std::remainder(point.i - i, lattice.is_closed() ? h.columns - 1.0 : 1e9), 0, 1e-6);
            }
    }
}

TEST(Lattice, PlacesBeyondTheEdgeAndNoPlacesAreOutside) {
    const Lattice lattice(region(1201, 801, 6));
    EXPECT_TRUE(lattice.point(radians(46.5), radians(10)).inside);
    EXPECT_FALSE(lattice.point(radians(47.001), radians(10)).inside);
    EXPECT_FALSE(lattice.point(radians(46.5), radians(9.499)).inside);
    EXPECT_FALSE(lattice.point(radians(46.5), radians(-170)).inside);
    EXPECT_FALSE(lattice.point(std::nan(""), radians(10)).inside);
    EXPECT_FALSE(lattice.point(radians(46.5), INFINITY).inside);
}

TEST(Lattice, CrossesTheAntimeridian) {
    FileHeader h = region(241, 121, 3);
    h.west_deg = 179.9;
    const Lattice lattice(h);
    const LatticePoint west = lattice.point(radians(46.95), radians(179.95)),
                       east = lattice.point(radians(46.95), radians(-179.95));
    EXPECT_TRUE(west.inside && east.inside);
    EXPECT_NEAR(east.i - west.i, 120, 1e-6);
    EXPECT_FALSE(lattice.point(radians(46.95), radians(-179.85)).inside);
}

TEST(Lattice, TheSeamAndThePolesAreSinglePlaces) {
    const Lattice lattice(world());
    for (std::uint32_t j : {0u, 1u, 30u, 72u}) EXPECT_EQ(lattice.position(0, j, 100), lattice.position(144, j, 100));
    for (std::uint32_t i = 0; i < 145; ++i) {
        EXPECT_EQ(lattice.position(i, 0, 100), lattice.position(0, 0, 100));
        EXPECT_EQ(lattice.position(i, 72, 100), lattice.position(0, 72, 100));
    }
    EXPECT_NEAR(lattice.position(3, 0, 0).z, 6356752.314245, 1e-5) << "WGS84's polar radius";
    EXPECT_NEAR(lattice.position(3, 72, 0).z, -6356752.314245, 1e-5);
    EXPECT_NEAR(lattice.point(radians(88.75), 0).j, 0.5, 1e-9);
    EXPECT_NEAR(lattice.point(radians(-88.75), 0).j, 71.5, 1e-9);
}

TEST(Lattice, ChunksOfALevelTileTheCells) {
    for (const FileHeader& h : {region(70, 161, 4), world()}) {
        const Lattice lattice(h);
        for (std::uint32_t level = 0; level < h.levels; ++level) {
            std::uint64_t cells = 0;
            for (std::uint32_t j = 0; j < lattice.grid_rows(level); ++j)
                for (std::uint32_t i = 0; i < lattice.grid_columns(level); ++i) {
                    const PostRange posts = lattice.posts_of({level, i, j});
                    ASSERT_LT(posts.i0, posts.i1);
                    ASSERT_LT(posts.j0, posts.j1);
                    ASSERT_LE(posts.i1, h.columns - 1);
                    ASSERT_LE(posts.j1, h.rows - 1);
                    cells += std::uint64_t{posts.i1 - posts.i0} * (posts.j1 - posts.j0);
                    EXPECT_TRUE(level + 1 == h.levels || lattice.contains(ChunkKey{level, i, j}.parent()));
                }
            EXPECT_EQ(cells, std::uint64_t{h.columns - 1} * (h.rows - 1));
            EXPECT_FALSE(lattice.contains({level, lattice.grid_columns(level), 0}));
            EXPECT_FALSE(lattice.contains({level, 0, lattice.grid_rows(level)}));
        }
        EXPECT_FALSE(lattice.contains({h.levels, 0, 0}));
        EXPECT_FALSE(lattice.contains(kNoChunk));
    }
}

TEST(Lattice, NeighboursShareASide) {
    for (const FileHeader& h : {region(70, 161, 4), world()}) {
        const Lattice lattice(h);
        for (std::uint32_t level = 0; level < h.levels; ++level)
            for (std::uint32_t j = 0; j < lattice.grid_rows(level); ++j)
                for (std::uint32_t i = 0; i < lattice.grid_columns(level); ++i) {
                    const ChunkKey key{level, i, j};
                    const ChunkKey east = lattice.neighbour(key, kEdgeEast), south = lattice.neighbour(key, kEdgeSouth);
                    const PostRange posts = lattice.posts_of(key);
                    if (east != kNoChunk) {
                        EXPECT_EQ(lattice.neighbour(east, kEdgeWest), key);
                        EXPECT_EQ(lattice.posts_of(east).i0 % (h.columns - 1), posts.i1 % (h.columns - 1));
                    } else {
                        EXPECT_TRUE(!lattice.is_closed() && posts.i1 == h.columns - 1);
                    }
                    if (south != kNoChunk) {
                        EXPECT_EQ(lattice.neighbour(south, kEdgeNorth), key);
                        EXPECT_EQ(lattice.posts_of(south).j0, posts.j1);
                    } else {
                        EXPECT_EQ(posts.j1, h.rows - 1);
                    }
                }
    }
    EXPECT_EQ(Lattice(world()).neighbour({0, 0, 1}, kEdgeNorth), (ChunkKey{0, 0, 0}));
    EXPECT_EQ(Lattice(world()).neighbour({0, 0, 0}, kEdgeNorth), kNoChunk) << "beyond a pole lies nothing";
    EXPECT_EQ(Lattice(world()).neighbour({0, 0, 0}, kEdgeWest), (ChunkKey{0, 4, 0}));
}

TEST(Lattice, EveryChunkHasOnePlaceInThePages) {
    const FileHeader h = region(1201, 801, 6);
    const Lattice lattice(h);
    std::set<std::pair<std::uint32_t, std::uint32_t>> places;
    std::uint64_t chunks = 0;
    for (std::uint32_t level = 0; level < h.levels; ++level)
        for (std::uint32_t j = 0; j < lattice.grid_rows(level); ++j)
            for (std::uint32_t i = 0; i < lattice.grid_columns(level); ++i, ++chunks) {
                EXPECT_LT(lattice.page_index({level, i, j}), lattice.page_count());
                places.insert({lattice.page_index({level, i, j}), Lattice::index_in_page({level, i, j})});
            }
    EXPECT_EQ(places.size(), chunks);
    EXPECT_EQ(lattice.page_index({0, 9, 17}), 2 * lattice.page_columns(0) + 1) << "row by row";
    EXPECT_EQ(Lattice::index_in_page({0, 9, 17}), 9u);
}

}  // namespace
}  // namespace tedavis::terrain::test_lattice
