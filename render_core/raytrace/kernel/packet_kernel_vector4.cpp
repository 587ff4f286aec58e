#include "render_core/raytrace/kernel/march_chunks.hpp"
#include "render_core/raytrace/kernel/packet_kernel_list.hpp"
#include "render_core/raytrace/lanes/vector_lanes.hpp"

namespace tedavis::raytrace {

void cross_vector4(const TracedNodes<std::int16_t>& nodes, CellSurface surface, HitSide side, std::int32_t column,
                   std::int32_t row, std::uint32_t asked, RayPacket& packet) {
    cross_with<VectorLanes<4>>(nodes, surface, side, column, row, asked, packet);
}
void seek_vector4(const TracedNodes<std::int16_t>& nodes, HitSide side, std::uint32_t asked, RayPacket& packet) {
    seek_with<VectorLanes<4>>(nodes, side, asked, packet);
}
void cross_vector4(const TracedNodes<float>& nodes, CellSurface surface, HitSide side, std::int32_t column, std::int32_t row,
                   std::uint32_t asked, RayPacket& packet) {
    cross_with<VectorLanes<4>>(nodes, surface, side, column, row, asked, packet);
}
void seek_vector4(const TracedNodes<float>& nodes, HitSide side, std::uint32_t asked, RayPacket& packet) {
    seek_with<VectorLanes<4>>(nodes, side, asked, packet);
}

}  // namespace tedavis::raytrace
