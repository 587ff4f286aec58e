/// Tests whether the drawn surface hides a point from the eye point, so that a symbol at a hidden point can be left out as a
/// whole.
///
/// A line of sight begins at the near plane and ends at the share reach() of its length, so that an object on the ground is not
/// hidden by the triangle that it stands on. It is blocked where it passes through the front of a drawn triangle, that is, of
/// the selected chunks with their lifts and their coarser edges; back faces are ignored. Triangles are widened by a millimetre,
/// so that no line passes between two.
///
/// In a chunk whose box the line intersects, every vertex is classified by its side of two planes whose intersection is the
/// line; a triangle that the line hits has corners on both sides of both planes. The index list for coarser edges, which costs
/// most, is built only where the triangles that it replaces reach both sides: otherwise the replacing triangles, which have no
/// other corners, cannot do so either.
///
/// Where the view's magnifiers move the ground, the line is mapped back to a chain of segments over the undistorted ground.
///
/// Computed in double, relative to the eye point. Pure, apart from the meshes that it requests. Bounded: one box per chunk, and
/// the vertices and triangles of the chunks whose boxes are hit. No heap; answers do not depend on earlier ones.
/// Thread  the meshes'.
#pragma once

#include "render_core/terrain/drawn_surface.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

class LineOfSight {
public:
    static constexpr double kTail = 0.005;
    /// Share of the distance to the point at which the line of sight ends: 1 - kTail * min(w, 1), w being the width of the view
    /// per unit distance.
    [[nodiscard]] static double reach(const View& view);

    /// All arguments must outlive the object. The selection is that of this frame, and its payloads are in memory.
    LineOfSight(const Lattice& lattice, base::Span<const SelectedChunk> selected, DrawnMeshes& meshes, const View& view)
        : lattice_(lattice), selected_(selected), meshes_(meshes), view_(view) {}

    /// Returns true where the surface hides `place` (ECEF, m). Returns false for a point that is not beyond the near plane, and
    /// over a flat surface, which hides nothing that stands on it.
    [[nodiscard]] bool is_hidden(const glm::dvec3& place);

private:
    [[nodiscard]] bool is_blocked(const glm::dvec3& eye, const glm::dvec3& way, double from, double to);
    [[nodiscard]] base::Span<const std::uint16_t> drawn_indices(const SelectedChunk& chunk);

    const Lattice& lattice_;
    base::Span<const SelectedChunk> selected_;
    DrawnMeshes& meshes_;
    const View& view_;
    const SelectedChunk* built_ = nullptr;  ///< the chunk whose drawn index list was requested last
    base::Span<const std::uint16_t> built_indices_;
};

}  // namespace tedavis::terrain
