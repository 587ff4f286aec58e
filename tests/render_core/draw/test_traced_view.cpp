#include "render_core/draw/traced_view.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "platform/threads/thread_workers.hpp"
#include "tests/support/raytrace/traced_file.hpp"

namespace tedavis::draw::test_traced_view {
namespace {

using raytrace::HitSide;

/// Memory for one picture.
struct Picture {
    std::vector<std::uint64_t> memory = std::vector<std::uint64_t>(TracedView::bytes_needed(160, 120) / 8 + 1);
    TracedView view;
    bool is_started;

    explicit Picture(std::int64_t bytes_off = 0) {
        base::Arena arena(memory.data(), static_cast<std::size_t>(static_cast<std::int64_t>(memory.size() * 8) + bytes_off));
        is_started = view.start(160, 120, arena);
    }
};

TEST(TracedView, PlacesInCellsLieAtTheDepthsAlongTheRaysOfTheWorld) {
    const test_support::TracedFile file(test_support::coast_file());
    const terrain::View seen = file.view(80, 64, 700, 40, -20);
    Picture picture;
    ASSERT_TRUE(picture.is_started);
    base::SerialWorkers workers;
    picture.view.trace(file.ground, file.space(), seen, workers);
    const raytrace::HitPicture& hits = picture.view.hits();
    int hit_count = 0, far_off = 0;
    for (std::uint32_t y = 0; y < 120; ++y)
        for (std::uint32_t x = 0; x < 160; ++x) {
            const std::size_t at = y * 160 + x;
            if (hits.side[at] == HitSide::none) continue;
            ++hit_count;
            const glm::dvec3 ray =
                seen.forward + seen.right * ((x + 0.5 - 80) / seen.focal_px) + seen.down * ((y + 0.5 - 60) / seen.focal_px);
            const glm::dvec3 place = file.space().place(seen.eye + double{hits.t[at]} * ray);
            const double i = hits.cell[at] % 160 + double{hits.u[at]}, j = hits.cell[at] / 160 + double{hits.v[at]};
            const double pixel_m = 0.2 * hits.t[at] / seen.focal_px;
            far_off += std::abs(place.x - i) * 60 > pixel_m + 0.1 || std::abs(place.y - j) * 90 > pixel_m + 0.1 ? 1 : 0;
        }
    EXPECT_GT(hit_count, 10000);
    EXPECT_EQ(far_off, 0) << "more than a fifth of a pixel";
}

TEST(TracedView, IsTheSameForAnyNumberOfWorkersAndNothingWhereItIsCleared) {
    const test_support::TracedFile file(test_support::coast_file());
    const terrain::View seen = file.view(80, 64, 700, 250, -12);
    Picture one, other;
    base::SerialWorkers serial;
    one.view.trace(file.ground, file.space(), seen, serial);
    for (const std::uint32_t count : {2u, 5u}) {
        const auto workers = platform::make_thread_workers({count, nullptr});
        ASSERT_TRUE(workers.ok());
        other.view.trace(file.ground, file.space(), seen, *workers.value());
        for (const auto& [a, b] :
             {std::pair(one.view.hits().t, other.view.hits().t), std::pair(one.view.hits().u, other.view.hits().u)})
            EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)), 0) << count;
    }
    other.view.clear();
    for (const HitSide side : other.view.hits().side) ASSERT_EQ(side, HitSide::none);
    for (const float t : other.view.hits().t) ASSERT_TRUE(std::isinf(t));
}

TEST(TracedView, RefusesWhatDoesNotHoldAPicture) { EXPECT_FALSE(Picture(-2000).is_started); }

}  // namespace
}  // namespace tedavis::draw::test_traced_view
