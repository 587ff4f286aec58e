#include "host_sim/replay/palette_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/expect_user_error.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tedavis::host_sim::test_palette_files {
namespace {

using ::testing::HasSubstr;

TEST(PaletteFiles, AShortNameIsAShippedFileAndAPathIsFoundFromTheDesign) {
    const test_support::TemporaryFolder place;
    const std::string grey = read_file(resolve_config("grey", "palettes"));
    std::filesystem::create_directory(place.file("mine"));
    place.write("mine/own.toml", grey);
    PaletteFiles palettes(place.file("design.toml"));
    EXPECT_EQ(palettes.find("slope").value().name.view(), "slope");
    EXPECT_EQ(palettes.find("mine/own.toml").value().name.view(), "grey");
    EXPECT_EQ(palettes.find(place.file("mine/own.toml")).value().name.view(), "grey");
    ASSERT_EQ(palettes.files().size(), 3u);
    EXPECT_EQ(palettes.files()[1].path, place.file("mine/own.toml"));
    EXPECT_EQ(palettes.files()[1].text, grey);
}

TEST(PaletteFiles, FaultsAreSentences) {
    const test_support::TemporaryFolder place;
    place.write("bad.toml", "colour = 1\n");
    PaletteFiles palettes(place.file("design.toml"));
    EXPECT_THAT(palettes.find("rainbow").error().message.c_str(), HasSubstr("one of these: alpine, "));
    EXPECT_THAT(palettes.find("own.toml").error().message.c_str(), HasSubstr(place.file("own.toml")));
    EXPECT_THAT(palettes.find("bad.toml").error().message.c_str(), HasSubstr(place.file("bad.toml") + ":1: "));
    test_support::expect_user_error([] { static_cast<void>(palette_from_text("name = 'x'\nkind = 1\n", "p.toml")); }, "p.toml:");
}

}  // namespace
}  // namespace tedavis::host_sim::test_palette_files
