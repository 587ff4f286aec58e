#include "render_core/terrain/lod_tree.hpp"

#include <initializer_list>

namespace tedavis::terrain {

std::uint64_t LodTree::bytes_needed(std::uint32_t nodes) {
    return std::uint64_t{nodes} * sizeof(LodNode) + KeyMap::bytes_needed(nodes) + alignof(LodNode);
}

bool LodTree::start(base::Arena& arena, std::uint32_t nodes) {
    nodes_ = arena.allocate_array<LodNode>(nodes);
    use_.capacity = nodes;
    return !nodes_.empty() && map_.start(arena, nodes);
}

void LodTree::clear(const Lattice& lattice) {
    lattice_ = &lattice;
    map_.clear();
    count_ = 0;
    use_.in_use = 0;
}

NodeIndex LodTree::add(const ChunkKey& key, const ChunkEntry* entry, NodeIndex parent) {
    TEDAVIS_CHECK(count_ < nodes_.size());
    LodNode& node = nodes_[count_];
    node = {};
    node.key = key;
    node.entry = entry;
    node.parent = parent;
    node.is_leaf = true;
    TEDAVIS_CHECK(map_.insert(key.packed(), count_));
    use_.take(1);
    return count_++;
}

std::uint8_t LodTree::coarser_edges(const ChunkKey& key) const {
    std::uint8_t edges = 0;
    for (const EdgeBit side : {kEdgeNorth, kEdgeEast, kEdgeSouth, kEdgeWest}) {
        const ChunkKey beside = lattice_->neighbour(key, side);
        if (beside != kNoChunk && find(beside) == kNoNode) edges = static_cast<std::uint8_t>(edges | side);
    }
    return edges;
}

NodeIndex LodTree::coarser_beyond(const ChunkKey& key, EdgeBit side) const {
    return find(lattice_->neighbour(key, side).parent());
}

NodeIndex LodTree::leaf_over_cell(std::int64_t i, std::int64_t j, std::uint32_t near_level) const {
    const std::int64_t cells_i = std::int64_t{lattice_->columns()} - 1, cells_j = std::int64_t{lattice_->rows()} - 1;
    if (lattice_->is_closed()) i = (i % cells_i + cells_i) % cells_i;
    if (i < 0 || j < 0 || i >= cells_i || j >= cells_j) return kNoNode;
    const auto over = [&](std::uint32_t level) {
        const std::int64_t cells = std::int64_t{kChunkCells} << level;
        return find({level, static_cast<std::uint32_t>(i / cells), static_cast<std::uint32_t>(j / cells)});
    };
    // Up to where the tree has come to, then down to its leaf.
    std::uint32_t level = near_level;
    NodeIndex node = over(level);
    while (node == kNoNode && level + 1 < lattice_->levels()) node = over(++level);
    while (node != kNoNode && !nodes_[node].is_leaf && level > 0) node = over(--level);
    return node;
}

}  // namespace tedavis::terrain
