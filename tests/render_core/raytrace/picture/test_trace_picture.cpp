#include "render_core/raytrace/picture/trace_picture.hpp"

#include <gtest/gtest.h>

#include <set>

#include "platform/threads/thread_workers.hpp"
#include "render_core/raytrace/picture/trace_presets.hpp"
#include "render_core/raytrace/stream/token_writer.hpp"
#include "tests/support/raytrace/drawn_trace.hpp"

namespace tedavis::raytrace {
namespace {

using test_support::DrawnTrace;

constexpr std::uint32_t kPictureSide = 257, kPictureWide = 130, kPictureHigh = 90;

std::unique_ptr<base::Workers> threads(std::uint32_t count) {
    auto made = platform::make_thread_workers({count, nullptr});
    return made ? std::move(made.value()) : nullptr;
}

/// Every operator is in one of them.
std::vector<TraceSettings> many_settings() {
    std::vector<TraceSettings> all(4);
    all[0] = time_preset();
    all[1].surface.kind = SurfaceKind::bilinear;
    all[1].shading = Shading::phong;
    all[1].ambient = Ambient::sky_view;
    all[1].antialiasing = Antialiasing::average_mipmap;
    all[1].has_data = true;
    all[2].surface.kind = SurfaceKind::approximate_bicubic;
    all[2].surface.micro.kind = MicroKind::noise;
    all[2].surface.micro.noise.amplitude = 40;
    all[2].is_surface_stored = true;
    all[2].shading = Shading::phong;
    all[2].ambient = Ambient::apertures;
    all[2].has_capsules = true;
    all[3] = memory_preset();
    all[3].mirrors = 3;
    return all;
}

const Capsule kTrajectory[] = {{{4200, 4300, 1000}, {5200, 4800, 1000}, 40}, {{5200, 4800, 1000}, {5400, 5600, 1100}, 40}};

void show_all(DrawnTrace& drawn) {
    drawn.look.material.mirror = 0.6f;
    drawn.look.mirror_below = drawn.look.ground.highest * 0.5f;
    drawn.look.capsules = kTrajectory;
    static const float values[4] = {0, 1, 2, 3}, doubts[4] = {0, 0.5f, 0.2f, 1};
    drawn.look.values = {values, 2, 2, 20, 20, 200, 200};
    drawn.look.uncertainties = {doubts, 2, 2, 20, 20, 200, 200};
    drawn.look.legend.palette = test_support::kGroundPalette;
    drawn.look.legend.highest = 3;
}

TEST(TracePicture, IsTheSameForAnyWorkersAndBlocksAndByDirectCalls) {
    const auto posts = test_support::fractal_heights(kPictureSide);
    const std::vector<TraceSettings> all = many_settings();
    DrawnTrace direct(posts, all, kPictureWide, kPictureHigh);
    show_all(direct);
    base::SerialWorkers alone;
    for (const std::uint32_t block : {64u, 512u, 4096u}) {
        StreamSettings stream;
        stream.block_words = block;
        DrawnTrace drawn(posts, all, kPictureWide, kPictureHigh, stream);
        show_all(drawn);
        for (std::uint32_t n = 0; n < all.size(); ++n) {
            direct.draw_directly(alone, n);
            for (const std::uint32_t count : {1u, 2u, 3u, 7u}) {
                const auto workers = threads(count);
                std::fill(drawn.rgb.begin(), drawn.rgb.end(), std::uint8_t{7});
                ASSERT_TRUE(drawn.draw(*workers, n));
                EXPECT_TRUE(DrawnTrace::is_same(drawn.light(), direct.light())) << block << " " << n << " " << count;
                EXPECT_TRUE(drawn.rgb == direct.rgb) << block << " " << n << " " << count;
            }
        }
    }
}

/// A round that is one group is one worker's, however many there are.
TEST(TracePicture, RoundsAreSharedAmongWorkers) {
    const auto posts = test_support::fractal_heights(kPictureSide);
    const std::vector<TraceSettings> all = many_settings();
    DrawnTrace drawn(posts, all, 640, 480);
    show_all(drawn);
    const auto workers = threads(2);
    for (std::uint32_t n = 0; n < all.size(); ++n) {
        ASSERT_TRUE(drawn.draw(*workers, n));
        EXPECT_GE(drawn.report.most_groups, 4u) << n;
    }
}

TEST(TracePicture, EveryOperatorShows) {
    const std::vector<TraceSettings> all = many_settings();
    DrawnTrace drawn(test_support::fractal_heights(kPictureSide), all, kPictureWide, kPictureHigh);
    show_all(drawn);
    base::SerialWorkers alone;
    std::set<std::vector<std::uint8_t>> pictures;
    for (std::uint32_t n = 0; n < all.size(); ++n) {
        drawn.draw_directly(alone, n);
        pictures.insert(drawn.rgb);
    }
    EXPECT_EQ(pictures.size(), all.size());
    std::size_t expected = pictures.size();
    const auto differs = [&](std::uint32_t n, auto change) {
        TraceSettings changed = all[n];
        change(changed);
        drawn.settings.push_back(changed);
        drawn.draw_directly(alone, static_cast<std::uint32_t>(drawn.settings.size() - 1));
        pictures.insert(drawn.rgb);
        EXPECT_EQ(pictures.size(), ++expected) << expected;
    };
    differs(1, [](TraceSettings& s) { s.has_data = false; });
    differs(1, [](TraceSettings& s) { s.antialiasing = Antialiasing::none; });
    differs(1, [](TraceSettings& s) { s.ambient = Ambient::none; });
    differs(2, [](TraceSettings& s) { s.has_capsules = false; });
    differs(2, [](TraceSettings& s) { s.ambient = Ambient::sky_view; });
    differs(3, [](TraceSettings& s) { s.mirrors = 0; });
    differs(3, [](TraceSettings& s) { s.mirrors = 1; });
    differs(3, [](TraceSettings& s) { s.has_shadows = false; });
    differs(3, [](TraceSettings& s) { s.antialiasing = Antialiasing::none; });
    differs(3, [](TraceSettings& s) { s.shading = Shading::lambert; });
    differs(3, [](TraceSettings& s) { s.paths = 2; });
}

/// A shade that leaves everything as it is.
void shade_nothing(void*, const Batch& batch, TokenWriter& out) {
    for (std::uint32_t n = 0; n < batch.count; ++n) out.done();
}

TEST(TracePicture, TasksReplacedWhileItRunsCountFromThatRoundOn) {
    const auto posts = test_support::fractal_heights(kPictureSide);
    StreamSettings small;
    small.capacity_words = 2 * kMaxOutputWords;
    std::vector<std::vector<std::uint8_t>> pictures;
    for (const std::uint32_t block : {64u, 512u, 4096u})
        for (const std::uint32_t count : {1u, 2u, 3u, 7u}) {
            small.block_words = block;
            DrawnTrace drawn(posts, {memory_preset()}, kPictureWide, kPictureHigh, small);
            const auto workers = threads(count);
            ASSERT_TRUE(drawn.begin());
            ASSERT_TRUE(drawn.picture.rewrite(*workers, 4).ok());
            TaskNetwork& network = drawn.picture.network();
            Task nothing = network.task(drawn.picture.tasks().resample);
            nothing.name = "as it is";
            nothing.run = [](void*, const Batch& batch, TokenWriter& out) {
                for (std::uint32_t n = 0; n < batch.count; ++n) out.done();
            };
            ASSERT_TRUE(network.replace(drawn.picture.tasks().resample, nothing).ok());
            const StreamRewriter::Answer answer = drawn.picture.rewrite(*workers);
            ASSERT_TRUE(answer.ok() && answer.value().is_finished);
            pictures.push_back(drawn.rgb);
            EXPECT_TRUE(pictures.back() == pictures.front()) << block << " " << count;
        }
    DrawnTrace whole(posts, {memory_preset()}, kPictureWide, kPictureHigh, small);
    base::SerialWorkers alone;
    ASSERT_TRUE(whole.draw(alone));
    EXPECT_FALSE(whole.rgb == pictures.front());
    ASSERT_TRUE(whole.begin());
    Task none = whole.picture.network().task(whole.picture.tasks().main.shade);
    none.run = shade_nothing;
    ASSERT_TRUE(whole.picture.network().replace(whole.picture.tasks().main.shade, none).ok());
    const std::vector<std::uint8_t> before = whole.rgb;
    ASSERT_TRUE(whole.picture.rewrite(alone).ok());
    EXPECT_TRUE(before == whole.rgb);
}

TEST(TracePicture, UprightViewsAndRegionsOfTwoSettingsAreTheSameToo) {
    const auto posts = test_support::fractal_heights(kPictureSide);
    TraceSettings smooth = quality_preset();
    smooth.has_shadows = false;
    smooth.antialiasing = Antialiasing::none;
    const std::vector<TraceSettings> all = {time_preset(), smooth};
    DrawnTrace drawn(posts, all, kPictureWide, kPictureHigh);
    const double steps = test_support::steps_a_cell(kPictureSide);
    base::SerialWorkers alone;
    const auto workers = threads(3);
    for (const std::uint32_t camera : {0u, 3u}) {
        drawn.set_camera(test_support::trace_cameras(kPictureSide, kPictureWide, kPictureHigh)[camera].in_steps(steps).view());
        drawn.draw_directly(alone, 0);
        const std::vector<glm::vec3> fast = drawn.light();
        drawn.draw_directly(alone, 1);
        const std::vector<glm::vec3> good = drawn.light();
        const std::uint32_t across = PictureVariants::regions_across(kPictureWide);
        std::vector<std::uint8_t> regions(across * PictureVariants::regions_down(kPictureHigh));
        for (std::uint32_t n = 0; n < regions.size(); ++n) regions[n] = n % 3 == 1 ? 1 : 0;
        ASSERT_TRUE(drawn.picture.begin(drawn.scene, drawn.look, {drawn.settings, regions}, drawn.rgb));
        ASSERT_TRUE(drawn.picture.rewrite(*workers).ok());
        const std::vector<glm::vec3> mixed = drawn.light();
        std::size_t wrong = 0;
        for (std::uint32_t at = 0; at < mixed.size(); ++at) {
            const std::uint32_t region =
                at / kPictureWide / PictureVariants::kRegionHeight * across + at % kPictureWide / PictureVariants::kRegionWidth;
            wrong += mixed[at] == (regions[region] == 1 ? good : fast)[at] ? 0 : 1;
        }
        EXPECT_EQ(wrong, 0U) << camera;
        EXPECT_FALSE(DrawnTrace::is_same(fast, good));
    }
}

}  // namespace
}  // namespace tedavis::raytrace
