#include "host_sim/replay/drawn_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "host_sim/commands/replay.hpp"
#include "host_sim/commands/shot.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/layer_mask.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "render_core/display/planner/picture_layer.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_drawn_layers {
namespace {

using display::PictureLayer;

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

/// A field with uncertainties over part of the terrain, and places with names.
const std::string& scene() {
    static const std::string kPath = [] {
        SceneDraft draft{"layers", "a test", 1, {}};
        LayerDraft field = test_support::small_grid();
        field.grid.west_rad = base::radians(9.66);
        field.grid.north_rad = base::radians(47.09);
        field.grid.step_lat_rad = base::radians(0.02);
        field.grid.step_lon_rad = base::radians(0.015);
        LayerDraft places;
        places.name = "places";
        places.role = scene::LayerRole::place;
        for (int n = 0; n < 5; ++n) {
            places.points.push_back(
                test_support::scene_point(47.05 + 0.006 * n, 9.67 + 0.004 * n, std::numeric_limits<float>::quiet_NaN()));
            places.names.push_back("Ort " + std::to_string(n));
        }
        draft.layers = {field, places};
        const std::vector<std::uint8_t> bytes = sdb_bytes(draft);
        return files().folder.write("layers.sdb", std::string(bytes.begin(), bytes.end()));
    }();
    return kPath;
}

/// `data`: what it shows beside the terrain.
std::string design(const std::string& name, const std::string& data) {
    return files().folder.write(name, "name = \"layers\"\n" + data);
}

const std::string kGround = "[data.ground]\nlayer = \"air\"\nattribute = \"temperature\"\npalette = \"data_temperature\"\n";
const std::string kUnsure = "[data.ground.uncertainty]\ntechnique = \"saturation\"\n";
const std::string kGlyphs =
    "[[data.element]]\nlayer = \"air\"\nattribute = \"temperature\"\ntechnique = \"spheres\"\npalette = \"data_temperature\"\n"
    "[data.element.uncertainty]\ntechnique = \"circles\"\n";
const std::string kPlaces = "[[data.element]]\nrole = \"place\"\ntechnique = \"billboard\"\n";

ShotOptions shot(const std::string& design_file, const char* device = "es3-mid") {
    ShotOptions options;
    options.pose = {47.03, 9.68, 2500, 10, -6, 3};
    options.picture = files().options("unused").picture;
    options.picture.scene = scene();
    options.picture.design = design_file;
    options.picture.device = device;
    options.output = files().folder.file("layers.png");
    return options;
}

struct Taken {
    RgbaPicture picture;
    std::vector<std::uint8_t> mask;
    [[nodiscard]] std::size_t count(PictureLayer layer) const {
        return static_cast<std::size_t>(std::count(mask.begin(), mask.end(), static_cast<std::uint8_t>(layer)));
    }
};

Taken taken(ShotOptions options) {
    options.layers = true;
    const test_support::CommandRun run =
        test_support::run_command([&](Console& console) { return run_shot(options, console); }, true);
    EXPECT_EQ(run.code, 0) << run.notes;
    EXPECT_EQ(run.json().at("layers").size(), display::kPictureLayers);
    Taken taken{read_png(options.output), {}};
    const RgbaPicture grey = read_png(layer_mask_path(options.output));
    for (std::size_t n = 0; n < grey.pixels.size(); n += 4) taken.mask.push_back(grey.pixels[n]);
    EXPECT_EQ(taken.mask.size() * 4, taken.picture.pixels.size());
    return taken;
}

/// Of a pixel's channels.
int difference(const Taken& a, const Taken& b, std::size_t n) {
    int most = 0;
    for (std::size_t channel = 4 * n; channel < 4 * n + 3; ++channel)
        most = std::max(most, std::abs(int{a.picture.pixels[channel]} - int{b.picture.pixels[channel]}));
    return most;
}

TEST(DrawnLayers, APixelIsOfTheFrontmostLayerThatChangesIt) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        const Taken all = taken(shot(design("all.toml", kGround + kUnsure + kGlyphs + kPlaces), device));
        for (std::size_t layer = 0; layer < display::kPictureLayers; ++layer)
            EXPECT_GT(all.count(static_cast<PictureLayer>(layer)), 50u) << device << display::kPictureLayerNames[layer];
        // A picture of the terrain alone is the same wherever nothing stands before it, but for the planes of depth, which data
        // move: a step of a colour.
        const Taken bare = taken(shot(design("bare.toml", ""), device));
        EXPECT_EQ(bare.count(PictureLayer::data) + bare.count(PictureLayer::uncertainty) + bare.count(PictureLayer::labels), 0u);
        std::size_t unlike = 0, like = 0;
        for (std::size_t n = 0; n < all.mask.size(); ++n) {
            const bool is_terrain = all.mask[n] == 0 && bare.mask[n] == 0;
            unlike += is_terrain && difference(all, bare, n) > 2 ? 1 : 0;
            const bool is_other = all.mask[n] > 0 && all.mask[n] < static_cast<std::uint8_t>(PictureLayer::symbology);
            like += is_other && difference(all, bare, n) == 0 ? 1 : 0;
        }
        EXPECT_EQ(unlike, 0u) << device;
        EXPECT_LT(like, all.mask.size() / 1000) << device << ": by chance";
    }
}

TEST(DrawnLayers, WhatADesignDoesNotShowIsInNoPixel) {
    const Taken sure = taken(shot(design("sure.toml", kGround + kPlaces)));
    EXPECT_EQ(sure.count(PictureLayer::uncertainty), 0u);
    EXPECT_GT(sure.count(PictureLayer::data), 1000u);
    const Taken unsure = taken(shot(design("unsure.toml", kGround + kUnsure + kPlaces)));
    EXPECT_GT(unsure.count(PictureLayer::uncertainty), 1000u);
    ShotOptions options = shot(design("sure.toml", kGround + kPlaces));
    options.picture.symbology = false;
    EXPECT_LT(taken(options).count(PictureLayer::symbology), sure.count(PictureLayer::symbology) / 2);
}

TEST(DrawnLayers, ARunWithMasksHasTheFramesOfOneWithout) {
    ReplayOptions options = files().options("plain_run");
    options.picture.scene = scene();
    options.picture.design = design("run.toml", kGround + kUnsure + kGlyphs + kPlaces);
    options.frames = FrameOutput::png;
    options.from_s = 1;
    options.to_s = 3;
    const auto pictures = [&](bool layers, const char* folder) {
        options.layers = layers;
        options.output = files().folder.file(folder);
        EXPECT_EQ(test_support::run_command([&](Console& console) { return run_replay(options, console); }, true).code, 0);
        std::vector<std::string> all;
        for (std::uint64_t n = 0; n < 5; ++n) all.push_back(read_file(frame_picture_path(options.output, n)));
        return all;
    };
    const std::vector<std::string> plain = pictures(false, "plain_run");
    EXPECT_EQ(pictures(true, "masked_run"), plain);
    EXPECT_TRUE(std::filesystem::exists(layer_mask_path(frame_picture_path(options.output, 4))));
    EXPECT_EQ(pictures(false, "masked_run").size(), 5u);
    EXPECT_FALSE(std::filesystem::exists(layer_mask_path(frame_picture_path(options.output, 4)))) << "of a run before";
    options.layers = true;
    options.frames = FrameOutput::hash;
    test_support::expect_user_error(
        [&] {
            static_cast<void>(test_support::run_command([&](Console& console) { return run_replay(options, console); }, true));
        },
        "--layers: lie beside the pictures");
}

}  // namespace
}  // namespace tedavis::host_sim::test_drawn_layers
