#ifdef __AVX512VL__  // compiled for it alone, where the compiler can
#include "render_core/raytrace/kernel/view_kernel_list.hpp"
#include "render_core/raytrace/kernel/view_tile.hpp"
#include "render_core/raytrace/lanes/avx512_lanes.hpp"
#include "render_core/raytrace/lanes/paired_lanes.hpp"

namespace tedavis::raytrace {

void trace_tile_vector16(const ViewJob<std::int16_t>& job, std::uint32_t left, std::uint32_t top) {
    trace_tile<PairedLanes<Avx512Lanes>>(job, left, top);
}
void trace_tile_vector16(const ViewJob<float>& job, std::uint32_t left, std::uint32_t top) {
    trace_tile<PairedLanes<Avx512Lanes>>(job, left, top);
}

}  // namespace tedavis::raytrace
#endif
