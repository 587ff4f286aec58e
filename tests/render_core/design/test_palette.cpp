#include "render_core/design/palette.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::design::test_palette {
namespace {

std::string with(const std::string& kind, const std::string& unit, const std::string& stops) {
    return "name = 'x'\ntitle = 'X'\nkind = '" + kind + "'\nunit = '" + unit + "'\norder = 'lightness'\n" + stops;
}
std::string stop(const std::string& value, const std::string& color = "#000000") {
    return "[[stop]]\nvalue = " + value + "\ncolor = '" + color + "'\n";
}
std::string error_of(const std::string& text) {
    const auto palette = read_palette(text, "p.toml");
    return palette.ok() ? "" : std::string(palette.error().message.view());
}

TEST(Palette, EveryShippedOneLoadsUnderItsFileName) {
    std::size_t files = 0, heights = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test_support::source_dir() + "/configs/palettes")) {
        if (entry.is_directory()) continue;  // palettes of the symbology
        const std::string path = "configs/palettes/" + entry.path().filename().string();
        const auto palette = read_palette(test_support::source_file(path), path);
        ASSERT_TRUE(palette.ok()) << palette.error().message.view();
        EXPECT_EQ(palette.value().name.view(), entry.path().stem().string());
        heights += palette.value().kind == PaletteKind::hypsometric ? 1 : 0;
        ++files;
    }
    EXPECT_GE(files, 7u);
    EXPECT_GE(heights, 4u);
}

TEST(Palette, TheBuiltInOneIsTheShippedOne) {
    const auto file = read_palette(test_support::source_file("configs/palettes/alpine.toml"), "alpine.toml");
    ASSERT_TRUE(file.ok());
    const Palette built_in = alpine_palette();
    EXPECT_EQ(file.value().name, built_in.name);
    EXPECT_EQ(file.value().title, built_in.title);
    EXPECT_EQ(file.value().kind, built_in.kind);
    EXPECT_EQ(file.value().order, built_in.order);
    ASSERT_EQ(file.value().stops.size(), built_in.stops.size());
    for (std::size_t i = 0; i < built_in.stops.size(); ++i) {
        EXPECT_EQ(file.value().stops[i].value, built_in.stops[i].value);
        EXPECT_EQ(file.value().stops[i].color, built_in.stops[i].color);
    }
}

TEST(Palette, OneThatFitsTerrainIsSpreadOverItsHeights) {
    const std::string stops = stop("0") + stop("250", "#404040") + stop("1000", "#ffffff");
    const Palette fits = read_palette(with("hypsometric", "m", "fits_terrain = true\n" + stops), "p.toml").value();
    const Palette fitted = fitted_palette(fits, 1200, 3200);
    ASSERT_EQ(fitted.stops.size(), 3u);
    EXPECT_DOUBLE_EQ(fitted.stops[0].value, 1200);
    EXPECT_DOUBLE_EQ(fitted.stops[1].value, 1700);
    EXPECT_DOUBLE_EQ(fitted.stops[2].value, 3200);
    EXPECT_EQ(color_of_value(fitted, 1700), color_of_value(fits, 250));
    const Palette again = fitted_palette(fitted, 1200, 3200);
    for (std::size_t n = 0; n < 3; ++n)
        EXPECT_DOUBLE_EQ(again.stops[n].value, fitted.stops[n].value) << "fitting twice changes nothing";
    EXPECT_DOUBLE_EQ(fitted_palette(fits, 10, 40).stops[2].value, 10 + kMinFittedSpan_m) << "flat land has no mountains' tints";

    const Palette fixed = read_palette(with("hypsometric", "m", stops), "p.toml").value();
    EXPECT_EQ(fitted_palette(fixed, 1200, 3200).stops[2].value, 1000) << "a palette of true heights keeps them";
    EXPECT_THAT(error_of(with("sequential", "deg", "fits_terrain = true\n" + stop("0") + stop("90", "#ffffff"))),
                testing::HasSubstr("'fits_terrain' is for heights of the terrain only"));
}

TEST(Palette, DegreesBecomeRadians) {
    const auto slope = read_palette(with("sequential", "deg", stop("0") + stop("90", "#ffffff")), "p.toml");
    ASSERT_TRUE(slope.ok()) << slope.error().message.view();
    EXPECT_EQ(slope.value().kind, PaletteKind::sequential);
    EXPECT_EQ(slope.value().unit, PaletteUnit::degrees);
    EXPECT_NEAR(slope.value().stops[1].value, 1.5707963267948966, 1e-15);
    EXPECT_EQ(read_palette(with("sequential", "1", stop("0") + stop("90")), "p.toml").value().stops[1].value, 90);
    EXPECT_EQ(read_palette(with("diverging", "m", stop("-1") + stop("0") + stop("2")), "p.toml").value().stops[0].value, -1);
}

TEST(Palette, ThoseOfDataSayTheirPurposeAndUnit) {
    const std::string stops = stop("1") + stop("2");
    for (const char* unit : {"m", "deg", "1", "m/s", "dBZ", "K"}) {
        const auto palette = read_palette(with("sequential", unit, stops), "p.toml");
        ASSERT_TRUE(palette.ok()) << palette.error().message.view();
        EXPECT_EQ(unit_name(palette.value().unit), unit);
        EXPECT_EQ(palette.value().purpose, PalettePurpose::terrain) << "where nothing is said";
    }
    EXPECT_EQ(read_palette("purpose = 'data'\n" + with("sequential", "K", stops), "p.toml").value().purpose,
              PalettePurpose::data);
    EXPECT_EQ(read_palette("purpose = 'objects'\n" + with("sequential", "K", stops), "p.toml").value().purpose,
              PalettePurpose::objects);
    EXPECT_EQ(error_of("purpose = 'fun'\n" + with("sequential", "K", stops)),
              "p.toml:1: 'purpose' must be one of: terrain, data, objects");
    EXPECT_NE(error_of(with("sequential", "K", stop("-1") + stop("2"))), "") << "below absolute zero";
}

std::string nominal(const std::string& classes) { return "name = 'x'\ntitle = 'X'\nkind = 'nominal'\n" + classes; }
std::string class_of(const std::string& name, const std::string& color) {
    return "[[class]]\nname = '" + name + "'\ncolor = '" + color + "'\n";
}

TEST(Palette, ClassesHaveNamesAndNoColorsBetweenThem) {
    const auto read = read_palette(
        nominal(class_of("forest", "#204020") + class_of("water", "#2040c0") + class_of("bare", "#e0e0e0")), "p.toml");
    ASSERT_TRUE(read.ok()) << read.error().message.view();
    const Palette& palette = read.value();
    EXPECT_TRUE(palette.is_nominal());
    EXPECT_EQ(color_of_name(palette, "water"), (Color{0x20, 0x40, 0xC0}));
    EXPECT_EQ(color_of_name(palette, "Water").alpha, 0) << "another name";
    EXPECT_EQ(color_of_name(palette, "").alpha, 0);
    for (const double value : {0.51, 1.0, 1.49}) EXPECT_EQ(color_of_value(palette, value), (Color{0x20, 0x40, 0xC0})) << value;
    EXPECT_EQ(color_of_value(palette, -5), palette.stops[0].color);
    EXPECT_EQ(color_of_value(palette, 1e300), palette.stops[2].color);
    EXPECT_EQ(color_of_name(alpine_palette(), "forest").alpha, 0) << "heights have no names";
}

TEST(Palette, FaultsOfClassesAreSaid) {
    const std::string two = class_of("a", "#000000") + class_of("b", "#ffffff");
    EXPECT_EQ(error_of(nominal(two)), "");
    EXPECT_NE(error_of(nominal(class_of("a", "#000000"))).find("needs at least two classes"), std::string::npos);
    EXPECT_NE(error_of(nominal(two + class_of("a", "#808080"))).find("is that of another class"), std::string::npos);
    EXPECT_NE(error_of(nominal(two + class_of(std::string(24, 'x'), "#808080"))).find("1 to 23 characters"), std::string::npos);
    EXPECT_NE(error_of(nominal(two + class_of("c", "#80808080"))).find("must be opaque"), std::string::npos);
    EXPECT_NE(error_of(nominal(stop("0") + stop("1"))), "") << "stops are of other kinds";
    EXPECT_NE(error_of(with("sequential", "1", two)), "") << "and classes of this one";
    std::string many;
    for (int n = 0; n < 17; ++n) many += class_of("c" + std::to_string(n), "#808080");
    EXPECT_NE(error_of(nominal(many)).find("one class too many"), std::string::npos);
}

TEST(Palette, EveryFaultNamesItsLine) {
    const std::string two = stop("0") + stop("1");
    const std::pair<std::string, const char*> faults[] = {
        {with("hypsometric", "m", stop("5") + stop("5")), "p.toml:10: 'value' must lie above"},
        {with("hypsometric", "m", stop("0")), "p.toml:3: 'kind' needs at least two"},
        {with("hypsometric", "deg", two), "p.toml:4: 'unit' of a hypsometric palette must be \"m\""},
        {with("diverging", "m", two), "p.toml:3: 'kind' \"diverging\" needs a middle"},
        {with("rainbow", "m", two), "p.toml:3: 'kind' must be one of: hypsometric, sequential, diverging"},
        {with("hypsometric", "ft", two), "p.toml:4: 'unit' must be one of: m, deg, 1, m/s, dBZ, K"},
        {with("hypsometric", "m", stop("0") + stop("1", "red")), "p.toml:11: 'color' is no colour"},
        {with("hypsometric", "m", stop("0") + stop("1", "#00000080")), "p.toml:11: 'color' must be opaque"},
        {with("hypsometric", "m", stop("0") + stop("10000")), "p.toml:10: 'value'"},
        {with("hypsometric", "m", stop("0") + stop("nan")), "p.toml:10: "},
        {with("hypsometric", "m", two + "width = 1\n"), "p.toml:12: unknown key"},
        {"name = 'x'\ntitle = 'low'\n", "p.toml:2: 'title' must be"},
        {"name = 'x'\ntitle = 'TWELVE CHARS'\n", "p.toml:2: 'title' must be"},
        {"name = ''\n", "p.toml:1: 'name'"},
        {"", "name"},
    };
    for (const auto& [text, expected] : faults)
        EXPECT_NE(error_of(text).find(expected), std::string::npos) << text << "\n-> " << error_of(text);
    for (const char* key : {"kind", "unit", "order"}) {
        std::string text = with("hypsometric", "m", two);
        const std::size_t line = text.find("\n" + std::string(key) + " = ") + 1;
        text.erase(line, text.find('\n', line) + 1 - line);
        EXPECT_NE(error_of(text).find("'" + std::string(key) + "'"), std::string::npos) << "must be stated: " << error_of(text);
    }
    std::string many;
    for (int i = 0; i < 17; ++i) many += stop(std::to_string(i));
    EXPECT_NE(error_of(with("hypsometric", "m", many)).find("at most 16"), std::string::npos);
    EXPECT_EQ(error_of(with("hypsometric", "m", two)), "") << "control";
}

TEST(Palette, HitsStopsInterpolatesBetweenAndHoldsBeyond) {
    Palette palette;
    ASSERT_TRUE(palette.stops.try_push_back({0, {0, 0, 0}}));
    ASSERT_TRUE(palette.stops.try_push_back({100, {200, 100, 0}}));
    ASSERT_TRUE(palette.stops.try_push_back({300, {0, 100, 50}}));
    EXPECT_EQ(color_of_value(palette, -1000), (Color{0, 0, 0}));
    EXPECT_EQ(color_of_value(palette, 100), (Color{200, 100, 0}));
    EXPECT_EQ(color_of_value(palette, 50), (Color{100, 50, 0}));
    EXPECT_EQ(color_of_value(palette, 200), (Color{100, 100, 25}));
    EXPECT_EQ(color_of_value(palette, 9000), (Color{0, 100, 50}));
}

TEST(Palette, NamesWithADotOrASlashArePaths) {
    EXPECT_TRUE(is_short_name("alpine"));
    EXPECT_TRUE(is_short_name("muted_relief"));
    EXPECT_FALSE(is_short_name("alpine.toml"));
    EXPECT_FALSE(is_short_name("mine/alpine"));
}

}  // namespace
}  // namespace tedavis::design::test_palette
