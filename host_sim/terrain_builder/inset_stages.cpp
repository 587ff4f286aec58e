#include "host_sim/terrain_builder/inset_stages.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

using namespace terrain;
using Finish = std::function<void()>;
using Stages = std::vector<BuildStage>;

// Processor time, microseconds a fine post.
constexpr double kImportCost = 0.3, kGroundCost = 0.1, kChunkCost = 3, kProofCost = 0.5;

double posts_of(const InsetRegion& region) {
    const PostRange& r = region.posts.region();
    return static_cast<double>(r.i1 - r.i0) * (r.j1 - r.j0);
}

/// A stage over the blocks of a region.
template <class Task>
BuildStage block_stage(const BuildParts& p, InsetRegion& region, std::string_view name, double cost, Task task) {
    const Lattice& lattice = p.plan.fine.lattice;
    return plain_stage(name, cost * posts_of(region), region.blocks.count(), [&region, &lattice, task](std::uint32_t block) {
        const ChunkKey key = region.blocks.chunk(block);
        task(key, lattice.posts_of(key));
    });
}

void add_ground_stages(BuildParts& p, InsetRegion& region, Stages& stages) {
    for (std::uint32_t m = 1; m < p.plan.coverage.base_level(); ++m)
        stages.push_back(plain_stage("insets", kGroundCost * posts_of(region) / (1u << (2 * m)), region.pyramid.block_count(m),
                                     [&region, m](std::uint32_t block) { region.pyramid.build_block(m, block); }));
    stages.push_back(block_stage(p, region, "insets", kGroundCost,
                                 [&region](const ChunkKey&, const PostRange& posts) { region.import.fill_voids(posts); }));
    stages.push_back(block_stage(p, region, "insets", kGroundCost,
                                 [&region](const ChunkKey& key, const PostRange&) { region.slopes.measure(key); }));
    stages.push_back(block_stage(p, region, "insets", kGroundCost,
                                 [&region](const ChunkKey& key, const PostRange&) { region.lines.build(key); }));
}

void keep(BuildParts& p, const std::vector<IrregularChunk>& chunks) {
    for (const IrregularChunk& chunk : chunks) {
        ChunkEntry entry = chunk.entry;
        entry.payload.offset =
            p.append(ChunkPart::irregular, key_of(entry), entry.payload, {chunk.payload.data(), chunk.payload.size()});
        p.entries.write(entry);
    }
}

void add_chunks(BuildParts& p, InsetRegion& region, Stages& stages) {
    stages.push_back({"insets", kChunkCost * posts_of(region), [&region] { return region.blocks.count(); },
                      [&p, &region](std::uint32_t block) {
                          const ChunkKey key = region.blocks.chunk(block);
                          return Finish([&p, made = build_inset_block(region.sources, p.plan.coverage, key)] { keep(p, made); });
                      }});
}

void add_proof(BuildParts& p, InsetRegion& region, Stages& stages) {
    stages.push_back({"insets", kProofCost * posts_of(region), [&region] { return region.blocks.count(); },
                      [&p, &region](std::uint32_t block) {
                          const ChunkKey key = region.blocks.chunk(block);
                          std::vector<CoarseErrors> errors;
                          if (p.plan.coverage.has_children(key))
                              errors = measure_inset_block(region.sources, p.chunks, p.coarse_entries, key);
                          return Finish([&p, errors] { p.inset_proof.include(errors); });
                      }});
}

/// Coarse entries state the larger of what coarse and fine posts say; their boxes hold both.
void state_changed(BuildParts& p) {
    for (const auto& [key, errors] : p.inset_proof.all()) {
        const ChunkEntry coarse = p.coarse_entries.read({key.level - p.plan.coverage.base_level(), key.i, key.j});
        ChunkEntry changed = coarse;
        errors.state(changed);
        changed.above_m = std::max(changed.above_m, coarse.above_m);
        changed.below_m = std::max(changed.below_m, coarse.below_m);
        changed.strip_above_m = std::max(changed.strip_above_m, coarse.strip_above_m);
        changed.strip_below_m = std::max(changed.strip_below_m, coarse.strip_below_m);
        changed.level = static_cast<std::uint8_t>(key.level);
        p.entries.write(changed);
    }
}

/// Calls action(key) for all chunks of a level that exist in a region.
template <class Action>
void for_chunks(const BuildParts& p, const PostRange& region, std::uint32_t level, Action action) {
    const std::uint32_t cells = kChunkCells << level;
    for (std::uint32_t j = region.j0 / cells; j * cells < region.j1; ++j)
        for (std::uint32_t i = region.i0 / cells; i * cells < region.i1; ++i)
            if (p.plan.coverage.exists({level, i, j})) action(ChunkKey{level, i, j});
}

}  // namespace

void add_inset_post_stages(BuildParts& p, Stages& stages) {
    for (const auto& region : p.regions)
        stages.push_back({"insets", kImportCost, [r = region.get()] { return r->blocks.count(); },
                          [&p, r = region.get()](std::uint32_t block) {
                              const PostStatistics found = r->import.import(p.plan.fine.lattice.posts_of(r->blocks.chunk(block)));
                              return Finish([&p, found] { p.record.statistics.include_heights(found); });
                          }});
    // No sooner than all fine posts are made from the coarse ones as the raster has them.
    for (const auto& region : p.regions)
        stages.push_back(block_stage(p, *region, "insets", 0, [&p, r = region.get()](const ChunkKey&, const PostRange& posts) {
            r->import.write_back(posts, p.posts);
        }));
}

void add_inset_chunk_stages(BuildParts& p, Stages& stages) {
    for (const auto& region : p.regions) {
        add_ground_stages(p, *region, stages);
        add_chunks(p, *region, stages);
        add_proof(p, *region, stages);
    }
    if (!p.regions.empty()) stages.push_back(plain_stage("insets", 0, 1, [&p](std::uint32_t) { state_changed(p); }));
}

void add_inset_entry_stages(BuildParts& p, Stages& stages) {
    for (std::uint32_t level = 0; level < p.plan.coverage.base_level(); ++level)
        for (const auto& region : p.regions)
            stages.push_back(plain_stage("insets", 0, 1, [&p, level, r = region.get()](std::uint32_t) {
                for_chunks(p, r->posts.region(), level, [&p](const ChunkKey& key) { finish_entry(p.directory, key); });
            }));
}

std::uint64_t inset_chunk_count(const BuildParts& p) {
    std::uint64_t count = 0;
    for (std::uint32_t level = 0; level < p.plan.coverage.base_level(); ++level)
        for (const PostRange& region : p.plan.coverage.regions())
            for_chunks(p, region, level, [&count](const ChunkKey&) { ++count; });
    return count;
}

}  // namespace tedavis::host_sim
