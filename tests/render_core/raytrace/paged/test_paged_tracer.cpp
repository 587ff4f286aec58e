#include "render_core/raytrace/paged/paged_tracer.hpp"

#include <gtest/gtest.h>

#include "platform/threads/thread_workers.hpp"
#include "tests/support/raytrace/held_chunks.hpp"
#include "tests/support/raytrace/traced_ground.hpp"
#include "tests/support/terrain/generated_chunks.hpp"

namespace tedavis::raytrace::test_paged_tracer {
namespace {

using test_support::HeldChunks;
using test_support::StartedPages;
using test_support::TracedPicture;
using test_support::ViewedHills;
using Tracer = PagedTracer<std::int16_t>;
constexpr CellSurface kTriangles = CellSurface::two_triangles;

const PacketKernel<std::int16_t>& widest() { return packet_kernels<std::int16_t>()[0]; }

std::size_t differences(const Hit& a, const Hit& b) {
    return a.side != b.side || std::memcmp(&a.t, &b.t, sizeof a.t) != 0 || a.column != b.column || a.row != b.row ? 1 : 0;
}

/// Along and through lines and corners of cells and chunks, upright, level, with ends; from everywhere.
std::vector<Ray> hard_rays(std::uint32_t columns, std::uint32_t rows, std::uint32_t count) {
    std::mt19937 random(5);
    const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    std::vector<Ray> rays;
    for (std::uint32_t n = 0; n < count; ++n) {
        Ray ray;
        ray.origin = {any(-0.3, 1.3) * columns, any(-0.3, 1.3) * rows, any(-3000, 9000)};
        if (n % 3 == 0) ray.origin = {32 * std::floor(ray.origin.x / 32), std::floor(ray.origin.y), std::floor(ray.origin.z)};
        if (n % 5 == 0) ray.origin.y = 32 * std::floor(ray.origin.y / 32);
        ray.direction = {any(-1, 1), any(-1, 1), any(-150, 60)};
        if (n % 4 == 1) ray.direction = {std::floor(any(-1, 2)), std::floor(any(-1, 2)), std::floor(any(-90, 30))};
        if (n % 7 == 2) ray.direction.z = 0;
        if (ray.direction == glm::vec3(0)) ray.direction.z = -1;
        if (n % 8 == 5) ray.gap = 200;
        if (n % 6 == 3) ray.from = static_cast<float>(any(0, 60));
        if (n % 6 >= 3) ray.to = ray.from + static_cast<float>(any(0, 200));
        rays.push_back(ray);
    }
    return rays;
}

TEST(PagedTracer, AnyRaysMeetWhatTheyMeetInTheWhole) {
    const ViewedHills<std::int16_t> hills(330, 261, true);
    auto field = hills.field(kTriangles);
    HeldChunks<std::int16_t> chunks(field.grid());
    const std::vector<Ray> rays = hard_rays(330, 261, 20000);
    std::vector<Hit> hits(rays.size());
    base::SerialWorkers workers;
    for (const std::uint32_t slots : {1u, 7u, 99u}) {
        StartedPages<std::int16_t> pages(chunks, {slots, 20000, 1});
        for (const bool from_below : {true, false}) {
            if (!from_below) field.minima = nullptr;
            for (const auto& kernel : packet_kernels<std::int16_t>()) {
                pages.tracer.trace(PagedRays::of(rays), kTriangles, from_below, kernel, workers, hits);
                std::size_t wrong = 0, hit_count = 0;
                for (std::size_t n = 0; n < rays.size(); ++n) {
                    const Hit whole = trace_ray(field, rays[n]);
                    wrong += differences(hits[n], whole);
                    hit_count += whole.side != HitSide::none;
                }
                EXPECT_EQ(wrong, 0u) << kernel.name << ", slots " << slots << (from_below ? ", from below" : "");
                EXPECT_GT(hit_count, 3000u);
            }
        }
        field = hills.field(kTriangles);
    }
}

TEST(PagedTracer, IsTheSameForEveryNumberOfWorkersAndLoadsEachChunkOnce) {
    const ViewedHills<std::int16_t> hills(700, 611, false);
    const auto field = hills.field(kTriangles);
    HeldChunks<std::int16_t> chunks(field.grid());
    GridCamera camera;  // from above, inwards
    camera.origin = {-20, 300.5, 12000};
    camera.corner = {1, -0.5f, -60};
    camera.right = {0, 0.005f, 0};
    camera.down = {0.001f, 0, -2};
    base::SerialWorkers serial;
    const TracedPicture singly = test_support::traced_singly(field, camera, 200, 90);
    std::uint32_t loads = 0;
    for (const std::uint32_t slots : {500u, 1u, 9u})
        for (const std::uint32_t threads : {1u, 2u, 7u}) {
            const auto workers = platform::make_thread_workers({threads, nullptr});
            StartedPages<std::int16_t> pages(chunks, {slots, 200 * 90, threads});
            const TracedPicture paged = pages.trace(camera, 200, 90, 699, kTriangles, widest(), *workers.value());
            EXPECT_EQ(paged.differences(singly), 0u);
            if (loads == 0) loads = pages.work.loads;
            EXPECT_EQ(pages.work.loads, loads) << slots << " slots, " << threads << " threads";
            EXPECT_EQ(pages.tracer.slots().in_use(), std::min(slots, loads));
            EXPECT_EQ(pages.work.passes == loads, slots == 1);
            (void)pages.trace(camera, 200, 90, 699, kTriangles, widest(), *workers.value());
            EXPECT_EQ(pages.work.loads == 0, slots == 500) << "what is kept is not loaded again";
        }
    EXPECT_GT(loads, 30u);
    EXPECT_LT(loads, 19u * 22u) << "some are never asked for";
}

TEST(PagedTracer, APictureIsTracedInPiecesOfItsRays) {
    const ViewedHills<std::int16_t> hills(330, 261, false);
    const auto field = hills.field(kTriangles);
    HeldChunks<std::int16_t> chunks(field.grid());
    StartedPages<std::int16_t> pages(chunks, {5, 100 * 80, 1});
    std::mt19937 random(12);
    base::SerialWorkers workers;
    std::size_t wrong = 0, first = 0, second = 0;
    for (int n = 0; n < 6; ++n) {
        const GridCamera camera = test_support::any_camera(random, 330, 261, 100);
        std::vector<Hit> hits(100 * 80);
        PagedRays rays = PagedRays::of(camera, 100, 80);
        rays.span.to = 60;
        (void)pages.tracer.trace(rays, kTriangles, true, widest(), workers, hits);
        rays.span = {60, 190, 30};
        rays.goes_on = true;
        (void)pages.tracer.trace(rays, kTriangles, true, widest(), workers, hits);
        for (std::uint32_t at = 0; at < hits.size(); ++at) {
            Ray ray = camera.ray(at % 100, at / 100);
            ray.to = 60;
            Hit whole = trace_ray(field, ray);
            first += whole.side != HitSide::none;
            if (whole.side == HitSide::none) {
                ray.from = 60;
                ray.to = 190;
                ray.gap = 30;
                whole = trace_ray(field, ray);
                second += whole.side != HitSide::none;
            }
            wrong += differences(hits[at], whole);
        }
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(first, 1000u);
    EXPECT_GT(second, 1000u);
}

/// 4,295 million posts, of which 1,025 x 1,025 near its far corner are in memory for comparison.
TEST(PagedTracer, GroundThatIsNeverInMemoryIsTracedLikeAPartOfItThatIs) {
    constexpr std::uint32_t kSide = HeightGrid<std::int16_t>::kMaxPosts, kFirst = kSide - 2049, kPart = 1025;
    test_support::HeightField<std::int16_t> part(kPart, kPart);
    for (std::uint32_t j = 0; j < kPart; ++j)
        for (std::uint32_t i = 0; i < kPart; ++i) part.at(i, j) = test_support::GeneratedChunks::height(kFirst + i, kFirst + j);
    const test_support::TracedGround<std::int16_t> ground(std::move(part));
    test_support::GeneratedChunks chunks(kSide, kSide);
    constexpr std::uint32_t kWidth = 160, kHeight = 120;
    StartedPages<std::int16_t> pages(chunks, {256, kWidth * kHeight, 1});
    ASSERT_EQ(pages.started, Tracer::Started::yes);
    EXPECT_LT(pages.memory.size() * 8, std::uint64_t{kSide} * kSide * 2 / 100) << "a hundredth of the posts";
    base::SerialWorkers workers;
    std::mt19937 random(3);
    std::vector<Hit> hits(std::size_t{kWidth} * kHeight);
    std::size_t compared = 0, wrong = 0;
    for (int n = 0; n < 6; ++n) {
        GridCamera near = test_support::any_camera(random, kPart, kPart, kWidth), far = near;
        near.origin = {512.25 + n, 500.5 + n, 4000};
        far.origin = near.origin + glm::dvec3(kFirst, kFirst, 0);
        (void)pages.tracer.trace(PagedRays::of(far, kWidth, kHeight), kTriangles, true, widest(), workers, hits);
        for (std::uint32_t ray = 0; ray < hits.size(); ++ray) {
            Hit whole = ground.trace(near.ray(ray % kWidth, ray / kWidth));
            if (whole.side != HitSide::above) continue;  // it may leave the part
            whole.column += kFirst;
            whole.row += kFirst;
            ++compared;
            wrong += differences(hits[ray], whole);
        }
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(compared, 30000u);
}

TEST(PagedTracer, ADamagedChunkIsAHoleAndCounted) {
    test_support::HeightField<std::int16_t> whole = test_support::rough_heights(150, 120, 300, 4);
    HeldChunks<std::int16_t> chunks(whole.grid());
    chunks.damaged = 1 * chunks.chunk_columns() + 2;
    test_support::HeightField<std::int16_t> holed = whole;
    for (std::uint32_t j = 33; j < 64; ++j)
        for (std::uint32_t i = 65; i < 96; ++i) holed.posts[j * 150 + i] = HeightGrid<std::int16_t>::kVoid;
    using Ground = test_support::TracedGround<std::int16_t>;
    const Ground sound(whole, Ground::Starts::anywhere), hole(holed, Ground::Starts::anywhere);
    StartedPages<std::int16_t> pages(chunks, {100, 64 * 64, 1});
    base::SerialWorkers workers;
    GridCamera camera;  // straight down
    camera.origin = {80, 48, 9000};
    camera.corner = {-0.6f, -0.6f, -100};
    camera.right = {0.02f, 0, 0};
    camera.down = {0, 0.02f, 0};
    const TracedPicture paged = pages.trace(camera, 64, 64, 149, kTriangles, widest(), workers);
    EXPECT_EQ(pages.work.damaged, 1u);
    EXPECT_EQ(paged.differences(test_support::traced_singly(hole.traced(kTriangles), camera, 64, 64)), 0u);
    EXPECT_GT(paged.differences(test_support::traced_singly(sound.traced(kTriangles), camera, 64, 64)), 200u);
}

TEST(PagedTracer, OriginsOutOfReachAndPicturesOfTheSkyLoadNothing) {
    const ViewedHills<std::int16_t> hills(100, 100, false);
    HeldChunks<std::int16_t> chunks(hills.field(kTriangles).grid());
    StartedPages<std::int16_t> pages(chunks, {2, 10, 1});
    Ray far, up;
    far.origin = {1e12, 0, 0};
    far.direction = {-1, 0, 0};
    up.origin = {50, 50, 20000};
    up.direction = {0.5f, 0, 1};
    const std::vector<Ray> rays = {far, up};
    std::vector<Hit> hits(2, Hit{HitSide::above, 1, 1, 1});
    base::SerialWorkers workers;
    EXPECT_EQ(pages.tracer.trace(PagedRays::of(rays), kTriangles, true, widest(), workers, hits).loads, 0u);
    for (const Hit& hit : hits) EXPECT_EQ(differences(hit, Hit{}), 0u);
}

TEST(PagedTracer, SaysWhyItCannotStart) {
    const ViewedHills<std::int16_t> hills(100, 100, false);
    HeldChunks<std::int16_t> chunks(hills.field(kTriangles).grid());
    std::vector<std::uint64_t> memory(Tracer::bytes_needed(100, 100, {4, 1000, 1}) / 8 + 1);
    base::Arena small(memory.data(), memory.size() * 4), enough(memory.data(), memory.size() * 8);
    Tracer tracer;
    EXPECT_EQ(tracer.start(chunks, {4, 1000, 1}, small), Tracer::Started::no_room);
    chunks.is_unreadable = true;
    EXPECT_EQ(tracer.start(chunks, {4, 1000, 1}, enough), Tracer::Started::unreadable);
}

}  // namespace
}  // namespace tedavis::raytrace::test_paged_tracer
