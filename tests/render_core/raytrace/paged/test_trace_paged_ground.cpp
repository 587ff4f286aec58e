#include "render_core/raytrace/paged/trace_paged_ground.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "platform/threads/thread_workers.hpp"
#include "render_core/raytrace/paged/database_chunks.hpp"
#include "tests/support/raytrace/held_chunks.hpp"
#include "tests/support/raytrace/traced_ground.hpp"
#include "tests/support/terrain/ground_files.hpp"
#include "tests/support/terrain/terrain_views.hpp"

namespace tedavis::raytrace::test_trace_paged_ground {
namespace {

using test_support::OpenedGround;

constexpr std::uint32_t kWidth = 190, kHeight = 120, kPixels = kWidth * kHeight;

terrain::View small_view(terrain::View view) {
    view.width = kWidth;
    view.height = kHeight;
    view.focal_px = 260;
    view.far_m = 90000;
    return view;
}

/// A database in memory as a grid, and in chunks.
struct BothGrounds {
    BothGrounds(OpenedGround& opened, std::uint32_t slots)
        : space(opened.database, opened.all(), 1),
          whole(read(opened), test_support::TracedGround<float>::Starts::anywhere),
          memory(DatabaseChunks::bytes_needed(2) / 8 + 1) {
        base::Arena arena(memory.data(), memory.size() * 8);
        EXPECT_TRUE(chunks.start(opened.database, opened.all(), 2, arena));
        pages = std::make_unique<test_support::StartedPages<float>>(chunks, PagedSettings{slots, kPixels, 2});
    }
    static test_support::HeightField<float> read(OpenedGround& opened) {
        base::SerialWorkers workers;
        const test_support::ReadGround<float> heights(opened.database, opened.all(), 1, workers, 1);
        test_support::HeightField<float> field(heights.window.columns(), heights.window.rows());
        field.posts = heights.heights;
        return field;
    }
    /// Pixels that are not the same; adds those that meet something.
    std::size_t different(const terrain::View& view, const GroundSpace& seen_in, std::size_t& hit_count) {
        const auto workers = platform::make_thread_workers({2, nullptr});
        test_support::TracedPicture picture(kWidth, kHeight);
        trace_ground(whole.traced(CellSurface::two_triangles), space, view, view_kernels<float>()[0], *workers.value(),
                     picture.picture());
        std::vector<GridCamera> cameras(ViewTiles(kWidth, kHeight).count());
        std::vector<Hit> hits(kPixels);
        work = trace_paged_ground(pages->tracer, seen_in, view, CellSurface::two_triangles, true, packet_kernels<float>()[0],
                                  *workers.value(), cameras, hits);
        std::size_t count = 0;
        for (std::uint32_t n = 0; n < kPixels; ++n) {
            const bool is_hit = hits[n].side != HitSide::none;
            const std::int32_t cell =
                is_hit ? static_cast<std::int32_t>(hits[n].row * (whole.field.columns - 1) + hits[n].column) : -1;
            count += hits[n].side != picture.side[n] || cell != picture.cell[n] ||
                     std::memcmp(&hits[n].t, &picture.t[n], sizeof(float)) != 0;
            hit_count += is_hit;
        }
        return count;
    }

    GroundSpace space;
    test_support::TracedGround<float> whole;
    std::vector<std::uint64_t> memory;
    DatabaseChunks chunks;
    std::unique_ptr<test_support::StartedPages<float>> pages;
    PagedWork work;
};

TEST(TracePagedGround, IsThePictureOfTheWholeDatabase) {
    for (const bool has_voids : {false, true}) {
        OpenedGround opened(test_support::mixed_file(has_voids));
        for (const std::uint32_t slots : {1u, 9u}) {
            BothGrounds grounds(opened, slots);
            std::size_t hit_count = 0, loads = 0;
            for (const terrain::View& seen : test_support::some_views(opened.tdb, 12, 7, 4)) {
                const terrain::View view = small_view(seen);
                ASSERT_TRUE(can_trace(grounds.space, view));
                EXPECT_EQ(grounds.different(view, grounds.space, hit_count), 0u);
                loads += grounds.work.loads;
            }
            EXPECT_GT(hit_count, 20000u);
            EXPECT_GT(loads, 10u);
        }
    }
}

TEST(TracePagedGround, TheCheckSeesASpaceThatIsOffByAColumn) {
    OpenedGround opened(test_support::mixed_file(false));
    BothGrounds grounds(opened, 64);
    const GroundSpace aside(opened.database, {1, 0, 256, 256}, 1);
    const terrain::View view = small_view(test_support::some_views(opened.tdb, 1, 7, 4)[0]);
    std::size_t hit_count = 0;
    EXPECT_GT(grounds.different(view, aside, hit_count), 500u);
}

}  // namespace
}  // namespace tedavis::raytrace::test_trace_paged_ground
