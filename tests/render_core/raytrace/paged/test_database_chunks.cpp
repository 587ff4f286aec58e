#include "render_core/raytrace/paged/database_chunks.hpp"

#include <gtest/gtest.h>

#include "platform/threads/thread_workers.hpp"
#include "tests/support/raytrace/held_chunks.hpp"
#include "tests/support/raytrace/traced_ground.hpp"
#include "tests/support/terrain/ground_files.hpp"

namespace tedavis::raytrace::test_database_chunks {
namespace {

using test_support::mixed_file;
using test_support::OpenedGround;
using test_support::ReadGround;
using test_support::StartedPages;
using test_support::TracedPicture;
using Ground = test_support::TracedGround<float>;

struct StartedChunks {
    StartedChunks(OpenedGround& ground, const terrain::PostRange& window, std::uint32_t desks)
        : memory(DatabaseChunks::bytes_needed(desks) / 8 + 1) {
        base::Arena arena(memory.data(), memory.size() * 8);
        EXPECT_TRUE(chunks.start(ground.database, window, desks, arena));
    }
    std::vector<std::uint64_t> memory;
    DatabaseChunks chunks;
};

/// What GroundReader gives of a window, as the tracer takes it.
Ground whole_ground(OpenedGround& ground, const terrain::PostRange& window) {
    base::SerialWorkers workers;
    const ReadGround<float> read(ground.database, window, 1, workers, 1);
    test_support::HeightField<float> field(read.window.columns(), read.window.rows());
    field.posts = read.heights;
    return Ground(std::move(field), Ground::Starts::anywhere);
}

GridCamera camera_over(std::mt19937& random, const terrain::PostRange& window) {
    GridCamera camera = test_support::any_camera(random, window.i1 - window.i0, window.j1 - window.j0, 80);
    camera.origin.z = 500 + 0.25 * camera.origin.z;
    for (glm::vec3* const part : {&camera.corner, &camera.right, &camera.down}) part->z *= 0.2f;
    return camera;
}

std::size_t wrong_pixels(OpenedGround& ground, const terrain::PostRange& window, std::uint32_t slots, bool is_damaged) {
    const Ground whole = whole_ground(ground, window);
    const auto workers = platform::make_thread_workers({2, nullptr});
    StartedChunks started(ground, window, 2);
    StartedPages<float> pages(started.chunks, {slots, 80 * 60, 2});
    EXPECT_EQ(pages.started, PagedTracer<float>::Started::yes);
    std::mt19937 random(slots);
    std::size_t wrong = 0, hit_count = 0;
    std::uint32_t found = 0;
    for (int n = 0; n < 12; ++n) {
        const GridCamera camera = camera_over(random, window);
        const auto field = whole.traced(CellSurface::two_triangles);
        const TracedPicture singly = test_support::traced_singly(field, camera, 80, 60);
        for (const HitSide side : singly.side) hit_count += side != HitSide::none;
        wrong += pages.trace(camera, 80, 60, window.i1 - window.i0, field.surface, packet_kernels<float>()[0], *workers.value())
                     .differences(singly);
        found = std::max(found, pages.work.damaged);
    }
    EXPECT_GT(hit_count, 5000u);
    EXPECT_EQ(found > 0, is_damaged);
    EXPECT_GT(started.chunks.read_bytes(), 0u);
    return wrong;
}

TEST(DatabaseChunks, PicturesAreThoseOfTheWholeDatabase) {
    for (const bool has_voids : {false, true}) {
        OpenedGround ground(mixed_file(has_voids));
        for (const std::uint32_t slots : {1u, 4u, 64u}) EXPECT_EQ(wrong_pixels(ground, ground.all(), slots, false), 0u);
        EXPECT_EQ(wrong_pixels(ground, {64, 32, 201, 256}, 8, false), 0u) << "a window";
    }
}

TEST(DatabaseChunks, ChunksAreThePostsThatTheReaderGives) {
    OpenedGround ground(mixed_file(true));
    base::SerialWorkers workers;
    const ReadGround<float> whole(ground.database, ground.all(), 1, workers, 1);
    StartedChunks started(ground, {32, 0, 250, 256}, 1);
    constexpr std::uint32_t kSide = DatabaseChunks::kPosts;
    std::vector<float> posts(kSide * kSide), lowest(7 * 8), highest(7 * 8);
    ASSERT_EQ(started.chunks.chunk_columns(), 7u);
    ASSERT_EQ(started.chunks.chunk_rows(), 8u);
    ASSERT_TRUE(started.chunks.read_bounds(lowest, highest));
    for (std::uint32_t chunk = 0; chunk < 7 * 8; ++chunk) {
        ASSERT_TRUE(started.chunks.load(chunk % 7, chunk / 7, 0, posts));
        for (std::uint32_t n = 0; n < kSide * kSide; ++n) {
            const std::uint32_t i = 32 + chunk % 7 * 32 + n % kSide, j = chunk / 7 * 32 + n / kSide;
            const float post = i <= 250 && j <= 256 ? whole.at(i, j) : HeightGrid<float>::kVoid;
            ASSERT_EQ(posts[n], post) << i << ", " << j;
            ASSERT_TRUE(post == HeightGrid<float>::kVoid || (post >= lowest[chunk] && post <= highest[chunk]));
        }
    }
}

TEST(DatabaseChunks, DamageIsAHoleAndCounted) {
    OpenedGround ground(mixed_file(false));
    for (std::uint32_t i = 0; i < 8; i += 2)
        for (std::uint32_t j = 4; j < 8; ++j) ground.bytes.content[ground.tdb.entry({0, i, j}).payload.offset + 10] ^= 1;
    EXPECT_EQ(wrong_pixels(ground, ground.all(), 64, true), 0u);
    OpenedGround coarse(mixed_file(false));
    coarse.bytes.content[coarse.tdb.entry({2, 1, 0}).payload.offset + 10] ^= 1;
    StartedChunks started(coarse, coarse.all(), 1);
    std::vector<float> posts(DatabaseChunks::kPosts * DatabaseChunks::kPosts);
    for (std::uint32_t n = 0; n < 16; ++n) EXPECT_FALSE(started.chunks.load(4 + n % 4, n / 4, 0, posts));
    EXPECT_TRUE(started.chunks.load(4, 4, 0, posts));
    EXPECT_TRUE(started.chunks.load(3, 3, 0, posts));
}

TEST(DatabaseChunks, ADamagedPageIsSaid) {
    OpenedGround ground(mixed_file(false));
    StartedChunks started(ground, ground.all(), 1);
    std::vector<float> lowest(64), highest(64);
    ASSERT_TRUE(started.chunks.read_bounds(lowest, highest));
    EXPECT_EQ(started.chunks.damaged_pages(), 0u);
    ground.bytes.content[ground.database.page_offset(ground.database.lattice().page_index({0, 0, 0})) + 100] ^= 1;
    ASSERT_TRUE(started.chunks.read_bounds(lowest, highest));
    EXPECT_EQ(started.chunks.damaged_pages(), 1u);
    EXPECT_GT(lowest[63], highest[63]) << "of level 0";
    EXPECT_LT(lowest[4], highest[4]) << "of level 2";
}

TEST(DatabaseChunks, RefusesWhatDoesNotDo) {
    OpenedGround ground(mixed_file(false));
    std::vector<std::uint64_t> memory(DatabaseChunks::bytes_needed(2) / 8 + 1);
    base::Arena small(memory.data(), memory.size() * 4), enough(memory.data(), memory.size() * 8);
    DatabaseChunks chunks;
    EXPECT_FALSE(chunks.start(ground.database, ground.all(), 2, small));
    EXPECT_FALSE(chunks.start(ground.database, {0, 0, 0, 100}, 1, enough)) << "one column";
    EXPECT_TRUE(chunks.start(ground.database, ground.all(), 2, enough));
}

}  // namespace
}  // namespace tedavis::raytrace::test_database_chunks
