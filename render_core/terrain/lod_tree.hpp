/// The part of the quadtree that one selection has examined; its leaves cover the whole database.
///
/// Invariant  across every edge, leaves differ by one level at most. Memory  from an arena at start(). Thread  one.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/terrain/chunk_catalogue.hpp"
#include "render_core/terrain/key_map.hpp"

namespace tedavis::terrain {

using NodeIndex = std::uint32_t;
inline constexpr NodeIndex kNoNode = KeyMap::kNone;

struct LodNode {
    ChunkKey key;
    NodeIndex parent;  ///< kNoNode: a root
    const ChunkEntry* entry;
    double error_px;  ///< error that remains while it is a leaf: its own, or that of leaves that it keeps coarse
    double priority;  ///< priority in the selection
    float lift_m;     ///< a leaf's own lift (chunk_lift.hpp)
    bool is_leaf;
    bool is_visible;
    bool is_tried;         ///< a split was tried and has succeeded or failed for good
    bool is_queued;        ///< is in the queue
    std::uint8_t blocked;  ///< LodStop: why it was not split
};

class LodTree {
public:
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t nodes);
    void clear(const Lattice& lattice);

    [[nodiscard]] std::uint32_t size() const { return count_; }
    [[nodiscard]] std::uint32_t room() const { return static_cast<std::uint32_t>(nodes_.size()) - count_; }
    [[nodiscard]] LodNode& node(NodeIndex index) { return nodes_[index]; }
    [[nodiscard]] const LodNode& node(NodeIndex index) const { return nodes_[index]; }
    /// Returns the node of a chunk, or kNoNode when the selection has not examined it.
    [[nodiscard]] NodeIndex find(const ChunkKey& key) const { return map_.find(key.packed()); }
    /// Adds a leaf; there must be room. Parents are added before their children.
    NodeIndex add(const ChunkKey& key, const ChunkEntry* entry, NodeIndex parent);

    /// Sides of a leaf beyond which the leaves are coarser.
    [[nodiscard]] std::uint8_t coarser_edges(const ChunkKey& key) const;
    /// The coarser leaf beyond one of these sides.
    [[nodiscard]] NodeIndex coarser_beyond(const ChunkKey& key, EdgeBit side) const;
    /// Returns the leaf over a lattice cell (given by its north-west post); columns wrap round the Earth. Returns kNoNode
    /// beyond the lattice. The search is fastest when the leaf's level is close to `near_level`.
    [[nodiscard]] NodeIndex leaf_over_cell(std::int64_t i, std::int64_t j, std::uint32_t near_level = 0) const;

    [[nodiscard]] const Lattice& lattice() const { return *lattice_; }
    [[nodiscard]] const base::ResourceUse& use() const { return use_; }
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t nodes);

private:
    const Lattice* lattice_ = nullptr;
    base::Span<LodNode> nodes_;
    KeyMap map_;
    std::uint32_t count_ = 0;
    base::ResourceUse use_;
};

}  // namespace tedavis::terrain
