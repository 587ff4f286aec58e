/// Rays that stand before one chunk, as the kernels of the paged tracer take them; and those kernels.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/raytrace/kernel/traced_nodes.hpp"
#include "render_core/raytrace/ray.hpp"
#include "render_core/raytrace/trace_ray.hpp"

namespace tedavis::raytrace {

/// Arrays of lanes: all that a kernel reads and writes. Bit n of a set is lane n.
struct RayPacket {
    static constexpr std::uint32_t kMaxLanes = 32;
    using Floats = float[kMaxLanes];
    using Ints = std::int32_t[kMaxLanes];

    Ints column, row, z;  ///< whole part of the origin, and what is left
    Floats column_fraction, row_fraction, z_fraction;
    Floats direction_x, direction_y, direction_z, from, to, gap;

    Floats t;                      ///< where rays are
    Ints at_column, at_row;        ///< mirrored: of the cell there
    std::uint32_t begin = 0;       ///< enter the grid at `from`
    std::uint32_t pass = 0;        ///< go on behind the chunk that they are in
    std::uint32_t ask = 0;         ///< out: stand before a chunk
    Ints chunk_column, chunk_row;  ///< out: of those

    std::uint32_t met = 0, beyond = 0;  ///< out
    Floats met_t;
    Ints met_column, met_row;  ///< in the grid
};

template <class Height>
struct PacketKernel {
    const char* name = "";
    std::uint32_t lanes = 1;
    /// The rays of `asked` through a chunk whose first cell is (column, row); its posts and bounds are `nodes`.
    void (*cross)(const TracedNodes<Height>& nodes, CellSurface surface, HitSide side, std::int32_t column, std::int32_t row,
                  std::uint32_t asked, RayPacket& packet) = nullptr;
    /// Those that begin or pass, of one side, on to the next chunk that they may meet. Bounds of that side from kChunkLevel up.
    void (*seek)(const TracedNodes<Height>& nodes, HitSide side, std::uint32_t asked, RayPacket& packet) = nullptr;
};

/// Those that this machine can run, the widest first; the last one is scalar and runs everywhere. All give the same bits.
template <class Height>
[[nodiscard]] base::Span<const PacketKernel<Height>> packet_kernels();

}  // namespace tedavis::raytrace
