/// Whether the surface, as it is drawn, stands between an eye and a place: what it hides can then be hidden whole.
///
/// A sight ends at reach() of its way, so that what stands on the ground is not hidden by the triangle that it stands on, and
/// begins at the near plane. It is blocked where it enters a triangle's front, of the triangles that are drawn: those of the
/// selected chunks beside coarser neighbours, with their lifts; back faces are culled. Triangles are taken a millimetre wider, so
/// that no sight slips through between two.
///
/// In a chunk whose box the sight passes through, every vertex gets its sides of two planes that meet in the sight; a triangle
/// that it meets has corners on both sides of both. The index list beside coarser neighbours, which costs most, is asked for only
/// where the triangles that it replaces reach both sides: they have all the corners of those in their place, and a polygon whose
/// triangles all stay on one side of a plane stays there.
///
/// Where the view's magnifiers move the ground, the sight is taken apart into its ways over the ground as it is.
///
/// Computed in double, from the eye. Pure but for the meshes that are asked. Bounded: a box a chunk, and the vertices and
/// triangles of the chunks whose boxes are met. No heap; the answer depends on nothing that was asked before.
/// Thread  the meshes'.
#pragma once

#include "render_core/terrain/drawn_surface.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

class LineOfSight {
public:
    static constexpr double kTail = 0.005;
    /// Share of its way at which a sight ends: all but kTail; of an eye that sees little of the far, but kTail of what it sees
    /// across there.
    [[nodiscard]] static double reach(const View& view);

    /// Everything must stay, and the selection be of this frame, its payloads in memory.
    LineOfSight(const Lattice& lattice, base::Span<const SelectedChunk> selected, DrawnMeshes& meshes, const View& view)
        : lattice_(lattice), selected_(selected), meshes_(meshes), view_(view) {}

    /// `place` in ECEF, m. False for what does not lie beyond the near plane: nobody looks there; and
    /// over a flat surface, which hides nothing that stands on it.
    [[nodiscard]] bool is_hidden(const glm::dvec3& place);

private:
    [[nodiscard]] bool is_blocked(const glm::dvec3& eye, const glm::dvec3& way, double from, double to);
    [[nodiscard]] base::Span<const std::uint16_t> drawn_indices(const SelectedChunk& chunk);

    const Lattice& lattice_;
    base::Span<const SelectedChunk> selected_;
    DrawnMeshes& meshes_;
    const View& view_;
    const SelectedChunk* built_ = nullptr;  ///< the last chunk whose drawn index list was asked for
    base::Span<const std::uint16_t> built_indices_;
};

}  // namespace tedavis::terrain
