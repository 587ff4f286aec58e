/// Terrain databases for tests, from a function of the post: valid files of today's version with regular grids at every level
/// and errors measured at every post. Independent of the terrain builder.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "render_core/terrain/terrain_database.hpp"
#include "tests/support/files/memory_bytes.hpp"

namespace tedavis::test_support {

struct TdbSpec {
    std::uint32_t columns = 129, rows = 129;
    double west_deg = 9, north_deg = 47, step_lon_deg = 1 / 1200.0, step_lat_deg = 1 / 1200.0;
    std::uint32_t lattice_flags = 0;
    std::uint32_t levels = 0;                                                    ///< 0: up to a single chunk
    std::function<double(std::uint32_t, std::uint32_t)> height_m;                ///< above MSL
    std::function<terrain::PostClass(std::uint32_t, std::uint32_t)> post_class;  ///< null: land
    std::function<bool(const terrain::ChunkKey&)> is_exact;                      ///< above level 0; null: none
    bool attributes = false;
    std::optional<std::uint32_t> drape_level;  ///< chunks from this level up have drape pages, of the texel drape_code()
    bool measured = true;                      ///< false: no errors are measured, all are 0; for tests that only read
};

/// A spec round the whole Earth, with both poles: closed columns and polar rows.
[[nodiscard]] TdbSpec whole_earth(std::uint32_t columns, std::uint32_t rows);

class WrittenTdb {
public:
    explicit WrittenTdb(TdbSpec spec);
    WrittenTdb(const WrittenTdb&) = delete;
    WrittenTdb& operator=(const WrittenTdb&) = delete;

    [[nodiscard]] const terrain::TerrainDatabase& database() const { return *database_; }
    [[nodiscard]] const terrain::Lattice& lattice() const { return lattice_; }
    [[nodiscard]] base::ByteSource& source() { return source_; }
    [[nodiscard]] const terrain::ChunkEntry& entry(const terrain::ChunkKey& key) const { return chunks_.at(key.packed()).entry; }
    [[nodiscard]] bool has(const terrain::ChunkKey& key) const { return chunks_.count(key.packed()) != 0; }
    [[nodiscard]] std::vector<terrain::ChunkKey> keys() const;
    /// Of the true surface at a post: height above MSL, and place.
    [[nodiscard]] double height_m(std::uint32_t i, std::uint32_t j) const { return heights_[std::size_t{j} * spec_.columns + i]; }
    [[nodiscard]] earth::Ecef position(std::uint32_t i, std::uint32_t j) const;
    /// A chunk's payload as it is drawn.
    [[nodiscard]] std::vector<terrain::ChunkVertex> vertices(const terrain::ChunkKey& key) const;
    [[nodiscard]] std::vector<std::uint16_t> indices(const terrain::ChunkKey& key, std::uint8_t coarser_edges) const;

    /// Signs the header, a directory page and an entry's payload anew after a change, so that no checksum tells.
    void sign_header();
    void sign_page(const terrain::ChunkKey& key);
    [[nodiscard]] terrain::FileHeader& header() { return *reinterpret_cast<terrain::FileHeader*>(bytes.data()); }
    [[nodiscard]] terrain::DirectoryPage& page(const terrain::ChunkKey& key);
    [[nodiscard]] terrain::ChunkEntry& entry_in_file(const terrain::ChunkKey& key);
    /// Opens it again into the same memory.
    [[nodiscard]] terrain::TdbFailure reopen();

    static double undulation_m(double latitude_rad);
    /// Every byte of a chunk's drape page.
    static std::uint8_t drape_code(const terrain::ChunkKey& key) { return static_cast<std::uint8_t>(1 + key.packed() % 241); }

    std::vector<std::uint8_t> bytes;  ///< the file

private:
    struct Chunk {
        terrain::ChunkEntry entry{};
        std::vector<terrain::ChunkVertex> vertices;
        std::vector<std::uint16_t> stored;
    };
    void sample_heights();
    void find_chunks();
    void flatten_exact_chunk(const terrain::ChunkKey& key);
    void make_chunk(const terrain::ChunkKey& key);
    void make_box(Chunk& chunk, const terrain::PostRange& posts) const;
    void make_triangles(Chunk& chunk) const;
    void measure(const terrain::ChunkKey& key);
    void bound(const terrain::ChunkKey& key);
    void assemble();

    TdbSpec spec_;
    terrain::FileHeader header_{};
    terrain::Lattice lattice_;
    double quantum_m_ = 1.0 / 1024;
    std::vector<double> heights_;
    std::vector<earth::Ecef> positions_, ups_;
    std::map<std::uint64_t, Chunk> chunks_;
    std::vector<terrain::ChunkKey> keys_;
    MemoryBytes source_{bytes};
    std::vector<std::uint8_t> memory_;
    std::unique_ptr<terrain::TerrainDatabase> database_;
};

}  // namespace tedavis::test_support
