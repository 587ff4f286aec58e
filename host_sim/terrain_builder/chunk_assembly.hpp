/// Gives a chunk the form that the file has. Posts become vertices, whose positions are rounded to the vertex grid and counted
/// from the chunk's centre; its box is made to hold them all.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/chunk_border.hpp"
#include "host_sim/terrain_builder/post_places.hpp"

namespace tedavis::host_sim {

/// How far rounding of its place and of its height moved a vertex, at most.
struct VertexRounding {
    double up_m = 0, sideways_m = 0;
};

/// A chunk that is being made: its entry (without place), vertices and, unless it is regular, triangles.
struct ChunkDraft {
    terrain::ChunkEntry entry{};
    std::vector<terrain::ChunkVertex> vertices;
    std::vector<std::uint16_t> triangles;
    double rounding_m = 0;                  ///< how far a vertex can lie from its post by rounding
    std::vector<VertexRounding> roundings;  ///< of every vertex; empty where a chunk was read from a file
};

class ChunkAssembly {
public:
    ChunkAssembly(const BuildPlan& plan, const terrain::ChunkKey& key);

    void reserve(std::size_t vertices);
    /// The window holds the post and, where they exist, its neighbours.
    void add_border(const BorderPost& post, const LatticeWindow& window, const PostPlaces& places);
    void add_inner(std::uint32_t i, std::uint32_t j, const LatticeWindow& window, const PostPlaces& places);
    /// Key, counts of vertices, centre, axes and the extent of the vertices are set.
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

/// Grows the box by what the true surface can lie outside the mesh.
void grow_box(terrain::ChunkEntry& entry, double margin_m);

}  // namespace tedavis::host_sim
