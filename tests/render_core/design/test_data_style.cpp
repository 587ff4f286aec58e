#include "render_core/design/data_style.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/display/grey_palettes.hpp"

namespace tedavis::design::test_data_style {
namespace {

using test_support::GreyPalettes;
using test_support::scale_of;

struct Read {
    DataStyle style;
    std::string fault;
};
Read read(const std::string& text) {
    GreyPalettes palettes;
    base::ConfigReader reader(text, "d.toml");
    Read result;
    read_data_style(reader.root().section("data"), palettes, result.style);
    if (!reader.finish()) result.fault = std::string(reader.error().message.view());
    return result;
}

TEST(DataStyle, EveryKeyIsRead) {
    const Read whole = read(R"([data.ground]
layer = "radar"
attribute = "reflectivity"
palette = "grey"
breaks = [10, 30.5]
opacity = 0.5
shown_from = 5
height_m = 1500
[data.ground.uncertainty]
technique = "noise"
strength = 0.4
levels = 3
)");
    EXPECT_EQ(whole.fault, "");
    const GroundData& ground = whole.style.ground;
    EXPECT_TRUE(ground.is_shown);
    EXPECT_EQ(ground.layer.view(), "radar");
    EXPECT_EQ(ground.attribute.view(), "reflectivity");
    ASSERT_EQ(ground.scale.breaks.size(), 2u);
    EXPECT_EQ(ground.scale.breaks[1], 30.5);
    EXPECT_EQ(ground.opacity, 0.5);
    EXPECT_EQ(ground.shown_from, 5);
    EXPECT_EQ(ground.height_m, 1500);
    EXPECT_EQ(ground.uncertainty.technique, IntrinsicUncertainty::noise);
    EXPECT_EQ(ground.uncertainty.levels, 3u);
    EXPECT_EQ(ground.overlay.technique, UncertaintyOverlay::none) << "nothing is laid over that is not asked for";
    EXPECT_FALSE(read("").style.ground.is_shown) << "nothing is shown that is not asked for";
    EXPECT_FALSE(read("[data.ground]\nenabled = false\nlayer = 'a'\nattribute = 'b'\npalette = 'grey'").style.ground.is_shown);
}

TEST(DataStyle, TheOverlayIsAChoiceOfItsOwn) {
    const std::string start = "[data]\nstale_after_min = 20\n[data.ground]\nlayer = 'a'\nattribute = 'b'\npalette = 'grey'\n";
    const Read whole = read(start + R"([data.ground.overlay]
technique = "grid"
strength = 0.5
levels = 6
threshold = 0.3
mesh_m = 64
color = "#102030"
[data.ground.uncertainty]
technique = "bump"
)");
    EXPECT_EQ(whole.fault, "");
    const GroundOverlay& overlay = whole.style.ground.overlay;
    EXPECT_EQ(overlay.technique, UncertaintyOverlay::grid);
    EXPECT_EQ(overlay.strength, 0.5);
    EXPECT_EQ(overlay.levels, 6u);
    EXPECT_EQ(overlay.threshold, 0.3);
    EXPECT_EQ(overlay.mesh_m, 64);
    EXPECT_EQ(overlay.color, (Color{0x10, 0x20, 0x30}));
    EXPECT_EQ(whole.style.ground.uncertainty.technique, IntrinsicUncertainty::bump);
    EXPECT_EQ(whole.style.stale_after_s, 1200);
    const std::string over = start + "[data.ground.overlay]\n";
    EXPECT_NE(read(over + "technique = 'snow'").fault, "");
    EXPECT_NE(read(over + "mesh_m = 100").fault.find("power of two"), std::string::npos);
    EXPECT_NE(read(over + "levels = 1").fault, "");
    EXPECT_NE(read(over + "technique = 'grid'\nlevels = 9").fault, "")
        << "its widest mesh would be wider than the ground's period";
    EXPECT_EQ(read(over + "technique = 'fog'\nlevels = 9").fault, "");
    for (const std::string_view technique : kIntrinsicUncertaintyNames)
        EXPECT_EQ(read(start + "[data.ground.uncertainty]\ntechnique = '" + std::string(technique) + "'").fault, "") << technique;
    for (const std::string_view technique : kUncertaintyOverlayNames)
        EXPECT_EQ(read(over + "technique = '" + std::string(technique) + "'").fault, "") << technique;
}

TEST(DataStyle, MoreGradationsConveyMore) {
    EXPECT_EQ(detail_of(scale_of({})), 1) << "continuous";
    EXPECT_EQ(detail_of(scale_of({10})), 0.25) << "two classes";
    EXPECT_EQ(detail_of(scale_of({10, 20, 30})), 0.5);
    GroundUncertainty uncertainty;
    EXPECT_EQ(detail_of(uncertainty), 0) << "none";
    for (std::size_t n = 1; n < kIntrinsicUncertainties; ++n) {
        uncertainty = {static_cast<IntrinsicUncertainty>(n), 0.5, 0};
        EXPECT_EQ(detail_of(uncertainty), 1);
        double last = 0;
        for (const std::uint32_t levels : {2u, 3u, 5u, 16u}) {
            uncertainty.levels = levels;
            EXPECT_GT(detail_of(uncertainty), last);
            last = detail_of(uncertainty);
        }
        EXPECT_EQ(last, 1);
        uncertainty.strength = 0;
        EXPECT_EQ(detail_of(uncertainty), 0) << "nothing is seen";
    }
    GroundOverlay overlay;
    const auto detail = [&](UncertaintyOverlay technique) {
        overlay.technique = technique;
        return detail_of(overlay);
    };
    EXPECT_EQ(detail(UncertaintyOverlay::none), 0);
    EXPECT_EQ(detail(UncertaintyOverlay::contour), 0.25) << "sure or not";
    EXPECT_EQ(detail(UncertaintyOverlay::halo), 0.25);
    EXPECT_GT(detail(UncertaintyOverlay::grid), detail(UncertaintyOverlay::contour));
    EXPECT_GT(detail(UncertaintyOverlay::fog), detail(UncertaintyOverlay::grid));
}

TEST(DataStyle, LessDetailHasFewerClassesAndGradationsAndNoOtherPrograms) {
    DataStyle style;
    GroundData& ground = style.ground;
    ground.is_shown = true;
    ground.scale = scale_of({10, 20, 30, 40, 50, 60, 70});
    ground.uncertainty = {IntrinsicUncertainty::noise, 0.8, 0};
    ground.overlay.technique = UncertaintyOverlay::fog;
    double last = 1;
    for (double detail = 1; detail >= 0; detail -= 0.05) {
        DataStyle reduced;
        reduced.ground = at_detail(ground, detail);
        EXPECT_TRUE(same_programs(style, reduced)) << detail;
        EXPECT_LE(detail_of(reduced.ground.scale), std::fmax(detail, 0.25) + 1e-9) << "two classes at least";
        EXPECT_LE(detail_of(reduced.ground.uncertainty), detail + 1e-9);
        EXPECT_LE(detail_of(reduced.ground.overlay), detail + 1e-9);
        EXPECT_LE(detail_of(reduced.ground.uncertainty), last);
        last = detail_of(reduced.ground.uncertainty);
    }
    const GroundData half = at_detail(ground, 0.5);
    ASSERT_EQ(half.scale.breaks.size(), 3u) << "four classes";
    EXPECT_EQ(half.scale.breaks[0], 20) << "limits that there were";
    EXPECT_EQ(half.scale.breaks[2], 60);
    EXPECT_EQ(half.uncertainty.levels, 4u);
    ground.scale.breaks.clear();
    EXPECT_EQ(at_detail(ground, 1).scale.breaks.size(), 0u);
    ASSERT_EQ(at_detail(ground, 0.5).scale.breaks.size(), 3u);
    EXPECT_EQ(at_detail(ground, 0.5).scale.breaks[1], 50) << "equal steps";
    EXPECT_EQ(at_detail(ground, std::nan("")).uncertainty.strength, 0);
}

TEST(DataStyle, MembersAreAskedForAndFewerOfThemAreLessDetail) {
    const std::string start = "[data.ground]\nlayer = 'a'\nattribute = 'b'\npalette = 'grey'\n";
    EXPECT_EQ(read(start).style.ground.members, GroundMembers::mean);
    const GroundData ground = read(start + "members = 'animated'\nmember_seconds = 3\n").style.ground;
    EXPECT_EQ(ground.members, GroundMembers::animated);
    EXPECT_EQ(ground.member_s, 3);
    EXPECT_NE(read(start + "members = 'all'\n").fault, "");
    EXPECT_NE(read(start + "members = 'animated'\nmember_seconds = 0\n").fault, "");
    for (std::uint32_t members = 1; members <= 16; members *= 2) {
        EXPECT_NEAR(detail_of_members(members), std::log2(members) / 4, 1e-12);
        EXPECT_EQ(at_detail(ground, detail_of_members(members)).most_members, members);
    }
    EXPECT_EQ(at_detail(ground, 0).most_members, 1u);
}

TEST(DataStyle, MapsBesideThePictureHaveFewerCellsOrMembersInLessDetail) {
    const std::string start = "[data.adjacent]\nlayer = 'a'\nattribute = 'b'\npalette = 'grey'\n";
    AdjacentView view = read(start).style.adjacent;
    EXPECT_TRUE(view.is_shown);
    EXPECT_EQ(at_detail(view, 1).cells, kMaxCells);
    EXPECT_EQ(at_detail(view, 0.5).cells, 12u);
    EXPECT_EQ(at_detail(view, 0).cells, kMinCells);
    EXPECT_EQ(at_detail(view, 0.5).scale.breaks.size(), 3u);
    EXPECT_EQ(at_detail(view, 0.5).most_members, 16u);
    view.shows = AdjacentShows::members;
    EXPECT_EQ(at_detail(view, 0.5).most_members, 4u);
    EXPECT_EQ(at_detail(view, 0.5).cells, kMaxCells);
    EXPECT_EQ(at_detail(view, std::nan("")).most_members, 1u);
    EXPECT_EQ(at_detail(AdjacentView{}, 0.2).scale.breaks.size(), 0u);
}

TEST(DataStyle, FaultsAreSaid) {
    const std::string start = "[data.ground]\nlayer = 'a'\nattribute = 'b'\n";
    EXPECT_NE(read("[data.ground]\nlayer = 'a'\npalette = 'grey'").fault, "");
    EXPECT_NE(read(start + "palette = 'none'").fault, "");
    EXPECT_EQ(read(start + "palette = 'grey'\nbreaks = [5, 5]").fault, "d.toml:5: 'breaks' must ascend; sort them");
    EXPECT_NE(read(start + "palette = 'grey'\nbreaks = [5]\nclasses = 3").fault.find("keep one"), std::string::npos);
    EXPECT_NE(read(start + "palette = 'grey'\nclasses = 1").fault.find("2 to 16"), std::string::npos);
    EXPECT_NE(read(start + "palette = 'grey'\nopacity = 2").fault, "");
    EXPECT_NE(read(start + "palette = 'grey'\n[data.ground.uncertainty]\ntechnique = 'magic'").fault, "");
    EXPECT_NE(read(start + "palette = 'grey'\n[data.ground.uncertainty]\nlevels = 1").fault, "");
    EXPECT_NE(read(start + "palette = 'grey'\nbreaks = [0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15]").fault.find("at most 15"),
              std::string::npos);
}

TEST(DataStyle, KindsStayAsTheyAre) {
    const std::string ground = "[data.ground]\nlayer = 'a'\nattribute = 'b'\npalette = 'kinds'\n";
    const Read whole = read(ground);
    EXPECT_EQ(whole.fault, "");
    EXPECT_EQ(detail_of(whole.style.ground.scale), 0.25) << "two of sixteen";
    EXPECT_TRUE(at_detail(whole.style.ground, 0.1).scale.breaks.empty());
    EXPECT_NE(read(ground + "[data.ground.uncertainty]\ntechnique = 'blur'\n").fault.find("blur would mix its colours"),
              std::string::npos);
    EXPECT_EQ(read(ground + "[data.ground.uncertainty]\ntechnique = 'saturation'\n").fault, "");
}

TEST(DataStyle, ManyClassesAreAlmostThePalette) {
    const Read fine = read("[data.ground]\nlayer = 'a'\nattribute = 'b'\npalette = 'grey'\nclasses = 16");
    ASSERT_EQ(fine.style.ground.scale.breaks.size(), 15u);
    for (double value = 0; value <= 100; value += 0.7)
        EXPECT_NEAR(scale_color(fine.style.ground.scale, value).red, 2.55 * value, 255 / 32.0 + 0.6) << "half a class";
}

TEST(DataStyle, WhatIsNotShownHasNothingToReduce) { EXPECT_TRUE(at_detail(GroundData{}, 0.25).scale.breaks.empty()); }

TEST(DataStyle, ProgramsDifferByTechnique) {
    DataStyle none, shown;
    shown.ground.is_shown = true;
    EXPECT_FALSE(same_programs(none, shown));
    DataStyle other = shown;
    other.ground.opacity = 0.1;
    other.ground.uncertainty.strength = 0.1;
    EXPECT_TRUE(same_programs(shown, other));
    other.ground.uncertainty.technique = IntrinsicUncertainty::strokes;
    EXPECT_FALSE(same_programs(shown, other));
    other = shown;
    other.ground.overlay.color = {1, 2, 3};
    EXPECT_TRUE(same_programs(shown, other));
    other.ground.overlay.technique = UncertaintyOverlay::halo;
    EXPECT_FALSE(same_programs(shown, other));
}

}  // namespace
}  // namespace tedavis::design::test_data_style
