/// The surface over the posts: operators of surface generation of the thesis (6.2.2.2).
#pragma once

#include "render_core/raytrace/surface/micro_structure.hpp"

namespace tedavis::raytrace {

enum class SurfaceKind : std::uint8_t {
    two_triangles,        ///< the true surface of a terrain database
    bilinear,             ///< creases at the sides of cells
    bicubic,              ///< smooth; bicubic_patch.hpp
    approximate_bicubic,  ///< bilinear between points of the bicubic surface
};

[[nodiscard]] constexpr bool is_cubic(SurfaceKind kind) {
    return kind == SurfaceKind::bicubic || kind == SurfaceKind::approximate_bicubic;
}

struct SurfaceSettings {
    static constexpr std::uint32_t kMaxSubdivisions = 64;

    SurfaceKind kind = SurfaceKind::bilinear;
    std::uint32_t subdivisions = 4;  ///< subdivisions of a cell in each direction for approximate_bicubic; 1..kMaxSubdivisions
    MicroStructure micro;
};

}  // namespace tedavis::raytrace
