/// Meshes of glyphs, made once and drawn many times.
///
/// Solids are convex parts with outward normals, counter-clockwise from outside. Flat shapes lie in the plane z = 0, seen from
/// +z, have no normals (they are not shaded) and a dark rim round them, so that they stand out against any ground. No two
/// triangles of a shape cover each other, so that it may be transparent. The frame: +x along the glyph's direction, +z up;
/// lengths are shares of the glyph's length (x), width (y) and height (z).
///
/// Plain variants are for glyphs of a few pixels. Plain data without pointers; an object of zero bytes has no meshes.
#pragma once

#include <cstdint>
#include <type_traits>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::draw {

enum class GlyphShape : std::uint8_t {
    arrow,         ///< shaft and tip, x -0.5 .. 0.5
    plain_arrow,   ///< the same with fewer corners
    flat_arrow,    ///< x -0.5 .. 0.5
    ring,          ///< flat: calm
    crossed_ring,  ///< flat: wind without one direction
    cross,         ///< flat: a value is missing
    sphere,        ///< of diameter 1 round the place
    plain_sphere,
    box,          ///< x, y -0.5 .. 0.5, stands on the place, z 0 .. 1; without its bottom
    tetrahedron,  ///< stands on the place, z 0 .. 1
    cone,         ///< the same
    plain_cone,
    circle,    ///< flat
    triangle,  ///< flat, a corner to +x
    puff,      ///< flat, without rim: opaque in its middle, nothing at its edge
    stem,      ///< flat: a line along x, -0.5 .. 0.5, from dark to light across
};
inline constexpr std::size_t kGlyphShapes = static_cast<std::size_t>(GlyphShape::stem) + 1;

[[nodiscard]] constexpr bool is_flat(GlyphShape shape) {
    return shape == GlyphShape::flat_arrow || shape == GlyphShape::ring || shape == GlyphShape::crossed_ring ||
           shape == GlyphShape::cross || shape == GlyphShape::circle || shape == GlyphShape::triangle ||
           shape == GlyphShape::puff || shape == GlyphShape::stem;
}
/// True for shapes that show only uncertainty.
[[nodiscard]] constexpr bool is_of_uncertainty(GlyphShape shape) {
    return shape == GlyphShape::circle || shape == GlyphShape::triangle || shape == GlyphShape::tetrahedron;
}
/// Returns the plain variant of sphere, arrow and cone; other shapes unchanged.
[[nodiscard]] GlyphShape plain_variant(GlyphShape shape) noexcept;

struct GlyphVertex {
    float place[3];
    std::int8_t normal[4];  ///< in 127ths, and 0; all 0 for flat shapes
    std::uint8_t tone;      ///< 255ths of the glyph's colour: 0 is black
    std::uint8_t opacity;   ///< 255ths of the glyph's opacity
    std::uint8_t unused[2];
};
static_assert(sizeof(GlyphVertex) == 20 && std::is_trivially_copyable_v<GlyphVertex>);

/// The part of the tables of vertices and indices that belongs to a shape.
struct GlyphMesh {
    std::uint16_t first_vertex = 0, vertices = 0, first_index = 0, indices = 0;
};

class GlyphShapes {
public:
    static constexpr std::size_t kMaxVertices = 640, kMaxIndices = 2048;

    void build();
    [[nodiscard]] const GlyphMesh& mesh(GlyphShape shape) const { return meshes_[static_cast<std::size_t>(shape)]; }
    [[nodiscard]] base::Span<const GlyphVertex> vertices() const { return {vertices_.data(), vertices_.size()}; }
    /// Indices into vertices(); three per triangle.
    [[nodiscard]] base::Span<const std::uint16_t> indices() const { return {indices_.data(), indices_.size()}; }
    /// Largest numbers of vertices and of indices of a shape.
    [[nodiscard]] std::uint32_t most_vertices() const;
    [[nodiscard]] std::uint32_t most_indices() const;

private:
    friend class GlyphShapeMaker;
    base::FixedVector<GlyphVertex, kMaxVertices> vertices_;
    base::FixedVector<std::uint16_t, kMaxIndices> indices_;
    GlyphMesh meshes_[kGlyphShapes];
};
static_assert(std::is_trivially_copyable_v<GlyphShapes>);

}  // namespace tedavis::draw
