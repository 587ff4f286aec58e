#include "host_sim/commands/trace.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "host_sim/input_file.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_trace {
namespace {

TEST(Trace, LeavesThePictureAndWhatItTook) {
    const test_support::FlownFiles files;
    TraceOptions options;
    options.terrain.database = files.terrain;
    options.plan.width = 120;
    options.plan.height = 90;
    options.plan.time = base::Time{0};  // midnight at Greenwich, and in the Alps
    options.output = files.folder.file("traced.png");
    const auto run = test_support::run_command([&](Console& console) { return run_trace(options, console); }, true);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(nlohmann::json::parse(read_file(files.folder.file("traced.json"))), run.json());
    EXPECT_EQ(run.json().at("preset"), "time");
    EXPECT_GT(run.json().at("ground_share"), 0.2);
    const RgbaPicture picture = read_png(options.output);
    EXPECT_EQ(picture.width, 120u);
    EXPECT_EQ(picture.height, 90u);
    EXPECT_THAT(run.notes, ::testing::HasSubstr("the sun is lower"));
}

/// How many pixels of two pictures differ by more than kSeen in a color.
std::size_t differing(const RgbaPicture& a, const RgbaPicture& b) {
    constexpr int kSeen = 8;
    std::size_t count = 0;
    for (std::size_t n = 0; n < a.pixels.size(); n += 4)
        count += std::equal(&a.pixels[n], &a.pixels[n] + 4, &b.pixels[n], [](int x, int y) { return std::abs(x - y) <= kSeen; })
                     ? 0
                     : 1;
    return count;
}

/// Over the shipped hills.
TEST(Trace, SearchesWithFewStepsMissTheGroundAndTheExactOneIsTheDefault) {
    const test_support::TemporaryFolder folder;
    TraceOptions options;
    (void)test_support::run_command([&](Console& console) {
        options.terrain.database = database_of({"", ""}, folder.path(), console);
        return 0;
    });
    options.plan.width = 160;
    options.plan.height = 120;
    options.plan.rounds = 1;
    options.preset = TracePreset::memory;
    options.output = folder.file("searched.png");
    const auto picture_of = [&](const raytrace::SearchSettings& search) {
        options.search = search;
        const auto run = test_support::run_command([&](Console& console) { return run_trace(options, console); }, true);
        EXPECT_EQ(run.json().at("search").at("name"), to_string(search.kind));
        EXPECT_EQ(run.json().at("search").value("steps", 0u), search.steps);
        return read_png(options.output);
    };
    EXPECT_TRUE(TraceOptions().search.is_exact());
    const RgbaPicture exact = picture_of({});
    const std::size_t all = exact.pixels.size() / 4;
    using raytrace::SearchKind;
    EXPECT_LT(differing(picture_of(raytrace::usual_search(SearchKind::cells)), exact), all / 200);
    EXPECT_LT(differing(picture_of({SearchKind::ray, 1024, 12}), exact), all / 100);
    EXPECT_GT(differing(picture_of({SearchKind::ray, 16, 12}), exact), all / 40) << "control: sixteen steps over the whole ray";
    EXPECT_LT(differing(picture_of(raytrace::usual_search(SearchKind::cones)), exact), all / 100);
}

TEST(Trace, RefusesSearchesThatDoNotSuitTheRest) {
    const test_support::FlownFiles files;
    TraceOptions options;
    options.terrain.database = files.terrain;
    options.plan.width = options.plan.height = 40;
    options.output = files.folder.file("none.png");
    options.search = raytrace::usual_search(raytrace::SearchKind::cones);
    const auto run = [&] { (void)test_support::run_command([&](Console& console) { return run_trace(options, console); }); };
    test_support::expect_user_error(run, "--search cones: stands over a bilinear surface, which --preset time has not");
    options.search = raytrace::usual_search(raytrace::SearchKind::ray);
    options.memory_mb = 0.195;
    test_support::expect_user_error(run, "the search of --preset time need");
    EXPECT_FALSE(std::filesystem::exists(options.output));
}

TEST(Trace, ChoosesUnderADeadlineAndSaysWhereItFails) {
    const test_support::FlownFiles files;
    TraceOptions options;
    options.terrain.database = files.terrain;
    options.plan.width = 128;
    options.plan.height = 64;
    options.choice = ChoicePlan{1e-6, 0, 2};
    options.output = files.folder.file("chosen.png");
    const auto run = test_support::run_command([&](Console& console) { return run_trace(options, console); }, true);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.json().at("preset"), "chosen");
    EXPECT_EQ(run.json().at("choice").at("frames").size(), 2u);
    EXPECT_EQ(run.json().at("choice").at("frames")[1].at("regions"), (std::vector<int>{4, 0, 0}));
    EXPECT_THAT(run.notes, ::testing::HasSubstr("longer than the deadline"));
}

TEST(Trace, SaysWhenNothingIsSeen) {
    const test_support::FlownFiles files;
    TraceOptions options;
    options.terrain.database = files.terrain;
    options.plan.width = options.plan.height = 40;
    base::SerialWorkers workers;
    options.pose = usual_pose(TracedGround(files.terrain, workers));
    options.pose->pitch_deg = 80;
    options.output = files.folder.file("sky.png");
    const auto run = test_support::run_command([&](Console& console) { return run_trace(options, console); });
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.notes, ::testing::HasSubstr("no ray meets the terrain"));
}

TEST(Trace, SaysWhenTheEyeIsBelowTheGround) {
    const test_support::FlownFiles files;
    TraceOptions options;
    options.terrain.database = files.terrain;
    options.plan.width = options.plan.height = 40;
    base::SerialWorkers workers;
    const TracedGround ground(files.terrain, workers);
    options.pose = usual_pose(ground);
    options.output = files.folder.file("below.png");
    const auto notes = [&] {
        return test_support::run_command([&](Console& console) { return run_trace(options, console); }).notes;
    };
    EXPECT_THAT(notes(), ::testing::Not(::testing::HasSubstr("below the ground")));
    options.pose->altitude_msl_m = ground.lowest_m() - 20;
    EXPECT_THAT(notes(), ::testing::HasSubstr("below the ground"));
}

TEST(Trace, ThePictureOfPagedGroundIsThatOfTheGroundInMemory) {
    const test_support::FlownFiles files;
    TraceOptions options;
    options.terrain.database = files.terrain;
    options.plan.width = 200;
    options.plan.height = 150;
    options.workers = 2;
    options.output = files.folder.file("traced.png");
    const auto run = [&] { return test_support::run_command([&](Console& c) { return run_trace(options, c); }, true).json(); };
    EXPECT_EQ(run().at("paged"), false);
    const RgbaPicture whole = read_png(options.output);
    options.memory_mb = 0.195;
    const nlohmann::json paged = run();
    EXPECT_EQ(read_png(options.output).pixels, whole.pixels);
    EXPECT_EQ(paged.at("paged"), true);
    EXPECT_GT(paged.at("paging").at("chunks_read"), 10);
    EXPECT_LE(paged.at("paging").at("held_bytes"), 195'000);
    EXPECT_LT(paged.at("paging").at("slots"), paged.at("paging").at("chunks"));
    options.memory_mb = 1000;
    EXPECT_EQ(run().at("paged"), false);
}

TEST(Trace, RefusesMemoryThatDoesNotDoAndWritesNothing) {
    const test_support::FlownFiles files;
    TraceOptions options;
    options.terrain.database = files.terrain;
    options.plan.width = options.plan.height = 40;
    options.output = files.folder.file("none.png");
    options.memory_mb = 0.01;
    const auto run = [&] { (void)test_support::run_command([&](Console& console) { return run_trace(options, console); }); };
    test_support::expect_user_error(run, "give --memory 0.");
    options.preset = TracePreset::memory;
    test_support::expect_user_error(run, "supersampling and cast shadows of --preset memory need all heights in memory");
    options.choice = ChoicePlan();
    test_support::expect_user_error(run, "settings by region");
    EXPECT_FALSE(std::filesystem::exists(options.output));
    EXPECT_FALSE(std::filesystem::exists(files.folder.file("none.json")));
}

TEST(Trace, RefusesTwoTerrainsAndNone) {
    const test_support::FlownFiles files;
    TraceOptions options;
    options.terrain = {files.terrain, "heights.tif"};
    options.output = files.folder.file("none.png");
    const auto run = [&] { (void)test_support::run_command([&](Console& console) { return run_trace(options, console); }); };
    test_support::expect_user_error(run, "--heights");
    options.terrain = {"missing.tdb", ""};
    test_support::expect_user_error(run, "missing.tdb");
    EXPECT_FALSE(std::filesystem::exists(options.output));
}

}  // namespace
}  // namespace tedavis::host_sim::test_trace
