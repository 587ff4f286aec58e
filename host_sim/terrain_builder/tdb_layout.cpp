#include "host_sim/terrain_builder/tdb_layout.hpp"

#include <algorithm>

#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

std::uint64_t payload_bytes(std::uint64_t vertices) { return vertices * sizeof(ChunkVertex); }

}  // namespace

TdbLayout::TdbLayout(const BuildPlan& coarse, const Lattice& database, const InsetCoverage& coverage) : lattice_(coarse.lattice) {
    undulation = sizeof(FileHeader);
    page_table = undulation + coarse.undulation.undulation_m.size() * sizeof(float);
    page_table = (page_table + 7) / 8 * 8;
    pages = page_table + std::uint64_t{database.page_count()} * sizeof(std::uint64_t);
    list_pages(database, coverage);
    regular = pages + existing_.size() * sizeof(DirectoryPage);
    // Chunks that lie side by side share their border posts, each has its own copy.
    const std::uint64_t across = lattice_.columns() - 1 + lattice_.grid_columns(0),
                        down = lattice_.rows() - 1 + lattice_.grid_rows(0);
    attributes = regular + payload_bytes(across * down);
    std::uint64_t chunks = 0;
    for (std::uint32_t level = 1; level < lattice_.levels(); ++level) {
        first_attribute_[level] = chunks;
        chunks += std::uint64_t{lattice_.grid_columns(level)} * lattice_.grid_rows(level);
    }
    open_parts = attributes + chunks * sizeof(AttributePage);
}

void TdbLayout::list_pages(const Lattice& database, const InsetCoverage& coverage) {
    std::uint32_t first = 0;
    for (std::uint32_t level = 0; level < database.levels(); ++level) {
        const std::uint32_t across = database.page_columns(level), down = database.page_rows(level);
        std::vector<PostRange> areas = coverage.regions();
        if (level >= coverage.base_level()) areas = {{0, 0, database.columns() - 1, database.rows() - 1}};
        std::vector<std::uint32_t> indices;
        for (const PostRange& area : areas) {
            const std::uint32_t side = kPageChunks * (kChunkCells << level);
            for (std::uint32_t j = area.j0 / side; j <= (area.j1 - 1) / side; ++j)
                for (std::uint32_t i = area.i0 / side; i <= (area.i1 - 1) / side; ++i) indices.push_back(first + j * across + i);
        }
        std::sort(indices.begin(), indices.end());
        indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
        for (const std::uint32_t index : indices) existing_.push_back({index, pages + existing_.size() * sizeof(DirectoryPage)});
        first += across * down;
    }
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
