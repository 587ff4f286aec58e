/// Work at seams whose result depends on whether the compiler may fuse a multiplication with an addition, once as the project is
/// compiled and once with leave to fuse: what the flag -ffp-contract=off is there for, and the control of the tests that rely on
/// it.
#pragma once

#include <cstdint>

#include "render_core/raytrace/trace_ray.hpp"

namespace tedavis::test_support {

/// Two triangles on either side of an edge, and points on it, as far as floats can say (NUMERICS, finding 1).
struct EdgeSeams {
    std::uint64_t points = 0;
    std::uint64_t uneven = 0;  ///< the edge and its reverse have edge functions that are not each other's negative
    std::uint64_t gaps = 0;    ///< the point lies outside of both triangles
};

struct SeamsAsCompiled {
    EdgeSeams (*edges)(std::uint64_t points);
    /// trace_ray() over two triangles, from above, made of the same kernel.
    raytrace::Hit (*trace)(const raytrace::HeightMipmap<std::int16_t>& maxima, const raytrace::Ray& ray);
};

SeamsAsCompiled seams_as_the_project();
/// Must not be used where the machine has no such instruction.
SeamsAsCompiled seams_fused();
[[nodiscard]] bool has_fused_instructions();

}  // namespace tedavis::test_support
