#include "render_core/raytrace/kernel/view_band.hpp"
#include "render_core/raytrace/kernel/view_kernel_list.hpp"
#include "render_core/raytrace/lanes/scalar_lanes.hpp"

namespace tedavis::raytrace {

void trace_band_scalar(const ViewJob<std::int16_t>& job, std::uint32_t band) { trace_band<ScalarLanes>(job, band); }
void trace_band_scalar(const ViewJob<float>& job, std::uint32_t band) { trace_band<ScalarLanes>(job, band); }
void trace_columns_scalar(const ViewJob<std::int16_t>& job, std::uint32_t group) { trace_columns<ScalarLanes>(job, group); }
void trace_columns_scalar(const ViewJob<float>& job, std::uint32_t group) { trace_columns<ScalarLanes>(job, group); }

}  // namespace tedavis::raytrace
