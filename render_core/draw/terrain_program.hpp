/// The shader program of one terrain style, for chunks with or without attribute pages and for a number of warning bands.
///
/// The image has pages of its own: chunks without one read a transparent place.
/// A technique that the style does not ask for is not compiled. Without pages the vertex normal shades, and what only a page
/// knows is left out (catalogue of replacements: README of this folder).
/// Memory  none of ours. Thread  the GL thread. Failure  one sentence.
#pragma once

#include "render_core/base/fixed_string.hpp"
#include "render_core/design/terrain_style.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

enum TerrainAttribute : GLuint { kTerrainPosition, kTerrainHeight, kTerrainNormal, kTerrainKind, kTerrainPlace };
inline constexpr GLuint kTerrainAttributes = 5;

/// Places in the program's list of uniforms; -1 where the style has no use for one.
enum TerrainUniform : std::size_t {
    kChunkOffset,
    kViewProjection,
    kToLocal,
    kHazePerM,
    kLift,
    kPlaceEnd,
    kEarthCentre,
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
    kGridLines,
    kLights,
    kLight,
    kOcclusion,
    kLineColor,
    kFormLines,
    kContour,
    kStrokes,
    kPageTexel,
    kCoastSharp,
    kBandColor,
    kBandLower,
    kTerrainUniforms
};

struct TerrainVariant {
    std::size_t bands = 0;            ///< warning bands that it tells apart
    bool baked = false;               ///< the chunk has attribute pages
    bool coast = false;               ///< the chunk has sea and land; what a pixel is comes from its pages
    bool lifted = false;              ///< never below the true terrain
    bool outlined = false;            ///< writes the distance for the pass that draws silhouettes
    bool maps[design::kBakedMaps]{};  ///< those that the database and the device have
};

inline constexpr std::size_t kMaxTerrainDefines = 1023;
using TerrainDefines = base::FixedString<kMaxTerrainDefines>;
/// The techniques of a style as the preprocessor's lines.
[[nodiscard]] TerrainDefines terrain_defines(const design::TerrainStyle& style, const TerrainVariant& variant);

[[nodiscard]] base::Result<gl::Program, gl::GlError> build_terrain_program(gl::Gl& gl, const design::TerrainStyle& style,
                                                                           const TerrainVariant& variant);

/// Distance on which DISTANCE_IN_ALPHA of terrain.frag codes a step of 1/255: the outline pass needs it.
inline constexpr double kDistanceCodeStart_m = 50, kDistanceCodeOctaves = 13;

}  // namespace tedavis::draw
