/// Upper bound of the true surface round a place: no summit between two samples is missed.
///
/// The ground within a radius is searched from the coarse chunks down, first by the height ranges in the directory. Where these
/// do not decide, the exact chunks are searched in blocks of kBlockCells x kBlockCells cells: a block counts as a whole if the
/// disc touches it. Blocks at a void count with their posts of land and sea.
///
/// Bound     posts are highest at corners of cells, on both triangles and beside a pole; the directory states the range of all
///           posts below a chunk (tdb_format.hpp). The undulation is bilinear, hence highest over a rectangle at a corner of its
///           parts between the grid's lines; its maximum over the rectangle round the disc is added.
/// Distance  along the surface of the ellipsoid, and never taken for longer than on the sphere of its least radius of curvature:
///           the disc is never too small, and at most 1.1 % wider than its radius.
/// Bounded   one query reads at most kMaxChunks chunks (kMaxChunks * kBlocks * kBlocks blocks) and looks at no more than
///           4 * kMaxChunks entries of a level. A larger disc is answered from coarser entries. The undulation is evaluated at
///           the grid's posts in the rectangle and on its border.
/// Memory    17.5 KiB (kKeptChunks) from the arena: the maxima of the last chunks. Answers do not depend on them. Thread  one.
#pragma once

#include "render_core/terrain/height_query.hpp"

namespace tedavis::terrain {

struct CeilingAnswer {
    double height_m = 0;    ///< above the ellipsoid; no known ground in the disc is higher. -infinity where none lies there
    bool is_whole = false;  ///< false where a part of the disc may be void, is outside the database or could not be read
};

class HeightCeiling {
public:
    static constexpr std::uint32_t kKeptChunks = 64, kMaxChunks = 32;
    static constexpr std::uint32_t kBlockCells = 4, kBlocks = kChunkCells / kBlockCells;  ///< blocks along a chunk's side

    /// Both must outlive the object, and `heights` must be a query over `database`. Returns false if the arena is too small.
    [[nodiscard]] bool start(const TerrainDatabase& database, HeightQuery& heights, base::Arena& arena,
                             std::uint32_t kept_chunks = kKeptChunks);

    /// Returns the bound over all ground within `radius_m` of a place. Ground that is certainly below `floor_m` (above the
    /// ellipsoid) is not searched further, so `over(...).height_m < floor_m` is the cheap question whether all known ground is
    /// below it; -infinity searches everything. Infinity, and not whole, for numbers that are not finite, a latitude beyond a
    /// pole, or a negative radius.
    [[nodiscard]] CeilingAnswer over(double latitude_rad, double longitude_rad, double radius_m, double floor_m);

    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t kept_chunks = kKeptChunks);

private:
    class Disc;
    class Search;
    struct Blocks {
        std::uint64_t chunk;                 ///< packed key
        std::uint64_t asked;                 ///< 0: empty
        std::uint64_t voids;                 ///< bit by block, row by row: a post in it is void
        float highest_m[kBlocks * kBlocks];  ///< above MSL, of posts that are not void; -infinity where there is none
    };
    [[nodiscard]] const Blocks* blocks_of(const ChunkKey& key);

    const TerrainDatabase* database_ = nullptr;
    HeightQuery* heights_ = nullptr;
    base::Span<Blocks> kept_;
    std::uint64_t asked_ = 0;
};

}  // namespace tedavis::terrain
