/// All posts of a terrain database in memory for the tracer: exact heights with their bounds, and the look of each post. Posts
/// between those of a coarser exact chunk lie on the chunk's triangles; posts on the border of two levels are those of the finer
/// chunk.
///
/// Ground without data has the database's interpolated heights. The class of its posts is void, so that it is drawn as unknown,
/// as the rasterizer draws it.
///
/// Memory    from an arena at start(). Thread  reading any. Failure  start() returns the fault; the object must then not be used.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/raytrace/space/ground_space.hpp"
#include "render_core/raytrace/trace_ray.hpp"
#include "render_core/terrain/height_query.hpp"

namespace tedavis::draw {

struct PostLook {
    std::int8_t normal[3];  ///< of the surface, a unit vector in ECEF times 127
    terrain::PostClass post_class;
};

enum class TracedGroundFault : std::uint8_t {
    none,
    no_room,  ///< in the arena
    round,    ///< the database goes round the Earth or contains a pole, for which there is no grid space
    damaged,  ///< a part of it cannot be read
};

class TracedGround {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(const terrain::Lattice& lattice);
    /// Reads the whole database through the query, whose cache then contains other chunks.
    [[nodiscard]] TracedGroundFault start(terrain::HeightQuery& database, base::Workers& workers, base::Arena& arena);

    [[nodiscard]] raytrace::TracedField<float> field() const { return {&maxima_, nullptr, raytrace::CellSurface::two_triangles}; }
    /// All posts of a lattice.
    [[nodiscard]] static terrain::PostRange all_of(const terrain::Lattice& lattice) {
        return {0, 0, lattice.columns() - 1, lattice.rows() - 1};
    }
    /// Metres above MSL, of every post of the lattice.
    [[nodiscard]] const raytrace::HeightGrid<float>& heights() const { return maxima_.grid(); }
    /// One per post, row by row.
    [[nodiscard]] base::Span<const PostLook> looks() const { return {looks_.data(), looks_.size()}; }

private:
    [[nodiscard]] bool read_level(terrain::HeightQuery& database, std::uint32_t level, std::uint64_t& cells);
    [[nodiscard]] bool read_chunk(terrain::HeightQuery& database, const terrain::ChunkKey& key);
    void fill_cell(const terrain::PostRange& cell, const terrain::ChunkVertex* const (&corners)[4]);

    raytrace::HeightMipmap<float> maxima_;
    base::Span<float> heights_;
    base::Span<PostLook> looks_;
    std::uint32_t columns_ = 0;
};

}  // namespace tedavis::draw
