#include "host_sim/commands/display_sheet.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/reports/display_parts.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_display_sheet {
namespace {

/// Share of pixels whose channels differ by 1 at most: what another build of Mesa may round otherwise.
double matching_pixels(const RgbaPicture& a, const RgbaPicture& b) {
    if (a.width != b.width || a.height != b.height) return 0;
    std::size_t matching = 0;
    for (std::size_t at = 0; at < a.pixels.size(); at += 4) {
        bool is_near = true;
        for (std::size_t c = 0; c < 3; ++c) is_near = is_near && std::abs(a.pixels[at + c] - b.pixels[at + c]) <= 1;
        matching += is_near ? 1 : 0;
    }
    return static_cast<double>(matching) / (static_cast<double>(a.pixels.size()) / 4);
}

/// TEDAVIS_NEW_PAGES=1 writes the picture of the page anew: look at it before it is committed.
TEST(DisplaySheet, DrawsThePictureOfThePage) {
    const test_support::TemporaryFolder folder;
    SheetOptions options;
    options.sheet = kDisplaySheetName;
    options.output = folder.file("sheet");
    const auto run = test_support::run_command([&](Console& console) { return run_display_sheet(options, console); }, true);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.json()["parts"].size(), display_parts().size());
    EXPECT_TRUE(std::filesystem::exists(options.output + "/index.html"));
    const RgbaPicture drawn = read_png(options.output + "/display.png");
    const std::string page = test_support::source_dir() + "/render_core/draw/symbology/display.png";
    if (std::getenv("TEDAVIS_NEW_PAGES") != nullptr) write_file_atomically(page, encode_small_png(view_of(drawn)));
    RgbaPicture committed = read_png(page);
    EXPECT_GE(matching_pixels(drawn, committed), 0.999);
    for (std::size_t at = 0; at < committed.pixels.size() / 50; ++at)
        committed.pixels[at] = static_cast<std::uint8_t>(committed.pixels[at] + 40);
    EXPECT_LT(matching_pixels(drawn, committed), 0.999) << "control";
}

TEST(DisplaySheet, RefusesWhatItDoesNotDraw) {
    SheetOptions options;
    options.layers = true;
    test_support::expect_user_error(
        [&] { (void)test_support::run_command([&](Console& console) { return run_display_sheet(options, console); }); },
        "--layers");
}

}  // namespace
}  // namespace tedavis::host_sim::test_display_sheet
