/// The kernels that trace bands of pictures, of each width of lanes that this build has; which of them a machine can run is found
/// out at run time. All give the same bits.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/span.hpp"
#include "render_core/raytrace/trace_ray.hpp"

namespace tedavis::raytrace {

/// Of rays through pixel (x, y), 0 at the upper left: origin + t * (corner + (x + 0.5) * right + (y + 0.5) * down), in grid
/// space.
struct GridCamera {
    glm::dvec3 origin{0};
    glm::vec3 corner{0}, right{0}, down{0};

    [[nodiscard]] Ray ray(std::uint32_t x, std::uint32_t y) const;
    /// All rays of a column lie in one vertical plane, and no two are the same.
    [[nodiscard]] bool has_upright_columns() const { return down.x == 0 && down.y == 0 && down.z != 0; }
};

/// Sides of beams, in pixels: kBeamSide[0] is found first, each further one starts where the one round it ended.
inline constexpr int kBeamSizes = 4;
inline constexpr std::uint32_t kBeamSide[kBeamSizes] = {32, 16, 8, 4};
inline constexpr std::uint32_t kBandRows = kBeamSide[0];

/// How far beams of one size got, row by row.
struct BeamStarts {
    std::uint32_t across = 0, down = 0;
    base::Span<float> t;
    base::Span<std::int32_t> level;  ///< of nodes that they were over last
};

template <class Height>
struct ViewJob {
    const TracedField<Height>* field = nullptr;
    const GridCamera* camera = nullptr;
    std::uint32_t width = 0, height = 0;
    const BeamStarts* beams = nullptr;  ///< kBeamSizes
    float* t = nullptr;
    std::int32_t* cell = nullptr;
    HitSide* side = nullptr;
};

template <class Height>
struct ViewKernel {
    const char* name = "";
    int lanes = 1;
    /// Rows [kBandRows * band, kBandRows * (band + 1)) of the picture.
    void (*trace_band)(const ViewJob<Height>& job, std::uint32_t band) = nullptr;
    /// Columns [lanes * group, lanes * (group + 1)), where GridCamera::has_upright_columns().
    void (*trace_columns)(const ViewJob<Height>& job, std::uint32_t group) = nullptr;
};

/// One pixel as trace_ray() finds it: for rays that leave a kernel's way.
template <class Height>
void trace_pixel(const ViewJob<Height>& job, std::uint32_t x, std::uint32_t y);

/// Those that this machine can run, the widest first; the last one is scalar and runs everywhere.
template <class Height>
[[nodiscard]] base::Span<const ViewKernel<Height>> view_kernels();

}  // namespace tedavis::raytrace
