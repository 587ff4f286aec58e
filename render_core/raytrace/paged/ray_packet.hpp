/// A packet of rays at one chunk, and the kernels of the paged tracer that process it.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/raytrace/kernel/traced_nodes.hpp"
#include "render_core/raytrace/ray.hpp"
#include "render_core/raytrace/trace_ray.hpp"

namespace tedavis::raytrace {

/// Arrays of lanes: the input and output of a kernel. Bit n of a set is lane n.
struct RayPacket {
    static constexpr std::uint32_t kMaxLanes = 32;
    using Floats = float[kMaxLanes];
    using Ints = std::int32_t[kMaxLanes];

    Ints column, row, z;  ///< whole part of the origin, with its fraction below
    Floats column_fraction, row_fraction, z_fraction;
    Floats direction_x, direction_y, direction_z, from, to, gap;

    Floats t;                      ///< current time of the rays
    Ints at_column, at_row;        ///< current cell, mirrored
    std::uint32_t begin = 0;       ///< rays that enter the grid at `from`
    std::uint32_t pass = 0;        ///< rays that continue behind their chunk
    std::uint32_t ask = 0;         ///< output: rays that wait for a chunk
    Ints chunk_column, chunk_row;  ///< output: their chunks

    std::uint32_t hit = 0, beyond = 0;  ///< output: rays with a hit, and those beyond the surface at their entry (CellHit)
    Floats hit_t;
    Ints hit_column, hit_row;  ///< cell of the hit in the grid
};

template <class Height>
struct PacketKernel {
    const char* name = "";
    std::uint32_t lanes = 1;
    /// Traverses a chunk, whose first cell is (column, row), with the rays of `asked`; `nodes` are its posts and bounds.
    void (*cross)(const TracedNodes<Height>& nodes, CellSurface surface, HitSide side, std::int32_t column, std::int32_t row,
                  std::uint32_t asked, RayPacket& packet) = nullptr;
    /// Advances the rays that begin or pass, of one side, to the next chunk that they may hit. `nodes` are the bounds of that
    /// side from kChunkLevel up.
    void (*seek)(const TracedNodes<Height>& nodes, HitSide side, std::uint32_t asked, RayPacket& packet) = nullptr;
};

/// Returns the kernels that this machine can run, the widest first; the last one is scalar and runs everywhere. All give the
/// same bits.
template <class Height>
[[nodiscard]] base::Span<const PacketKernel<Height>> packet_kernels();

}  // namespace tedavis::raytrace
