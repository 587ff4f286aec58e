#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/batch_rasterizer.hpp"
#include "tests/support/draw/symbology_scene.hpp"
#include "tests/support/files/device_files.hpp"

namespace tedavis::draw::test_legend {
namespace {

using design::Color;
using test_support::BatchStore;
using test_support::Picture;
using test_support::text_of;

constexpr double kFoot = base::kMetresPerFoot;

/// Terrain of 0 to 2000 m with the warning bands, in calm flight.
SymbologyInput calm_input() {
    SymbologyInput input = test_support::scene_input(test_support::scene_state(30, 2, 0), 640, 480);
    input.legend.lowest = 0;
    input.legend.highest = 2000;
    return input;
}

/// Of the whole legend.
LegendNeed column() {
    LegendNeed need;
    need.keeps_column = true;
    return need;
}

std::string legend_text(const SymbologyInput& input) {
    BatchStore store;
    build_legend(Painter(store.batch, make_layout(1280, 960, 96, column())), input);
    return text_of(store.batch);
}

TEST(Legend, NamesWhatIsOnThePicture) {
    SymbologyInput input = calm_input();
    EXPECT_EQ(legend_text(input), "GROUNDELEVFT0100020003000400050006000SEANODATAOUTSIDERELATIVEFT+2000+1000-500-1000-2000");
    input.legend.bands = false;
    EXPECT_EQ(legend_text(input), "GROUNDELEVFT0100020003000400050006000SEANODATAOUTSIDE");
    input.legend.tint = false;
    EXPECT_EQ(legend_text(input), "SEANODATAOUTSIDE") << "whatever gives the ground its colour";
    input.legend.bands = true;
    EXPECT_EQ(legend_text(input), "SEANODATAOUTSIDERELATIVEFT+2000+1000-500-1000-2000");
    input.legend.ground = false;
    EXPECT_EQ(legend_text(input), "") << "no terrain, no colours";
    input = calm_input();
    input.decisions.unusual_attitude = true;
    EXPECT_EQ(legend_text(input), "");
    // The decisions of a display without and with terrain reach it.
    policy::DisplayConditions conditions = test_support::scene_conditions();
    EXPECT_TRUE(calm_input().legend.tint);
    conditions.terrain = policy::TerrainSource::none;
    EXPECT_FALSE(test_support::scene_input(test_support::scene_state(30, 2, 0), 640, 480, conditions).legend.ground);
}

TEST(Legend, SaysByHowMuchTheBandsAreLowered) {
    SymbologyInput input = calm_input();
    input.legend.bands_lowered_m = 30.48;
    const std::string known = legend_text(input);
    EXPECT_NE(known.find("-2000VERTERR100"), std::string::npos) << known;
    input.legend.accuracy_assumed = true;
    EXPECT_EQ(legend_text(input), known + "ASSUMED");
    input.legend.units = base::DisplayUnits::metric;
    EXPECT_NE(legend_text(input).find("VERTERR30A"), std::string::npos);
    input.legend.bands = false;
    EXPECT_EQ(legend_text(input).find("VERTERR"), std::string::npos);
}

TEST(Legend, SpeaksTheUnitOfTheDesignAndOfThePalette) {
    SymbologyInput input = calm_input();
    input.legend.units = base::DisplayUnits::metric;
    EXPECT_EQ(legend_text(input), "GROUNDELEVM0500100015002000SEANODATAOUTSIDERELATIVEM+610+305-152-305-610");
    input.legend.bands = false;
    input.legend.lowest = input.legend.highest = 0;
    input.legend.palette = test_support::ShippedFiles().find({"slope", ""}).value();
    EXPECT_EQ(legend_text(input), "SLOPEDEG0102030405060SEANODATAOUTSIDE");
    input.legend.palette = test_support::ShippedFiles().find({"local_relief", ""}).value();
    EXPECT_EQ(legend_text(input), "RELIEFM-60-40-200204060SEANODATAOUTSIDE");
    input.legend.palette.unit = design::PaletteUnit::one;
    EXPECT_EQ(legend_text(input).substr(0, 9), "RELIEF-60");
}

TEST(Legend, ADesignCanSwitchItOff) {
    const Layout layout = make_layout(1280, 960, 96, column());
    SymbologyInput input = calm_input();
    BatchStore with, without;
    build_symbology(with.batch, input, layout);
    input.shown.legend = false;
    build_symbology(without.batch, input, layout);
    EXPECT_NE(text_of(with.batch).find("GROUNDELEV"), std::string::npos);
    EXPECT_EQ(text_of(without.batch).find("GROUNDELEV"), std::string::npos);
}

/// Eight bands a thousand feet apart.
design::WarningBands most_bands() {
    design::WarningBands bands;
    for (int n = 0; n < 8; ++n) EXPECT_TRUE(bands.try_push_back({(4000 - 1000 * n) * kFoot, 0, {200, 0, 0}, 0.5}));
    return bands;
}

/// Middles of the lines of text, downwards: of the last glyph in each, a letter or a digit.
std::vector<float> text_rows(const QuadBatch& batch, float text_px) {
    std::vector<float> rows;
    const auto vertices = batch.vertices();
    for (std::size_t i = 0; i + 3 < vertices.size(); ++i) {
        if (vertices[i].extent_x != -1.0f) continue;  // no glyph, or a halo
        const float y = (vertices[i].y + vertices[i + 2].y) / 2;
        if (rows.empty() || std::fabs(rows.back() - y) > 0.4f * text_px) rows.push_back(y);
        rows.back() = y;
        i += 3;
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

TEST(Legend, HasRoomOnEveryScreenWithEveryBandAndRangeOfHeights) {
    struct Screen {
        std::uint32_t width, height;
    };
    SymbologyInput input = calm_input();
    input.legend.warning_bands = most_bands();
    input.legend.bands_lowered_m = 40;
    input.legend.accuracy_assumed = true;
    for (const Screen& screen : {Screen{320, 240},
                                 {240, 320},
                                 {640, 480},
                                 {480, 640},
                                 {1024, 768},
                                 {768, 1024},
                                 {1920, 1080},
                                 {1080, 2560},
                                 {3840, 2160}})
        for (const double dpi : {60.0, 96.0, 300.0})
            for (const auto& [low, high] :
                 {std::pair{0.0, 8848.0}, {-430.0, 0.0}, {236.0, 1076.0}, {100.0, 101.0}, {-1.0, 0.5}, {5.0, 5.0}}) {
                const Layout layout = make_layout(screen.width, screen.height, dpi, column());
                if (!layout.has_legend_rows) continue;
                input.legend.lowest = low;
                input.legend.highest = high;
                BatchStore store;
                build_legend(Painter(store.batch, layout), input);
                const std::string what = std::to_string(screen.width) + "x" + std::to_string(screen.height) + " " +
                                         std::to_string(dpi) + " from " + std::to_string(low) + " to " + std::to_string(high);
                EXPECT_EQ(store.batch.use().refused, 0u) << what;
                EXPECT_LT(store.batch.use().high_water, kSymbologyVertices / 4) << what;
                const Rect room = layout.legend.shrunk(-1.5f);
                for (const QuadVertex& v : store.batch.vertices())
                    ASSERT_TRUE(room.contains(Point{v.x, v.y})) << what << " at " << v.x << ", " << v.y;
                const std::vector<float> rows = text_rows(store.batch, layout.text_px);
                EXPECT_GE(rows.size(), 16u) << what << ": two titles, eight bands, three samples, two remarks and a value";
                for (std::size_t i = 1; i < rows.size(); ++i)
                    EXPECT_GT(rows[i] - rows[i - 1], 0.7f * layout.text_px) << what << ": lines run into each other";
            }
}

/// The legend drawn over a black screen.
Picture drawn(const SymbologyInput& input, const Layout& layout) {
    BatchStore store;
    build_legend(Painter(store.batch, layout), input);
    Picture picture(1280, 960, {0, 0, 0});
    rasterize(store.batch, picture);
    return picture;
}

int distance(Color a, Color b) {
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

TEST(Legend, EachNumberStandsAtItsColor) {
    const Layout layout = make_layout(1280, 960, 96, column());
    SymbologyInput input = calm_input();
    input.legend.bands = false;
    const Picture picture = drawn(input, layout);
    // The bar's frame is white and its numbers' ticks reach in from the right: read in the left half.
    const float t = layout.text_px;
    const int x = static_cast<int>(layout.legend.x + 0.7f * t);
    BatchStore store;
    build_legend(Painter(store.batch, layout), input);
    const std::vector<float> rows = text_rows(store.batch, layout.text_px);  // title, 6000 .. 0 ft, SEA, NO DATA, OUTSIDE
    ASSERT_EQ(rows.size(), 11u);
    for (int n = 1; n <= 5; ++n) {  // the lowest stands on the frame
        const double height_m = (7 - n) * 1000 * kFoot;
        const Color shown = picture.at(x, static_cast<int>(rows[static_cast<std::size_t>(n)]));
        EXPECT_LE(distance(shown, color_of_value(input.legend.palette, height_m)), 6) << height_m;
        EXPECT_GT(distance(shown, color_of_value(input.legend.palette, height_m + 300)), 6) << "control";
    }
    EXPECT_EQ(picture.at(x, static_cast<int>(rows[8])), input.legend.sea);
    EXPECT_EQ(picture.at(x, static_cast<int>(rows[10])), input.legend.unknown);
}

/// As terrain.frag draws missing data: stripes 12 pixels apart, half of them dark, the same along every diagonal.
TEST(Legend, UnknownGroundAndTheOutsideAreHatchedAlike) {
    const Layout layout = make_layout(1280, 960, 96, column());
    SymbologyInput input = calm_input();
    input.legend.bands = input.legend.tint = false;
    const Picture picture = drawn(input, layout);
    BatchStore store;
    build_legend(Painter(store.batch, layout), input);
    const std::vector<float> rows = text_rows(store.batch, layout.text_px);
    ASSERT_EQ(rows.size(), 3u);
    const float t = layout.text_px;
    const int left = static_cast<int>(layout.legend.x + 0.3f * t) + 5, right = static_cast<int>(layout.legend.x + 1.5f * t) - 5;
    const Color dark = blended({0, 0, 0}, input.legend.unknown, 0.5);
    const auto count = [&](float row, Color wanted) {
        int found = 0;
        for (int y = static_cast<int>(row) - 6; y <= static_cast<int>(row) + 6; ++y)
            for (int x = left; x < right; ++x) found += distance(picture.at(x, y), wanted) <= 2 ? 1 : 0;
        return found;
    };
    const int all = 13 * (right - left);
    for (const float row : {rows[1], rows[2]}) {
        EXPECT_GT(count(row, dark), all / 5);
        EXPECT_GT(count(row, input.legend.unknown), all / 5);
    }
    EXPECT_EQ(count(rows[0], input.legend.sea), all);
}

TEST(Legend, BandsLookAsTheyDoOverTheTerrain) {
    const Layout layout = make_layout(1280, 960, 96, column());
    const SymbologyInput input = calm_input();
    const Picture picture = drawn(input, layout);
    BatchStore store;
    build_legend(Painter(store.batch, layout), input);
    const std::vector<float> rows = text_rows(store.batch, layout.text_px);
    const auto& bands = input.legend.warning_bands;
    const float t = layout.text_px;
    const int left = static_cast<int>(layout.legend.x + 0.45f * t), right = static_cast<int>(layout.legend.x + 1.3f * t);
    for (std::size_t n = 0; n < bands.size(); ++n) {
        const float limit = rows[rows.size() - bands.size() + n];  // a band's number stands at its foot
        const int y = static_cast<int>(limit - 0.5f * t);
        const Color low = blended(color_of_value(input.legend.palette, 0), bands[n].color, bands[n].strength);
        const Color high = blended(color_of_value(input.legend.palette, 2000), bands[n].color, bands[n].strength);
        EXPECT_EQ(picture.at(left, y), low) << n;
        EXPECT_EQ(picture.at(right, y), high) << n;
    }
}

TEST(Legend, ItsTextIsReadOverSnow) {
    const auto contrast = [](Color a, Color b) {
        const double first = relative_luminance(a) + 0.05, second = relative_luminance(b) + 0.05;
        return first > second ? first / second : second / first;
    };
    const Color snow{255, 255, 255};
    const Color plate = blended(snow, test_support::day_color(SymbolRole::tape_ground),
                                test_support::day_color(SymbolRole::tape_ground).alpha / 255.0);
    EXPECT_GT(contrast(test_support::day_color(SymbolRole::scale), plate), 4.5);
    EXPECT_LT(contrast(test_support::day_color(SymbolRole::scale), snow), 4.5) << "control";
}

}  // namespace
}  // namespace tedavis::draw::test_legend
