/// Builds the shader program that draws terrain chunks in one style, or the variant that writes codes in place of colours.
///
/// A variant is compiled for chunks with or without attribute pages and for a number of warning bands; techniques that the style
/// does not use are not compiled. For a chunk without attribute pages the vertex normal is used for shading, and techniques that
/// need a page are replaced or left out (render_core/draw/README.md). The draped image has pages of its own; a chunk
/// without such a page reads a transparent texel.
/// Memory  the program belongs to the caller; nothing else is allocated. Thread  the GL thread. Failure  one sentence.
#pragma once

#include "render_core/base/fixed_string.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/draw/drawers/air_table.hpp"
#include "render_core/draw/drawers/alert_zone_uniforms.hpp"
#include "render_core/draw/drawers/focus_ground.hpp"
#include "render_core/draw/drawers/magnified_uniforms.hpp"
#include "render_core/draw/drawers/shadow_map.hpp"
#include "render_core/draw/drawn_design.hpp"
#include "render_core/draw/shader_texts.hpp"
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
    kMissingColor,
    kNaturalRock,
    kNaturalWoods,
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
    kGeometry,
    kChunkNumber,
    kRayAxes,
    kTerrainAir,                                  ///< the first of kAirUniformNames
    kTerrainShadow = kTerrainAir + kAirUniforms,  ///< the first of kShadowUniformNames
    kTerrainLeft = kTerrainShadow + kShadowUniforms,
    kTerrainFocus,                                           ///< the first of kFocusUniformNames
    kTerrainMagnifier = kTerrainFocus + kFocusUniforms,      ///< the first of kMagnifierUniformNames
    kTerrainAlert = kTerrainMagnifier + kMagnifierUniforms,  ///< the first of kAlertUniformNames
    kTerrainUniforms = kTerrainAlert + kAlertUniforms
};

/// The properties of a chunk and a frame for which a program is compiled.
struct TerrainVariant {
    std::size_t bands =
        0;  ///< number of warning bands that it distinguishes; above 0 also the zone of an alert (with codes only the zone)
    bool baked = false;   ///< the chunk has attribute pages
    bool coast = false;   ///< the chunk has sea and land; what a pixel is comes from its pages
    bool classes = true;  ///< the chunk has sea or void; the code of a chunk that is all land is written faster
    bool lifted = false;  ///< vertices are raised so that the surface is never below the true terrain
    bool flat = false;    ///< the surface is a plane at one height
    TerrainOutput output = TerrainOutput::color;
    bool deferred = false;     ///< it shades the pixels of a chunk from a geometry picture, instead of the chunk's triangles
    bool ground_data = false;  ///< a field of the scene colours the ground
    design::IntrinsicUncertainty uncertainty =
        design::IntrinsicUncertainty::none;                                 ///< how the field's uncertainty changes its colour
    design::UncertaintyOverlay overlay = design::UncertaintyOverlay::none;  ///< what is drawn over the field for its uncertainty
    bool air = false;                 ///< the light of the air between ground and eye point is drawn
    bool fine_distance = false;       ///< the picture pass draws it: distances have the steps of fine_distance.frag
    bool shafts = false;              ///< shadows of data in the air are drawn
    bool shadows = false;             ///< data cast shadows on the ground
    GroundFocusKind focus;            ///< how the design's foci change the ground
    bool in_focus = true;             ///< the whole chunk is in focus
    bool magnified = false;           ///< magnifiers displace a part of the chunk
    bool maps[design::kBakedMaps]{};  ///< baked maps that both the database and the device have

    /// Compares everything except `focus`.
    friend bool operator==(const TerrainVariant& a, const TerrainVariant& b) noexcept;
};

inline constexpr std::size_t kMaxTerrainDefines = 1023;
using TerrainDefines = base::FixedString<kMaxTerrainDefines>;
/// Returns preprocessor lines that select the techniques of a style.
[[nodiscard]] TerrainDefines terrain_defines(const design::TerrainStyle& style, const TerrainVariant& variant);

/// Compiles and links the program. The error is one sentence with the log of the driver.
[[nodiscard]] base::Result<gl::Program, base::Error> build_terrain_program(gl::Gl& gl, const design::TerrainStyle& style,
                                                                           const TerrainVariant& variant);

/// Programs are compiled for these numbers of warning bands.
inline constexpr std::size_t kBandVariants = 3, kCodeBandVariants = 2;
inline constexpr std::size_t kBandsOfVariant[kBandVariants] = {0, 2, design::kMaxWarningBands};
/// Returns the index in kBandsOfVariant of the smallest program that distinguishes `bands` bands.
[[nodiscard]] constexpr std::size_t band_variant(std::size_t bands) noexcept { return bands == 0 ? 0 : bands <= 2 ? 1 : 2; }

/// The code in alpha is the logarithm of the distance: it begins at kDistanceCodeStart_m and covers kDistanceCodeOctaves octaves.
inline constexpr double kDistanceCodeStart_m = 50, kDistanceCodeOctaves = 13;

}  // namespace tedavis::draw
