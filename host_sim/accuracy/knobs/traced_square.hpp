/// A square part of a terrain with rays over it, on which the knobs of the ray tracer are measured.
#pragma once

#include <cstdint>
#include <vector>

#include "host_sim/tracing/traced_ground.hpp"
#include "render_core/raytrace/height_mipmap.hpp"
#include "render_core/raytrace/ray.hpp"
#include "render_core/raytrace/surface/surface_point.hpp"
#include "render_core/raytrace/surface/surface_settings.hpp"

namespace tedavis::host_sim {

class TracedSquare {
public:
    static constexpr std::uint32_t kMaxSide = 769;

    /// The middle of the ground, at most kMaxSide posts along a side.
    explicit TracedSquare(const TracedGround& ground);

    /// Metres above MSL, grid space (height_grid.hpp).
    [[nodiscard]] raytrace::HeightGrid<float> grid() const { return {posts_.data(), columns_, rows_, columns_}; }
    /// Scale of the grid at the middle row; heights are in metres.
    [[nodiscard]] const raytrace::GridScale& scale() const { return scale_; }
    [[nodiscard]] double cell_m() const { return scale_.column_m; }

private:
    template <class Height>
    void take(const raytrace::HeightGrid<Height>& all, double step_m);

    std::vector<float> posts_;
    std::uint32_t columns_ = 0, rows_ = 0;
    raytrace::GridScale scale_;
};

/// The bounds of a surface over a square.
class BoundedSurface {
public:
    BoundedSurface(const TracedSquare& square, const raytrace::SurfaceSettings& surface);
    BoundedSurface(const BoundedSurface&) = delete;
    BoundedSurface& operator=(const BoundedSurface&) = delete;

    [[nodiscard]] const raytrace::HeightMipmap<float>& maxima() const { return maxima_; }
    [[nodiscard]] const raytrace::SurfaceSettings& settings() const { return settings_; }
    [[nodiscard]] std::uint64_t bytes() const { return memory_.size(); }
    [[nodiscard]] double build_ms() const { return build_ms_; }

private:
    raytrace::SurfaceSettings settings_;
    std::vector<unsigned char> memory_;
    raytrace::HeightMipmap<float> maxima_;
    double build_ms_ = 0;
};

/// Returns rays from above the western border, 150 to 900 m above the ground, eastwards and 0.5 to 8 degrees down.
[[nodiscard]] std::vector<raytrace::Ray> rays_over(const TracedSquare& square, std::size_t count, std::uint64_t seed);
/// The ray parameter t at which a ray of rays_over() leaves the square.
[[nodiscard]] double end_over(const TracedSquare& square, const raytrace::Ray& ray);
/// "the ray from column 0, row 17.2, height 812 m, along (1, 0.21, -3.1)"
[[nodiscard]] std::string ray_text(const raytrace::Ray& ray);

}  // namespace tedavis::host_sim
