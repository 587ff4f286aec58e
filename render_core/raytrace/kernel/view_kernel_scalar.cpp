#include "render_core/raytrace/kernel/view_kernel_list.hpp"
#include "render_core/raytrace/kernel/view_tile.hpp"
#include "render_core/raytrace/lanes/scalar_lanes.hpp"

namespace tedavis::raytrace {

void trace_tile_scalar(const ViewJob<std::int16_t>& job, std::uint32_t left, std::uint32_t top) {
    trace_tile<ScalarLanes>(job, left, top);
}
void trace_tile_scalar(const ViewJob<float>& job, std::uint32_t left, std::uint32_t top) {
    trace_tile<ScalarLanes>(job, left, top);
}

}  // namespace tedavis::raytrace
