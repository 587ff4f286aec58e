#include "host_sim/commands/gallery_sheet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include "host_sim/commands/gallery_moments.hpp"
#include "host_sim/commands/own_ground.hpp"
#include "host_sim/commands/replay.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/frame_lines.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_gallery_sheet {
namespace {

using test_support::CommandRun;
using ::testing::HasSubstr;

CommandRun run(const SheetOptions& options) {
    return test_support::run_command([&](Console& console) { return run_gallery_sheet(options, console); }, true);
}

/// Small, and made once for all tests.
struct Gallery {
    test_support::TemporaryFolder folder;
    SheetOptions options;
    CommandRun told;

    Gallery() {
        options.sheet = kGallerySheetName;
        options.output = folder.file("gallery");
        options.picture.size = PictureSize{320, 180};
        told = run(options);
    }
};

const Gallery& gallery() {
    static const Gallery kGallery;
    return kGallery;
}

TEST(GallerySheet, TellsTheFlightInTwelvePictures) {
    EXPECT_EQ(gallery().told.code, 0) << gallery().told.notes;
    const auto json = gallery().told.json();
    EXPECT_TRUE(json.at("pose").is_null());
    const auto& pictures = json.at("pictures");
    ASSERT_EQ(pictures.size(), 12u);
    std::set<std::string> hashes;
    std::map<std::string, std::string> designs;
    double before_s = -1;
    for (const auto& picture : pictures) {
        const std::string file = picture.at("file");
        hashes.insert(picture.at("hash").get<std::string>());
        designs[file] = picture.at("design");
        EXPECT_GT(picture.at("triangles"), 100) << file;
        EXPECT_GT(picture.at("flight_s"), before_s) << file << ": in order of the flight";
        before_s = picture.at("flight_s");
        EXPECT_EQ(read_png(gallery().options.output + "/" + file).width, 320u);
        EXPECT_THAT(gallery().folder.read("gallery/index.html"), HasSubstr(picture.at("caption").get<std::string>()));
    }
    EXPECT_EQ(hashes.size(), 12u);
    EXPECT_EQ(designs["cruise.png"], "cruise");
    EXPECT_EQ(designs["replanning.png"], "replanning");
    EXPECT_EQ(designs["short_final.png"], "approach");
    EXPECT_GT(read_png(gallery().options.output + "/sheet.png").width, 4 * 320u);
}

/// The picture of the gallery is that of a replay at its instant.
TEST(GallerySheet, ItsPicturesAreThoseOfAReplay) {
    const test_support::TemporaryFolder folder;
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    ReplayOptions replay;
    replay.picture.terrain = build_own_terrain({shipped_root() + kOwnRaster, false, 16.0}, folder.path(), console);
    replay.picture.scene = build_own_scenario("default", folder.path(), console);
    replay.picture.aircraft = "turboprop";
    replay.picture.size = gallery().options.picture.size;
    replay.log = folder.file("scenario/flight.log");
    replay.switches = folder.file("scenario/flight.switches");
    replay.frames = FrameOutput::hash;
    for (const std::size_t n : {3u, 9u}) {
        const auto picture = gallery().told.json().at("pictures").at(n);
        replay.output = folder.file("run" + std::to_string(n));
        replay.from_s = replay.to_s = picture.at("flight_s").get<double>();
        EXPECT_EQ(run_replay(replay, console), 0) << notes.str();
        const auto lines = test_support::frame_lines(replay.output);
        ASSERT_EQ(lines.size(), 1u);
        EXPECT_EQ(lines[0].at("hash"), picture.at("hash")) << picture.at("file");
    }
}

TEST(GallerySheet, RefusesWhatItDoesNotShow) {
    SheetOptions options;
    options.output = gallery().folder.file("none");
    options.picture.terrain = "my.tdb";
    test_support::expect_user_error([&] { static_cast<void>(run(options)); }, "leave --pose, --time, --scene and --terrain out");
    options.picture.terrain.clear();
    options.pose = AircraftPose{};
    test_support::expect_user_error([&] { static_cast<void>(run(options)); }, "--pose");
    EXPECT_FALSE(std::filesystem::exists(options.output));
}

}  // namespace
}  // namespace tedavis::host_sim::test_gallery_sheet
