/// Functions for each width of lanes, each width in a source of its own: wider ones are compiled for their instructions.
#pragma once

#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

void trace_band_scalar(const ViewJob<std::int16_t>& job, std::uint32_t band);
void trace_band_scalar(const ViewJob<float>& job, std::uint32_t band);
void trace_columns_scalar(const ViewJob<std::int16_t>& job, std::uint32_t group);
void trace_columns_scalar(const ViewJob<float>& job, std::uint32_t group);
void trace_band_vector4(const ViewJob<std::int16_t>& job, std::uint32_t band);
void trace_band_vector4(const ViewJob<float>& job, std::uint32_t band);
void trace_columns_vector4(const ViewJob<std::int16_t>& job, std::uint32_t group);
void trace_columns_vector4(const ViewJob<float>& job, std::uint32_t group);
void trace_band_vector8(const ViewJob<std::int16_t>& job, std::uint32_t band);
void trace_band_vector8(const ViewJob<float>& job, std::uint32_t band);
void trace_columns_vector8(const ViewJob<std::int16_t>& job, std::uint32_t group);
void trace_columns_vector8(const ViewJob<float>& job, std::uint32_t group);
void trace_band_vector16(const ViewJob<std::int16_t>& job, std::uint32_t band);
void trace_band_vector16(const ViewJob<float>& job, std::uint32_t band);
void trace_columns_vector16(const ViewJob<std::int16_t>& job, std::uint32_t group);
void trace_columns_vector16(const ViewJob<float>& job, std::uint32_t group);

}  // namespace tedavis::raytrace
