/// How the terrain looks: texture, shade and sketch, each by exchangeable techniques that can be combined freely.
///
/// Plain data in SI and radians, read from the sections [terrain.texture], [terrain.shade], [terrain.sketch] of a design.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/time.hpp"
#include "render_core/base/units.hpp"
#include "render_core/design/color.hpp"

namespace tedavis::design {

/// What gives the ground its colour. Warning colours, sea and void lie over all of them.
enum class TerrainTexture : std::uint8_t {
    plain,         ///< one colour
    hypsometric,   ///< the palette over the height above MSL
    slope,         ///< the slope palette over the angle
    local_relief,  ///< the relief palette over the height above the surroundings (Hesse 2010)
    openness,      ///< the openness palette over positive openness (Doneus 2013)
    image,         ///< the drape baked into the database; plain where it has none. On slopes it does not stretch: terrain.frag
    material,      ///< rock, scree, grass and snow by slope and height
};
inline constexpr std::size_t kTerrainTextures = 7;
extern const std::array<std::string_view, kTerrainTextures> kTerrainTextureNames;

/// Its colours stand for values of the palette, and need a legend.
[[nodiscard]] constexpr bool colors_by_palette(TerrainTexture texture) noexcept {
    return texture == TerrainTexture::hypsometric || texture == TerrainTexture::slope ||
           texture == TerrainTexture::local_relief || texture == TerrainTexture::openness;
}

enum class TerrainShade : std::uint8_t {
    none,
    lambert,    ///< one light (Yoeli 1967)
    lights,     ///< several lights, weighted (Hobbs 1995)
    phong,      ///< one light with a highlight (Phong 1975)
    light_map,  ///< the baked light with one diffuse bounce; its light is fixed
    aperture,   ///< ambient aperture lighting (Oat, Sander 2007)
};
inline constexpr std::size_t kTerrainShades = 6;
extern const std::array<std::string_view, kTerrainShades> kTerrainShadeNames;

struct DirectedLight {
    double azimuth_rad = base::radians(315);   ///< from which it shines, clockwise from true north
    double elevation_rad = base::radians(45);  ///< above the horizontal
    double weight = 1;
    Color color{0xFF, 0xFF, 0xFF};
};
inline constexpr std::size_t kMaxLights = 4;

struct ShadeSettings {
    TerrainShade technique = TerrainShade::lambert;
    DirectedLight lights[kMaxLights];
    std::size_t light_count = 1;
    double ambient = 0.35;  ///< 0..1 of full light that reaches slopes in the shade
    Color ambient_color{0xFF, 0xFF, 0xFF};
    bool baked_normals = false;  ///< a pixel's normals come from the attribute pages, as with shadows; else from the mesh
    bool follows_sun = false;    ///< the first light is the sun of date, time and place; as stated where there is none
    bool sun_is_fixed = false;   ///< at `sun_utc` instead of the time of the source
    base::Time sun_utc;
    bool cast_shadows = false;     ///< of the first light, from the baked horizons
    double ambient_occlusion = 0;  ///< 0..1: how much the baked sky view darkens
    double openness = 0;           ///< 0..1: how much baked positive openness darkens
    double highlight = 0.25;       ///< 0..1 of full light that phong adds
    double highlight_exponent = 24;
};

struct SketchSettings {
    Color line{0x20, 0x20, 0x20};
    double silhouettes = 0;          ///< strengths are 0..1; 0 switches off
    double ridges = 0, valleys = 0;  ///< lines where the baked curvature is large
    double suggestive_contours = 0;  ///< DeCarlo et al. 2003
    double contours = 0;             ///< lines of equal height
    double contour_interval_m = 100;
    std::uint32_t contour_index = 5;  ///< every so many contours one is stronger
    bool illuminated = false;         ///< contours light towards the light, dark away from it (Tanaka 1950)
    double hatching = 0;              ///< strokes down the slope, denser in the shade
    double stippling = 0;             ///< dots, larger in the shade
    double stroke_spacing_px = 7;     ///< of hatches and stipples on the screen, up to a factor of two
};

/// Lines of known spacing along meridians and parallels over the ground: a depth cue. To the north they stand exactly so far
/// apart; to the east so at the middle latitude of the terrain, elsewhere by the ratio of the latitudes' cosines. Data that ask
/// for it have the same lines, and lines of equal height above MSL besides.
struct GridSettings {
    double spacing_m = 0;  ///< 0: none
    Color line{0, 0, 0};
    double strength = 0.65;       ///< 0..1
    double height_spacing_m = 0;  ///< on data; 0: no lines of equal height
};

struct TerrainStyle {
    TerrainTexture texture = TerrainTexture::hypsometric;
    Color plain{0xD8, 0xD2, 0xC4};
    ShadeSettings shade;
    SketchSettings sketch;
    GridSettings grid;
};
static_assert(std::is_trivially_copyable_v<TerrainStyle>);

/// Some light that the shade uses is not white, so that lit ground changes its hue. The baked light map has no colours.
[[nodiscard]] bool has_colored_light(const ShadeSettings& shade) noexcept;

/// All that a pixel shows follows from its height, one number of light, its class and its distance.
[[nodiscard]] bool fits_pixel_code(const TerrainStyle& style) noexcept;

/// Any line, hatch or dot at all.
[[nodiscard]] bool has_lines(const SketchSettings& sketch) noexcept;

/// 0..1: how much of the ground's form is told: 1 by shading, a half by lines alone, a quarter by colours alone.
[[nodiscard]] double detail_of(const TerrainStyle& style) noexcept;

/// Baked maps that a style reads.
enum class BakedMap : std::uint8_t { form, light, aperture, horizon, drape };
inline constexpr std::size_t kBakedMaps = 5;
[[nodiscard]] bool needs_map(const TerrainStyle& style, BakedMap map) noexcept;

/// Maps that one style needs, or several together.
class MapSet {
public:
    MapSet() = default;
    MapSet(const TerrainStyle& style) noexcept { add(style); }  // NOLINT(google-explicit-constructor): one style's maps are a set
    void add(const TerrainStyle& style) noexcept;
    [[nodiscard]] bool has(BakedMap map) const noexcept { return maps_[static_cast<std::size_t>(map)]; }
    [[nodiscard]] bool any() const noexcept;

private:
    bool maps_[kBakedMaps]{};
};

/// True when two styles need the same shader programs and maps, so that one can follow the other while running.
[[nodiscard]] bool same_programs(const TerrainStyle& a, const TerrainStyle& b) noexcept;

/// `terrain` is the section that holds the three; absent keys keep what `style` has.
void read_terrain_style(base::ConfigSection& terrain, TerrainStyle& style);

}  // namespace tedavis::design
