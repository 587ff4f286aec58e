/// Functions for each width of lanes. Each width has its own source file, compiled for its instruction set.
#pragma once

#include "render_core/raytrace/view_kernels.hpp"

namespace tedavis::raytrace {

void trace_tile_scalar(const ViewJob<std::int16_t>& job, std::uint32_t left, std::uint32_t top);
void trace_tile_scalar(const ViewJob<float>& job, std::uint32_t left, std::uint32_t top);
void trace_tile_vector4(const ViewJob<std::int16_t>& job, std::uint32_t left, std::uint32_t top);
void trace_tile_vector4(const ViewJob<float>& job, std::uint32_t left, std::uint32_t top);
void trace_tile_vector8(const ViewJob<std::int16_t>& job, std::uint32_t left, std::uint32_t top);
void trace_tile_vector8(const ViewJob<float>& job, std::uint32_t left, std::uint32_t top);
void trace_tile_vector16(const ViewJob<std::int16_t>& job, std::uint32_t left, std::uint32_t top);
void trace_tile_vector16(const ViewJob<float>& job, std::uint32_t left, std::uint32_t top);

}  // namespace tedavis::raytrace
