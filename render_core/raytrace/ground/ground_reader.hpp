/// Reads the heights of a window of a terrain database from its exact chunks of any level (exact_posts.hpp).
///
/// Where chunks of two levels meet, the posts on their border are those of the finer one. Every part is verified as it is read;
/// parts that cannot be read are void and reported, except for posts that a neighbouring chunk contains too. Posts without a
/// height stay void.
///
/// Heights as floats in metres equal the stored bits at posts of level 0, and the surface between them equals that of
/// terrain::HeightQuery within half a unit in the last place of a float: 0.06 mm below 2048 m, 0.5 mm up to 12,000 m.
///
/// Memory  from an arena at start: kBytesEach per worker. Thread  read() uses the workers; its result does not depend on their
/// number. The byte source of the database must be as thread-safe as its port says.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/ground/exact_chunk.hpp"
#include "render_core/raytrace/ground/ground_window.hpp"

namespace tedavis::raytrace {

struct GroundReading {
    GroundRounding rounding;
    std::uint64_t void_posts = 0;      ///< posts without a height, for any reason
    std::uint64_t read_bytes = 0;      ///< of directory pages and chunks
    std::uint32_t damaged_parts = 0;   ///< damaged directory pages and chunks; with a page all its exact chunks are missing
    terrain::TdbFailure first_damage;  ///< the one with the smallest file offset
};

class GroundReader {
public:
    static constexpr std::size_t kBytesEach = kExactChunkBytes + sizeof(terrain::DirectoryPage) + 128;

    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t workers) { return workers * kBytesEach + 64; }
    /// Allocates for `workers` workers; returns false where the arena is too small. The database must outlive the reader.
    [[nodiscard]] bool start(const terrain::TerrainDatabase& database, std::uint32_t workers, base::Arena& arena);
    /// Reads the window. Workers beyond those of start() are not used.
    template <class Height>
    GroundReading read(const GroundWindow<Height>& to, base::Workers& workers);

private:
    struct Desk {  ///< memory of one worker
        terrain::DirectoryPage page;
        alignas(terrain::ChunkVertex) std::uint8_t payload[kExactChunkBytes];
        GroundReading reading;
    };
    template <class Height>
    struct Round;
    template <class Height>
    void read_page(const Round<Height>& round, std::uint32_t i, std::uint32_t j, Desk& desk) const;
    template <class Height>
    void read_chunk(const Round<Height>& round, const terrain::ChunkEntry& entry, Desk& desk) const;

    const terrain::TerrainDatabase* database_ = nullptr;
    base::Span<Desk> desks_;
};

}  // namespace tedavis::raytrace
