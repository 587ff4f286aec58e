/// Where the parts of a database file lie. All but the irregular chunks' payloads have places that are known beforehand.
#pragma once

#include <cstdint>

#include "host_sim/terrain_builder/build_plan.hpp"

namespace tedavis::host_sim {

/// Header, undulation, page table, directory pages, payloads of level 0, attribute pages; then payloads of the other levels
/// in the order in which they are made.
struct TdbLayout {
    explicit TdbLayout(const BuildPlan& plan);

    std::uint64_t undulation = 0, page_table = 0, pages = 0, regular = 0, attributes = 0, irregular = 0;

    /// Of a chunk of level 0: the regular payload's place without checksum.
    [[nodiscard]] terrain::PartPlace regular_place(std::uint32_t i, std::uint32_t j) const;
    /// Of a chunk of level 1 and above.
    [[nodiscard]] terrain::PartPlace attribute_place(const terrain::ChunkKey& key) const;

private:
    const terrain::Lattice& lattice_;
    std::uint64_t first_attribute_[terrain::kMaxLevels + 1]{};
};

/// Chunks of all levels, and where a chunk stands among them: level by level, row by row.
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
