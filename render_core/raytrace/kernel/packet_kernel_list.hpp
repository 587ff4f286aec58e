/// Functions of the paged tracer for each width of lanes, as in view_kernel_list.hpp.
#pragma once

#include "render_core/raytrace/paged/ray_packet.hpp"

namespace tedavis::raytrace {

template <class Height>
struct PacketFunctions {
    using Cross = void(const TracedNodes<Height>&, CellSurface, HitSide, std::int32_t, std::int32_t, std::uint32_t, RayPacket&);
    using Seek = void(const TracedNodes<Height>&, HitSide, std::uint32_t, RayPacket&);
};

PacketFunctions<std::int16_t>::Cross cross_scalar, cross_vector4, cross_vector8, cross_vector16;
PacketFunctions<float>::Cross cross_scalar, cross_vector4, cross_vector8, cross_vector16;
PacketFunctions<std::int16_t>::Seek seek_scalar, seek_vector4, seek_vector8, seek_vector16;
PacketFunctions<float>::Seek seek_scalar, seek_vector4, seek_vector8, seek_vector16;

}  // namespace tedavis::raytrace
