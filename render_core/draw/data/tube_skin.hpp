/// Builds the surfaces of tubes as solids in blocks of rings, to limit memory: flat coloured sides (scene/tube_mesh.hpp), and
/// round hulls with radial normals, for rims and margins.
///
/// A block of a piece repeats the last ring of the block before; only the first and the last block have an end cap.
///
/// Memory  from an arena, once. Thread  one. Failure  a block without room in the batch is left out, and the function returns
/// false.
#pragma once

#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_mesh.hpp"
#include "render_core/scene/tube_mesh.hpp"

namespace tedavis::draw {

inline constexpr std::uint32_t kTubeBlockRings = 64;
inline constexpr std::uint32_t kTubeHullSides = 12;
inline constexpr std::uint32_t kTubeRimSides = scene::kDefaultTubeSides;

struct TubeColor {
    design::Color color;
    scene::Uncertainty uncertainty;
};
/// Colours of a ring: on even sides, which include the upper one, and on odd sides.
struct RingColors {
    TubeColor even, odd;
};

/// Consecutive rings of a piece: at most kTubeBlockRings, and before them the last ring of the block before.
struct TubeBlock {
    base::Span<const scene::TubeRing> rings;
    bool begins = false, ends = false;  ///< the piece begins with the first ring, ends with the last
};

class TubeSkin {
public:
    static constexpr std::uint32_t kRingVertices = 2 * scene::kDefaultTubeSides, kEndVertices = scene::kDefaultTubeSides;

    [[nodiscard]] static std::uint64_t bytes_needed();
    [[nodiscard]] bool start(base::Arena& arena);

    /// `colors`: one for each ring.
    bool add_sides(SolidBatch& batch, SolidMesh& mesh, const TubeBlock& block, base::Span<const RingColors> colors);

private:
    base::Span<scene::TubeVertex> vertices_;
    base::Span<std::uint16_t> indices_;
};

/// Semi-axes of the margin added to a tube's radius.
struct TubeMargin {
    double horizontal_m = 0, vertical_m = 0;
};

/// Adds a hull with kTubeHullSides sides, or with kTubeRimSides, whose corners are those of the tube's sides. `margins`: one for
/// each ring, or empty. Rings have their even colours.
bool add_tube_hull(SolidBatch& batch, SolidMesh& mesh, const TubeBlock& block, std::uint32_t sides,
                   base::Span<const TubeMargin> margins, base::Span<const RingColors> colors);

/// Adds the marker of a single point: an octahedron.
bool add_tube_marker(SolidBatch& batch, SolidMesh& mesh, const scene::TubeRing& ring, const TubeColor& color);

}  // namespace tedavis::draw
