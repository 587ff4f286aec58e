#include "render_core/design/terrain_style.hpp"

#include <cmath>

#include "render_core/base/utc_time.hpp"
#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

using base::ConfigSection;

constexpr std::string_view kNormalNames[] = {"mesh", "baked"};

double read_angle(ConfigSection& section, std::string_view key, double low_deg, double high_deg, double angle_rad) {
    return base::radians(section.number(key, low_deg, high_deg, base::degrees(angle_rad)));
}

void read_share(ConfigSection& section, std::string_view key, double& share) { share = section.number(key, 0, 1, share); }

void read_texture(ConfigSection section, TerrainStyle& style) {
    section.choose("technique", kTerrainTextureNames, style.texture);
    read_color(section, "plain_color", style.plain);
    read_color(section, "rock_color", style.rock);
    read_color(section, "woods_filter", style.woods);
    style.tree_line_m = section.number("tree_line_m", -500, 9000, style.tree_line_m);
    read_share(section, "grain", style.grain);
}

DirectedLight read_light(ConfigSection section, DirectedLight light) {
    light.azimuth_rad = read_angle(section, "azimuth_deg", 0, 360, light.azimuth_rad);
    light.elevation_rad = read_angle(section, "elevation_deg", 0, 90, light.elevation_rad);
    light.weight = section.number("weight", 0, 1, light.weight);
    read_color(section, "color", light.color);
    return light;
}

void read_lights(ConfigSection& section, ShadeSettings& shade) {
    const std::size_t count = section.table_count("light");
    if (count == 0) return;
    if (count > kMaxLights) section.fault("light", "'light' has too many entries; keep at most 4");
    shade.light_count = count < kMaxLights ? count : kMaxLights;
    for (std::size_t n = 0; n < shade.light_count; ++n) shade.lights[n] = read_light(section.table_at("light", n), {});
}

void read_sun(ConfigSection& section, ShadeSettings& shade) {
    shade.follows_sun = section.boolean("follows_sun", shade.follows_sun);
    if (shade.follows_sun && shade.technique == TerrainShade::light_map)
        fault_of(section, "follows_sun", "cannot move the baked light of light_map; choose another technique");
    if (!section.has("sun_utc")) return;
    shade.sun_is_fixed = base::parse_utc(section.text("sun_utc"), shade.sun_utc);
    if (!shade.sun_is_fixed)
        fault_of(section, "sun_utc", "is no instant of UTC between 1970 and 2199; write it as \"2026-06-01T14:00:00Z\"");
    if (!shade.follows_sun) fault_of(section, "sun_utc", "has no effect; set follows_sun = true with it");
}

void read_shade(ConfigSection section, ShadeSettings& shade) {
    section.choose("technique", kTerrainShadeNames, shade.technique);
    read_lights(section, shade);
    read_share(section, "ambient", shade.ambient);
    read_color(section, "ambient_color", shade.ambient_color);
    section.choose("normals", kNormalNames, shade.baked_normals);
    read_sun(section, shade);
    shade.cast_shadows = section.boolean("cast_shadows", shade.cast_shadows);
    read_share(section, "ambient_occlusion", shade.ambient_occlusion);
    read_share(section, "openness", shade.openness);
    read_share(section, "highlight", shade.highlight);
    shade.highlight_exponent = section.number("highlight_exponent", 1, 200, shade.highlight_exponent);
}

void read_sketch(ConfigSection section, SketchSettings& sketch) {
    read_color(section, "line_color", sketch.line);
    read_share(section, "silhouettes", sketch.silhouettes);
    read_share(section, "ridges", sketch.ridges);
    read_share(section, "valleys", sketch.valleys);
    read_share(section, "suggestive_contours", sketch.suggestive_contours);
    read_share(section, "contours", sketch.contours);
    sketch.contour_interval_m = section.number("contour_interval_m", 1, 5000, sketch.contour_interval_m);
    sketch.contour_index = static_cast<std::uint32_t>(section.integer("contour_index", 1, 100, sketch.contour_index));
    sketch.illuminated = section.boolean("illuminated", sketch.illuminated);
    read_share(section, "hatching", sketch.hatching);
    read_share(section, "stippling", sketch.stippling);
    sketch.stroke_spacing_px = section.number("stroke_spacing_px", 3, 40, sketch.stroke_spacing_px);
}

bool draws_on_ground(const SketchSettings& sketch) {
    return sketch.ridges > 0 || sketch.valleys > 0 || sketch.suggestive_contours > 0 || sketch.contours > 0 ||
           sketch.hatching > 0 || sketch.stippling > 0;
}

bool reads_form(const TerrainStyle& style) {
    const TerrainShade shade = style.shade.technique;
    return draws_on_ground(style.sketch) ||
           (shade != TerrainShade::none && (style.shade.baked_normals || style.shade.cast_shadows)) ||
           shade == TerrainShade::aperture || style.shade.ambient_occlusion > 0 || style.texture == TerrainTexture::slope ||
           style.texture == TerrainTexture::material;
}

bool reads_light(const TerrainStyle& style) {
    return style.shade.technique == TerrainShade::light_map || style.shade.openness > 0 ||
           style.texture == TerrainTexture::local_relief || style.texture == TerrainTexture::openness;
}

constexpr double kMaxHeightSpacing_m = 10'000;

/// Of a tenth, the nearest of 1, 2 and 5 of its power of ten.
double tenth_of(double spacing) {
    const double tenth = spacing / 10, power = std::pow(10, std::floor(std::log10(tenth))), first = tenth / power;
    return power * (first < 1.5 ? 1 : first < 3.5 ? 2 : first < 7.5 ? 5 : 10);
}

/// Round in feet where the spacing is in nautical miles.
double height_spacing_m(ConfigSection& section, double spacing_m) {
    if (section.has("height_spacing_ft")) return section.number("height_spacing_ft", 3, 30'000, 500) * base::kMetresPerFoot;
    const double unit_m = section.has("spacing_nm") || section.has("spacing_arcmin") ? base::kMetresPerFoot : 1;
    const double usual_m = std::fmin(unit_m * tenth_of(spacing_m / unit_m), kMaxHeightSpacing_m);
    return section.number("height_spacing_m", 1, kMaxHeightSpacing_m, usual_m);
}

void read_spacing(ConfigSection& section, GridSettings& grid) {
    constexpr std::string_view kSpacings[] = {"spacing_m", "spacing_nm", "spacing_arcmin"};
    const char* stated = nullptr;
    for (const std::string_view key : kSpacings) {
        if (!section.has(key)) continue;
        if (stated != nullptr) fault_of(section, key, "stands beside another spacing; state one of them");
        stated = key.data();
    }
    grid.spacing_m = grid.spacing_rad = 0;
    if (section.has("spacing_arcmin"))
        grid.spacing_rad = base::radians(section.number("spacing_arcmin", 0.01, 600, 1) / 60);
    else if (section.has("spacing_nm"))
        grid.spacing_m = section.number("spacing_nm", 0.01, 60, 1) * base::kMetresPerNauticalMile;
    else
        grid.spacing_m = section.number("spacing_m", 10, 100'000, 1000);
}

void read_grid(ConfigSection section, GridSettings& grid) {
    if (!section.present()) return;
    if (section.has("height_spacing_m") && section.has("height_spacing_ft"))
        fault_of(section, "height_spacing_ft", "stands beside height_spacing_m; state one of them");
    read_spacing(section, grid);
    read_color(section, "color", grid.line);
    read_share(section, "strength", grid.strength);
    if (grid.strength == 0) grid.spacing_m = grid.spacing_rad = 0;
    const double usual_m =
        grid.is_angular() ? grid.spacing_rad / base::radians(1.0 / 60) * base::kMetresPerNauticalMile : grid.spacing_m;
    grid.height_spacing_m = height_spacing_m(section, usual_m);
}

}  // namespace

const std::array<std::string_view, kTerrainTextures> kTerrainTextureNames = {"plain",    "hypsometric", "slope",   "local_relief",
                                                                             "openness", "image",       "material"};
const std::array<std::string_view, kTerrainShades> kTerrainShadeNames = {"none",  "lambert",   "lights",
                                                                         "phong", "light_map", "aperture"};

Color wooded(const TerrainStyle& style, Color tint) noexcept {
    const auto left = [](std::uint8_t level, std::uint8_t share) {
        return static_cast<std::uint8_t>(std::lround(level * share / 255.0));
    };
    return {left(tint.red, style.woods.red), left(tint.green, style.woods.green), left(tint.blue, style.woods.blue), tint.alpha};
}

bool has_colored_light(const ShadeSettings& shade) noexcept {
    if (shade.technique == TerrainShade::none || shade.technique == TerrainShade::light_map) return false;
    const Color white{0xFF, 0xFF, 0xFF};
    bool colored = shade.ambient_color != white;
    const std::size_t count = shade.technique == TerrainShade::lights ? shade.light_count : 1;
    for (std::size_t n = 0; n < count; ++n) colored = colored || shade.lights[n].color != white;
    return colored;
}

bool fits_pixel_code(const TerrainStyle& style) noexcept {
    const ShadeSettings& shade = style.shade;
    const bool one_light = shade.technique == TerrainShade::none || shade.technique == TerrainShade::lambert ||
                           shade.technique == TerrainShade::lights;
    return (style.texture == TerrainTexture::plain || style.texture == TerrainTexture::hypsometric) && one_light &&
           !(shade.baked_normals && shade.technique != TerrainShade::none) && !has_colored_light(shade) && !shade.cast_shadows &&
           shade.ambient_occlusion == 0 && shade.openness == 0 && !draws_on_ground(style.sketch) && !style.grid.is_shown();
}

bool has_lines(const SketchSettings& sketch) noexcept { return sketch.silhouettes > 0 || draws_on_ground(sketch); }

bool needs_map(const TerrainStyle& style, BakedMap map) noexcept {
    switch (map) {
        case BakedMap::form: return reads_form(style);
        case BakedMap::light: return reads_light(style);
        case BakedMap::aperture: return style.shade.technique == TerrainShade::aperture;
        case BakedMap::horizon: return style.shade.cast_shadows;
        case BakedMap::drape: return style.texture == TerrainTexture::image;
    }
    return false;
}

void MapSet::add(const TerrainStyle& style) noexcept {
    for (std::size_t map = 0; map < kBakedMaps; ++map) maps_[map] = maps_[map] || needs_map(style, static_cast<BakedMap>(map));
}

bool MapSet::any() const noexcept {
    for (const bool is_needed : maps_)
        if (is_needed) return true;
    return false;
}

double detail_of(const TerrainStyle& style) noexcept {
    const ShadeSettings& shade = style.shade;
    const bool is_flat = shade.ambient >= 1 && shade.technique != TerrainShade::light_map;
    if (shade.technique != TerrainShade::none && !is_flat) return 1;
    return has_lines(style.sketch) ? 0.5 : 0.25;
}

bool same_programs(const TerrainStyle& a, const TerrainStyle& b) noexcept {
    const auto on = [](double x, double y) { return (x > 0) == (y > 0); };
    const SketchSettings &s = a.sketch, &t = b.sketch;
    return a.texture == b.texture && a.shade.technique == b.shade.technique && a.shade.light_count == b.shade.light_count &&
           has_colored_light(a.shade) == has_colored_light(b.shade) && a.shade.cast_shadows == b.shade.cast_shadows &&
           a.shade.baked_normals == b.shade.baked_normals && on(a.shade.ambient_occlusion, b.shade.ambient_occlusion) &&
           on(a.shade.openness, b.shade.openness) && on(s.silhouettes, t.silhouettes) && on(s.ridges, t.ridges) &&
           on(s.valleys, t.valleys) && on(s.suggestive_contours, t.suggestive_contours) && on(s.contours, t.contours) &&
           s.illuminated == t.illuminated && on(s.hatching, t.hatching) && on(s.stippling, t.stippling) &&
           a.grid.is_shown() == b.grid.is_shown();
}

void read_terrain_style(ConfigSection& terrain, TerrainStyle& style) {
    read_texture(terrain.section("texture"), style);
    read_shade(terrain.section("shade"), style.shade);
    read_sketch(terrain.section("sketch"), style.sketch);
    read_grid(terrain.section("grid"), style.grid);
}

}  // namespace tedavis::design
