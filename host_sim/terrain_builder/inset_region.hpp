/// One region of insets while a terrain is built, with all sources of its chunks.
#pragma once

#include <string>

#include "host_sim/terrain_builder/entry_book.hpp"
#include "host_sim/terrain_builder/fine_unit.hpp"
#include "host_sim/terrain_builder/inset_lines.hpp"
#include "host_sim/terrain_builder/inset_pyramid.hpp"
#include "host_sim/terrain_builder/inset_slopes.hpp"
#include "host_sim/terrain_builder/terrain_sources.hpp"

namespace tedavis::host_sim {

struct InsetRegion {
    /// The coarse terrain's parts must outlive this object. The paths of its work files begin with `path`.
    InsetRegion(TerrainPlan& plan, const terrain::PostRange& region, const ChunkSources& coarse, const PostsFile& coarse_posts,
                const BorderLines& coarse_lines, const SlopeMap& coarse_slopes, const std::string& path)
        : blocks(region, plan.coverage.base_level()),
          posts(coarse_posts, plan.coverage.base_level(), region, path + ".posts"),
          import(plan.insets, posts, coarse_posts, plan.coverage.base_level()),
          pyramid(posts, coarse_posts, plan.coverage.base_level(), path),
          lines(plan.fine, plan.coverage, coarse_lines, posts, path),
          slopes(plan.fine, coarse_slopes, plan.coverage.base_level(), posts, path + ".slopes"),
          sources{plan.fine, coarse.layout, posts, lines, slopes, coarse.store} {}

    void sync() {
        posts.sync();
        pyramid.sync();
        lines.sync();
        slopes.sync();
    }

    RegionBlocks blocks;
    InsetPosts posts;
    InsetImport import;
    RegionPyramid pyramid;
    InsetLines lines;
    InsetSlopes slopes;
    ChunkSources sources;
};

}  // namespace tedavis::host_sim
