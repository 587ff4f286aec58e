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

/// How far a flat triangle misses the true surface, and the place where.
struct TinMiss {
    double error_m = 0, i = 0, j = 0;
};

struct TinInput {
    std::uint32_t last_i = 0, last_j = 0;  ///< of the chunk: its domain is [0, last_i] x [0, last_j], at most 32768
    std::vector<TinPost> border;           ///< clockwise seen from above from the north-west corner, all four corners in it
    std::vector<TinPost> candidates;       ///< posts that may become vertices; those on the four sides are left out
    double tolerance_m = 0;                ///< no valid candidate further from the mesh than this, if the capacity allows
    std::uint32_t max_vertices = 0;        ///< borders included; at most 65536
    /// Metres by which a flat triangle of the given extent (posts east, posts south, northernmost row) can lie below the
    /// curved Earth: counts as error of every triangle. May be null.
    double (*curvature_m)(const void* context, std::uint32_t posts_east, std::uint32_t posts_south, std::uint32_t row) = nullptr;
    /// The miss of a flat triangle, asked once its candidates are within the tolerance. While it exceeds
    /// `miss_tolerance_m`, the candidate nearest to the place is taken, of the triangle and its neighbours: between posts, where
    /// sides cross the true surface's folds, a mesh can be far off though it is near at every post. May be null.
    TinMiss (*miss)(const void* context, const TinPost& a, const TinPost& b, const TinPost& c) = nullptr;
    double miss_tolerance_m = 0;
    const void* context = nullptr;  ///< handed to both
};

struct Tin {
    std::vector<TinPost> vertices;         ///< the border first, in the order given; then as they were inserted
    std::vector<std::uint16_t> triangles;  ///< three a triangle, counter-clockwise seen from above (i east, j south)
    double candidate_error_m = 0;          ///< largest error left, at valid candidates and by curvature
};

/// A triangle that holds void candidates gets a void vertex before anything else is refined, as far as the capacity goes:
/// what is not known is seen to be unknown. A candidate on a side belongs to one of the two triangles there. Void candidates
/// have no error; the heights of void vertices count as drawn. Where curvature alone exceeds the tolerance, the candidate
/// nearest to the triangle's middle is taken.
[[nodiscard]] Tin make_chunk_tin(const TinInput& input);

}  // namespace tedavis::host_sim
