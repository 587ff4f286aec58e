#include "host_sim/terrain_builder/tdb_layout.hpp"

#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

std::uint64_t payload_bytes(std::uint64_t vertices) { return vertices * sizeof(ChunkVertex); }

}  // namespace

TdbLayout::TdbLayout(const BuildPlan& plan) : lattice_(plan.lattice) {
    undulation = sizeof(FileHeader);
    page_table = undulation + plan.undulation.undulation_m.size() * sizeof(float);
    page_table = (page_table + 7) / 8 * 8;
    pages = page_table + std::uint64_t{lattice_.page_count()} * sizeof(std::uint64_t);
    regular = pages + std::uint64_t{lattice_.page_count()} * sizeof(DirectoryPage);
    // Chunks that lie side by side share their border posts, each has its own copy.
    const std::uint64_t across = lattice_.columns() - 1 + lattice_.grid_columns(0),
                        down = lattice_.rows() - 1 + lattice_.grid_rows(0);
    attributes = regular + payload_bytes(across * down);
    std::uint64_t chunks = 0;
    for (std::uint32_t level = 1; level < lattice_.levels(); ++level) {
        first_attribute_[level] = chunks;
        chunks += std::uint64_t{lattice_.grid_columns(level)} * lattice_.grid_rows(level);
    }
    irregular = attributes + chunks * sizeof(AttributePage);
}

PartPlace TdbLayout::regular_place(std::uint32_t i, std::uint32_t j) const {
    const PostRange posts = lattice_.posts_of({0, i, j});
    const std::uint64_t across = lattice_.columns() - 1 + lattice_.grid_columns(0);
    const std::uint32_t columns = posts.i1 - posts.i0 + 1, rows = posts.j1 - posts.j0 + 1;
    const std::uint64_t rows_before = posts.j0 + j, columns_before = posts.i0 + i;
    return {regular + payload_bytes(rows_before * across + columns_before * rows),
            static_cast<std::uint32_t>(payload_bytes(std::uint64_t{columns} * rows)), 0};
}

PartPlace TdbLayout::attribute_place(const ChunkKey& key) const {
    const std::uint64_t chunk = first_attribute_[key.level] + std::uint64_t{key.j} * lattice_.grid_columns(key.level) + key.i;
    return {attributes + chunk * sizeof(AttributePage), sizeof(AttributePage), 0};
}

ChunkOrder::ChunkOrder(const Lattice& lattice) : levels_(lattice.levels()) {
    for (std::uint32_t level = 0; level < levels_; ++level) {
        columns_[level] = lattice.grid_columns(level);
        first_[level + 1] = first_[level] + std::uint64_t{columns_[level]} * lattice.grid_rows(level);
    }
}

}  // namespace tedavis::host_sim
