#include "host_sim/commands/readme_sheet.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "host_sim/commands/gallery_moments.hpp"
#include "host_sim/input_file.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_readme_sheet {
namespace {

using ::testing::HasSubstr;

constexpr std::uintmax_t kMaxReadmePicture_bytes = 250'000;

std::string shown_picture(const std::string& name) {
    return test_support::source_dir() + "/" + kReadmePictureFolder + "/" + name + ".png";
}

/// Share of pixels whose channels differ by 12 at most: another build of Mesa may round otherwise, and so choose other colors.
double alike_pixels(const RgbaPicture& a, const RgbaPicture& b) {
    if (a.width != b.width || a.height != b.height) return 0;
    std::size_t alike = 0;
    for (std::size_t at = 0; at < a.pixels.size(); at += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a.pixels[at + c] - b.pixels[at + c]));
        alike += most <= 12 ? 1 : 0;
    }
    return static_cast<double>(alike) / (static_cast<double>(a.pixels.size()) / 4);
}

/// Changes the first of `parts` parts of the picture by more than what is alike.
void spoil(RgbaPicture& picture, std::size_t parts) {
    for (std::size_t at = 0; at < picture.pixels.size() / parts; ++at)
        picture.pixels[at] = static_cast<std::uint8_t>(picture.pixels[at] ^ 0x40);
}

/// TEDAVIS_NEW_PAGES=1 writes the pictures of README.md anew: look at them before they are committed.
TEST(ReadmeSheet, DrawsThePicturesOfTheReadme) {
    constexpr double kAlike = 0.999;
    const test_support::TemporaryFolder folder;
    SheetOptions options;
    options.output = std::getenv("TEDAVIS_NEW_PAGES") != nullptr ? test_support::source_dir() + "/" + kReadmePictureFolder
                                                                 : folder.file("readme");
    const auto run = test_support::run_command([&](Console& console) { return run_readme_sheet(options, console); }, true);
    EXPECT_EQ(run.code, 0);
    EXPECT_EQ(run.json().at("pictures").size(), 5u);
    const std::string readme = read_file(test_support::source_dir() + "/README.md");
    for (const GalleryMoment& moment : gallery_moments()) {
        if (moment.readme == ReadmePlace::nowhere) continue;
        const RgbaPicture drawn = read_png(options.output + "/" + moment.name + ".png");
        EXPECT_EQ(drawn.width, (moment.readme == ReadmePlace::large ? kReadmeLargeSize : kReadmeRowSize).width) << moment.name;
        RgbaPicture committed = read_png(shown_picture(moment.name));
        EXPECT_GE(alike_pixels(drawn, committed), kAlike) << moment.name;
        spoil(committed, 500);
        EXPECT_LT(alike_pixels(drawn, committed), kAlike) << moment.name << ": control";
        EXPECT_LE(std::filesystem::file_size(shown_picture(moment.name)), kMaxReadmePicture_bytes) << moment.name;
        EXPECT_THAT(readme, HasSubstr(kReadmePictureFolder + std::string("/") + moment.name + ".png"));
    }
    EXPECT_THAT(readme, HasSubstr("tedavis sheet readme -o docs"));
}

TEST(ReadmeSheet, HasOneLargePictureAndARowOfFour) {
    const auto in = [](ReadmePlace place) {
        return std::count_if(gallery_moments().begin(), gallery_moments().end(),
                             [&](const GalleryMoment& moment) { return moment.readme == place; });
    };
    EXPECT_EQ(in(ReadmePlace::large), 1);
    EXPECT_EQ(in(ReadmePlace::row), 4);
}

TEST(ReadmeSheet, RefusesWhatItDoesNotDraw) {
    const test_support::TemporaryFolder folder;
    SheetOptions options;
    options.output = folder.file("none");
    const auto refused = [&](const std::string& words) {
        test_support::expect_user_error(
            [&] { (void)test_support::run_command([&](Console& console) { return run_readme_sheet(options, console); }); },
            words);
        EXPECT_FALSE(std::filesystem::exists(options.output));
    };
    options.layers = true;
    refused("leave --size and --layers out");
    options.layers = false;
    options.picture.size = PictureSize{320, 180};
    refused("leave --size and --layers out");
    options.picture.scene = "my.sdb";
    refused("sheet readme: shows the default flight");
}

}  // namespace
}  // namespace tedavis::host_sim::test_readme_sheet
