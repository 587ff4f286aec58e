/// The exhaustive signed error of a chunk: of its own mesh, and of its mesh beside coarser neighbours.
///
/// Every triangle of the chunk that can be drawn is compared with every post below it; added are bounds of the distance of flat
/// triangles from the curved Earth and of the rounding of vertices. Exact chunks have only the latter two, which are bounded cell
/// by cell from the rise of the cell, the slopes around it, and the displacements of its four vertices.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/chunk_assembly.hpp"
#include "host_sim/terrain_builder/curvature_bound.hpp"
#include "host_sim/terrain_builder/slope_map.hpp"
#include "host_sim/terrain_builder/surface_error.hpp"
#include "render_core/terrain/chunk_mesh.hpp"

namespace tedavis::host_sim {

/// Indices of the triangles of a chunk that only appear beside coarser neighbours, each once, for all combinations of the
/// given sides. Throws UserError where the mesh is not sound (a defect of the builder).
[[nodiscard]] std::vector<std::uint16_t> strip_triangles(const ChunkDraft& draft, std::uint8_t sides);

/// Errors in metres.
struct ChunkErrors {
    SignedError own, strips;
    double shift_m = 0;  ///< bound of the horizontal displacement of the mesh

    void include(const ChunkErrors& other);
    /// Writes the errors to the entry and extends its box by the distance of the surface from the mesh.
    void state(terrain::ChunkEntry& entry) const;
};

class ChunkProof {
public:
    /// `surface_m` are the heights of the draft's vertices; `sides`, as EdgeBits, those at which coarser neighbours can be.
    ChunkProof(const BuildPlan& plan, const Steepness& slopes, const ChunkDraft& draft, const std::vector<double>& surface_m,
               std::uint8_t sides);

    /// Compares with the posts of a window. The errors are complete after windows whose union is the chunk's domain, in any
    /// order.
    void include(const PostWindowView& posts);
    [[nodiscard]] const ChunkErrors& errors() const { return errors_; }

private:
    struct Triangle {
        std::array<MeshCorner, 3> corners;
        std::int64_t i0, j0, i1, j1;
        double more_above_m, more_below_m;  // by curvature and rounding
        double shift_m;
        bool in_strip, exact;
    };
    void add_triangles(const ChunkDraft& draft, const std::vector<double>& surface_m, const std::uint16_t* indices,
                       std::size_t count, bool in_strip);
    void add_regular(const ChunkDraft& draft);
    [[nodiscard]] bool take_cells(const ChunkDraft& draft);
    void include_cells(const PostWindowView& posts);
    void include_curvature(const Steepness& slopes);

    const BuildPlan& plan_;
    const terrain::PostRange domain_;
    const double rounding_m_;
    double steepest_ = 0;
    std::vector<VertexRounding> roundings_;  // of the posts of a chunk that is measured cell by cell, row by row
    std::vector<Triangle> triangles_;
    ChunkErrors errors_;
};

}  // namespace tedavis::host_sim
