/// Where the parts of a database file lie. All but open parts have places that are known beforehand.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/inset_coverage.hpp"

namespace tedavis::host_sim {

/// Header, undulation, page table, directory pages, payloads of the finest coarse chunks, their ancestors' attribute pages; then
/// the open parts in the order in which they are made: payloads of the other levels, and all parts of insets. Without insets the
/// coarse lattice is the database's.
class TdbLayout {
public:
    TdbLayout(const BuildPlan& coarse, const terrain::Lattice& database, const InsetCoverage& coverage);

    struct Page {
        std::uint32_t index;  ///< in the page table
        std::uint64_t offset;
    };
    /// Pages that have chunks, in the order of the page table.
    [[nodiscard]] const std::vector<Page>& existing_pages() const { return existing_; }

    std::uint64_t undulation = 0, page_table = 0, pages = 0, regular = 0, attributes = 0, open_parts = 0;

    /// Of a chunk of level 0 of the coarse lattice: its payload's place, without checksum.
    [[nodiscard]] terrain::PartPlace regular_place(std::uint32_t i, std::uint32_t j) const;
    /// Of a chunk of level 1 and above of the coarse lattice.
    [[nodiscard]] terrain::PartPlace attribute_place(const terrain::ChunkKey& key) const;

private:
    void list_pages(const terrain::Lattice& database, const InsetCoverage& coverage);

    const terrain::Lattice& lattice_;
    std::vector<Page> existing_;
    std::uint64_t first_attribute_[terrain::kMaxLevels + 1]{};
};

/// Chunks of all levels of a lattice, and where a chunk stands among them: level by level, row by row.
class ChunkOrder {
public:
    explicit ChunkOrder(const terrain::Lattice& lattice);

    [[nodiscard]] std::uint64_t count() const { return first_[levels_]; }
    [[nodiscard]] std::uint64_t index(const terrain::ChunkKey& key) const {
        return first_[key.level] + std::uint64_t{key.j} * columns_[key.level] + key.i;
    }

private:
    std::uint32_t levels_;
    std::uint64_t first_[terrain::kMaxLevels + 1]{};
    std::uint32_t columns_[terrain::kMaxLevels]{};
};

}  // namespace tedavis::host_sim
