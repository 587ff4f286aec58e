#include "render_core/design/design_settings.hpp"

#include "render_core/design/config_values.hpp"
#include "render_core/design/inherit_bases.hpp"

namespace tedavis::design {
namespace {

using base::ConfigSection;

enum class WarningProfile : std::uint8_t { egpws, garmin, custom };
constexpr std::string_view kWarningProfileNames[] = {"egpws", "garmin", "custom"};

void read_angle(ConfigSection& section, std::string_view key, double low_deg, double high_deg, double& angle_rad) {
    angle_rad = base::radians(section.number(key, low_deg, high_deg, base::degrees(angle_rad)));
}

void read_mode(ConfigSection& section, ViewSettings& view) {
    static constexpr std::string_view kModes[] = {"3d", "map"}, kProjections[] = {"perspective", "orthographic"};
    section.choose("mode", kModes, view.mode);
    bool is_parallel = false;
    section.choose("projection", kProjections, is_parallel);
    if (!is_parallel) return;
    if (view.mode == ViewMode::map)
        fault_of(section, "projection", "is of mode 3d; the map shows equal lengths alike anyway, leave it out");
    view.mode = ViewMode::orthographic;
    if (section.number("map_range_m", 500, 500'000, view.map_range_m) > kMaxOrthographicRange_m)
        fault_of(section, "map_range_m", "is at most 15000 in the orthographic view; farther away lengths would differ");
}

void read_reference(ConfigSection& section, ViewSettings& view) {
    section.choose("reference", kReferenceNames, view.reference);
    view.flat_msl_m = section.number("flat_msl_m", -500, 9000, view.flat_msl_m);
    if (view.reference == Reference::flat && view.mode == ViewMode::perspective)
        fault_of(
            section, "reference",
            "flat would be taken for the terrain in the pilot's own view; it is for mode map and for projection orthographic");
}

void read_view(ConfigSection section, ViewSettings& view) {
    read_mode(section, view);
    read_reference(section, view);
    read_angle(section, "look_down_deg", 25, 90, view.look_down_rad);
    read_angle(section, "look_turn_deg", -180, 180, view.look_turn_rad);
    section.choose("map_orientation", kMapOrientationNames, view.map_orientation);
    view.map_range_m = section.number("map_range_m", 500, 500'000, view.map_range_m);
    view.transition_s = section.number("transition_s", 0.5, 2, view.transition_s);
    read_angle(section, "horizontal_field_of_view_deg", 10, 120, view.horizontal_field_of_view_rad);
    double eye_m[3] = {view.eye_forward_m, view.eye_right_m, view.eye_down_m};
    section.numbers("eye_forward_right_down_m", -100, 100, eye_m);
    view.eye_forward_m = eye_m[0];
    view.eye_right_m = eye_m[1];
    view.eye_down_m = eye_m[2];
    view.dpi = section.number("dpi", 30, 1000, view.dpi);
}

/// What the texture colours by; a palette of something else would say nonsense.
bool palette_fits(TerrainTexture texture, const Palette& palette) {
    switch (texture) {
        case TerrainTexture::slope:
        case TerrainTexture::openness: return palette.kind != PaletteKind::hypsometric && palette.unit == PaletteUnit::degrees;
        case TerrainTexture::local_relief: return palette.kind == PaletteKind::diverging && palette.unit == PaletteUnit::metres;
        default: return palette.kind == PaletteKind::hypsometric;
    }
}

void read_texture_palette(ConfigSection& section, PaletteSource& palettes, TerrainSettings& terrain) {
    if (section.has("palette")) {
        const auto found = palettes.find(section.file("palette"));
        if (!found.ok()) return section.fault("palette", found.error().message.view());
        terrain.palette = found.value();
    }
    if (!palette_fits(terrain.style.texture, terrain.palette))
        fault_of(section, "palette",
                 "does not fit the texture: heights need a hypsometric one, slope and openness one in degrees, local_relief a "
                 "diverging one in metres");
}

void read_terrain(ConfigSection section, PaletteSource& palettes, TerrainSettings& terrain) {
    section.choose("renderer", kTerrainRendererNames, terrain.renderer);
    terrain.tau_px = section.number("tau_px", 0.1, 32, terrain.tau_px);
    terrain.conservative_up = section.boolean("conservative_up", terrain.conservative_up);
    read_color(section, "sea_color", terrain.sea);
    read_color(section, "unknown_color", terrain.unknown);
    read_terrain_style(section, terrain.style);
    read_texture_palette(section, palettes, terrain);
}

void read_sky(ConfigSection section, SkySettings& sky) {
    read_color(section, "zenith_color", sky.zenith);
    read_color(section, "horizon_color", sky.horizon);
    read_color(section, "ground_color", sky.ground);
    read_color(section, "ground_horizon_color", sky.ground_horizon);
    read_color(section, "haze_color", sky.haze);
    sky.haze_distance_m = section.number("haze_distance_m", 0, 1e6, sky.haze_distance_m);
    sky.air.is_shown = section.boolean("aerial_perspective", sky.air.is_shown);
    sky.air.visibility_m = section.number("visibility_m", 1e3, 290e3, sky.air.visibility_m);
    sky.air.horizon_brightness = section.number("horizon_brightness", 0.2, 1, sky.air.horizon_brightness);
}

WarningBand read_band(ConfigSection band) {
    WarningBand result;
    const double lower_ft = band.number("lower_ft", -20'000, 20'000);
    result.lower_m = lower_ft * base::kMetresPerFoot;
    result.lower_gear_down_m = band.number("lower_gear_down_ft", -20'000, 20'000, lower_ft) * base::kMetresPerFoot;
    result.color = required_color(band, "color");
    result.strength = band.number("strength", 0, 1);
    return result;
}

void read_custom_bands(ConfigSection& section, WarningBands& bands) {
    bands.clear();
    const std::size_t count = section.table_count("band");
    if (count == 0)
        fault_of(section, "profile", "'custom' needs at least one [[warning.band]]; add one or choose egpws or garmin");
    for (std::size_t i = 0; i < count; ++i)
        if (!bands.try_push_back(read_band(section.table_at("band", i))))
            fault_of(section, "band", "has too many entries; keep at most 8");
    const std::size_t wrong = first_band_out_of_order(bands);
    if (wrong == bands.size()) return;
    ConfigSection band = section.table_at("band", wrong);
    fault_of(band, "lower_ft", "must lie below the band before it, gear up and gear down; sort the bands from high to low");
}

void read_widening(ConfigSection section, WideningSettings& widening) {
    widening.enabled = section.boolean("enabled", widening.enabled);
    widening.coverage = section.number("coverage", 0.5, 0.9999, widening.coverage);
    widening.position_accuracy_m = section.number("position_accuracy_m", 0, 1000, widening.position_accuracy_m);
    widening.terrain_accuracy_m = section.number("terrain_accuracy_m", 0, 1000, widening.terrain_accuracy_m);
}

void read_warning(ConfigSection section, DesignSettings& design) {
    design.warning_colors = section.boolean("enabled", design.warning_colors);
    WarningProfile profile = WarningProfile::egpws;
    section.choose("profile", kWarningProfileNames, profile);
    if (profile == WarningProfile::custom)
        read_custom_bands(section, design.warning_bands);
    else
        design.warning_bands = profile == WarningProfile::egpws ? egpws_bands() : garmin_bands();
    read_widening(section.section("widening"), design.widening);
}

void read_limits(ConfigSection degradation, ConfigSection attitude, DesignSettings& design) {
    DegradationLimits& limits = design.degradation;
    limits.horizontal_accuracy_m = degradation.number("horizontal_accuracy_m", 0.1, 10'000, limits.horizontal_accuracy_m);
    limits.vertical_accuracy_m = degradation.number("vertical_accuracy_m", 0.1, 10'000, limits.vertical_accuracy_m);
    limits.terrain_error_px = degradation.number("terrain_error_px", 0.1, 1000, limits.terrain_error_px);
    limits.terrain_removed_px = degradation.number("terrain_removed_px", 1, 10'000, limits.terrain_removed_px);
    limits.show_reduced = degradation.boolean("show_reduced", limits.show_reduced);
    read_angle(attitude, "pitch_up_deg", 5, 90, design.unusual_attitude.pitch_up_rad);
    read_angle(attitude, "pitch_down_deg", 5, 90, design.unusual_attitude.pitch_down_rad);
    read_angle(attitude, "roll_deg", 15, 180, design.unusual_attitude.roll_rad);
}

void read_symbology(ConfigSection section, SymbologySettings& shown) {
    shown.attitude = section.boolean("attitude", shown.attitude);
    shown.map = section.boolean("map", shown.map);
    shown.heading = section.boolean("heading", shown.heading);
    shown.airspeed = section.boolean("airspeed", shown.airspeed);
    shown.altitude = section.boolean("altitude", shown.altitude);
    shown.vertical_speed = section.boolean("vertical_speed", shown.vertical_speed);
    shown.flight_path = section.boolean("flight_path", shown.flight_path);
    shown.baro_setting = section.boolean("baro_setting", shown.baro_setting);
    shown.ground_height = section.boolean("ground_height", shown.ground_height);
    shown.air = section.boolean("air", shown.air);
    shown.phase = section.boolean("phase", shown.phase);
    shown.legend = section.boolean("legend", shown.legend);
    static constexpr std::string_view kUnits[] = {"ft_kt", "m_kmh"};
    section.choose("units", kUnits, shown.units);
}

void refuse_grid_without_spacing(ConfigSection data, const DesignSettings& design) {
    if (design.terrain.style.grid.is_shown()) return;
    for (std::size_t n = 0; n < design.data.elements.size(); ++n) {
        if (!design.data.elements[n].grid) continue;
        ConfigSection element = data.table_at("element", n);
        return fault_of(element, "grid", "asks for the surface grid, and there is none; add [terrain.grid], or leave it out");
    }
}

}  // namespace

bool has_grid_on_data(const DesignSettings& design) noexcept {
    return design.terrain.style.grid.is_shown() && asks_for_grid(design.data.elements);
}

bool magnifies(const DesignSettings& design) noexcept {
    if (design.view.mode == ViewMode::perspective) return false;
    for (const FocusSettings& focus : design.foci)
        if (focus.power > 0) return true;
    return false;
}

DesignSettings default_design_settings() noexcept {
    DesignSettings design;
    design.name = "default";
    design.terrain.palette = alpine_palette();
    design.warning_bands = egpws_bands();
    return design;
}

base::Result<DesignSettings, base::Error> read_design_settings(std::string_view text, std::string_view file_name,
                                                               DesignSource& files, NamedPhases* phases) {
    base::ConfigReader reader(text, file_name);
    return read_design_settings(reader, files, phases);
}

base::Result<DesignSettings, base::Error> read_design_settings(base::ConfigReader& reader, DesignSource& files,
                                                               NamedPhases* phases) {
    ConfigSection root = reader.root();
    DesignSettings design = default_design_settings();
    const std::string_view name = root.text("name");
    design.name = name;
    if (design.name.empty() || design.name.cut()) fault_of(root, "name", "must be 1 to 47 characters long");
    inherit_bases(reader, files);
    read_view(root.section("view"), design.view);
    read_terrain(root.section("terrain"), files, design.terrain);
    if (design.terrain.conservative_up && design.view.reference == Reference::flat) {
        ConfigSection terrain = root.section("terrain");
        fault_of(terrain, "conservative_up", "has no meaning where the ground is drawn flat; leave it out");
    }
    read_data_style(root.section("data"), files, design.data);
    refuse_grid_without_spacing(root.section("data"), design);
    read_label_settings(root.section("labels"), design.labels);
    read_priority(root.section("priority"), design.priority);
    read_foci(root, design.foci);
    read_sky(root.section("sky"), design.sky);
    read_view_effects(root.section("effects"), design.effects);
    read_warning(root.section("warning"), design);
    read_limits(root.section("degradation"), root.section("unusual_attitude"), design);
    ConfigSection symbology = root.section("symbology");
    read_symbology(symbology, design.symbology);
    NamedPhases named;
    read_named_phases(root.section("phases"), named);
    if (design.data.ground.members == GroundMembers::animated && !design.symbology.legend)
        fault_of(symbology, "legend", "must stay where members are animated: it names the one that is shown");
    if (!reader.finish()) return base::fail(reader.error());
    if (phases != nullptr) *phases = named;
    return design;
}

}  // namespace tedavis::design
