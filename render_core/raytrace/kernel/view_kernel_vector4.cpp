#include "render_core/raytrace/kernel/view_kernel_list.hpp"
#include "render_core/raytrace/kernel/view_tile.hpp"
#include "render_core/raytrace/lanes/vector_lanes.hpp"

namespace tedavis::raytrace {

void trace_tile_vector4(const ViewJob<std::int16_t>& job, std::uint32_t left, std::uint32_t top) {
    trace_tile<VectorLanes<4>>(job, left, top);
}
void trace_tile_vector4(const ViewJob<float>& job, std::uint32_t left, std::uint32_t top) {
    trace_tile<VectorLanes<4>>(job, left, top);
}

}  // namespace tedavis::raytrace
