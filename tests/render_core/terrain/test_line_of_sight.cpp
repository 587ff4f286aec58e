#include "render_core/terrain/line_of_sight.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "render_core/terrain/chunk_mesh.hpp"
#include "tests/support/terrain/drawn_meshes.hpp"
#include "tests/support/terrain/selection.hpp"
#include "tests/support/terrain/terrain_views.hpp"

namespace tedavis::terrain::test_line_of_sight {
namespace {

using test_support::MeshesOfTest;
using test_support::ResidentTdb;
using test_support::Selection;
using test_support::TdbSpec;
using test_support::WrittenTdb;

const WrittenTdb& region() {
    static const WrittenTdb tdb([] {
        TdbSpec spec;
        spec.columns = spec.rows = 257;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) {
            return 1000 + 400 * std::sin(i * 0.09) * std::cos(j * 0.07) + 9 * std::sin(i * 1.3 + j * 0.7);
        };
        return spec;
    }());
    return tdb;
}

const WrittenTdb& world() {
    static const WrittenTdb tdb([] {
        TdbSpec spec = test_support::whole_earth(193, 97);
        spec.levels = 3;
        spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 3000 + 2500 * std::sin(i * 0.7) * std::cos(j * 0.9); };
        return spec;
    }());
    return tdb;
}

/// A plain with a wall from west to east in its middle, 300 m high.
const WrittenTdb& wall() {
    static const WrittenTdb tdb([] {
        TdbSpec spec;
        spec.columns = spec.rows = 129;
        spec.height_m = [](std::uint32_t, std::uint32_t j) { return j == 64 ? 800.0 : 500.0; };
        return spec;
    }());
    return tdb;
}

enum class Answer { hidden, seen, close };

/// By every triangle there is, in long double: barycentric weights and the share of the way. Close: within a thousandth.
class AllTriangles {
public:
    using Place = glm::vec<3, long double>;

    void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) { triangles_.push_back({{a, b, c}}); }
    [[nodiscard]] std::size_t size() const { return triangles_.size(); }
    [[nodiscard]] Answer ask(const View& view, const glm::dvec3& place) const {
        const Place way = Place(place) - Place(view.eye);
        const long double near = view.near_m / glm::dot(way, Place(view.forward));
        Answer answer = Answer::seen;
        for (const Triangle& t : triangles_) {
            const Place a = Place(t.at[0]) - Place(view.eye), ab = Place(t.at[1]) - Place(t.at[0]),
                        ac = Place(t.at[2]) - Place(t.at[0]);
            const Place across = glm::cross(way, ac);
            const long double determinant = glm::dot(ab, across);
            if (!(determinant > 0)) continue;  // from behind, or along it
            const long double u = -glm::dot(a, across) / determinant, v = -glm::dot(way, glm::cross(a, ab)) / determinant,
                              at = -glm::dot(ac, glm::cross(a, ab)) / determinant;
            constexpr long double kClose = 1e-3L;
            const long double inside = std::min({u, v, 1 - u - v}), within = std::min(at - near, LineOfSight::reach(view) - at);
            if (inside > kClose && within > 1e-6L) return Answer::hidden;
            if (inside > -kClose && within > -1e-6L) answer = Answer::close;
        }
        return answer;
    }

private:
    struct Triangle {
        glm::dvec3 at[3];
    };
    std::vector<Triangle> triangles_;
};

struct Scene {
    Scene(const WrittenTdb& tdb, const View& seen_from, bool conservative_up) : view(seen_from), meshes(tdb) {
        ResidentTdb catalogue(tdb);
        LodSettings settings;
        settings.tau_px = 4;
        settings.conservative_up = conservative_up;
        EXPECT_TRUE(selection.select(catalogue, view, settings).within_budget);
        for (const SelectedChunk& chunk : selection.chunks) {
            add_all(chunk, tdb.indices(chunk.key, chunk.coarser_edges), drawn);
            add_all(chunk, tdb.indices(chunk.key, 0), stored);
        }
    }
    void add_all(const SelectedChunk& chunk, const std::vector<std::uint16_t>& indices, AllTriangles& all) {
        const PostRange posts = meshes.tdb().lattice().posts_of(chunk.key);
        const auto vertices = meshes.vertices(chunk);
        const auto at = [&](std::size_t n) {
            const ChunkVertex& v = vertices[indices[n]];
            const double lift_m = double{vertex_lift_m(chunk.lift, posts, v)};
            const auto& lattice = meshes.tdb().lattice();
            return glm::dvec3(chunk.entry->centre_m[0], chunk.entry->centre_m[1], chunk.entry->centre_m[2]) +
                   glm::dvec3(double{v.x}, double{v.y}, double{v.z}) + lattice.position(posts.i0 + v.i, posts.j0 + v.j, lift_m) -
                   lattice.position(posts.i0 + v.i, posts.j0 + v.j, 0);
        };
        for (std::size_t n = 0; n + 2 < indices.size(); n += 3) all.add(at(n), at(n + 1), at(n + 2));
    }
    [[nodiscard]] bool is_hidden(const glm::dvec3& place) {
        const base::Span<const SelectedChunk> selected(selection.chunks.data(), selection.chunks.size());
        return LineOfSight(meshes.tdb().lattice(), selected, meshes, view).is_hidden(place);
    }

    View view;
    MeshesOfTest meshes;
    Selection selection;
    AllTriangles drawn, stored;
};

struct Tally {
    int hidden = 0, seen = 0, close = 0, other_when_stored = 0;
};

void compare(Scene& scene, const glm::dvec3& place, Tally& tally) {
    if (glm::dot(place - scene.view.eye, scene.view.forward) * LineOfSight::reach(scene.view) <= scene.view.near_m) return;
    const Answer expected = scene.drawn.ask(scene.view, place);
    ++(expected == Answer::hidden ? tally.hidden : expected == Answer::seen ? tally.seen : tally.close);
    if (expected == Answer::close) return;
    EXPECT_EQ(scene.is_hidden(place), expected == Answer::hidden);
    const Answer stored = scene.stored.ask(scene.view, place);
    tally.other_when_stored += stored != Answer::close && stored != expected ? 1 : 0;
}

TEST(LineOfSight, AgreesWithEveryTriangle) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const WrittenTdb* tdb : {&region(), &world()})
        for (const bool conservative_up : {false, true}) {
            Tally tally;
            const double scale = tdb == &world() ? 400 : 1;
            for (const View& view : test_support::some_views(*tdb, 6, 3, scale)) {
                Scene scene(*tdb, view, conservative_up);
                for (int n = 0; n < 100; ++n) {
                    const auto i = static_cast<std::uint32_t>(unit(random) * (tdb->lattice().columns() - 1));
                    const auto j = static_cast<std::uint32_t>(unit(random) * (tdb->lattice().rows() - 1));
                    const double over_m = scale * 700 * unit(random) * unit(random);
                    compare(scene, tdb->position(i, j) + glm::normalize(tdb->position(i, j)) * over_m, tally);
                }
            }
            EXPECT_GT(tally.hidden, 40);
            EXPECT_GT(tally.seen, 20);
            EXPECT_LT(tally.close, tally.hidden / 10);
        }
}

/// Sights that end between the border that is stored and the one that is drawn beside a coarser neighbour.
TEST(LineOfSight, SeesTheBordersThatAreDrawn) {
    Tally tally;
    for (const View& view : test_support::some_views(region(), 5, 5)) {
        Scene scene(region(), view, false);
        for (const SelectedChunk& chunk : scene.selection.chunks) {
            const PostRange posts = region().lattice().posts_of(chunk.key);
            const auto vertices = scene.meshes.vertices(chunk);
            for (std::uint32_t n = 1; n + 1 < chunk.entry->border_count; ++n) {
                const ChunkVertex& v = vertices[n];
                if (!is_taken_out(v, posts.i1 - posts.i0, posts.j1 - posts.j0, chunk.coarser_edges)) continue;
                const glm::dvec3 at = region().position(posts.i0 + v.i, posts.j0 + v.j), up = glm::normalize(at);
                for (const double over_m : {-3.0, -1.0, 1.0, 3.0})
                    compare(scene, view.eye + (at + up * over_m - view.eye) / 0.9, tally);
            }
        }
    }
    EXPECT_GT(tally.other_when_stored, 5) << "what is stored would not do";
}

TEST(LineOfSight, WhatStandsOnTheGroundIsNotHiddenByIt) {
    int seen = 0;
    // 3 km south of the wall, 100 m over the plain.
    const View view = test_support::view_from(wall(), 64, 100, 100, 0, 0);
    Scene scene(wall(), view, true);
    for (std::uint32_t i = 40; i < 90; i += 3)
        for (std::uint32_t j = 66; j < 92; j += 3) {
            EXPECT_FALSE(scene.is_hidden(wall().position(i, j))) << i << ", " << j;
            ++seen;
        }
    EXPECT_GT(seen, 100);
}

TEST(LineOfSight, AWallHidesWhatIsBehindAndBelowItsTop) {
    const View view = test_support::view_from(wall(), 64, 100, 100, 0, 0);
    Scene scene(wall(), view, false);
    const auto over = [&](std::uint32_t j, double metres) {
        return wall().position(64, j) + glm::normalize(wall().position(64, j)) * metres;
    };
    EXPECT_FALSE(scene.is_hidden(over(66, 0))) << "before it";
    EXPECT_TRUE(scene.is_hidden(over(40, 0)));
    EXPECT_TRUE(scene.is_hidden(over(62, 250)));
    EXPECT_FALSE(scene.is_hidden(over(62, 400)));
    // From 100 m over the plain, the top at 300 m in 36 rows: 200 / 36 a row beyond.
    EXPECT_TRUE(scene.is_hidden(over(28, 100 + 72 * 200 / 36.0 - 40)));
    EXPECT_FALSE(scene.is_hidden(over(28, 100 + 72 * 200 / 36.0 + 40)));
    EXPECT_FALSE(scene.is_hidden(view.eye - view.forward * 500.0)) << "nobody looks back";
    scene.view.near_m = 5000;
    EXPECT_FALSE(scene.is_hidden(over(40, 0))) << "the wall lies before the near plane and is not drawn";
}

TEST(LineOfSight, WithoutChunksNothingIsHidden) {
    Scene scene(wall(), test_support::view_from(wall(), 64, 100, 100, 0, 0), false);
    scene.selection.chunks.clear();
    EXPECT_FALSE(scene.is_hidden(wall().position(64, 40)));
}

}  // namespace
}  // namespace tedavis::terrain::test_line_of_sight
