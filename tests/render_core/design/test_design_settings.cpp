#include "render_core/design/design_settings.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::design::test_design_settings {
namespace {

/// One palette of heights and one of slopes.
class SeededPalettes final : public DesignSource {
public:
    base::Result<Palette, base::Error> find(const base::StatedFile& stated) override {
        const std::string_view name = stated.name;
        Palette palette = alpine_palette();
        if (name != "seeded" && name != "slopes") return base::fail(base::Error{"no palette is called so"});
        palette.name = name;
        palette.kind = name == "slopes" ? PaletteKind::sequential : PaletteKind::hypsometric;
        return palette;
    }
    base::Result<DesignText, base::Error> find_design(const base::StatedFile& /*design*/) override {
        return base::fail(base::Error{"no design is called so"});
    }
};

base::Result<DesignSettings, base::Error> read_seeded(const std::string& text) {
    SeededPalettes palettes;
    return read_design_settings(text, "d.toml", palettes);
}

std::string file_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string error_of(const std::string& text) {
    const auto design = read_seeded(text);
    return design.ok() ? "" : std::string(design.error().message.view());
}

TEST(DesignSettings, EveryShippedDesignLoadsUnderItsFileName) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test_support::source_dir() + "/configs/designs")) {
        if (entry.path().extension() != ".toml") continue;
        test_support::ShippedFiles named;
        const std::string path = entry.path().lexically_relative(test_support::source_dir()).string();
        const auto design = read_design_settings(file_text(entry.path()), path, named);
        ASSERT_TRUE(design.ok()) << design.error().message.view();
        EXPECT_EQ(design.value().name.view(), entry.path().stem().string());
        EXPECT_EQ(first_band_out_of_order(design.value().warning_bands), design.value().warning_bands.size());
        ++files;
    }
    EXPECT_GE(files, 40u);
}

TEST(DesignSettings, TheDefaultFileStatesTheBuiltInValuesBesidesTheShippedLook) {
    const DesignSettings file = test_support::shipped_design("default");
    const DesignSettings built_in = default_design_settings();
    EXPECT_DOUBLE_EQ(file.view.horizontal_field_of_view_rad, built_in.view.horizontal_field_of_view_rad);
    EXPECT_EQ(file.view.mode, built_in.view.mode);
    EXPECT_EQ(file.view.map_orientation, built_in.view.map_orientation);
    EXPECT_EQ(file.view.map_range_m, built_in.view.map_range_m);
    EXPECT_EQ(file.view.transition_s, built_in.view.transition_s);
    EXPECT_EQ(file.symbology.map, built_in.symbology.map);
    EXPECT_EQ(file.terrain.tau_px, built_in.terrain.tau_px);
    EXPECT_EQ(file.terrain.unknown, built_in.terrain.unknown);
    EXPECT_EQ(file.sky.zenith, built_in.sky.zenith);
    EXPECT_EQ(file.sky.ground_horizon, built_in.sky.ground_horizon);
    EXPECT_EQ(file.sky.haze_distance_m, built_in.sky.haze_distance_m);
    EXPECT_EQ(file.degradation.vertical_accuracy_m, built_in.degradation.vertical_accuracy_m);
    EXPECT_EQ(file.degradation.terrain_error_px, built_in.degradation.terrain_error_px);
    EXPECT_EQ(file.degradation.terrain_removed_px, built_in.degradation.terrain_removed_px);
    EXPECT_EQ(file.degradation.show_reduced, built_in.degradation.show_reduced);
    EXPECT_EQ(file.widening.enabled, built_in.widening.enabled);
    EXPECT_EQ(file.widening.coverage, built_in.widening.coverage);
    EXPECT_EQ(file.widening.position_accuracy_m, built_in.widening.position_accuracy_m);
    EXPECT_EQ(file.widening.terrain_accuracy_m, built_in.widening.terrain_accuracy_m);
    EXPECT_EQ(file.terrain.palette.name.view(), "natural") << "the shipped look, not the plainest one";
    EXPECT_EQ(file.symbology.air, built_in.symbology.air);
    EXPECT_EQ(file.symbology.legend, built_in.symbology.legend);
    EXPECT_EQ(file.symbology.units, built_in.symbology.units);
}

TEST(DesignSettings, ConvertsUnits) {
    const auto read = read_seeded(
        "name = 'x'\n[view]\nhorizontal_field_of_view_deg = 90\neye_forward_right_down_m = [1.5, -0.25, -2]\n"
        "[warning]\nprofile = 'custom'\n[[warning.band]]\nlower_ft = 100\ncolor = '#ff0000'\nstrength = 0.5\n"
        "[[warning.band]]\nlower_ft = -1000\nlower_gear_down_ft = -500\ncolor = '#00ff00'\nstrength = "
        "1\n[symbology]\nunits = 'm_kmh'\n");
    ASSERT_TRUE(read.ok()) << read.error().message.view();
    EXPECT_NEAR(read.value().view.horizontal_field_of_view_rad, 1.5707963267948966, 1e-15);
    EXPECT_EQ(read.value().view.eye_down_m, -2);
    EXPECT_EQ(read.value().symbology.units, base::DisplayUnits::metric);
    ASSERT_EQ(read.value().warning_bands.size(), 2u);
    EXPECT_NEAR(read.value().warning_bands[0].lower_m, 30.48, 1e-12);
    EXPECT_NEAR(read.value().warning_bands[0].lower_gear_down_m, 30.48, 1e-12);
    EXPECT_NEAR(read.value().warning_bands[1].lower_gear_down_m, -152.4, 1e-12);
}

TEST(DesignSettings, ReadsTheMap) {
    const auto read = read_seeded(
        "name = 'x'\n[view]\nmode = 'map'\nmap_orientation = 'track_up'\nmap_range_m = 500\ntransition_s = 2\n"
        "[symbology]\nmap = false\n");
    ASSERT_TRUE(read.ok()) << read.error().message.view();
    EXPECT_EQ(read.value().view.mode, ViewMode::map);
    EXPECT_EQ(read.value().view.map_orientation, MapOrientation::track_up);
    EXPECT_EQ(read.value().view.map_range_m, 500);
    EXPECT_EQ(read.value().view.transition_s, 2);
    EXPECT_FALSE(read.value().symbology.map);
}

TEST(DesignSettings, ReadsTheOrthographicViewAndTheFlatGround) {
    const auto read = read_seeded(
        "name = 'x'\n[view]\nprojection = 'orthographic'\nmap_range_m = 15000\nlook_down_deg = 25\nlook_turn_deg = -90\n"
        "reference = 'flat'\nflat_msl_m = 450\n");
    ASSERT_TRUE(read.ok()) << read.error().message.view();
    const ViewSettings& view = read.value().view;
    EXPECT_EQ(view.mode, ViewMode::orthographic);
    EXPECT_NEAR(view.look_down_rad, base::radians(25), 1e-12);
    EXPECT_NEAR(view.look_turn_rad, base::radians(-90), 1e-12);
    EXPECT_EQ(view.reference, Reference::flat);
    EXPECT_EQ(view.flat_msl_m, 450);
    EXPECT_TRUE(read_seeded("name = 'x'\n[view]\nmode = 'map'\nreference = 'flat'\n").ok());
    const auto plain = read_seeded("name = 'x'\n[view]\nprojection = 'perspective'\n");
    ASSERT_TRUE(plain.ok());
    EXPECT_EQ(plain.value().view.mode, ViewMode::perspective);
    EXPECT_EQ(plain.value().view.reference, Reference::terrain);
}

TEST(DesignSettings, TerrainIsOfTrianglesUnlessRaysAreAskedFor) {
    const auto triangles = read_seeded("name = 'x'\n"), rays = read_seeded("name = 'x'\n[terrain]\nrenderer = 'trace'\n"),
               either = read_seeded("name = 'x'\n[terrain]\nrenderer = 'auto'\n");
    ASSERT_TRUE(triangles.ok() && rays.ok() && either.ok());
    EXPECT_EQ(triangles.value().terrain.renderer, TerrainRenderer::raster);
    EXPECT_EQ(rays.value().terrain.renderer, TerrainRenderer::trace);
    EXPECT_EQ(either.value().terrain.renderer, TerrainRenderer::automatic);
    EXPECT_TRUE(may_trace(rays.value().terrain) && may_trace(either.value().terrain));
    EXPECT_FALSE(may_trace(triangles.value().terrain));
}

TEST(DesignSettings, EveryFaultNamesItsLine) {
    const std::pair<const char*, const char*> faults[] = {
        {"name = 'x'\n[view]\nreference = 'flat'\n", "d.toml:3: 'reference' flat would be taken for the terrain"},
        {"name = 'x'\n[view]\nmode = 'map'\nprojection = 'orthographic'\n", "d.toml:4: 'projection' is of mode 3d"},
        {"name = 'x'\n[view]\nprojection = 'orthographic'\nmap_range_m = 15001\n", "d.toml:4: 'map_range_m' is at most 15000"},
        {"name = 'x'\n[view]\nlook_down_deg = 24\n", "d.toml:3: 'look_down_deg'"},
        {"name = 'x'\n[view]\nmode = 'map'\nreference = 'flat'\n[terrain]\nconservative_up = true\n",
         "d.toml:6: 'conservative_up' has no meaning"},
        {"name = 'x'\n[view]\nhorizontal_field_of_view_deg = 200\n", "d.toml:3: 'horizontal_field_of_view_deg'"},
        {"name = 'x'\n[view]\nhorizontal_field_of_view_deg = nan\n", "d.toml:3: "},
        {"name = 'x'\n[terrain]\ntau_px = 1\nrenderer = 'rays'\n", "d.toml:4: 'renderer' must be one of: raster, trace, auto"},
        {"name = 'x'\n[view]\nmode = '2d'\n", "d.toml:3: 'mode' must be one of: 3d, map"},
        {"name = 'x'\n[view]\nmap_orientation = 'up'\n", "d.toml:3: 'map_orientation' must be one of: north_up, track_up"},
        {"name = 'x'\n[view]\nmap_range_m = 499\n", "d.toml:3: 'map_range_m'"},
        {"name = 'x'\n[view]\nmap_range_m = 500001\n", "d.toml:3: 'map_range_m'"},
        {"name = 'x'\n[view]\ntransition_s = 0.4\n", "d.toml:3: 'transition_s'"},
        {"name = 'x'\n[terrain]\n\nsea_color = 'blue'\n", "d.toml:4: 'sea_color' is no colour"},
        {"name = 'x'\n[terrain]\ntau = 2\n", "d.toml:3: unknown key 'terrain.tau'"},
        {"name = 'x'\n[warning]\nprofile = 'radar'\n", "d.toml:3: 'profile' must be one of: egpws, garmin, custom"},
        {"name = 'x'\n[warning]\nprofile = 'custom'\n", "d.toml:3: 'profile' 'custom' needs"},
        {"name = 'x'\n[terrain]\npalette = 7\n", "d.toml:3: "},
        {"name = 'x'\n[data.ground]\nlayer = 'a'\nattribute = 'b'\npalette = 'slopes'\nmembers = 'animated'\n[symbology]\nlegend "
         "= false\n",
         "d.toml:8: 'legend' must stay where members are animated: it names the one that is shown"},
        {"name = 'x'\n[symbology]\nunits = 'yd'\n", "d.toml:3: 'units' must be one of: ft_kt, m_kmh"},
        {"name = 'x'\n[warning]\nprofile = 'custom'\n[[warning.band]]\nlower_ft = 0\ncolor = '#000000'\nstrength = 1\n"
         "[[warning.band]]\nlower_ft = 10\ncolor = '#000000'\nstrength = 1\n",
         "d.toml:9: 'lower_ft' must lie below"},
        {"name = 'x'\n[symbology]\nphase = 1\n", "d.toml:3: 'phase' must be true or false"},
        {"name = 'x'\n[warning.widening]\ncoverage = 1\n", "d.toml:3: 'coverage'"},
        {"name = ''\n", "d.toml:1: 'name'"},
        {"name = 'x'\nname = 'y'\n", "d.toml:2: "},
        {"", "name"},
    };
    for (const auto& [text, expected] : faults)
        EXPECT_NE(error_of(text).find(expected), std::string::npos) << text << "\n-> " << error_of(text);
}

TEST(DesignSettings, TooManyBandsAreRefused) {
    std::string bands = "name = 'x'\n[warning]\nprofile = 'custom'\n";
    for (int i = 0; i < 9; ++i)
        bands += "[[warning.band]]\nlower_ft = " + std::to_string(-i) + "\ncolor = '#000000'\nstrength = 0\n";
    EXPECT_NE(error_of(bands).find("at most 8"), std::string::npos);
}

TEST(DesignSettings, DataHaveNoGridWhereTheGroundHasNone) {
    const std::string elements =
        "[[data.element]]\nlayer = 'a'\n[[data.element]]\nlayer = 'b'\ntechnique = 'prism'\ngrid = true\n";
    EXPECT_NE(error_of("name = 'x'\n" + elements).find("d.toml:7: 'grid' asks for the surface grid, and there is none"),
              std::string::npos);
    const std::string whole = "name = 'x'\n[terrain.grid]\n" + elements;
    EXPECT_EQ(error_of(whole), "");
    DesignSettings design = read_seeded(whole).value();
    EXPECT_TRUE(has_grid_on_data(design));
    design.terrain.style.grid.spacing_m = 0;
    EXPECT_FALSE(has_grid_on_data(design));
    design.terrain.style.grid.spacing_m = 1000;
    for (DataElement& element : design.data.elements) element.grid = false;
    EXPECT_FALSE(has_grid_on_data(design));
}

TEST(DesignSettings, ThePaletteComesFromTheSource) {
    const std::string head = "name = 'x'\n[terrain]\n";
    SeededPalettes palettes;
    EXPECT_EQ(read_design_settings(head + "palette = 'seeded'\n", "d.toml", palettes).value().terrain.palette.name.view(),
              "seeded");
    EXPECT_EQ(read_design_settings(head, "d.toml", palettes).value().terrain.palette.name.view(), "alpine") << "names none";
    EXPECT_NE(error_of(head + "palette = 'absent'\n").find("d.toml:3: no palette is called so"), std::string::npos);
    EXPECT_NE(error_of(head + "palette = 'slopes'\n").find("d.toml:3: 'palette' does not fit the texture"), std::string::npos);
    EXPECT_NE(error_of(head + "[[terrain.palette]]\nheight_m = 0\ncolor = '#000000'\n").find("d.toml:3: "), std::string::npos)
        << "stops stand in files of their own";
}

TEST(DesignSettings, TruncatedFilesNeverLoadAsWholeWithoutTheirName) {
    const std::string whole = file_text(test_support::source_dir() + "/configs/designs/default.toml");
    const std::size_t name_end = whole.find("name = \"default\"") + 16;
    for (std::size_t length = 0; length < name_end; ++length) EXPECT_FALSE(error_of(whole.substr(0, length)).empty()) << length;
}

/// The sections of configs/designs/README.md with the rows of their tables.
struct DocumentedKey {
    std::string section, key, may_be;
};
std::vector<DocumentedKey> documented_keys() {
    std::istringstream text(file_text(test_support::source_dir() + "/configs/designs/README.md"));
    std::vector<DocumentedKey> keys;
    std::string section;
    for (std::string line; std::getline(text, line);) {
        if (line.rfind("## ", 0) == 0) section = line[3] == '`' ? line.substr(4, line.find('`', 4) - 4) : "";
        if (line.rfind("| `", 0) != 0) continue;
        const std::size_t key_end = line.find('`', 3), default_at = line.rfind(" | ", line.size() - 3);
        const std::size_t may_at = line.rfind(" | ", default_at - 1) + 3;
        keys.push_back({section, line.substr(3, key_end - 3), line.substr(may_at, default_at - may_at)});
    }
    return keys;
}

bool is_of_data_focus(const std::string& key) {
    const std::set<std::string> keys{"layer", "role", "attribute", "value", "interval", "extreme", "within", "similar"};
    return keys.count(key) > 0;
}

/// What must stand in a section so that the key is looked at, without the key itself.
std::string with_key(const DocumentedKey& documented, const std::string& value) {
    const std::string &section = documented.section, &key = documented.key;
    std::string text;
    const auto add = [&](const std::string& name, const std::string& stated) {
        if (name != key) text += name + " = " + stated + "\n";
    };
    const auto add_shown = [&](bool has_palette) {
        if (key != "role" && key != "own") add("layer", "'a'");
        if (!has_palette) return add("technique", "'tube'");
        add("attribute", "'b'");
        add("palette", "'seeded'");
    };
    if (!section.empty() || key != "name") text += "name = 'x'\n";
    if (section == "[[warning.band]]") text += "[warning]\nprofile = 'custom'\n";
    if (section.find("[focus.") == 0) text += "[[focus]]\n";
    if (section.find("data.ground.") != std::string::npos)
        text += "[data.ground]\nlayer = 'a'\nattribute = 'b'\npalette = 'seeded'\n";
    if (section.find("data.element.") != std::string::npos) text += "[[data.element]]\nlayer = 'a'\ntechnique = 'tube'\n";
    if (!section.empty()) text += section + "\n";
    if (section == "[data.ground]" || section == "[data.adjacent]") add_shown(true);
    if (section == "[[data.element]]") {
        add_shown(false);
        const bool is_second = key.rfind("second_", 0) == 0, is_first = key == "palette" || key == "classes" || key == "breaks";
        if (is_first) text += "attribute = 'b'\n";
        if (is_first) add("palette", "'seeded'");
        if (is_second) add("second_attribute", "'b'");
        if (is_second && key != "second_attribute") add("second_palette", "'seeded'");
    }
    if (section == "[[focus]]" && is_of_data_focus(key)) {
        text += "shape = 'data'\n";
        if (key != "role") add("layer", "'a'");
        add("attribute", "'b'");
        if (key == "within" || key == "similar") add("value", "1");
    }
    if (section == "[data.element.cues]" && key.rfind("line_spacing", 0) != 0) text += "line_spacing_m = 100\n";
    if (section == "[[warning.band]]")
        for (const char* name : {"lower_ft", "color", "strength"}) add(name, name[0] == 'c' ? "'#ffffff'" : "0.5");
    if (section == "[[priority.aspect]]") {
        add("name", "'a'");
        add("roles", "['road']");
        add("weight", "1");
    }
    return text + key + " = " + value + "\n";
}

TEST(DesignSettings, EveryKeyOfTheReadmeIsReadAsItSays) {
    const std::vector<DocumentedKey> keys = documented_keys();
    EXPECT_GT(keys.size(), 140u);
    for (const DocumentedKey& documented : keys) {
        // A day is nothing that any key takes; a text is told apart from a choice, a colour or an instant by another fault.
        const std::string day = error_of(with_key(documented, "1979-05-27")), text = error_of(with_key(documented, "'?'"));
        EXPECT_TRUE(day.find(documented.may_be) != std::string::npos || text.find(documented.may_be) != std::string::npos)
            << documented.section << " " << documented.key << " may be " << documented.may_be << "; the reader says: " << day
            << " / " << text;
        EXPECT_EQ(day.find("unknown key"), std::string::npos) << day;
        EXPECT_NE(day.find("'" + documented.key + "'"), std::string::npos) << day;
    }
    EXPECT_NE(error_of("name = 'x'\n[view]\nzoom = 1979-05-27\n").find("unknown key"), std::string::npos) << "a control";
}

TEST(DesignSettings, EveryKeyThatTheReaderAsksForIsInTheReadme) {
    const std::string readme = file_text(test_support::source_dir() + "/configs/designs/README.md");
    const std::regex asked(
        R"re((?:\b(?:number|numbers|integer|boolean|text|choice|has|section|table_count|table_at|element_count)\(|\b(?:read_\w+|required_color)\(\w+, |ScaleKeys\w* *\w* *\{|^\s*std::string_view \w+ = )"([a-z][a-z0-9_]*)")re");
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(test_support::source_dir() + "/render_core/design")) {
        const std::string stem = entry.path().stem().string();
        if (stem == "palette" || stem == "aircraft_settings" || stem == "symbology_palette") continue;  // files of their own
        const std::string source = file_text(entry.path());
        for (std::sregex_iterator at(source.begin(), source.end(), asked), end; at != end; ++at) found.insert((*at)[1]);
    }
    EXPECT_GT(found.size(), 100u);
    for (const std::string& key : found)
        EXPECT_TRUE(readme.find("`" + key + "`") != std::string::npos || readme.find(key + "]") != std::string::npos) << key;
}

}  // namespace
}  // namespace tedavis::design::test_design_settings
