/// The exhaustive signed error of a chunk: of its own mesh, and of what coarser neighbours make of it.
///
/// Every triangle that can ever be drawn of the chunk is measured against every post under it; to that comes what flat
/// triangles miss of the curved Earth and what rounding moves the vertices. Exact chunks have nothing else, which is stated cell
/// by cell: with the rise of a cell, the slopes round it and where its own four vertices went.
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

/// Errors with all that belongs to them, metres.
struct ChunkErrors {
    SignedError own, strips;
    double shift_m = 0;  ///< how far the mesh can lie off sideways

    void include(const ChunkErrors& other);
    /// Into the entry; its box grows by what the surface can lie outside the mesh.
    void state(terrain::ChunkEntry& entry) const;
};

class ChunkProof {
public:
    /// `surface_m` are the heights of the draft's vertices; `sides` where coarser neighbours can be.
    ChunkProof(const BuildPlan& plan, const Steepness& slopes, const ChunkDraft& draft, const std::vector<double>& surface_m,
               std::uint8_t sides);

    /// Takes the posts of a window into account. Windows whose union is the chunk's domain, in any order, measure the chunk.
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
