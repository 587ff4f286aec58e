#include "render_core/draw/symbology/painter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "tests/support/draw/batch_shapes.hpp"
#include "tests/support/draw/symbology_scene.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::draw::test_painter {
namespace {

using test_support::BatchStore;
using test_support::text_of;

const Layout& layout() {
    static const Layout made = make_layout(640, 480, 96);
    return made;
}

TEST(WholeNumber, RoundsPadsAndKeepsItsSign) {
    EXPECT_EQ(whole_number(0.5).view(), "1");
    EXPECT_EQ(whole_number(-0.4).view(), "0");
    EXPECT_EQ(whole_number(-7.5).view(), "-8");
    EXPECT_EQ(whole_number(7, 3).view(), "007");
    EXPECT_EQ(whole_number(-7, 3).view(), "-007");
    EXPECT_EQ(whole_number(1e300).view(), "9999999");
    EXPECT_EQ(whole_number(std::nan("")).view(), "-9999999");
}

TEST(Limited, NotANumberBecomesTheLowEnd) {
    EXPECT_EQ(limited(std::nan(""), -1, 1), -1);
    EXPECT_EQ(limited(std::numeric_limits<double>::infinity(), -1, 1), 1);
    EXPECT_EQ(limited(0.25, -1, 1), 0.25);
}

/// Slides a turned number over the edges of a clip: at every place all of it is there or nothing.
TEST(Painter, ANumberIsWrittenWholeOrNotAtAll) {
    int whole = 0, left_out = 0;
    for (const double angle_deg : {0.0, 30.0, -75.0, 90.0, 180.0})
        for (const TextAnchor anchor : {TextAnchor::left, TextAnchor::center, TextAnchor::right})
            for (float x = 60; x <= 340; x += 3.5f)
                for (const float y : {100.0f, 104.0f, 150.0f, 197.0f}) {
                    BatchStore store;
                    const Painter painter(store.batch, layout());
                    store.batch.set_clip({100, 100, 200, 100});
                    painter.text("1230", {x, y}, anchor, 1, test_support::day_color(SymbolRole::scale),
                                 static_cast<float>(base::radians(angle_deg)));
                    const std::string text = text_of(store.batch);
                    EXPECT_TRUE(text.empty() || text == "1230") << text;
                    (text.empty() ? left_out : whole) += 1;
                }
    EXPECT_GT(whole, 100);
    EXPECT_GT(left_out, 100);
}

TEST(Painter, FittedTextNeverLeavesItsBox) {
    for (const float width : {10.0f, 40.0f, 90.0f, 400.0f})
        for (const TextAnchor anchor : {TextAnchor::left, TextAnchor::center, TextAnchor::right}) {
            BatchStore store;
            const Rect box{50, 50, width, 30};
            Painter(store.batch, layout())
                .fitted_text("VERTICAL SPEED", box, anchor, 1, test_support::day_color(SymbolRole::scale));
            for (const QuadVertex& vertex : store.batch.vertices()) {
                EXPECT_GE(vertex.x, box.x - 2.5f);
                EXPECT_LE(vertex.x, box.right() + 2.5f);
            }
        }
}

TEST(Painter, ReadoutsAndFailuresSayTheirText) {
    BatchStore store;
    const Painter painter(store.batch, layout());
    painter.readout({10, 10, 120, 40}, "123", false);
    EXPECT_EQ(text_of(store.batch), "123");
    store.batch.clear();
    painter.failed({10, 10, 200, 200}, "ATTITUDE");
    EXPECT_EQ(text_of(store.batch), "ATTITUDE");
    store.batch.clear();
    painter.crossed_out({10, 10, 200, 40}, "HDG");
    EXPECT_EQ(text_of(store.batch), "HDG");
}

/// Samples of legends have the colors of the data, and darken them.
bool may_have_colors(const std::string& file) { return file == "legend_sample.cpp" || file == "legend.cpp"; }

std::vector<std::string> literal_colors(const std::string& source) {
    static const std::regex literal(R"((Color(\s+\w+)?|[({,=:]|return)\s*\{\s*\d+\s*,\s*\d+\s*,\s*\d+\s*(,\s*\d+\s*)?\})");
    std::vector<std::string> found;
    for (std::sregex_iterator at(source.begin(), source.end(), literal), end; at != end; ++at) found.push_back(at->str());
    return found;
}

TEST(Painter, NoSourceOfTheSymbologyHasAColorOfItsOwn) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test_support::source_dir() + "/render_core/draw/symbology")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() == ".md" || may_have_colors(name)) continue;
        EXPECT_TRUE(literal_colors(test_support::source_file("render_core/draw/symbology/" + name)).empty()) << name;
        ++files;
    }
    EXPECT_GT(files, 30u);
    EXPECT_EQ(literal_colors("constexpr design::Color kGround{0, 0, 0, 255};").size(), 1u);
    EXPECT_EQ(literal_colors("painter.line(a, b, {255, 48, 48});").size(), 1u);
    EXPECT_TRUE(literal_colors("painter.line({0, 1}, {2, 3}, painter.color(SymbolRole::scale));").empty());
}

TEST(Painter, ColorsAndSizesAreThoseOfThePalette) {
    design::SymbologyPalette palette = design::kDaySymbology;
    palette.colors[static_cast<std::size_t>(SymbolRole::scale)] = {1, 2, 3};
    palette.type.value = 0.75f;
    BatchStore own, standard;
    const Painter painter(own.batch, layout(), palette);
    EXPECT_EQ(painter.label_color(policy::ElementShow::normal), (design::Color{1, 2, 3}));
    EXPECT_EQ(painter.label_color(policy::ElementShow::flagged), test_support::day_color(SymbolRole::caution));
    painter.readout({10, 10, 120, 40}, "123", false);
    Painter(standard.batch, layout()).readout({10, 10, 120, 40}, "123", false);
    const auto digits = [](const BatchStore& store) {
        std::vector<test_support::BatchShape> glyphs;
        for (const test_support::BatchShape& shape : test_support::shapes_of(store.batch))
            if (shape.letter != 0) glyphs.push_back(shape);
        return test_support::bounds_of(glyphs);
    };
    EXPECT_LT(digits(own).height / digits(standard).height, 0.75f) << "0.65, but for the pixels in which edges fade out";
}

}  // namespace
}  // namespace tedavis::draw::test_painter
