/// Converts a chunk to the form of the file: posts become vertices, whose positions are rounded to the vertex grid and relative
/// to the chunk's centre, and its bounding box contains them all.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/chunk_border.hpp"
#include "host_sim/terrain_builder/post_places.hpp"

namespace tedavis::host_sim {

/// Bounds of the displacement of a vertex by the rounding of its position and of its height.
struct VertexRounding {
    double up_m = 0, sideways_m = 0;
};

/// A chunk that is being made: its entry (without place), vertices and, unless it is regular, triangles.
struct ChunkDraft {
    terrain::ChunkEntry entry{};
    std::vector<terrain::ChunkVertex> vertices;
    std::vector<std::uint16_t> triangles;
    double rounding_m = 0;                  ///< bound of the distance of a vertex from its post by rounding
    std::vector<VertexRounding> roundings;  ///< of every vertex; empty where a chunk was read from a file
};

class ChunkAssembly {
public:
    ChunkAssembly(const BuildPlan& plan, const terrain::ChunkKey& key);

    void reserve(std::size_t vertices);
    /// The window must contain the post and, where they exist, its neighbours.
    void add_border(const BorderPost& post, const LatticeWindow& window, const PostPlaces& places);
    void add_inner(std::uint32_t i, std::uint32_t j, const LatticeWindow& window, const PostPlaces& places);
    /// Returns the draft with key, counts of vertices, centre, axes and bounding box of the vertices.
    [[nodiscard]] ChunkDraft finish();

private:
    void add(std::uint32_t i, std::uint32_t j, std::uint32_t quantum_level, bool stays, const LatticeWindow& window,
             const PostPlaces& places);
    void place_box();

    const BuildPlan& plan_;
    const terrain::PostRange posts_;
    std::vector<double> quantum_m_;  ///< by level
    std::vector<glm::dvec3> places_;
    ChunkDraft draft_;
};

/// Extends the box by the distance of the true surface from the mesh.
void grow_box(terrain::ChunkEntry& entry, double margin_m);

}  // namespace tedavis::host_sim
