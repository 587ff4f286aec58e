/// The layout of a database file. The places of all parts except the open ones are known beforehand.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/build_plan.hpp"
#include "host_sim/terrain_builder/inset_coverage.hpp"

namespace tedavis::host_sim {

/// The order is: header, undulation, page table, directory pages, payloads of the finest coarse chunks, attribute pages of their
/// ancestors; then the open parts in the order in which they are made: payloads of the other levels, and all parts of insets.
/// Without insets the coarse lattice is the database's.
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

    /// Place of the payload of a chunk of level 0 of the coarse lattice, without checksum.
    [[nodiscard]] terrain::PartPlace regular_place(std::uint32_t i, std::uint32_t j) const;
    /// Place of the attribute page of a chunk of level 1 or above of the coarse lattice.
    [[nodiscard]] terrain::PartPlace attribute_place(const terrain::ChunkKey& key) const;

private:
    void list_pages(const terrain::Lattice& database, const InsetCoverage& coverage);

    const terrain::Lattice& lattice_;
    std::vector<Page> existing_;
    std::uint64_t first_attribute_[terrain::kMaxLevels + 1]{};
};

/// The order of all chunks of a lattice: level by level, row by row.
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
