#include "host_sim/commands/device.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/commands/start_trial.hpp"
#include "host_sim/device_plan/device_draft.hpp"
#include "host_sim/input_file.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_device {
namespace {

using test_support::CommandRun;
using test_support::expect_user_error;
using ::testing::HasSubstr;

struct DevicePlanCommand : ::testing::Test {
    test_support::TemporaryFolder folder;
    DevicePlanOptions options;

    DevicePlanCommand() {
        options.output = folder.file("device.toml");
        options.memory = "64M";
        options.picture.size = {320, 240};
    }
    CommandRun run() {
        return test_support::run_command([&](Console& console) { return run_device_plan(options, console); }, true);
    }
};

/// What is written starts by itself, as `tedavis check` proves it.
TEST_F(DevicePlanCommand, APlanForTheMemoryOfEachShippedDeviceStarts) {
    for (const char* const name : {"es2-small", "es3-mid", "sc2"}) {
        const effects::DeviceSettings shipped = test_support::shipped_device(name);
        const std::uint64_t bytes = total_bytes(shipped);
        options.memory = std::to_string(bytes);
        options.picture.size = {shipped.width_px, shipped.height_px};
        const CommandRun made = run();
        ASSERT_EQ(made.code, 0) << made.notes;
        const auto read = effects::read_device_settings(read_file(options.output), options.output);
        ASSERT_TRUE(read.ok()) << read.error().message.view();
        EXPECT_LE(total_bytes(read.value()), bytes) << name;
        EXPECT_EQ(made.json()["total_bytes"].get<std::uint64_t>(), total_bytes(read.value()));
        EXPECT_EQ(read.value().width_px, shipped.width_px);
        EXPECT_GE(read.value().max_chunk_slots, 100u);
        StartTrial trial;
        EXPECT_NO_THROW(trial.require(options.output, "default")) << name;
    }
}

TEST_F(DevicePlanCommand, TheFileSaysHowItWasMadeAndWhatWasGivenUp) {
    options.memory = "32M";
    options.lane = effects::Lane::es2;
    const CommandRun made = run();
    ASSERT_EQ(made.code, 0);
    const std::string text = read_file(options.output);
    EXPECT_THAT(text, HasSubstr("# Written by: tedavis device plan --size 320x240 --memory 32M --rate 30 --design default "
                                "--lane es2 -o "));
    ASSERT_FALSE(made.json()["given_up"].empty());
    for (const auto& one : made.json()["given_up"])
        EXPECT_THAT(text, HasSubstr("# Given up: " + one["sentence"].get<std::string>() + ".\n"));
    EXPECT_THAT(text, HasSubstr("name = \"device\"\n"));
}

TEST_F(DevicePlanCommand, TooSmallAMemoryIsRefusedAndNothingIsWritten) {
    options.memory = "64K";
    expect_user_error([&] { run(); }, "--memory 64K: 65536 bytes are ");
    expect_user_error([&] { run(); },
                      " less than the least that a picture of 320x240 with the design default needs; give --memory ");
    EXPECT_FALSE(std::filesystem::exists(options.output));
    EXPECT_FALSE(std::filesystem::exists(options.output + ".part"));
}

TEST_F(DevicePlanCommand, OptionsThatAreNoneAreRefused) {
    const auto refuses = [&](const std::string& words) {
        expect_user_error([&] { run(); }, words);
        EXPECT_FALSE(std::filesystem::exists(options.output));
    };
    options.memory = "much";
    refuses("--memory much: not a number of bytes");
    options.memory = "64M";
    options.rate_hz = 0;
    refuses("--rate");
    options.rate_hz = 30;
    options.picture.size = {20, 20};
    refuses("--size");
    options.picture.size = {320, 240};
    options.output = folder.file("device.json");
    refuses("ends in .toml");
}

TEST(MemoryFrom, ReadsBytesAndUnits) {
    EXPECT_EQ(memory_from("4096"), 4096u);
    EXPECT_EQ(memory_from("64K"), 65536u);
    EXPECT_EQ(memory_from("1.5M"), 1572864u);
    EXPECT_EQ(memory_from("2G"), std::uint64_t{2} << 30);
    for (const char* const text : {"", "M", "-5M", "5 M", "5MB", "0", "nan", "inf", "1e300", " 5", "5T"})
        EXPECT_THROW(static_cast<void>(memory_from(text)), UserError) << text;
}

}  // namespace
}  // namespace tedavis::host_sim::test_device
