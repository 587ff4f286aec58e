#include "render_core/raytrace/kernel/march_chunks.hpp"
#include "render_core/raytrace/kernel/packet_kernel_list.hpp"
#include "render_core/raytrace/lanes/scalar_lanes.hpp"

namespace tedavis::raytrace {

void cross_scalar(const TracedNodes<std::int16_t>& nodes, CellSurface surface, HitSide side, std::int32_t column,
                  std::int32_t row, std::uint32_t asked, RayPacket& packet) {
    cross_with<ScalarLanes>(nodes, surface, side, column, row, asked, packet);
}
void seek_scalar(const TracedNodes<std::int16_t>& nodes, HitSide side, std::uint32_t asked, RayPacket& packet) {
    seek_with<ScalarLanes>(nodes, side, asked, packet);
}
void cross_scalar(const TracedNodes<float>& nodes, CellSurface surface, HitSide side, std::int32_t column, std::int32_t row,
                  std::uint32_t asked, RayPacket& packet) {
    cross_with<ScalarLanes>(nodes, surface, side, column, row, asked, packet);
}
void seek_scalar(const TracedNodes<float>& nodes, HitSide side, std::uint32_t asked, RayPacket& packet) {
    seek_with<ScalarLanes>(nodes, side, asked, packet);
}

}  // namespace tedavis::raytrace
