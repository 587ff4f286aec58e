/// Draws pictures of ground that is larger than the allowed memory: chunks of heights are read when rays need them
/// (render_core/raytrace/paged). The pixels equal those of the ground in memory, bit for bit.
#pragma once

#include "host_sim/tracing/shot_drawer.hpp"
#include "render_core/raytrace/paged/database_chunks.hpp"
#include "render_core/raytrace/picture/paged_terrain.hpp"

namespace tedavis::host_sim {

class PagedDrawer {
public:
    /// ground.is_paged() must be true, and require_pageable() must hold for the settings. Throws UserError where the memory is
    /// too small for the bounds of the chunks and one chunk for each worker, or the tracer cannot trace from the pose.
    PagedDrawer(const TracedGround& ground, const raytrace::TraceSettings& settings, const TracedShotPlan& plan,
                base::Workers& workers);
    PagedDrawer(const PagedDrawer&) = delete;
    PagedDrawer& operator=(const PagedDrawer&) = delete;

    /// Reads the bounds of chunks. Throws UserError where they are damaged.
    void build(const TracedGround& ground, base::Workers& workers);
    /// As ShotDrawer::draw(). Throws UserError where chunks that rays need are damaged.
    std::uint32_t draw(const raytrace::TraceLook& look, base::Span<const std::uint8_t> regions, bool is_direct,
                       base::Workers& workers);
    void tell(TracedShot& shot) const;

private:
    void divide_memory(const TracedGround& ground, const TracedShotPlan& plan, std::uint32_t desks);
    [[noreturn]] void refuse_damage(std::uint32_t parts, const char* what) const;

    std::string path_;
    raytrace::PagedSettings paging_;
    PagedUse use_;
    std::vector<std::uint64_t> memory_;
    base::Arena arena_{nullptr, 0};
    raytrace::DatabaseChunks chunks_;
    raytrace::PagedTracer<float> tracer_;
    raytrace::PagedTerrain terrain_;
    raytrace::CellSurface surface_;
    ShotDrawer<float> drawer_;
};

}  // namespace tedavis::host_sim
