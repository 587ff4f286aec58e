#include "host_sim/commands/shot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host_sim/input_file.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/programs/headless_backends.hpp"
#include "tests/support/terrain/damaged_terrain.hpp"

namespace tedavis::host_sim::test_shot {
namespace {

using nlohmann::json;

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

ShotOptions shot() {
    ShotOptions options;
    options.pose = {47.03, 9.68, 2500, 40, -6, 12};
    options.picture = files().options("unused").picture;
    options.output = files().folder.file("shot.png");
    return options;
}

json taken(const ShotOptions& options) {
    std::ostringstream results, notes;
    Console console(results, notes, true, false);
    EXPECT_EQ(run_shot(options, console), 0);
    return json::parse(results.str());
}

TEST(Shot, LeavesThePictureAndItsRecord) {
    const json told = taken(shot());
    EXPECT_EQ(json::parse(read_file(files().folder.file("shot.json"))), told);
    EXPECT_EQ(read_file(files().folder.file("shot.png")).substr(1, 3), "PNG");
    const json& own = told.at("own_ship");
    EXPECT_NEAR(own.at("lat_deg"), 47.03, 1e-9);
    EXPECT_NEAR(own.at("lon_deg"), 9.68, 1e-9);
    EXPECT_NEAR(own.at("alt_msl_m"), 2500, 1e-6);
    EXPECT_NEAR(own.at("alt_ellipsoid_m"), 2548, 2) << "EGM96 over the Alps";
    EXPECT_NEAR(own.at("heading_deg"), 40, 1e-9);
    EXPECT_NEAR(own.at("pitch_deg"), -6, 1e-9);
    EXPECT_NEAR(own.at("roll_deg"), 12, 1e-9);
    EXPECT_GT(told.at("terrain").at("triangles"), 100);
    EXPECT_EQ(told.at("phase"), "unknown");
    EXPECT_EQ(told.at("phase_source"), "none") << "nobody stated one";
}

TEST(Shot, EqualPosesGiveEqualPictures) {
    ShotOptions options = shot();
    const json first = taken(options);
    EXPECT_EQ(taken(options).at("hash"), first.at("hash"));
    if (test_support::headless_backends().size() > 1) {
        options.picture.gl = GlChoice::osmesa;
        EXPECT_EQ(taken(options).at("hash"), first.at("hash"));
    }
    options.pose.longitude_deg += 360;
    EXPECT_NEAR(taken(options).at("own_ship").at("lon_deg"), 9.68, 1e-9);
    for (double AircraftPose::*part : {&AircraftPose::latitude_deg, &AircraftPose::altitude_msl_m, &AircraftPose::heading_deg,
                                       &AircraftPose::pitch_deg, &AircraftPose::roll_deg}) {
        ShotOptions other = shot();
        other.pose.*part += 0.01 * (part == &AircraftPose::altitude_msl_m ? 1000 : 10);
        EXPECT_NE(taken(other).at("hash"), first.at("hash"));
    }
}

TEST(Shot, TheOverlayChangesThePictureFileAlone) {
    ShotOptions options = shot();
    const json plain = taken(options);
    const std::string file = read_file(options.output);
    EXPECT_FALSE(plain.contains("accuracy_overlay"));
    options.accuracy = {true, true};
    const json marked = taken(options);
    EXPECT_EQ(marked.at("accuracy_overlay"), true);
    EXPECT_EQ(marked.at("hash"), plain.at("hash")) << "of the display's own picture";
    EXPECT_NE(read_file(options.output), file);
    EXPECT_GT(marked.at("measured_error").at("places"), 100);
    EXPECT_LE(marked.at("measured_error").at("max_px"), marked.at("terrain").at("worst_error_px"));
    options.picture.terrain.clear();
    options.output = files().folder.file("never.png");
    test_support::expect_user_error([&] { static_cast<void>(taken(options)); }, "--error-map: needs terrain");
    EXPECT_FALSE(std::filesystem::exists(options.output));
}

TEST(Shot, OtherFilesAreNotReplaced) {
    ShotOptions options = shot();
    options.output = files().folder.file("mine.png");
    const std::string mine = "{\"my\": \"own\"}\n";
    for (const char* const name : {"mine.png", "mine.json"}) {
        files().folder.write(name, mine);
        test_support::expect_user_error([&] { static_cast<void>(taken(options)); },
                                        std::string(name) + ": is there already and is no");
        EXPECT_EQ(files().folder.read(name), mine);
        std::filesystem::remove(files().folder.file(name));
    }
    EXPECT_EQ(taken(options).at("hash"), taken(options).at("hash")) << "a picture makes room for the next";
}

TEST(Shot, NamesThePhase) {
    ShotOptions options = shot();
    options.phase = "approach.final";
    const json record = taken(options);
    EXPECT_EQ(record.at("phase"), "approach");
    EXPECT_EQ(record.at("sub_phase"), "final");
    EXPECT_EQ(record.at("phase_source"), "switch");
}

TEST(Shot, NeedsNoTerrain) {
    ShotOptions options = shot();
    options.picture.terrain.clear();
    const json record = taken(options);
    EXPECT_EQ(record.at("terrain").at("triangles"), 0);
    EXPECT_NEAR(record.at("own_ship").at("alt_msl_m"), 2500, 60) << "no geoid in the display, but none asked of it either";
}

TEST(Shot, TheRecordLiesBesideThePicture) {
    ShotOptions options = shot();
    options.output = files().folder.file("plain");
    static_cast<void>(taken(options));
    EXPECT_TRUE(std::filesystem::exists(files().folder.file("plain.json")));
    std::filesystem::create_directories(files().folder.file("dot.ted"));
    options.output = files().folder.file("dot.ted/plain");
    static_cast<void>(taken(options));
    EXPECT_TRUE(std::filesystem::exists(files().folder.file("dot.ted/plain.json")));
}

TEST(Shot, ADamagedChunkLeavesThePictureAndEndsWithTwo) {
    std::string image = files().folder.read("terrain.tdb");
    test_support::damage_payloads(image);
    ShotOptions options = shot();
    options.picture.terrain = files().folder.write("damaged.tdb", image);
    options.output = files().folder.file("damaged.PNG");
    const test_support::CommandRun run =
        test_support::run_command([&](Console& console) { return run_shot(options, console); }, true);
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.notes, ::testing::HasSubstr("damaged.tdb: a part of it cannot be used"));
    EXPECT_THAT(run.json().at("flags").dump(), ::testing::HasSubstr("terrain.failing"));
    EXPECT_TRUE(std::filesystem::exists(options.output));
    EXPECT_TRUE(std::filesystem::exists(files().folder.file("damaged.json")));
}

TEST(Shot, APoseElsewhereIsSaidAndFailsWhereItIsStrict) {
    ShotOptions options = shot();
    EXPECT_TRUE(taken(options).at("warnings").empty());
    std::swap(options.pose.latitude_deg, options.pose.longitude_deg);
    const auto run = [&] {
        return test_support::run_command([&](Console& console) { return run_shot(options, console); }, true);
    };
    const test_support::CommandRun swapped = run();
    EXPECT_EQ(swapped.code, 0);
    EXPECT_THAT(swapped.notes, ::testing::StartsWith("warning: the pose 9.6800,47.0300 lies outside "));
    EXPECT_EQ(swapped.json().at("warnings")[0].at("name"), "terrain.outside");
    EXPECT_EQ(json::parse(read_file(files().folder.file("shot.json"))), swapped.json());
    options.strict = true;
    EXPECT_EQ(run().code, 1);
    options.pose = shot().pose;
    EXPECT_EQ(run().code, 0) << "the control";
}

TEST(Shot, AFocusThatIsNowhereIsSaid) {
    ShotOptions options = shot();
    options.picture.foci = {"at = \"place\", place = \"DAVOS\"", "at = \"own_ship\""};
    const test_support::CommandRun run =
        test_support::run_command([&](Console& console) { return run_shot(options, console); }, true);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.notes, "note: focus 1 of --focus is nowhere: the scene has no feature of that name\n");
}

TEST(Shot, WrongInputIsRefusedAndNothingIsWritten) {
    const auto refused = [](ShotOptions options, const std::string& words) {
        options.output = files().folder.file("refused.png");
        std::ostringstream results, notes;
        Console console(results, notes, false, false);
        test_support::expect_user_error([&] { static_cast<void>(run_shot(options, console)); }, words);
        EXPECT_FALSE(std::filesystem::exists(files().folder.file("refused.png")));
        EXPECT_FALSE(std::filesystem::exists(files().folder.file("refused.json")));
    };
    ShotOptions options = shot();
    options.phase = "lunch";
    refused(options, "--phase lunch");
    options = shot();
    options.picture.terrain = files().folder.file("none.tdb");
    refused(options, "none.tdb");
    for (const char* name : {"x.jpg", "x.json", "x.png.tif"}) {
        options = shot();
        options.output = files().folder.file(name);
        std::ostringstream results, notes;
        Console console(results, notes, false, false);
        test_support::expect_user_error([&] { static_cast<void>(run_shot(options, console)); }, "name that ends in .png");
        EXPECT_FALSE(std::filesystem::exists(options.output));
    }
    options = shot();
    options.output = files().log + "/x.png";
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    test_support::expect_user_error([&] { static_cast<void>(run_shot(options, console)); }, "flight.log");
}

}  // namespace
}  // namespace tedavis::host_sim::test_shot
