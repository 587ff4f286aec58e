#include "render_core/raytrace/picture/kernel_terrain.hpp"

#include <algorithm>

#include "render_core/raytrace/picture/wide_loops.hpp"
#include "render_core/raytrace/surface/cell_patch.hpp"

namespace tedavis::raytrace {
namespace {

std::uint32_t beams_across(std::uint32_t pixels, int size) { return (pixels + kBeamSide[size] - 1) / kBeamSide[size]; }

constexpr std::uint32_t kMostInSpan = PixelSpan::kMost;

/// Rays of a line of pixels, in posts: from `origin` along `first` + n * `step`.
struct LineOfRays {
    double origin[2], first[2], step[2];
};

/// Cells of a span with places in them, and the heights of their posts.
struct SpanCells {
    std::uint32_t post[kMostInSpan];  ///< row * cells + column
    std::int32_t row[kMostInSpan];
    float u[kMostInSpan], v[kMostInSpan];
    float corner[4][kMostInSpan];
};

/// Rows of cells by a multiplication: with half a cell added it is right for every number of 31 bits.
TEDAVIS_WIDE_LOOPS void find_places(const LineOfRays& rays, std::int32_t cells, double part, const float* __restrict t,
                                    const std::int32_t* __restrict cell, SpanSurface& __restrict out,
                                    SpanCells& __restrict found) {
    const double cells_part = 1.0 / cells;
    const std::uint32_t count = out.count;
    for (std::uint32_t n = 0; n < count; ++n) out.is_met[n] = cell[n] >= 0;
    for (std::uint32_t n = 0; n < count; ++n) {
        const bool is_met = cell[n] >= 0;
        const std::int32_t place = is_met ? cell[n] : 0;
        const auto row = static_cast<std::int32_t>((place + 0.5) * cells_part);
        const std::int32_t column = place - row * cells;
        const float met_t = is_met ? t[n] : 0;
        const double at = met_t, x = rays.origin[0] + at * (rays.first[0] + static_cast<std::int32_t>(n) * rays.step[0]) - column,
                     y = rays.origin[1] + at * (rays.first[1] + static_cast<std::int32_t>(n) * rays.step[1]) - row;
        const double u = std::min(std::max(x, 0.0), 1.0), v = std::min(std::max(y, 0.0), 1.0);
        out.t[n] = met_t;
        out.x[n] = (column + u) * part;
        out.y[n] = (row + v) * part;
        found.row[n] = row;
        found.post[n] = static_cast<std::uint32_t>(place);
        found.u[n] = static_cast<float>(u);
        found.v[n] = static_cast<float>(v);
    }
}

template <class Height>
void find_corners(const HeightGrid<Height>& grid, std::uint32_t count, SpanCells& __restrict cells) {
    const std::size_t stride = grid.stride, skipped = stride - (grid.columns - 1);
    for (std::uint32_t n = 0; n < count; ++n) {
        const Height* const post = grid.posts + cells.post[n] + static_cast<std::size_t>(cells.row[n]) * skipped;
        cells.corner[0][n] = static_cast<float>(post[0]);
        cells.corner[1][n] = static_cast<float>(post[1]);
        cells.corner[2][n] = static_cast<float>(post[stride]);
        cells.corner[3][n] = static_cast<float>(post[stride + 1]);
    }
}

TEDAVIS_WIDE_LOOPS void find_bilinear(const SpanCells& __restrict cells, float parts, SpanSurface& __restrict out) {
    const std::uint32_t count = out.count;
    for (std::uint32_t n = 0; n < count; ++n) {
        const float a = cells.corner[0][n], b = cells.corner[1][n], c = cells.corner[2][n], d = cells.corner[3][n];
        const float u = cells.u[n], v = cells.v[n];
        const float slope_x = (1 - v) * (b - a) + v * (d - c), slope_y = (1 - u) * (c - a) + u * (d - b);
        out.height[n] = a + u * (b - a) + v * slope_y;
        out.slope_x[n] = slope_x * parts;
        out.slope_y[n] = slope_y * parts;
    }
}

TEDAVIS_WIDE_LOOPS void find_triangles(const SpanCells& __restrict cells, float parts, SpanSurface& __restrict out) {
    const std::uint32_t count = out.count;
    for (std::uint32_t n = 0; n < count; ++n) {
        const float a = cells.corner[0][n], b = cells.corner[1][n], c = cells.corner[2][n], d = cells.corner[3][n];
        const float u = cells.u[n], v = cells.v[n];
        const bool is_first = u + v <= 1;
        const float slope_x = is_first ? b - a : d - c, slope_y = is_first ? c - a : d - b;
        const float base = is_first ? a : d, along_x = is_first ? u : u - 1, along_y = is_first ? v : v - 1;
        out.height[n] = base + along_x * slope_x + along_y * slope_y;
        out.slope_x[n] = slope_x * parts;
        out.slope_y[n] = slope_y * parts;
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
    LineOfRays rays;
    for (int axis = 0; axis < 2; ++axis) {
        const double right = camera_.right[axis], down = camera_.down[axis];
        rays.origin[axis] = camera_.origin[axis];
        rays.first[axis] = camera_.corner[axis] + (left + 0.5) * right + (line + 0.5) * down;
        rays.step[axis] = right;
    }
    const HeightGrid<Height>& grid = field_.grid();
    SpanCells cells;
    find_places(rays, static_cast<std::int32_t>(grid.columns - 1), 1.0 / parts_, hits.t.data() + span.first,
                hits.cell.data() + span.first, surface, cells);
    find_corners(grid, span.count, cells);
    const auto find = field_.surface == CellSurface::bilinear ? find_bilinear : find_triangles;
    find(cells, static_cast<float>(parts_), surface);
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
