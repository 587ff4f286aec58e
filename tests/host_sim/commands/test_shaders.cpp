#include "host_sim/commands/shaders.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "platform/programs/program_folder.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_shaders {
namespace {

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

ShadersOptions small(const std::string& output) {
    ShadersOptions options;
    options.picture = files().options("unused").picture;
    options.picture.device = "sc2";
    options.output = output;
    return options;
}

TEST(Shaders, WritesEveryProgramThatTheDesignStartsWith) {
    const test_support::TemporaryFolder folder;
    const ShadersOptions options = small(folder.file("new/programs"));
    const auto run = test_support::run_command([&](Console& console) { return run_shaders(options, console); }, true);
    EXPECT_EQ(run.code, 0);
    const auto programs = run.json()["programs"];
    ASSERT_GT(programs.size(), 3u);
    EXPECT_EQ(nlohmann::json::parse(read_file(options.output + "/programs.json")), run.json());
    auto opened = platform::open_program_folder(options.output);
    ASSERT_TRUE(opened.ok());
    for (const auto& program : programs) {
        const std::string file = program["file"];
        base::StoredProgram stored;
        EXPECT_TRUE(opened.value().find(std::stoull(file, nullptr, 16), stored)) << file;
        EXPECT_EQ(stored.binary.size(), program["bytes"].get<std::size_t>());
    }
    const auto again = test_support::run_command([&](Console& console) { return run_shaders(options, console); }, true);
    EXPECT_EQ(again.json(), run.json()) << "the same driver and design have the same programs";
}

TEST(Shaders, LeavesNothingBehindWhereTheDisplayDoesNotStart) {
    const test_support::TemporaryFolder folder;
    ShadersOptions options = small(folder.file("programs"));
    options.picture.terrain = folder.file("none.tdb");
    const auto run = [&] {
        return test_support::run_command([&](Console& console) { return run_shaders(options, console); }, false);
    };
    test_support::expect_user_error(run, "none.tdb");
    options.picture.device = "es3-mid";
    test_support::expect_user_error(run, "es3-mid: it has a compiler");
    std::string text = read_file(shipped_root() + "/configs/devices/sc2.toml");
    text.insert(text.find("calls = "), "also = [\"BogusCall\"]\n");
    options.picture.device = folder.write("bogus.toml", text);
    options.picture.terrain = files().terrain;
    test_support::expect_user_error(run, "BogusCall");
    EXPECT_FALSE(std::filesystem::exists(options.output));
}

}  // namespace
}  // namespace tedavis::host_sim::test_shaders
