#include "target/write_shaders.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "target/board_display.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/target/captured_output.hpp"
#include "tests/target/fake_board.hpp"

namespace tedavis::target::test_write_shaders {
namespace {

using ::testing::HasSubstr;

struct WriteShadersTest : testing::Test {
    WriteShadersTest() { settings.device = test_support::shipped_device("sc2"); }
    std::string write(const std::string& path, bool json = false) {
        base::Error error;
        printed_text = printed([&](std::FILE* out) { error = write_shaders(settings, path.c_str(), stop, json, out); });
        return std::string(error.message.view());
    }
    BoardSettings settings = board_settings();
    test_support::TemporaryFolder folder;
    StopSignal stop;
    std::string printed_text;
};

TEST_F(WriteShadersTest, TheBoardStartsWithWhatItWrote) {
    const std::string path = folder.file("sc2.programs");
    settings.programs = Path(path);
    {
        platform::DisplayHost host;
        EXPECT_THAT(std::string(start_board_display(settings, host).error.message.view()), HasSubstr("no folder of programs"));
    }
    ASSERT_EQ(write(path, true), "");
    const auto json = nlohmann::json::parse(printed_text);
    EXPECT_EQ(json.at("programs"), path);
    EXPECT_EQ(json.at("device"), "sc2");
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(path)) files += entry.path().extension() == ".program" ? 1 : 0;
    EXPECT_EQ(json.at("count"), files);
    EXPECT_GT(files, 10u);
    platform::DisplayHost host;
    EXPECT_EQ(std::string(start_board_display(settings, host).error.message.view()), "");
}

TEST_F(WriteShadersTest, ADeviceWithACompilerNeedsNone) {
    settings = board_settings();
    EXPECT_EQ(write(folder.file("x")),
              "--write-shaders: device 'es2-small' has a compiler and needs no programs; leave [programs] out of the board file");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(WriteShadersTest, ABoardThatDoesNotStartLeavesNothing) {
    settings.device.budget.find(effects::kSymbologyVertices)->bytes = 100;
    EXPECT_THAT(write(folder.file("x")), HasSubstr("budget line"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(WriteShadersTest, ASignalLeavesNothingBehind) {
    raise(SIGINT);
    EXPECT_EQ(write(folder.file("x")), "interrupted; nothing was written");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace tedavis::target::test_write_shaders
