/// The mesh of one chunk: Delaunay triangulation by greedy insertion of the post with the largest error (Garland, Heckbert,
/// "Fast Polygonal Approximation of Terrains and Height Fields", CMU-CS-95-181, 1995), between given border vertices.
///
/// Coordinates are whole lattice posts relative to the chunk's north-west corner, i east, j south; heights in metres.
/// Deterministic: equal input gives equal output on every machine; of equal errors the northernmost, then the westernmost
/// goes first. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <vector>

#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {

struct TinPost {
    std::uint16_t i = 0, j = 0;
    float height_m = 0;
    terrain::PostClass post_class = terrain::PostClass::land;
};

/// The largest distance of a flat triangle from the true surface, and its place.
struct TinMiss {
    double error_m = 0, i = 0, j = 0;
};

struct TinInput {
    std::uint32_t last_i = 0, last_j = 0;  ///< the chunk's domain is [0, last_i] x [0, last_j]; at most 32768
    std::vector<TinPost> border;           ///< clockwise seen from above from the north-west corner, all four corners in it
    std::vector<TinPost> candidates;       ///< posts that may become vertices; those on the four sides are left out
    double tolerance_m = 0;                ///< largest distance of a valid candidate from the mesh, if the capacity allows
    std::uint32_t max_vertices = 0;        ///< borders included; at most 65536
    /// Returns the metres by which a flat triangle of the given extent (posts east, posts south, northernmost row) can lie below
    /// the curved Earth; part of the error of every triangle. May be null.
    double (*curvature_m)(const void* context, std::uint32_t posts_east, std::uint32_t posts_south, std::uint32_t row) = nullptr;
    /// Returns the miss of a flat triangle whose candidates are within the tolerance. While it exceeds `miss_tolerance_m`, the
    /// candidate of the triangle or its neighbours that is nearest to the place is inserted: between posts, where sides cross
    /// edges of the true surface, the mesh can be inaccurate even if it is accurate at every post. May be null.
    TinMiss (*miss)(const void* context, const TinPost& a, const TinPost& b, const TinPost& c) = nullptr;
    double miss_tolerance_m = 0;
    const void* context = nullptr;  ///< passed to both functions
};

struct Tin {
    std::vector<TinPost> vertices;         ///< the border first, in the order given; then as they were inserted
    std::vector<std::uint16_t> triangles;  ///< three a triangle, counter-clockwise seen from above (i east, j south)
    double candidate_error_m = 0;          ///< largest error left, at valid candidates and by curvature
};

/// A triangle with void candidates first gets a void vertex, as far as the capacity allows, so that voids are drawn as such. A
/// candidate on a side belongs to one of the two triangles there. Void candidates have no error; void vertices are drawn at their
/// heights. Where curvature alone exceeds the tolerance, the candidate nearest to the triangle's middle is taken.
[[nodiscard]] Tin make_chunk_tin(const TinInput& input);

}  // namespace tedavis::host_sim
