#include "render_core/raytrace/picture/paged_terrain.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "render_core/raytrace/paged/database_chunks.hpp"
#include "render_core/raytrace/picture/kernel_terrain.hpp"
#include "tests/support/raytrace/held_chunks.hpp"
#include "tests/support/raytrace/traced_ground.hpp"
#include "tests/support/terrain/ground_files.hpp"
#include "tests/support/terrain/terrain_views.hpp"

namespace tedavis::raytrace::test_paged_terrain {
namespace {

using test_support::OpenedGround;

constexpr std::uint32_t kWidth = 190, kHeight = 120, kPixels = kWidth * kHeight;

struct PlacedPicture : test_support::TracedPicture {
    PlacedPicture() : TracedPicture(kWidth, kHeight) {}
    [[nodiscard]] HitPicture hits() { return {t, cell, side, u, v}; }
    std::vector<float> u = std::vector<float>(kPixels), v = u;
};

test_support::HeightField<float> read_heights(OpenedGround& opened) {
    base::SerialWorkers alone;
    const test_support::ReadGround<float> read(opened.database, opened.all(), 1, alone, 1);
    test_support::HeightField<float> field(read.window.columns(), read.window.rows());
    field.posts = read.heights;
    return field;
}

/// Terrain in memory, and paged from chunks of heights.
class BothTerrains {
public:
    BothTerrains(OpenedGround& opened, test_support::HeightField<float> paged_heights, CellSurface surface)
        : space_(opened.database, opened.all(), 1),
          whole_(read_heights(opened)),
          paged_(std::move(paged_heights)),
          chunks_(paged_.grid()),
          pages_(chunks_, {5, kPixels, 1}),
          memory_(PagedTerrain::bytes_needed(kWidth, kHeight) / 8 + 1) {
        base::Arena arena(memory_.data(), memory_.size() * 8);
        EXPECT_TRUE(terrain_.start(pages_.tracer, surface, kWidth, kHeight, arena));
        field_ = whole_.traced(surface);
        field_.minima = nullptr;
        kernel_.start(field_, 1, kWidth, kHeight);
    }
    /// Pixels whose hit or surface has other bits; adds those that have a hit.
    std::size_t different(const terrain::View& view, std::size_t& hit_count) {
        const PictureSight sight = PictureSight::of_world(space_, view);
        kernel_.set_view(sight, view_kernels<float>()[0]);
        base::SerialWorkers alone;
        work = terrain_.trace_picture(sight, packet_kernels<float>()[0], alone);
        PlacedPicture whole, paged;
        kernel_.trace({0, 0, kWidth, kHeight}, whole.hits());
        for (std::uint32_t x = 0; x < kWidth; x += 32) terrain_.trace({x, 0, std::min(32u, kWidth - x), kHeight}, paged.hits());
        std::size_t count = 0;
        for (std::uint32_t y = 0; y < kHeight; ++y) {
            SpanSurface a, b;
            const PixelSpan span{y * kWidth + 64, 64};
            kernel_.find_surface(span, whole.hits(), a);
            terrain_.find_surface(span, paged.hits(), b);
            for (std::uint32_t n = 0; n < span.count; ++n) {
                hit_count += a.is_hit[n];
                count += is_different(a, b, n) || paged.side[span.first + n] != whole.side[span.first + n];
            }
        }
        return count;
    }
    PagedWork work;

private:
    static bool is_different(const SpanSurface& a, const SpanSurface& b, std::uint32_t n) {
        const auto is_other = [n](const auto& one, const auto& two) { return std::memcmp(&one[n], &two[n], sizeof one[n]) != 0; };
        if (a.is_hit[n] != b.is_hit[n] || is_other(a.t, b.t)) return true;
        return a.is_hit[n] && (is_other(a.x, b.x) || is_other(a.y, b.y) || is_other(a.height, b.height) ||
                               is_other(a.slope_x, b.slope_x) || is_other(a.slope_y, b.slope_y));
    }

    GroundSpace space_;
    test_support::TracedGround<float> whole_;
    test_support::HeightField<float> paged_;
    test_support::HeldChunks<float> chunks_;
    test_support::StartedPages<float> pages_;
    std::vector<std::uint64_t> memory_;
    PagedTerrain terrain_;
    TracedField<float> field_;
    KernelTerrain<float> kernel_;
};

std::vector<terrain::View> views_over(const OpenedGround& opened, int count) {
    std::vector<terrain::View> views = test_support::some_views(opened.tdb, count, 7, 4);
    for (terrain::View& view : views) {
        view.width = kWidth;
        view.height = kHeight;
        view.focal_px = 260;
        view.far_m = 90000;
    }
    return views;
}

TEST(PagedTerrain, HasTheBitsOfTheTerrainInMemory) {
    for (const CellSurface surface : {CellSurface::two_triangles, CellSurface::bilinear})
        for (const bool has_voids : {false, true}) {
            OpenedGround opened(test_support::mixed_file(has_voids));
            BothTerrains both(opened, read_heights(opened), surface);
            std::size_t hit_count = 0, loads = 0;
            for (const terrain::View& view : views_over(opened, 6)) {
                EXPECT_EQ(both.different(view, hit_count), 0u);
                loads += both.work.loads;
            }
            EXPECT_GT(hit_count, 5000u);
            EXPECT_GT(loads, 10u);
        }
}

TEST(PagedTerrain, TheComparisonSeesPostsOfAChunkThatAreHigher) {
    OpenedGround opened(test_support::mixed_file(false));
    test_support::HeightField<float> raised = read_heights(opened);
    for (std::uint32_t j = 1; j < raised.rows - 1; ++j)
        for (std::uint32_t i = 97; i < 128; ++i) raised.at(i, j) += 0.125f;
    BothTerrains both(opened, std::move(raised), CellSurface::two_triangles);
    std::size_t hit_count = 0, different = 0;
    for (const terrain::View& view : views_over(opened, 6)) different += both.different(view, hit_count);
    EXPECT_GT(different, 100u);
    EXPECT_LT(different, hit_count / 2) << "elsewhere it is the same";
}

TEST(PagedTerrain, RefusesAnArenaThatIsTooSmall) {
    PagedTracer<float> tracer;
    PagedTerrain terrain;
    std::vector<std::uint64_t> memory(PagedTerrain::bytes_needed(kWidth, kHeight) / 8 + 1);
    base::Arena small(memory.data(), memory.size() * 4);
    EXPECT_FALSE(terrain.start(tracer, CellSurface::bilinear, kWidth, kHeight, small));
}

TEST(PagedTerrainDeathTest, HasNoSingleRays) {
    const PagedTerrain terrain;
    EXPECT_DEATH((void)terrain.intersect({}), "");
    EXPECT_DEATH((void)terrain.is_hidden({}), "");
}

}  // namespace
}  // namespace tedavis::raytrace::test_paged_terrain
