/// The style of the terrain: texture, shade and sketch, each by exchangeable techniques that can be combined freely.
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

/// The source of the ground's colour. Warning colours, sea and void override it.
enum class TerrainTexture : std::uint8_t {
    plain,         ///< one colour
    hypsometric,   ///< the palette over the height above MSL
    slope,         ///< the slope palette over the slope angle
    local_relief,  ///< the relief palette over the height above the surroundings (Hesse 2010)
    openness,      ///< the openness palette over positive openness (Doneus 2013)
    image,         ///< the drape stored in the database; plain where it has none. It is not stretched on slopes (terrain.frag)
    material,      ///< natural ground: the palette over the height, woods on slopes, rock where it is steep, and a grain
};
inline constexpr std::size_t kTerrainTextures = 7;
extern const std::array<std::string_view, kTerrainTextures> kTerrainTextureNames;

/// True where colours stand for values of the palette, so that a legend is needed.
[[nodiscard]] constexpr bool colors_by_palette(TerrainTexture texture) noexcept {
    return texture == TerrainTexture::hypsometric || texture == TerrainTexture::slope ||
           texture == TerrainTexture::local_relief || texture == TerrainTexture::openness;
}

enum class TerrainShade : std::uint8_t {
    none,
    lambert,    ///< one light (Yoeli 1967)
    lights,     ///< several lights, weighted (Hobbs 1995)
    phong,      ///< one light with a highlight (Phong 1975)
    light_map,  ///< the precomputed light with one diffuse bounce, for a fixed light
    aperture,   ///< ambient aperture lighting (Oat, Sander 2007)
};
inline constexpr std::size_t kTerrainShades = 6;
extern const std::array<std::string_view, kTerrainShades> kTerrainShadeNames;

struct DirectedLight {
    double azimuth_rad = base::radians(315);   ///< direction from which it shines, clockwise from true north
    double elevation_rad = base::radians(45);  ///< above the horizontal
    double weight = 1;
    Color color{0xFF, 0xFF, 0xFF};
};
inline constexpr std::size_t kMaxLights = 4;

struct ShadeSettings {
    TerrainShade technique = TerrainShade::lambert;
    DirectedLight lights[kMaxLights];
    std::size_t light_count = 1;
    double ambient = 0.35;  ///< 0..1, share of full light on slopes in shade
    Color ambient_color{0xFF, 0xFF, 0xFF};
    bool baked_normals = false;  ///< normals per pixel from the attribute pages, as with shadows; else from the mesh
    bool follows_sun = false;    ///< the first light is the sun; as stated where it is unknown or too low
    bool sun_is_fixed = false;   ///< at `sun_utc` instead of the time of the source
    base::Time sun_utc;
    bool cast_shadows = false;     ///< by the first light, from the stored horizons
    double ambient_occlusion = 0;  ///< 0..1: darkening by the stored sky view
    double openness = 0;           ///< 0..1: darkening by the stored positive openness
    double highlight = 0.25;       ///< 0..1, share of full light that phong adds
    double highlight_exponent = 24;
};

struct SketchSettings {
    Color line{0x20, 0x20, 0x20};
    double silhouettes = 0;          ///< all strengths are 0..1; 0 means off
    double ridges = 0, valleys = 0;  ///< lines where the stored curvature is large
    double suggestive_contours = 0;  ///< DeCarlo et al. 2003
    double contours = 0;             ///< lines of equal height
    double contour_interval_m = 100;
    std::uint32_t contour_index = 5;  ///< every n-th contour is stronger
    bool illuminated = false;         ///< contours are light on slopes that face the light, else dark (Tanaka 1950)
    double hatching = 0;              ///< strokes down the slope, denser in the shade
    double stippling = 0;             ///< dots, larger in the shade
    double stroke_spacing_px = 7;     ///< spacing of hatches and stipples on the screen, within a factor of two
};

/// The surface grid: lines along meridians and parallels over the ground, a depth cue. By angle they lie at whole multiples of
/// the spacing. By length the spacing is exact to the north; to the east it is exact at the middle latitude of the terrain, and
/// elsewhere scaled by the ratio of the latitudes' cosines. Data elements with the grid also have lines of equal height above
/// MSL.
struct GridSettings {
    double spacing_m = 0;    ///< 0: none, or by angle
    double spacing_rad = 0;  ///< of latitude and longitude, from 0 N 0 E; 0: none, or by length
    Color line{0, 0, 0};
    double strength = 0.65;       ///< 0..1
    double height_spacing_m = 0;  ///< for data; 0: no lines of equal height

    [[nodiscard]] bool is_angular() const { return spacing_rad > 0; }
    [[nodiscard]] bool is_shown() const { return spacing_m > 0 || is_angular(); }
};

struct TerrainStyle {
    TerrainTexture texture = TerrainTexture::hypsometric;
    Color plain{0xD8, 0xD2, 0xC4};
    Color rock{0x8C, 0x84, 0x76};   ///< of natural ground
    Color woods{0xC2, 0xDB, 0xBA};  ///< of natural ground: shares of red, green and blue that woods leave of its tint
    double tree_line_m = 2000;      ///< of natural ground: the height above MSL where woods end
    double grain = 0.35;            ///< of natural ground, 0..1: share of its light that the grain takes and gives at most
    ShadeSettings shade;
    SketchSettings sketch;
    GridSettings grid;
};
static_assert(std::is_trivially_copyable_v<TerrainStyle>);

/// Returns the color of a wooded slope of natural ground, whose tint by height is `tint`.
[[nodiscard]] Color wooded(const TerrainStyle& style, Color tint) noexcept;

/// True where a light of the shade is not white, so that lit ground changes its hue. The stored light map has no colours.
[[nodiscard]] bool has_colored_light(const ShadeSettings& shade) noexcept;

/// True where a pixel's colour depends only on its height, one light value, its class and its distance.
[[nodiscard]] bool fits_pixel_code(const TerrainStyle& style) noexcept;

/// True where any line, hatch or dot is on.
[[nodiscard]] bool has_lines(const SketchSettings& sketch) noexcept;

/// Returns how much of the ground's form the style shows, 0..1: 1 with shading, 0.5 with lines alone, 0.25 with colours alone.
[[nodiscard]] double detail_of(const TerrainStyle& style) noexcept;

/// The stored maps that a style reads.
enum class BakedMap : std::uint8_t { form, light, aperture, horizon, drape };
inline constexpr std::size_t kBakedMaps = 5;
[[nodiscard]] bool needs_map(const TerrainStyle& style, BakedMap map) noexcept;

/// The maps that one or several styles need.
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

/// True where two styles need the same shader programs and maps, so that a running display can change between them.
[[nodiscard]] bool same_programs(const TerrainStyle& a, const TerrainStyle& b) noexcept;

/// Reads the three sections below `terrain`; absent keys leave `style` unchanged.
void read_terrain_style(base::ConfigSection& terrain, TerrainStyle& style);

}  // namespace tedavis::design
