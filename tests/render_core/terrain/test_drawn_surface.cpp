#include "render_core/terrain/drawn_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/render_core/terrain/drawn_mesh_check.hpp"
#include "tests/support/terrain/resident_tdb.hpp"
#include "tests/support/terrain/selection.hpp"
#include "tests/support/terrain/terrain_views.hpp"

namespace tedavis::terrain::test_drawn_surface {
namespace {

using test_support::ResidentTdb;
using test_support::Selection;
using test_support::TdbSpec;
using test_support::WrittenTdb;

const WrittenTdb& region() {
    static const WrittenTdb tdb([] {
        TdbSpec spec;
        spec.columns = spec.rows = 257;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) {
            return 1000 + 400 * std::sin(i * 0.05) * std::cos(j * 0.04) + 5 * std::sin(i * 1.3 + j * 0.7);
        };
        return spec;
    }());
    return tdb;
}

const WrittenTdb& world() {
    static const WrittenTdb tdb([] {
        TdbSpec spec = test_support::whole_earth(193, 97);
        spec.levels = 3;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 2000 + 1500 * std::sin(i * 0.7) * std::cos(j * 0.9); };
        return spec;
    }());
    return tdb;
}

struct Drawn {
    Drawn(const WrittenTdb& over, const View& view, bool conservative_up) : tdb(over) {
        ResidentTdb catalogue(tdb);
        LodSettings settings;
        settings.tau_px = 4;
        settings.conservative_up = conservative_up;
        EXPECT_TRUE(selection.select(catalogue, view, settings).within_budget);
        for (const SelectedChunk& chunk : selection.chunks) {
            vertices.push_back(tdb.vertices(chunk.key));
            indices.push_back(tdb.indices(chunk.key, chunk.coarser_edges));
        }
    }
    DrawnPoint at(const LatticePoint& point) const {
        const SelectedChunk* chunk = chunk_under(tdb.lattice(), {selection.chunks.data(), selection.chunks.size()}, point);
        if (chunk == nullptr) return {};
        const auto n = static_cast<std::size_t>(chunk - selection.chunks.data());
        return drawn_point(tdb.database(),
                           {chunk, {vertices[n].data(), vertices[n].size()}, {indices[n].data(), indices[n].size()}}, point);
    }
    const WrittenTdb& tdb;
    Selection selection;
    std::vector<std::vector<ChunkVertex>> vertices;
    std::vector<std::vector<std::uint16_t>> indices;
};

View over_all(const WrittenTdb& tdb) {
    return test_support::view_from(tdb, (tdb.lattice().columns() - 1) / 2.0, (tdb.lattice().rows() - 1) / 2.0,
                                   tdb.lattice().is_closed() ? 4e6 : 15000, 0, -90);
}

TEST(DrawnSurface, APostsPointIsOnTheTriangleThatTheOtherArithmeticFinds) {
    for (const WrittenTdb* tdb : {&region(), &world()})
        for (const bool conservative_up : {false, true}) {
            const Drawn drawn(*tdb, over_all(*tdb), conservative_up);
            int compared = 0;
            for (const SelectedChunk& chunk : drawn.selection.chunks)
                test_support::visit_drawn_posts(
                    *tdb, chunk, 5, [&](std::uint32_t i, std::uint32_t j, const glm::dvec3& expected) {
                        const DrawnPoint point = drawn.at({double(i), double(j), true});
                        ASSERT_TRUE(point.found) << i << ", " << j;
                        // On a border the neighbour may answer, from vertices that are the same to the last bit.
                        EXPECT_LT(glm::distance(point.position, expected),
                                  1e-6 * std::max(1.0, glm::distance(expected, point.position)) + 1e-6);
                        ++compared;
                    });
            EXPECT_GT(compared, 300);
        }
}

TEST(DrawnSurface, IsWithoutAHoleAndAStepOverChunksAndPoles) {
    for (const WrittenTdb* tdb : {&region(), &world()}) {
        const Drawn drawn(*tdb, over_all(*tdb), true);
        const double last_i = tdb->lattice().columns() - 1, last_j = tdb->lattice().rows() - 1;
        int found = 0;
        for (double j = 0.013; j < last_j; j += last_j / 61)
            for (double i = 0.017; i < last_i; i += last_i / 67) {
                const DrawnPoint here = drawn.at({i, j, true});
                const bool drawn_there =
                    chunk_under(tdb->lattice(), {drawn.selection.chunks.data(), drawn.selection.chunks.size()}, {i, j, true}) !=
                    nullptr;
                EXPECT_EQ(here.found, drawn_there);
                found += here.found ? 1 : 0;
                const DrawnPoint beside = drawn.at({i + 1e-7, j, true}), below = drawn.at({i, j + 1e-7, true});
                if (!here.found || !beside.found || !below.found) continue;
                const double cell_m = 111320 * tdb->database().header().step_lat_deg;
                EXPECT_LT(glm::distance(here.position, beside.position), 1e-5 * cell_m);
                EXPECT_LT(glm::distance(here.position, below.position), 1e-5 * cell_m);
            }
        EXPECT_GT(found, 1000);
    }
}

TEST(DrawnSurface, AtAPoleTheMeridiansMeet) {
    View view = test_support::view_from(world(), 20, 2, 3e6, 0, -90);
    const Drawn drawn(world(), view, false);
    const DrawnPoint pole = drawn.at({20.3, 0, true});
    ASSERT_TRUE(pole.found);
    for (double i = 0.4; i < 192; i += 11.3) {
        const DrawnPoint same = drawn.at({i, 0, true});
        if (!same.found) continue;
        EXPECT_LT(glm::distance(same.position, pole.position), 1e-6);
        const earth::Geodetic near = earth::from_ecef(drawn.at({i, 0.5, true}).position);
        EXPECT_NEAR(std::remainder(near.longitude_rad - base::radians(-180 + i * 360 / 192), 2 * base::kPi), 0, 0.02)
            << "a place is on its own meridian";
    }
}

TEST(DrawnSurface, HeightsAreAboveMeanSeaLevelAndNearTheTrueOnes) {
    const Drawn drawn(region(), over_all(region()), false);
    for (std::uint32_t j = 3; j < 250; j += 19)
        for (std::uint32_t i = 5; i < 250; i += 17) {
            const DrawnPoint point = drawn.at({double(i), double(j), true});
            ASSERT_TRUE(point.found);
            const SelectedChunk* chunk = chunk_under(
                region().lattice(), {drawn.selection.chunks.data(), drawn.selection.chunks.size()}, {double(i), double(j), true});
            const double bound_m = double{std::max({chunk->entry->strip_above_m, chunk->entry->strip_below_m})};
            EXPECT_NEAR(point.height.m, region().height_m(i, j), bound_m + 0.05);
            EXPECT_EQ(point.post_class, PostClass::land);
        }
}

TEST(DrawnSurface, LiftsReachEveryPartOfAChunk) {
    const PostRange posts{64, 32, 128, 96};
    ChunkLift lift;
    lift.own_m = 1;
    for (int n = 0; n < 4; ++n) {
        lift.edge_m[n] = static_cast<float>(10 + n);
        lift.corner_m[n] = static_cast<float>(20 + n);
    }
    const auto at = [&](std::uint16_t i, std::uint16_t j) {
        ChunkVertex v{};
        v.i = i;
        v.j = j;
        return vertex_lift_m(lift, posts, v);
    };
    EXPECT_EQ(at(5, 5), 1);
    EXPECT_EQ(at(5, 0), 10);
    EXPECT_EQ(at(64, 5), 11);
    EXPECT_EQ(at(5, 64), 12);
    EXPECT_EQ(at(0, 5), 13);
    EXPECT_EQ(at(0, 0), 20);
    EXPECT_EQ(at(64, 0), 21);
    EXPECT_EQ(at(0, 64), 22);
    EXPECT_EQ(at(64, 64), 23);
}

TEST(DrawnSurface, NothingIsFoundWhereNothingIsDrawn) {
    const Drawn drawn(region(), over_all(region()), false);
    EXPECT_FALSE(drawn.at(region().lattice().point(0.1, 0.1)).found);
    const SelectedChunk& chunk = drawn.selection.chunks.front();
    const PostRange posts = region().lattice().posts_of(chunk.key);
    EXPECT_FALSE(drawn_point(region().database(), {&chunk, {drawn.vertices[0].data(), drawn.vertices[0].size()}, {}},
                             {posts.i0 + 0.5, posts.j0 + 0.5, true})
                     .found);
}

}  // namespace
}  // namespace tedavis::terrain::test_drawn_surface
