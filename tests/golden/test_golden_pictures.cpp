// Every way to show terrain, as it looked when it was last looked at: the pictures of tests/golden/pictures.
//
// Tolerance  1/255 a channel on 99.9 % of the pixels: what another build of Mesa may round otherwise. Both lanes are held to the
//            same picture.
// New ones   TEDAVIS_NEW_GOLDEN=1 build/host/bin/test_golden writes those that differ, from es3-mid; look at each before it is
// committed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "host_sim/commands/sheet_plan.hpp"
#include "host_sim/commands/terrain.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/png_file.hpp"
#include "host_sim/replay/posed_frame.hpp"
#include "host_sim/terrain_builder/generated_image.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"

namespace tedavis::test_golden_pictures {
namespace {

using host_sim::PictureOptions;
using host_sim::RgbaPicture;
using host_sim::SheetPlan;

constexpr host_sim::PictureSize kSize{256, 192};
constexpr double kMatchingShare = 0.999;
constexpr int kTolerance = 1;

std::string root() { return test_support::source_dir(); }
std::string golden_path(const SheetPlan::Picture& picture) { return root() + "/tests/golden/pictures/" + picture.file; }

SheetPlan plan() {
    const std::string path = root() + "/configs/sheets/terrain-styles.toml";
    return host_sim::parse_sheet_plan(host_sim::read_file(path), path);
}

std::vector<SheetPlan::Picture> pictures() {
    std::vector<SheetPlan::Picture> all;
    for (const SheetPlan::Group& group : plan().groups) all.insert(all.end(), group.pictures.begin(), group.pictures.end());
    return all;
}

std::string default_terrain(const test_support::TemporaryFolder& folder) {
    host_sim::TerrainBuildOptions build;
    build.rasters = {plan().terrain};
    build.output = folder.file("golden.tdb");
    build.accuracy_m = 16;
    build.drape = folder.file("generated_image.tif");
    host_sim::write_generated_image(build.rasters.front(), build.drape);
    EXPECT_EQ(test_support::run_command([&](host_sim::Console& console) { return run_terrain_build(build, console); }).code, 0);
    return build.output;
}

RgbaPicture drawn(const SheetPlan::Picture& picture, const std::string& terrain, const std::string& device) {
    PictureOptions options;
    options.terrain = terrain;
    options.design = picture.design;
    options.device = device;
    options.size = kSize;
    options.symbology = false;
    options.legend = flight::LegendShow::none;  // what is held is the ground
    host_sim::DisplaySession session(options, false);
    static_cast<void>(posed_frame(session, plan().pose, {}));
    return upright(session.pixels());
}

/// Share of pixels whose channels differ by `tolerance` at most.
double matching_share(const RgbaPicture& a, const RgbaPicture& b, int tolerance) {
    if (a.width != b.width || a.height != b.height) return 0;
    std::size_t matching = 0;
    for (std::size_t p = 0; p < a.pixels.size(); p += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(int{a.pixels[p + c]} - int{b.pixels[p + c]}));
        matching += most <= tolerance ? 1 : 0;
    }
    return static_cast<double>(matching) / (static_cast<double>(a.pixels.size()) / 4);
}

bool is_matching(const RgbaPicture& a, const RgbaPicture& b) { return matching_share(a, b, kTolerance) >= kMatchingShare; }

class GoldenPictures : public testing::TestWithParam<const char*> {};

TEST_P(GoldenPictures, EveryTechniqueLooksAsItDid) {
    const bool renew = std::getenv("TEDAVIS_NEW_GOLDEN") != nullptr && std::string(GetParam()) == "es3-mid";
    const test_support::TemporaryFolder folder;
    const std::string terrain = default_terrain(folder);
    for (const SheetPlan::Picture& picture : pictures()) {
        const RgbaPicture now = drawn(picture, terrain, GetParam());
        const std::string path = golden_path(picture);
        const bool exists = std::filesystem::exists(path);
        if (renew && (!exists || !is_matching(now, host_sim::read_png(path)))) host_sim::write_png(path, view_of(now));
        ASSERT_TRUE(exists || renew) << path << " is missing: TEDAVIS_NEW_GOLDEN=1 writes it";
        EXPECT_GE(matching_share(now, host_sim::read_png(path), kTolerance), kMatchingShare) << picture.title;
    }
}

INSTANTIATE_TEST_SUITE_P(Devices, GoldenPictures, testing::Values("es3-mid", "es2-small"),
                         [](const auto& device) { return std::string(device.param).substr(0, 3); });

/// Control: no technique passes for another one, and there are no pictures without a technique.
TEST(GoldenPictures, NoTechniqueMatchesThePictureOfAnother) {
    std::map<std::string, RgbaPicture> golden;
    for (const SheetPlan::Picture& picture : pictures()) golden.emplace(picture.file, host_sim::read_png(golden_path(picture)));
    for (auto a = golden.begin(); a != golden.end(); ++a)
        for (auto b = std::next(a); b != golden.end(); ++b) {
            EXPECT_FALSE(is_matching(a->second, b->second)) << a->first << " and " << b->first;
            EXPECT_LT(matching_share(a->second, b->second, 8), 0.999) << a->first << " looks like " << b->first;
        }
    std::uintmax_t bytes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(root() + "/tests/golden/pictures")) {
        EXPECT_EQ(golden.count(entry.path().filename().string()), 1u) << entry.path() << " belongs to no picture of the sheet";
        bytes += entry.file_size();
    }
    EXPECT_LT(bytes, 1'500'000u);
}

}  // namespace
}  // namespace tedavis::test_golden_pictures
