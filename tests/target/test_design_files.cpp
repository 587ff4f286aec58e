#include "target/design_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::target::test_design_files {
namespace {

using ::testing::HasSubstr;

const std::string kShipped = test_support::source_file("configs/palettes/grey.toml");

TEST(DesignFiles, AShortNameIsAFileOfTheFolderAndAPathIsFoundFromTheDesign) {
    const test_support::TemporaryFolder place;
    std::filesystem::create_directory(place.file("designs"));
    place.write("mine.toml", kShipped);
    place.write("designs/beside.toml", kShipped);
    const std::string design = place.file("designs/own.toml"), folder = place.path() + "/";
    DesignFiles files({folder, ""});
    const auto find = [&](const std::string& name) { return files.find({name, design}); };
    EXPECT_EQ(find("mine").value().name.view(), "grey");
    EXPECT_EQ(find("beside.toml").value().name.view(), "grey");
    EXPECT_EQ(find("../mine.toml").value().name.view(), "grey");
    EXPECT_EQ(find(place.file("mine.toml")).value().name.view(), "grey") << "an absolute path";
    EXPECT_THAT(find("beside").error().message.c_str(), HasSubstr(place.file("beside.toml")));
}

TEST(DesignFiles, FaultsNameTheFile) {
    const test_support::TemporaryFolder place;
    place.write("bad.toml", "colour = 1\n" + kShipped);
    const std::string design = place.file("own.toml"), folder = place.path() + "/";
    DesignFiles files({folder, ""});
    const auto find = [&](const std::string& name) { return files.find({name, design}); };
    EXPECT_THAT(find("bad").error().message.c_str(), HasSubstr(place.file("bad.toml") + ":1: unknown key"));
    EXPECT_THAT(find(std::string(2000, 'p')).error().message.c_str(), HasSubstr("use a shorter one"));
}

TEST(DesignFiles, ABaseLiesBesideTheDesignThatNamesIt) {
    const test_support::TemporaryFolder place;
    std::filesystem::create_directory(place.file("designs"));
    place.write("designs/base.toml", "name = 'base'\n");
    place.write("above.toml", "name = 'above'\n");
    const std::string design = place.file("designs/own.toml");
    DesignFiles files({"", ""});
    const auto found = files.find_design({"base", design});
    ASSERT_TRUE(found.ok()) << found.error().message.view();
    EXPECT_EQ(found.value().text, "name = 'base'\n");
    EXPECT_EQ(found.value().file_name, place.file("designs/base.toml"));
    EXPECT_EQ(files.find_design({"../above.toml", design}).value().text, "name = 'above'\n");
    EXPECT_EQ(files.find_design({place.file("above.toml"), design}).value().text, "name = 'above'\n");
    EXPECT_THAT(files.find_design({"absent", design}).error().message.c_str(), HasSubstr(place.file("designs/absent.toml")));
    EXPECT_THAT(files.find_design({std::string(2000, 'd'), design}).error().message.c_str(), HasSubstr("use a shorter one"));
}

TEST(DesignFiles, ShortNamesOfDesignsMayHaveAFolder) {
    const test_support::TemporaryFolder place;
    std::filesystem::create_directory(place.file("designs"));
    place.write("designs/base.toml", "name = 'in the folder'\n");
    place.write("base.toml", "name = 'beside'\n");
    const std::string folder = place.file("designs/"), design = place.file("own.toml");
    DesignFiles files({"", folder});
    EXPECT_EQ(files.find_design({"base", design}).value().text, "name = 'in the folder'\n");
    EXPECT_EQ(files.find_design({"base.toml", design}).value().text, "name = 'beside'\n") << "a path, from the design";
}

TEST(DesignFiles, TheBoardFileSaysInWhichFolder) {
    const test_support::TemporaryFolder place;
    const std::string root = test_support::source_dir();
    place.write("own.toml", "name = 'own'\n[terrain]\npalette = 'mine'\n");
    const std::string rest = "device = '" + root + "/configs/devices/es3-mid.toml'\nbus = '" + root +
                             "/configs/buses/canaerospace.toml'\ndesign = 'own.toml'\n";
    const std::string can = "[can]\ninterface = 'can0'\n";
    const auto load = [&](const std::string& text) { return load_board_settings(place.write("board.toml", text).c_str()); };
    EXPECT_THAT(load(rest + can).error().message.c_str(), HasSubstr(place.file("mine.toml"))) << "the board file's own folder";
    std::filesystem::create_directory(place.file("colours"));
    place.write("colours/mine.toml", kShipped);
    for (const char* folder : {"colours", "colours/"}) {
        const auto settings = load(rest + "palettes = '" + folder + "'\n" + can);
        ASSERT_TRUE(settings.ok()) << settings.error().message.view();
        EXPECT_EQ(settings.value().design.terrain.palette.name.view(), "grey");
    }
}

}  // namespace
}  // namespace tedavis::target::test_design_files
