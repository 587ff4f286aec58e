#include "host_sim/replay/design_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_design_files {
namespace {

using ::testing::HasSubstr;

TEST(DesignFiles, AShortNameIsAShippedFileAndAPathIsFoundFromTheDesign) {
    const test_support::TemporaryFolder place;
    const std::string grey = read_file(resolve_config("grey", "palettes"));
    std::filesystem::create_directory(place.file("mine"));
    place.write("mine/own.toml", grey);
    const std::string design = place.file("design.toml");
    DesignFiles files;
    const auto find = [&](const std::string& name) { return files.find({name, design}); };
    EXPECT_EQ(find("slope").value().name.view(), "slope");
    EXPECT_EQ(find("mine/own.toml").value().name.view(), "grey");
    EXPECT_EQ(find(place.file("mine/own.toml")).value().name.view(), "grey");
    ASSERT_EQ(files.files().size(), 3u);
    EXPECT_EQ(files.files()[1].path, place.file("mine/own.toml"));
    EXPECT_EQ(files.files()[1].text, grey);
}

TEST(DesignFiles, FaultsAreSentences) {
    const test_support::TemporaryFolder place;
    place.write("bad.toml", "colour = 1\n");
    const std::string design = place.file("design.toml");
    DesignFiles files;
    const auto find = [&](const std::string& name) { return files.find({name, design}); };
    EXPECT_THAT(find("rainbow").error().message.c_str(), HasSubstr("one of these: alpine, "));
    EXPECT_THAT(find("own.toml").error().message.c_str(), HasSubstr(place.file("own.toml")));
    EXPECT_THAT(find("bad.toml").error().message.c_str(), HasSubstr(place.file("bad.toml") + ":1: "));
    test_support::expect_user_error([] { static_cast<void>(palette_from_text("name = 'x'\nkind = 1\n", "p.toml")); }, "p.toml:");
}

TEST(DesignFiles, ABaseIsAShippedDesignOrAPathFromTheFileThatSaysIt) {
    const test_support::TemporaryFolder place;
    place.write("base.toml", "name = 'base'\n");
    DesignFiles files;
    EXPECT_EQ(files.find_design({"cruise", place.file("d.toml")}).value().file_name,
              shipped_root() + "/configs/designs/cruise.toml");
    EXPECT_EQ(files.find_design({"base.toml", place.file("d.toml")}).value().text, "name = 'base'\n");
    const auto absent = files.find_design({"none.toml", place.file("d.toml")});
    EXPECT_THAT(absent.error().message.c_str(), HasSubstr(place.file("none.toml") + ": no such file"));
    ASSERT_EQ(files.files().size(), 3u) << "what is not there is watched, too";
    EXPECT_EQ(files.files()[1].path, place.file("base.toml"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_design_files
