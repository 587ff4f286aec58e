/// The shader program of one terrain style, for chunks with or without attribute pages and for a number of warning bands, or
/// the one that writes codes.
///
/// The image has pages of its own: chunks without one read a transparent place.
/// A technique that the style does not ask for is not compiled. Without pages the vertex normal shades, and what only a page
/// knows is left out (catalogue of replacements: README of this folder).
/// Memory  none of ours. Thread  the GL thread. Failure  one sentence.
#pragma once

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/span.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/draw/air_table.hpp"
#include "render_core/draw/focus_ground.hpp"
#include "render_core/draw/magnified_uniforms.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/draw/shadow_map.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

enum TerrainAttribute : GLuint { kTerrainPosition, kTerrainHeight, kTerrainNormal, kTerrainKind, kTerrainPlace };
inline constexpr GLuint kTerrainAttributes = 5;

/// Indices in the program's list of uniforms; a uniform that the style does not use has location -1.
enum TerrainUniform : std::size_t {
    kChunkOffset,
    kViewProjection,
    kToLocal,
    kHazePerM,
    kLift,
    kPlaceEnd,
    kEarthCentre,
    kFlatHeight,
    kPageWindow,
    kStrokeWindow,
    kFormMap,
    kLightMap,
    kApertureMap,
    kHorizonMap,
    kPageOrigin,
    kPageScale,
    kDrapeMap,
    kDrapeWindow,
    kDrapeOrigin,
    kPalette,
    kPaletteRange,
    kPlainColor,
    kSeaColor,
    kUnknownColor,
    kHazeColor,
    kPixel,
    kGridWindow,
    kGridLook,
    kGridSpacing,
    kLights,
    kLight,
    kLightColor,
    kAmbientColor,
    kOcclusion,
    kLineColor,
    kFormLines,
    kContour,
    kStrokes,
    kPageTexel,
    kCoastSharp,
    kBandColor,
    kBandLower,
    kHeightRange,
    kDataMap,
    kDataColors,
    kDataSize,
    kDataScale,
    kDataBreaks,
    kDataLook,
    kDataWindow,
    kDataOverlay,
    kDataOverlayColor,
    kDataLowest,
    kTerrainAir,                                  ///< the first of kAirUniformNames
    kTerrainShadow = kTerrainAir + kAirUniforms,  ///< the first of kShadowUniformNames
    kTerrainLeft = kTerrainShadow + kShadowUniforms,
    kTerrainFocus,                                       ///< the first of kFocusUniformNames
    kTerrainMagnifier = kTerrainFocus + kFocusUniforms,  ///< the first of kMagnifierUniformNames
    kTerrainUniforms = kTerrainMagnifier + kMagnifierUniforms
};

/// What a terrain program writes. All except `color` are drawn off-screen, for the picture pass.
enum class TerrainOutput : std::uint8_t {
    color,               ///< the picture
    color_and_distance,  ///< the distance in alpha: silhouettes are found in it; with blur round a focus how sharp it is
    code,                ///< heights, light and distance of terrain_code.frag
};
/// A design, and what terrain programs write for it.
struct DrawnDesign {
    const design::DesignSettings* design = nullptr;
    TerrainOutput output = TerrainOutput::color;
    bool has_focus = false;  ///< foci are drawn: one is in effect and changes the ground
};
using DrawnDesigns = base::Span<const DrawnDesign>;

/// True where the distances in the picture are only used for volumetric light. Warning colours are then written as near, so that
/// no shaft darkens them, and the picture needs no separate pass before the others.
[[nodiscard]] bool has_shafts_only(const design::DesignSettings& design) noexcept;
/// True where there is blur round a focus; degrees of focus are then written instead of distances.
[[nodiscard]] bool blurs_context(const DrawnDesign& design) noexcept;
/// Returns the cheapest output that shows the style and the data on a device with or without off-screen depth; `focus` is the
/// variant of foci that is drawn.
[[nodiscard]] TerrainOutput output_of(const design::DesignSettings& design, bool off_screen_depth,
                                      const GroundFocusKind& focus = {}) noexcept;
/// With that output. `has_focus`: whether foci are to be drawn, where the design has any that change the ground.
[[nodiscard]] DrawnDesign drawn_as(const design::DesignSettings& design, bool off_screen_depth, bool has_focus) noexcept;

struct TerrainVariant {
    std::size_t bands = 0;  ///< number of warning bands that it distinguishes
    bool baked = false;     ///< the chunk has attribute pages
    bool coast = false;     ///< the chunk has sea and land; what a pixel is comes from its pages
    bool classes = true;    ///< the chunk has sea or void; codes of land alone are written faster
    bool lifted = false;    ///< never below the true terrain
    bool flat = false;      ///< all at one height
    TerrainOutput output = TerrainOutput::color;
    bool ground_data = false;                                                       ///< a field of the scene colours the ground
    design::IntrinsicUncertainty uncertainty = design::IntrinsicUncertainty::none;  ///< of that field
    design::UncertaintyOverlay overlay = design::UncertaintyOverlay::none;          ///< on it
    bool air = false;                                                               ///< between it and the eye
    bool shafts = false;                                                            ///< of light, before it
    bool shadows = false;                                                           ///< of data
    GroundFocusKind focus;                                                          ///< that the design has
    bool in_focus = true;                                                           ///< the chunk is, as a whole
    bool magnified = false;                                                         ///< a part of what magnifiers move
    bool maps[design::kBakedMaps]{};  ///< those that the database and the device have

    /// But for the focus.
    friend bool operator==(const TerrainVariant& a, const TerrainVariant& b) noexcept;
};

inline constexpr std::size_t kMaxTerrainDefines = 1023;
using TerrainDefines = base::FixedString<kMaxTerrainDefines>;
/// The techniques of a style as preprocessor lines.
[[nodiscard]] TerrainDefines terrain_defines(const design::TerrainStyle& style, const TerrainVariant& variant);

[[nodiscard]] base::Result<gl::Program, base::Error> build_terrain_program(gl::Gl& gl, const design::TerrainStyle& style,
                                                                           const TerrainVariant& variant);

/// Returns the number of bands in the smallest program that distinguishes `bands` bands.
inline constexpr std::size_t kBandVariants = 3;
inline constexpr std::size_t kBandsOfVariant[kBandVariants] = {0, 2, design::kMaxWarningBands};
[[nodiscard]] constexpr std::size_t band_variant(std::size_t bands) noexcept { return bands == 0 ? 0 : bands <= 2 ? 1 : 2; }

/// Distance and number of octaves of the code in alpha.
inline constexpr double kDistanceCodeStart_m = 50, kDistanceCodeOctaves = 13;

}  // namespace tedavis::draw
