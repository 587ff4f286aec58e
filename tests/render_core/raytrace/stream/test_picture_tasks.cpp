#include "render_core/raytrace/stream/picture_tasks.hpp"

#include "tests/support/raytrace/rewritten_stream.hpp"
#include "tests/support/raytrace/synthetic_rays.hpp"

namespace tedavis::raytrace::test_picture_tasks {
namespace {

using test_support::RewrittenStream;
using test_support::SyntheticRays;
using test_support::SyntheticRayTasks;

constexpr std::uint32_t kTiles = 1500, kPixels = kTiles * SyntheticRays::kTilePixels;
constexpr int kSteps = 4;

std::vector<float> drawn_directly(std::uint32_t mirrors) {
    SyntheticRays rays(kPixels, kSteps);
    rays.mirrors = mirrors;
    for (std::uint32_t tile = 0; tile < kTiles; ++tile) rays.draw_tile(tile);
    return rays.picture;
}

/// Changes the network after the fourth round.
using Change = void (*)(SyntheticRayTasks&);

std::vector<float> drawn(std::uint32_t mirrors, std::uint32_t block_words, base::Workers& workers, Change change = nullptr) {
    SyntheticRays rays(kPixels, kSteps);
    rays.mirrors = mirrors;
    SyntheticRayTasks tasks(rays);
    tasks.steps.pieces = 300;
    RewrittenStream s(test_support::stream_settings(block_words, 1 << 16));
    EXPECT_TRUE(begin_picture(s.stream, tasks.tasks, kTiles));
    if (change != nullptr) {
        EXPECT_TRUE(s.rewriter.rewrite(tasks.network, workers, 4).ok());
        change(tasks);
    }
    const StreamRewriter::Answer answer = s.rewriter.rewrite(tasks.network, workers, 100000);
    EXPECT_TRUE(answer.ok() && answer.value().is_finished) << (answer.ok() ? "" : answer.error().c_str());
    EXPECT_EQ(s.stream.words(), 0u);
    return rays.picture;
}

TEST(PictureTasks, PicturesAreThoseOfDirectCalls) {
    for (const std::uint32_t mirrors : {0u, 3u}) {
        const std::vector<float> expected = drawn_directly(mirrors);
        for (const std::uint32_t count : test_support::kWorkerCounts) {
            const std::unique_ptr<base::Workers> workers = test_support::make_workers(count);
            for (const std::uint32_t size : test_support::kBlockSizes)
                EXPECT_EQ(drawn(mirrors, size, *workers), expected) << mirrors << ' ' << count << ' ' << size;
        }
    }
}

std::uint32_t black_pixels(const std::vector<float>& picture) {
    return static_cast<std::uint32_t>(std::count(picture.begin(), picture.end(), 0.0f));
}

void make_black(SyntheticRayTasks& tasks) { EXPECT_TRUE(tasks.network.replace(tasks.tasks.shade, tasks.black_shade()).ok()); }

TEST(PictureTasks, AShadeThatIsReplacedOnTheWayGivesOnePictureForAll) {
    base::SerialWorkers serial;
    const std::vector<float> whole = drawn(3, 512, serial), expected = drawn(3, 512, serial, make_black);
    EXPECT_EQ(black_pixels(whole), 0u);
    EXPECT_GT(black_pixels(expected), kPixels / 10);
    EXPECT_LT(black_pixels(expected), kPixels * 9 / 10);
    for (const std::uint32_t count : test_support::kWorkerCounts) {
        const std::unique_ptr<base::Workers> workers = test_support::make_workers(count);
        for (const std::uint32_t size : test_support::kBlockSizes) EXPECT_EQ(drawn(3, size, *workers, make_black), expected);
    }
}

/// Doubles the light of what goes through.
void brighten(void*, const Batch& batch, TokenWriter& out) {
    for (std::uint32_t n = 0; n < batch.count; ++n) {
        SyntheticRays::Dot dot = batch.records<SyntheticRays::Dot>()[n];
        dot.light *= 2;
        out.each_calls(batch.next, &dot, 1);
    }
}

Task brightening() {
    Task task;
    task.name = "brighten";
    task.arguments = 2;
    task.most_outputs = 3;
    task.run = brighten;
    return task;
}

void insert_brightening(SyntheticRayTasks& tasks) {
    EXPECT_TRUE(tasks.network.insert(tasks.tasks.set_pixel, brightening()).ok());
}

TEST(PictureTasks, AStageMayBeInsertedAndRemovedOnTheWay) {
    base::SerialWorkers serial;
    const std::vector<float> plain = drawn_directly(0), brightened = drawn(0, 512, serial, insert_brightening);
    std::uint32_t twice = 0;
    for (std::uint32_t n = 0; n < kPixels; ++n) {
        EXPECT_TRUE(brightened[n] == plain[n] || brightened[n] == 2 * plain[n]);
        twice += brightened[n] == 2 * plain[n] ? 1 : 0;
    }
    EXPECT_GT(twice, kPixels / 10);
    EXPECT_LT(twice, kPixels);
    const auto in_and_out = [](SyntheticRayTasks& tasks) {
        insert_brightening(tasks);
        EXPECT_TRUE(tasks.network.remove(tasks.tasks.set_pixel).ok());
    };
    EXPECT_EQ(drawn(0, 512, serial, in_and_out), plain);
}

TEST(PictureTasks, SurfaceComesBetweenRaysAndShade) {
    SyntheticRays rays(kPixels, kSteps);
    SyntheticRayTasks tasks(rays);
    PictureStages stages;
    stages.primary = tasks.network.task(tasks.tasks.primary);
    stages.trace = tasks.network.task(tasks.tasks.trace);
    stages.surface = brightening();
    stages.shade = tasks.network.task(tasks.tasks.shade);
    stages.set_pixel = tasks.network.task(tasks.tasks.set_pixel);
    TaskNetwork network;
    RangeSteps steps;
    const PictureTasks made = add_picture_tasks(network, stages, steps).value();
    EXPECT_EQ(network.task(made.tiles).next, made.primary);
    EXPECT_EQ(network.task(made.primary).next, made.surface);
    EXPECT_EQ(network.task(made.trace).next, made.surface);
    EXPECT_EQ(network.task(made.surface).next, made.shade);
    EXPECT_EQ(network.task(made.shade).next, made.set_pixel);
}

TEST(PictureTasks, SaysWhatIsMissing) {
    TaskNetwork network;
    RangeSteps steps;
    PictureStages stages;
    EXPECT_EQ(add_picture_tasks(network, stages, steps).error().view(),
              "a picture needs the stages primary, shade and set pixel; give each a function");
    stages.primary = stages.shade = stages.set_pixel = brightening();
    stages.primary.arguments = 3;
    EXPECT_EQ(add_picture_tasks(network, stages, steps).error().view(),
              "the stage primary takes two words, the first tile and the end; state 2 arguments");
    stages.primary.arguments = 2;
    stages.shade.lanes = 0;
    EXPECT_EQ(add_picture_tasks(network, stages, steps).error().view(), "task 'brighten' has 0 lanes; give it 1 or more");
}

}  // namespace
}  // namespace tedavis::raytrace::test_picture_tasks
