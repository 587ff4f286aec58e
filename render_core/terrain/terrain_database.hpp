/// An opened .tdb: header, lattice, page table and undulation grid in memory; directory pages and payloads are read on demand.
///
/// Memory    page table (8 bytes per page) and undulation grid come from the arena passed to open(); nothing is allocated
/// later.
/// Failure   every read verifies checksum, sizes and ranges; one flipped bit anywhere in the file is found when its part is
///           read. The entries of a directory page that passes need no further checks.
/// Thread    const after open(); reads are as thread-safe as the byte source.
#pragma once

#include "render_core/base/fault_text.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/base/ports/byte_source.hpp"
#include "render_core/base/result.hpp"
#include "render_core/earth/geodetic.hpp"
#include "render_core/terrain/lattice.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::terrain {

enum class TdbError : std::uint8_t {
    none,
    unreadable,
    not_a_tdb,
    wrong_version,
    truncated,
    header_damaged,
    directory_damaged,
    chunk_damaged,
    too_large,
    too_many_roots
};
/// Returns the predicate of a message: "is not a terrain database".
[[nodiscard]] const char* to_string(TdbError error) noexcept;

/// A failure and the file offset at which it was found.
struct TdbFailure {
    TdbError error = TdbError::none;
    std::uint64_t offset = 0;
};

/// Returns what is wrong, where, and what to do, to be appended to the file's name: "is not a terrain database (offset 0); name
/// a file that ...".
[[nodiscard]] base::FaultText describe(const TdbFailure& failure) noexcept;

class TerrainDatabase {
public:
    [[nodiscard]] static base::Result<TerrainDatabase, TdbFailure> open(base::ByteSource& source, base::Arena& arena);

    [[nodiscard]] const FileHeader& header() const { return header_; }
    [[nodiscard]] const Lattice& lattice() const { return lattice_; }
    [[nodiscard]] std::uint32_t levels() const { return header_.levels; }
    [[nodiscard]] std::uint32_t top_level() const { return header_.levels - 1; }
    /// Number of chunks of the top level.
    [[nodiscard]] std::uint32_t root_count() const;

    /// True where a directory page exists; `page_index` is 0..lattice().page_count()-1. Where it does not, none of its chunks
    /// exists.
    [[nodiscard]] bool has_page(std::uint32_t page_index) const { return page_table_[page_index] != 0; }
    [[nodiscard]] std::uint64_t page_offset(std::uint32_t page_index) const { return page_table_[page_index]; }
    /// Reads and verifies a page, which must exist.
    [[nodiscard]] TdbFailure read_page(std::uint32_t page_index, DirectoryPage& page) const;
    /// Verifies a page that was read from page_offset() by other means: checksum, and every entry's position, counts, parts and
    /// dimensions.
    [[nodiscard]] TdbFailure check_page(std::uint32_t page_index, const DirectoryPage& page) const;

    /// Reads and verifies a part into `destination` (at least place.bytes long).
    [[nodiscard]] TdbFailure read_part(const PartPlace& place, base::Span<std::uint8_t> destination) const;
    /// Verifies the checksum of bytes that were read from the part's offset by other means.
    [[nodiscard]] static TdbFailure check_part(const PartPlace& place, base::Span<const std::uint8_t> bytes);

    /// Bytes that open() takes from its arena.
    [[nodiscard]] std::uint64_t table_bytes() const {
        return page_table_.size() * sizeof(std::uint64_t) + undulation_.size() * sizeof(float);
    }

    /// Returns the undulation (EGM96 geoid above WGS84 ellipsoid) at a point, bilinear in the stored grid, clamped to its
    /// border.
    [[nodiscard]] earth::GeoidUndulation undulation(double latitude_rad, double longitude_rad) const;

private:
    [[nodiscard]] TdbFailure read_tables();

    base::ByteSource* source_ = nullptr;
    FileHeader header_{};
    Lattice lattice_;
    base::Span<std::uint64_t> page_table_;
    base::Span<float> undulation_;
};

}  // namespace tedavis::terrain
