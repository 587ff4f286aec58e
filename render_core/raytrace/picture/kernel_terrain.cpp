#include "render_core/raytrace/picture/kernel_terrain.hpp"

#include <algorithm>

#include "render_core/raytrace/surface/cell_patch.hpp"

namespace tedavis::raytrace {
namespace {

std::uint32_t beams_across(std::uint32_t pixels, int size) { return (pixels + kBeamSide[size] - 1) / kBeamSide[size]; }

/// Height and slopes at (u, v) of the cell whose first post is `post`; in posts and steps of the grid itself.
template <class Height, CellSurface surface>
void surface_in_cell(const Height* post, std::uint32_t stride, float u, float v, float& height, float& slope_x, float& slope_y) {
    const auto a = static_cast<float>(post[0]), b = static_cast<float>(post[1]);
    const auto c = static_cast<float>(post[stride]), d = static_cast<float>(post[stride + 1]);
    if constexpr (surface == CellSurface::bilinear) {
        slope_x = (1 - v) * (b - a) + v * (d - c);
        slope_y = (1 - u) * (c - a) + u * (d - b);
        height = a + u * (b - a) + v * slope_y;
    } else {
        const bool is_first = u + v <= 1;
        slope_x = is_first ? b - a : d - c;
        slope_y = is_first ? c - a : d - b;
        height = is_first ? a + u * slope_x + v * slope_y : d - (1 - u) * slope_x - (1 - v) * slope_y;
    }
}

/// Of rays from `origin`, in the grid's own posts, to where they met a cell.
template <class Height, CellSurface surface>
void surface_of_span(const HeightGrid<Height>& grid, std::uint32_t parts, const GridCamera& camera, std::uint32_t left,
                     std::uint32_t line, const float* t, const std::int32_t* cell, SpanSurface& out) {
    const std::uint32_t cells = grid.columns - 1;
    const double each = 1.0 / parts, y_of_row = line + 0.5;
    const double from_x = camera.corner.x + y_of_row * camera.down.x, from_y = camera.corner.y + y_of_row * camera.down.y;
    for (std::uint32_t n = 0; n < out.count; ++n) {
        out.is_met[n] = cell[n] >= 0;
        const std::uint32_t place = out.is_met[n] ? static_cast<std::uint32_t>(cell[n]) : 0;
        const std::uint32_t row = place / cells, column = place - row * cells;
        const double at = out.is_met[n] ? double{t[n]} : 0, middle = left + n + 0.5;
        const double x = camera.origin.x + at * (from_x + middle * camera.right.x) - column;
        const double y = camera.origin.y + at * (from_y + middle * camera.right.y) - row;
        const double u = std::min(std::max(x, 0.0), 1.0), v = std::min(std::max(y, 0.0), 1.0);
        surface_in_cell<Height, surface>(grid.row(row) + column, grid.stride, static_cast<float>(u), static_cast<float>(v),
                                         out.height[n], out.slope_x[n], out.slope_y[n]);
        out.slope_x[n] *= static_cast<float>(parts);
        out.slope_y[n] *= static_cast<float>(parts);
        out.x[n] = (column + u) * each;
        out.y[n] = (row + v) * each;
        out.t[n] = static_cast<float>(at);
    }
}

}  // namespace

template <class Height>
std::uint64_t KernelTerrain<Height>::bytes_needed(std::uint32_t width, std::uint32_t height) {
    return ViewTracer<Height>::bytes_needed(width, height);
}

template <class Height>
bool KernelTerrain<Height>::start(const TracedField<Height>& field, std::uint32_t parts, std::uint32_t width,
                                  std::uint32_t height, base::Arena& arena) {
    TEDAVIS_CHECK(parts > 0 && width > 0 && height > 0);
    field_ = field;
    parts_ = parts;
    width_ = width;
    height_ = height;
    for (int n = 0; n < kBeamSizes; ++n) {
        beams_[n].across = beams_across(width, n);
        beams_[n].down = beams_across(height, n);
        beams_[n].t = arena.allocate_array<float>(std::size_t{beams_[n].across} * beams_[n].down);
        beams_[n].level = arena.allocate_array<std::int32_t>(std::size_t{beams_[n].across} * beams_[n].down);
        if (beams_[n].t.empty() || beams_[n].level.empty()) return false;
    }
    return true;
}

template <class Height>
void KernelTerrain<Height>::set_view(const GridCamera& camera, const ViewKernel<Height>& kernel) {
    const auto scaled = [&](const glm::vec3& v) {
        return glm::vec3(v.x * static_cast<float>(parts_), v.y * static_cast<float>(parts_), v.z);
    };
    camera_ = {{camera.origin.x * parts_, camera.origin.y * parts_, camera.origin.z},
               scaled(camera.corner),
               scaled(camera.right),
               scaled(camera.down)};
    kernel_ = &kernel;
}

template <class Height>
void KernelTerrain<Height>::trace(const PixelRect& rect, const HitPicture& hits) const {
    const ViewJob<Height> job = {&field_, &camera_, width_, height_, beams_, hits.t.data(), hits.cell.data(), hits.side.data()};
    const auto lanes = static_cast<std::uint32_t>(kernel_->lanes);
    const bool is_upright = camera_.has_upright_columns();
    const bool is_band = rect.x == 0 && rect.width == width_ && rect.y % kBandRows == 0 &&
                         (rect.height == kBandRows || rect.y + rect.height == height_) && rect.height <= kBandRows;
    const bool is_group = rect.y == 0 && rect.height == height_ && rect.x % lanes == 0 &&
                          (rect.width == lanes || rect.x + rect.width == width_) && rect.width <= lanes;
    if (is_upright && is_group) return kernel_->trace_columns(job, rect.x / lanes);
    if (!is_upright && is_band) return kernel_->trace_band(job, rect.y / kBandRows);
    for (std::uint32_t y = rect.y; y < rect.y + rect.height; ++y)
        for (std::uint32_t x = rect.x; x < rect.x + rect.width; ++x) trace_pixel(job, x, y);
}

template <class Height>
void KernelTerrain<Height>::find_surface(const PixelSpan& span, const HitPicture& hits, SpanSurface& surface) const {
    TEDAVIS_CHECK(span.count <= PixelSpan::kMost && std::size_t{span.first} + span.count <= hits.t.size());
    surface.count = span.count;
    const std::uint32_t line = span.first / width_, left = span.first - line * width_;
    const auto find = field_.surface == CellSurface::bilinear ? surface_of_span<Height, CellSurface::bilinear>
                                                              : surface_of_span<Height, CellSurface::two_triangles>;
    find(field_.grid(), parts_, camera_, left, line, hits.t.data() + span.first, hits.cell.data() + span.first, surface);
}

template <class Height>
Ray KernelTerrain<Height>::own_ray(const Ray& ray) const {
    Ray own = ray;
    own.origin.x *= parts_;
    own.origin.y *= parts_;
    own.direction.x *= static_cast<float>(parts_);
    own.direction.y *= static_cast<float>(parts_);
    return own;
}

template <class Height>
RayMeeting KernelTerrain<Height>::meet(const Ray& ray) const {
    const Ray own = own_ray(ray);
    const Hit hit = trace_ray(field_, own);
    RayMeeting met;
    met.is_met = hit.side != HitSide::none;
    if (!met.is_met) return met;
    const double u = std::clamp(own.origin.x + double{hit.t} * double{own.direction.x} - hit.column, 0.0, 1.0);
    const double v = std::clamp(own.origin.y + double{hit.t} * double{own.direction.y} - hit.row, 0.0, 1.0);
    SurfaceSettings settings;
    settings.kind = field_.surface == CellSurface::bilinear ? SurfaceKind::bilinear : SurfaceKind::two_triangles;
    met.point = cell_patch(field_.grid(), settings, hit.column, hit.row).at(u, v);
    met.point.slope_x *= parts_;
    met.point.slope_y *= parts_;
    met.t = hit.t;
    met.x = (hit.column + u) / parts_;
    met.y = (hit.row + v) / parts_;
    return met;
}

template <class Height>
bool KernelTerrain<Height>::is_hidden(const Ray& ray) const {
    return trace_ray(field_, own_ray(ray)).side != HitSide::none;
}

template class KernelTerrain<std::int16_t>;
template class KernelTerrain<float>;

}  // namespace tedavis::raytrace
