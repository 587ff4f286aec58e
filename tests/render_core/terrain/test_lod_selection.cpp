#include "render_core/terrain/lod_selection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/built_database.hpp"

namespace tedavis::terrain {
namespace {

using base::radians;
using test_support::BuiltDatabase;
using test_support::BuiltMesh;

constexpr std::uint32_t kColumns = 257, kRows = 225;

const host_sim::Raster& raster() {
    static const host_sim::Raster made = test_support::make_rough_raster(kColumns, kRows);
    return made;
}
const BuiltDatabase& built() {
    static const BuiltDatabase database(raster());
    return database;
}

glm::dvec3 post_position(std::int64_t i, std::int64_t j) {
    const host_sim::Raster& r = raster();
    const double latitude = radians(r.north_deg - static_cast<double>(j) * r.step_lat_deg),
                 longitude = radians(r.west_deg + static_cast<double>(i) * r.step_lon_deg);
    const double height = double{r.height_m[r.at(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j))]};
    return earth::to_ecef({latitude, longitude, {height + built().database.undulation(latitude, longitude).m}});
}

View view_from(double i, double j, double above_m, double heading_deg, double pitch_deg, double roll_deg = 0) {
    const host_sim::Raster& r = raster();
    const double latitude = radians(r.north_deg - j * r.step_lat_deg), longitude = radians(r.west_deg + i * r.step_lon_deg);
    const glm::dmat3 body = earth::body_axes(latitude, longitude, radians(heading_deg), radians(pitch_deg), radians(roll_deg));
    View view;
    view.eye =
        post_position(std::lround(i), std::lround(j)) + glm::normalize(post_position(std::lround(i), std::lround(j))) * above_m;
    view.forward = body[0];
    view.right = body[1];
    view.down = body[2];
    view.width = 1024;
    view.height = 768;
    view.focal_px = 512 / std::tan(radians(30));
    view.near_m = 5;
    return view;
}

struct Pixel {
    double x = 0, y = 0;
    bool visible = false;
};
Pixel project(const View& view, const glm::dvec3& point) {
    const glm::dvec3 d = point - view.eye;
    const double depth = glm::dot(d, view.forward);
    if (depth < view.near_m) return {};
    const double x = 0.5 * view.width + view.focal_px * glm::dot(d, view.right) / depth,
                 y = 0.5 * view.height + view.focal_px * glm::dot(d, view.down) / depth;
    return {x, y, x >= 0 && y >= 0 && x <= view.width && y <= view.height};
}

struct Selection {
    std::vector<std::uint8_t> states = std::vector<std::uint8_t>(built().database.chunk_count());
    std::vector<ChunkIndex> work = std::vector<ChunkIndex>(4096);
    std::vector<SelectedChunk> chunks = std::vector<SelectedChunk>(512);
    LodResult result;

    explicit Selection(const View& view, LodSettings settings = {1, 250000, 512}) {
        result = select_chunks(built().database, view, settings, {states.data(), states.size()}, {work.data(), work.size()},
                               {chunks.data(), chunks.size()});
        chunks.resize(result.chunks);
    }
};

std::vector<View> some_views() {
    std::vector<View> views;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int n = 0; n < 12; ++n)
        views.push_back(view_from(10 + unit(random) * (kColumns - 20), 10 + unit(random) * (kRows - 20),
                                  20 + 3000 * unit(random) * unit(random), 360 * unit(random), -40 * unit(random) + 5,
                                  60 * unit(random) - 30));
    views.push_back(view_from(128, 100, 15000, 0, -90));
    return views;
}

TEST(LodSelection, EveryVisiblePostIsCoveredByExactlyOneChunk) {
    int visible = 0;
    for (const View& view : some_views()) {
        const Selection selection(view);
        ASSERT_TRUE(selection.result.within_budget);
        for (std::int64_t j = 0; j < kRows - 1; j += 5)
            for (std::int64_t i = 0; i < kColumns - 1; i += 5) {
                if (!project(view, post_position(i, j)).visible) continue;
                ++visible;
                int covering = 0;
                for (const SelectedChunk& s : selection.chunks) {
                    const ChunkEntry& e = built().database.entry(s.chunk);
                    covering += (i >> e.level) / kChunkCells == e.i && (j >> e.level) / kChunkCells == e.j ? 1 : 0;
                }
                EXPECT_EQ(covering, 1) << "post " << i << ", " << j;
            }
    }
    EXPECT_GT(visible, 1000);
}

TEST(LodSelection, NeighboursDifferByOneLevelAndTheCoarserEdgesAreMarked) {
    for (const View& view : some_views()) {
        const Selection selection(view);
        for (const SelectedChunk& a : selection.chunks)
            for (const SelectedChunk& b : selection.chunks) {
                const ChunkEntry &fine = built().database.entry(a.chunk), &coarse = built().database.entry(b.chunk);
                if (fine.level >= coarse.level) continue;
                const std::uint32_t up = coarse.level - fine.level;
                const std::int64_t beside[4][2] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
                for (int edge = 0; edge < 4; ++edge) {
                    const std::int64_t i = std::int64_t{fine.i} + beside[edge][0], j = std::int64_t{fine.j} + beside[edge][1];
                    if (i < 0 || j < 0 || (i >> up) != coarse.i || (j >> up) != coarse.j) continue;
                    EXPECT_EQ(up, 1u);
                    EXPECT_NE(a.coarser_edges & (1 << edge), 0);
                }
            }
    }
}

/// Largest distance in pixels between a true post in view and the drawn mesh at its place.
double drawn_error_px(const View& view, const SelectedChunk& selected) {
    const BuiltMesh mesh(built(), selected.chunk, selected.coarser_edges);
    const ChunkEntry& e = built().database.entry(selected.chunk);
    const auto position = [&](std::uint16_t n) {
        const ChunkVertex& v = mesh.vertices[n];
        return glm::dvec3(e.centre_m[0] + v.x, e.centre_m[1] + v.y, e.centre_m[2] + v.z);
    };
    double worst = 0;
    for (std::size_t n = 0; n < mesh.indices.size(); n += 3) {
        const auto a = mesh.at(mesh.indices[n]), b = mesh.at(mesh.indices[n + 1]), c = mesh.at(mesh.indices[n + 2]);
        const double area =
            static_cast<double>((b.first - a.first) * (c.second - a.second) - (c.first - a.first) * (b.second - a.second));
        for (std::int64_t j = std::min({a.second, b.second, c.second}); j <= std::max({a.second, b.second, c.second}); ++j)
            for (std::int64_t i = std::min({a.first, b.first, c.first}); i <= std::max({a.first, b.first, c.first}); ++i) {
                if (i >= kColumns || j >= kRows) continue;
                const double v = static_cast<double>((i - a.first) * (c.second - a.second) -
                                                     (c.first - a.first) * (j - a.second)) /
                                 area,
                             w = static_cast<double>((b.first - a.first) * (j - a.second) -
                                                     (i - a.first) * (b.second - a.second)) /
                                 area;
                if (v < 0 || w < 0 || v + w > 1) continue;
                const glm::dvec3 drawn = position(mesh.indices[n]) * (1 - v - w) + position(mesh.indices[n + 1]) * v +
                                         position(mesh.indices[n + 2]) * w;
                const Pixel p = project(view, post_position(i, j)), q = project(view, drawn);
                if (p.visible && q.visible) worst = std::fmax(worst, std::hypot(p.x - q.x, p.y - q.y));
            }
    }
    return worst;
}

TEST(LodSelection, TheMeshesStayWithinTheErrorThatIsStatedForThem) {
    double worst_ratio = 0;
    std::size_t coarse = 0;
    for (const View& view : some_views())
        for (const double tau : {1.0, 8.0}) {
            const Selection selection(view, {tau, 250000, 512});
            double worst = 0;
            for (const SelectedChunk& s : selection.chunks) {
                if (built().database.entry(s.chunk).level == 0) continue;
                ++coarse;
                const double error = drawn_error_px(view, s);
                EXPECT_LE(error, double{s.error_px}) << "chunk " << s.chunk << " at tau " << tau;
                worst_ratio = std::fmax(worst_ratio, error / double{s.error_px});
                worst = std::fmax(worst, error);
            }
            EXPECT_LE(worst, selection.result.worst_error_px);
            EXPECT_LE(selection.result.worst_error_px, tau) << "the eye is far enough for level 0 to be within tau";
        }
    EXPECT_GT(coarse, 20u);
    EXPECT_GT(worst_ratio, 0.1) << "control: the bound must not be idle";
}

TEST(LodSelection, BudgetsRaiseTauAndAreNeverExceeded) {
    const View view = view_from(20, 110, 300, 90, -10);
    const Selection free(view, {0.25, 1000000, 512});
    ASSERT_TRUE(free.result.within_budget);
    EXPECT_EQ(free.result.tau_reached_px, 0.25);
    double last_tau = 0.25;
    for (const std::uint32_t triangles : {60000u, 30000u, 15000u, 9000u}) {
        const Selection tight(view, {0.25, triangles, 512});
        ASSERT_TRUE(tight.result.within_budget);
        EXPECT_LE(tight.result.triangles, triangles);
        EXPECT_GE(tight.result.tau_reached_px, last_tau);
        last_tau = tight.result.tau_reached_px;
    }
    EXPECT_GT(last_tau, 0.25);
    EXPECT_LE(Selection(view, {0.25, 1000000, 6}).result.chunks, 6u);
    EXPECT_FALSE(Selection(view, {0.25, 100, 512}).result.within_budget) << "the coarsest mesh does not fit";
}

TEST(LodSelection, NearestFirstAndTheSameEveryTime) {
    for (const View& view : some_views()) {
        const Selection first(view), second(view);
        ASSERT_EQ(first.chunks.size(), second.chunks.size());
        for (std::size_t n = 0; n < first.chunks.size(); ++n) EXPECT_EQ(first.chunks[n].chunk, second.chunks[n].chunk);
        for (std::size_t n = 1; n < first.chunks.size(); ++n)
            EXPECT_LE(first.chunks[n - 1].distance_m, first.chunks[n].distance_m);
    }
}

TEST(LodSelection, NoVisibleChunkIsCalledOutside) {
    int outside = 0;
    for (const View& view : some_views())
        for (ChunkIndex chunk = 0; chunk < built().database.chunk_count(); ++chunk) {
            const ChunkEntry& e = built().database.entry(chunk);
            if (!is_outside_view(e, view)) continue;
            ++outside;
            const std::int64_t side = std::int64_t{kChunkCells} << e.level;
            for (std::int64_t j = e.j * side; j <= std::min<std::int64_t>((e.j + 1) * side, kRows - 1); j += 3)
                for (std::int64_t i = e.i * side; i <= std::min<std::int64_t>((e.i + 1) * side, kColumns - 1); i += 3)
                    EXPECT_FALSE(project(view, post_position(i, j)).visible);
        }
    EXPECT_GT(outside, 100);
}

TEST(LodSelection, ABrokenViewIsNotTakenForAnEmptyOne) {
    View view = view_from(100, 100, 300, 0, 0);
    view.eye.x = std::nan("");
    const Selection selection(view, {1, 250000, 512});
    EXPECT_TRUE(!selection.result.within_budget || selection.result.chunks > 0);
}

}  // namespace
}  // namespace tedavis::terrain
