/// The attribute stage of a build: pages of all chunks of level 1 and above, tile by tile, coarse before fine.
///
/// A page of level k has the posts of pyramid level k-1. Horizons beyond a tile's apron come from the tile of the next coarser
/// level that contains it, and so on. Tiles are therefore visited from coarse to fine, and each worker keeps the far horizons of
/// the tiles above the current one.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "host_sim/terrain_builder/attributes/attribute_maps.hpp"
#include "host_sim/terrain_builder/height_levels.hpp"
#include "host_sim/terrain_builder/idle_pool.hpp"
#include "host_sim/terrain_builder/inset_coverage.hpp"
#include "host_sim/terrain_builder/part_store.hpp"
#include "host_sim/terrain_builder/tdb_layout.hpp"

namespace tedavis::host_sim {

/// Tile (u, v) of a pyramid level begins at post (128 u, 128 v): pages of two by two chunks.
struct TileKey {
    std::uint32_t level = 0, u = 0, v = 0;
};
inline constexpr std::uint32_t kTilePosts = 128;

struct BakedPage {
    terrain::ChunkKey chunk;
    terrain::PartPlace place;         ///< without its offset where there are bytes
    std::vector<std::uint8_t> bytes;  ///< empty: in the store
};

class AttributeBaker {
public:
    /// `plan` is for the finest posts; with insets, `layout` is for the coarse ones. All references must outlive this object.
    AttributeBaker(const BuildPlan& plan, const TdbLayout& layout, const InsetCoverage& coverage, const HeightLevels& heights,
                   PartStore& store);

    /// Tasks are independent of each other; together they make each page once.
    [[nodiscard]] std::uint32_t task_count() const { return static_cast<std::uint32_t>(tasks_.size()); }
    /// Makes the pages of chunks that have children; pages whose place is known beforehand are written to the store. Any thread.
    [[nodiscard]] std::vector<BakedPage> run(std::uint32_t task);

private:
    struct Task {
        TileKey tile;
        std::uint32_t last_level;  ///< the task also makes the tiles below, down to this level
    };
    /// Far horizons of one tile per level.
    struct Sight {
        struct Level {
            TileKey tile;
            FarHorizons far;
            bool known = false;
        };
        std::vector<Level> levels;
    };

    [[nodiscard]] std::uint32_t tiles_across(std::uint32_t level) const;
    [[nodiscard]] std::uint32_t tiles_down(std::uint32_t level) const;
    void list_tasks(std::uint32_t first_level, std::uint32_t last_level);
    [[nodiscard]] std::vector<TileKey> tiles_of(std::uint32_t level) const;
    [[nodiscard]] bool is_needed(const TileKey& tile) const;
    [[nodiscard]] AttributeTile load(const TileKey& tile, std::vector<terrain::PostClass>& classes) const;
    [[nodiscard]] FarView view_above(const TileKey& tile, Sight& sight) const;
    void bake(const Task& task, Sight& sight, std::vector<BakedPage>& pages);
    void put_pages(const TileKey& tile, const AttributeMaps& maps, std::vector<BakedPage>& pages);
    [[nodiscard]] BakedPage placed(const terrain::ChunkKey& chunk, const terrain::AttributePage& page);
    [[nodiscard]] std::unique_ptr<Sight> new_sight() const;

    const BuildPlan& plan_;
    const TdbLayout& layout_;
    const InsetCoverage& coverage_;
    const HeightLevels& heights_;
    PartStore& store_;
    std::vector<Task> tasks_;
    IdlePool<Sight> sights_;
};

}  // namespace tedavis::host_sim
