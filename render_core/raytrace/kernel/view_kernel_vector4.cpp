#include "render_core/raytrace/kernel/view_band.hpp"
#include "render_core/raytrace/kernel/view_kernel_list.hpp"
#include "render_core/raytrace/lanes/vector_lanes.hpp"

namespace tedavis::raytrace {

void trace_band_vector4(const ViewJob<std::int16_t>& job, std::uint32_t band) { trace_band<VectorLanes<4>>(job, band); }
void trace_band_vector4(const ViewJob<float>& job, std::uint32_t band) { trace_band<VectorLanes<4>>(job, band); }
void trace_columns_vector4(const ViewJob<std::int16_t>& job, std::uint32_t group) { trace_columns<VectorLanes<4>>(job, group); }
void trace_columns_vector4(const ViewJob<float>& job, std::uint32_t group) { trace_columns<VectorLanes<4>>(job, group); }

}  // namespace tedavis::raytrace
