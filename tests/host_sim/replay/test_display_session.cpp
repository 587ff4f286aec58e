#include "host_sim/replay/display_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/device_files.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/programs/headless_backends.hpp"

namespace tedavis::host_sim::test_display_session {
namespace {

using test_support::expect_user_error;

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

PictureOptions picture() { return files().options("unused").picture; }

std::uint64_t hash_without_signals(const PictureOptions& options, bool generated = false) {
    DisplaySession session(options, generated);
    session.display().plan({{}, {}, base::Time{0}});
    session.draw();
    session.present();
    return session.frame_hash();
}

TEST(DisplaySession, SizesComeFromTheOptionsElseFromTheDevice) {
    PictureOptions options = picture();
    EXPECT_EQ(DisplaySession(options, false).width(), 320u);
    options.size.reset();
    const DisplaySession session(options, false);
    EXPECT_EQ(session.width(), session.device().width_px);
    EXPECT_EQ(session.height(), session.device().height_px);
}

TEST(DisplaySession, AllSurfacesDrawTheSamePicture) {
    PictureOptions options = picture();
    options.gl = GlChoice::egl;
    const std::uint64_t egl = hash_without_signals(options);
    EXPECT_EQ(hash_without_signals(options), egl) << "again";
    options.gl = GlChoice::osmesa;
    if (test_support::headless_backends().size() > 1) {
        EXPECT_EQ(hash_without_signals(options), egl);
    }
    EXPECT_NE(hash_without_signals(options, true), egl) << "a generated flight says so";
}

TEST(DisplaySession, SaysWhatItDrawsWith) {
    DisplaySession session(picture(), false);
    EXPECT_THAT(session.gl_description(), ::testing::StartsWith("egl: "));
    const RgbaView view = session.pixels();
    EXPECT_EQ(view.width, 320u);
    EXPECT_TRUE(view.bottom_up);
}

TEST(DisplaySession, WhatCannotBeOpenedIsOneSentence) {
    const auto refused = [](const PictureOptions& options, const std::string& words) {
        expect_user_error([&] { DisplaySession session(options, false); }, words);
    };
    PictureOptions options = picture();
    options.terrain = files().folder.file("none.tdb");
    refused(options, "none.tdb");
    options.terrain = files().folder.write("text.tdb", "this is no terrain database, however long it may be: it is not one");
    refused(options, "text.tdb: ");
    options = picture();
    options.device = "toaster";
    refused(options, "toaster: no such file");
    options = picture();
    options.design = files().folder.write("bad.toml", "name = 3\n");
    refused(options, "bad.toml:1");
    options = picture();
    options.aircraft = files().folder.write("glider.toml", "name = \"glider\"\n[speeds]\nvne = 250\n");
    refused(options, "glider.toml:3: 'vne' has no unit; write 'vne_kt'");
    options.aircraft = "airship";
    refused(options, "airship: no such file and no shipped one of aircraft; name a file, or one of these: glider, ");
}

TEST(DisplaySession, AnAircraftFileIsTheDisplays) {
    PictureOptions options = picture();
    EXPECT_FALSE(DisplaySession(options, false).display().planner().settings().aircraft.is_stated());
    options.aircraft = "turboprop";
    DisplaySession session(options, false);
    const design::AircraftSettings& aircraft = session.display().planner().settings().aircraft;
    EXPECT_EQ(aircraft.name.view(), "turboprop");
    EXPECT_EQ(aircraft.eye.forward_m, load_aircraft(options.aircraft).eye.forward_m);
    EXPECT_NE(aircraft.eye.forward_m, 0);
}

TEST(DisplaySession, ADatabaseWithAFlippedBitIsFoundAndTheNextSessionWorks) {
    std::string image = files().folder.read("terrain.tdb");
    image[20] = static_cast<char>(image[20] ^ 4);
    PictureOptions options = picture();
    options.terrain = files().folder.write("flipped.tdb", image);
    expect_user_error([&] { DisplaySession session(options, false); }, "flipped.tdb: ");
    EXPECT_NE(hash_without_signals(picture()), 0u);
}

TEST(DisplaySession, TheDeviceFileIsBlamedForWhatIsTheDevices) {
    std::string device = test_support::source_file("configs/devices/es3-mid.toml");
    const std::string bytes = "bytes = 1048576";
    const std::size_t at = device.find(bytes, device.find("\"lod_scratch\""));
    ASSERT_NE(at, std::string::npos);
    PictureOptions options = picture();
    options.device = files().folder.write("small.toml", device.replace(at, bytes.size(), "bytes = 4096"));
    expect_user_error([&] { DisplaySession session(options, false); },
                      "small.toml: the budget line 'lod_scratch' has 4096 of 4096 bytes left");
}

TEST(DisplaySession, SaysWhenTheTerrainFails) {
    DisplaySession sound(picture(), false);
    sound.draw();
    EXPECT_EQ(sound.terrain_fault(), "");
}

TEST(DisplaySession, ASurfaceThatCannotBeMadeIsRefused) {
    const SurfaceMaker none = [](const platform::SurfaceSettings&) -> base::Result<std::unique_ptr<base::Surface>, base::Error> {
        return base::fail(base::make_error("no surface today; come back tomorrow"));
    };
    expect_user_error([&] { DisplaySession session(picture(), false, none); }, "no surface today; come back tomorrow");
}

}  // namespace
}  // namespace tedavis::host_sim::test_display_session
