#include "host_sim/tracing/paged_drawer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/trace.hpp"
#include "host_sim/temporary_folder.hpp"
#include "platform/threads/thread_workers.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::host_sim::test_paged_drawer {
namespace {

constexpr std::uint64_t kPagedBytes = 300'000;

/// Hills of whole metres, of which columns of one chunk may be higher.
test_support::TdbSpec hills(int raised_m) {
    test_support::TdbSpec spec;
    spec.columns = spec.rows = 385;
    spec.height_m = [raised_m](std::uint32_t i, std::uint32_t j) {
        return std::round(600 + 250 * std::sin(0.05 * i) * std::cos(0.04 * j)) + (i > 192 && i < 224 ? raised_m : 0);
    };
    spec.measured = false;
    return spec;
}

struct WrittenGround {
    explicit WrittenGround(int raised_m = 0) : tdb(hills(raised_m)) { write(); }
    void write() const { write_file_atomically(path, std::string(tdb.bytes.begin(), tdb.bytes.end())); }
    TemporaryFolder folder;
    std::string path = folder.path() + "/ground.tdb";
    test_support::WrittenTdb tdb;
};

/// As the command draws it, in at most so many bytes of heights.
TracedShot drawn(const std::string& path, std::uint64_t bytes, std::uint32_t threads = 1) {
    const raytrace::TraceSettings settings = settings_of(TracePreset::time);
    const auto workers = platform::make_thread_workers({threads, nullptr});
    const TracedGround ground(path, *workers.value(), {bytes, {settings}});
    TracedShotPlan plan;
    plan.pose = usual_pose(ground);
    plan.width = 190;
    plan.height = 130;
    return draw_traced_shot(ground, settings, plan, *workers.value());
}

TEST(PagedDrawer, PixelsAreThoseOfWholeMetresInMemory) {
    const WrittenGround ground;
    const TracedShot whole = drawn(ground.path, 10'000'000);
    EXPECT_FALSE(whole.paged.has_value());
    for (const std::uint32_t threads : {1u, 2u}) {
        const TracedShot paged = drawn(ground.path, kPagedBytes, threads);
        EXPECT_EQ(paged.pixels.pixels, whole.pixels.pixels) << threads;
        EXPECT_EQ(paged.ground_share, whole.ground_share);
        ASSERT_TRUE(paged.paged.has_value());
        EXPECT_EQ(paged.paged->chunks, 12u * 12u);
        EXPECT_LT(paged.paged->slots, 20u);
        EXPECT_LE(paged.paged->held_bytes, kPagedBytes);
        EXPECT_GT(paged.paged->read_bytes, 10'000u);
        EXPECT_GT(paged.paged->chunks_read, paged.paged->slots);
    }
}

TEST(PagedDrawer, APostOfAChunkThatIsHigherChangesThem) {
    const WrittenGround ground, raised(1);
    EXPECT_NE(drawn(ground.path, kPagedBytes).pixels.pixels, drawn(raised.path, kPagedBytes).pixels.pixels);
}

TEST(PagedDrawer, RefusesMemoryForLessThanAChunkOfEachWorker) {
    const WrittenGround ground;
    test_support::expect_user_error([&] { (void)drawn(ground.path, 90'000); }, "one chunk for each of 1 worker take");
    test_support::expect_user_error([&] { (void)drawn(ground.path, 120'000, 2); }, "give --memory 0.");
}

TEST(PagedDrawer, RefusesDamage) {
    WrittenGround ground;
    for (std::uint32_t i = 0; i < 12; ++i)
        for (std::uint32_t j = 0; j < 12; ++j) ground.tdb.bytes[ground.tdb.entry({0, i, j}).payload.offset + 5] ^= 1;
    ground.write();
    test_support::expect_user_error([&] { (void)drawn(ground.path, kPagedBytes); }, " damaged chunks;");
    WrittenGround pages;
    pages.tdb.bytes[pages.tdb.database().page_offset(pages.tdb.lattice().page_index({0, 0, 0})) + 100] ^= 1;
    pages.write();
    test_support::expect_user_error([&] { (void)drawn(pages.path, kPagedBytes); }, "has 1 damaged directory pages");
}

}  // namespace
}  // namespace tedavis::host_sim::test_paged_drawer
