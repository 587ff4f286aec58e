#include "host_sim/replay/display_files.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_display_files {
namespace {

/// A design that is based on another one and names a palette, and a scene, of which any bytes do.
struct Files {
    test_support::TemporaryFolder folder;
    std::string base = folder.write("base.toml", "name = \"base\"\n");
    std::string design = folder.write("a.toml", "name = \"a\"\nbased_on = \"base.toml\"\n");
    std::string scene = folder.write("a.sdb", "a scene");
    PictureOptions picture;

    Files() {
        picture.design = design;
        picture.scene = scene;
    }
    [[nodiscard]] std::string content() const {
        const auto files = display_files(picture);
        EXPECT_TRUE(files);
        return files ? files->content : "";
    }
};

void make_later(const std::string& file) {
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(1));
}

TEST(DisplayFiles, AreTheSameUntilOneOfThemChanges) {
    Files files;
    const auto before = display_files(files.picture);
    EXPECT_TRUE(equal(before, display_files(files.picture)));
    static_cast<void>(files.folder.write("base.toml", "name = \"base\"\n[effects]\nfade_s = 0.5\n"));
    const auto after = display_files(files.picture);
    EXPECT_FALSE(equal(before, after));
    ASSERT_TRUE(before && after);
    EXPECT_NE(before->content, after->content) << "what the design is based on";
}

TEST(DisplayFiles, AFileThatHoldsTheSameAgainIsEqualToTheNextRunAlone) {
    Files files;
    const auto before = display_files(files.picture);
    make_later(files.design);
    const auto after = display_files(files.picture);
    EXPECT_FALSE(equal(before, after)) << "it may have held something else in between";
    ASSERT_TRUE(before && after);
    EXPECT_EQ(before->content, after->content);
}

TEST(DisplayFiles, EveryFileCounts) {
    Files files;
    const std::string plain = files.content();
    files.picture.device = "sc2";
    const std::string of_device = files.content();
    EXPECT_NE(of_device, plain);
    files.picture.aircraft = "turboprop";
    const std::string of_aircraft = files.content();
    EXPECT_NE(of_aircraft, of_device);
    files.picture.scene.clear();
    EXPECT_NE(files.content(), of_aircraft);
}

TEST(DisplayFiles, ASceneIsToldByItsTimesButAMadeOneByWhatItHolds) {
    Files files;
    const std::string plain = files.content();
    make_later(files.scene);
    EXPECT_NE(files.content(), plain);
    files.picture.ghosts.scene = files.folder.write("ghosts.sdb", "a scene and ghosts");
    const std::string with_ghosts = files.content();
    make_later(files.picture.ghosts.scene);
    EXPECT_EQ(files.content(), with_ghosts);
    static_cast<void>(files.folder.write("ghosts.sdb", "a scene and others"));
    EXPECT_NE(files.content(), with_ghosts);
}

TEST(DisplayFiles, WhatCannotBeReadIsNoAnswerAndEqualToNone) {
    Files files;
    files.picture.scene = files.folder.file("missing.sdb");
    EXPECT_FALSE(display_files(files.picture));
    EXPECT_FALSE(equal(display_files(files.picture), display_files(files.picture)));
}

}  // namespace
}  // namespace tedavis::host_sim::test_display_files
