#include "host_sim/commands/trace_sheet.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_trace_sheet_command {
namespace {

TEST(TraceSheetCommand, LeavesAllPictures) {
    const test_support::FlownFiles files;
    SheetOptions options;
    options.sheet = kTraceSheetName;
    options.picture.terrain = files.terrain;
    options.picture.size = PictureSize{64, 48};
    options.output = files.folder.file("sheet");
    const auto run = test_support::run_command([&](Console& console) { return run_trace_sheet(options, console); }, true);
    EXPECT_EQ(run.code, 0);
    for (const char* name : {"time.png", "memory.png", "quality.png", "noise.png", "sheet.png", "index.html"})
        EXPECT_TRUE(std::filesystem::exists(options.output + "/" + name)) << name;
    EXPECT_EQ(nlohmann::json::parse(read_file(options.output + "/sheet.json")), run.json());
}

TEST(TraceSheetCommand, RefusesWhatItDoesNotDraw) {
    SheetOptions options;
    options.layers = true;
    test_support::expect_user_error(
        [&] { (void)test_support::run_command([&](Console& console) { return run_trace_sheet(options, console); }); },
        "--layers");
}

}  // namespace
}  // namespace tedavis::host_sim::test_trace_sheet_command
