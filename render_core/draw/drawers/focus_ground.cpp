#include "render_core/draw/drawers/focus_ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

#include "render_core/base/check.hpp"
#include "render_core/terrain/projected_error.hpp"

namespace tedavis::draw {
namespace {

using design::FocusBorderKind;
using scene::FocusRegion;

enum Texel : std::uint32_t { kRadiusTexel, kStepTexel, kKindTexel, kLookTexel, kSpacingTexel, kPointsTexel };
static_assert(kPointsTexel + 2 * scene::kMaxFocusPoints <= GroundFocus::kTexelsOfFocus);

constexpr double kZero = 8388608, kMaxNumber = 8388607;
constexpr double kFinestUnit_m = 1.0 / 64;
constexpr double kTenthsOfPixel = 10;
/// A pixel reaches no farther where the ground is seen edge-on (shaders/focus.frag), and some.
constexpr double kFarthestReach = 12;
constexpr double kBoxSlack_m = 2;

bool is_path(const FocusRegion& region) { return region.kind == scene::FocusPoints::path && region.point_count > 1; }

double step_m(const FocusRegion& region, double farthest_m) {
    if (region.context.width_m <= 0) return farthest_m;  // beyond the rim all is one step
    return region.context.levels == 0 ? region.context.width_m : region.context.width_m / region.context.levels;
}

double steps(const FocusRegion& region) {
    if (region.context.width_m <= 0) return 1;
    return region.context.levels == 0 ? 0 : region.context.levels + 1;
}

double largest_number_m(const FocusRegion& region) {
    double largest = std::fmax(region.radius_m, region.context.width_m);
    for (std::uint32_t n = 0; n < region.point_count; ++n)
        largest = std::fmax(largest, std::fmax(std::fabs(region.points[n].x), std::fabs(region.points[n].y)));
    return largest;
}

glm::dvec3 axis_of(const terrain::ChunkEntry& entry, int n) {
    return {entry.axes[3 * n], entry.axes[3 * n + 1], entry.axes[3 * n + 2]};
}

glm::dvec3 centre_of(const terrain::ChunkEntry& entry) { return {entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]}; }

/// No place of the box is farther from its centre in the region's plane.
double reach_in_plane_m(const terrain::ChunkEntry& entry, const FocusRegion& region) {
    glm::dvec2 half(kBoxSlack_m);
    for (int n = 0; n < 3; ++n)
        half += double{entry.half_extent_m[n]} * glm::dvec2(std::fabs(glm::dot(axis_of(entry, n), region.east)),
                                                            std::fabs(glm::dot(axis_of(entry, n), region.north)));
    return glm::length(half);
}

double farthest_pixel_m(const terrain::ChunkEntry& entry, const terrain::View& view) {
    const glm::dvec3 half(entry.half_extent_m[0], entry.half_extent_m[1], entry.half_extent_m[2]);
    return (glm::length(centre_of(entry) - view.eye) + glm::length(half)) / view.focal_px;
}

}  // namespace

double sharp_distance_m() noexcept { return 50 * (std::exp2(13 * kSharpCode / 255) - 1); }

double focus_grid_spacing_m(double radius_m) noexcept {
    const double most = radius_m / 2, decade = std::pow(10, std::floor(std::log10(most)));
    return most >= 5 * decade ? 5 * decade : most >= 2 * decade ? 2 * decade : decade;
}

std::uint32_t GroundFocus::count() const {
    return regions_ == nullptr ? 0 : static_cast<std::uint32_t>(std::min(regions_->size(), foci_->size()));
}

void GroundFocus::set(const scene::FocusRegions* regions, const design::FocusList& foci, bool blurs) {
    regions_ = regions;
    foci_ = &foci;
    is_any_ = false;
    double largest_m = 0;
    for (std::uint32_t n = 0; n < count(); ++n) {
        if (!region(n).is_valid) continue;
        is_any_ = true;
        largest_m = std::fmax(largest_m, largest_number_m(region(n)));
    }
    if (!is_any_) return;
    const design::FocusTerrain& asked = design::terrain_of_context(foci);
    look_ = blurs ? asked : design::darkened_instead_of_blurred(asked);
    unit_m_ = kFinestUnit_m;
    while (largest_m > kMaxNumber * unit_m_ && unit_m_ < 1024) unit_m_ *= 2;
    texels_ = {};
    for (std::uint32_t n = 0; n < count(); ++n)
        if (region(n).is_valid) write_focus(n);
}

void GroundFocus::write(std::uint32_t texel, double number) {
    const double code = std::clamp(std::round(number / unit_m_) + kZero, 0.0, kZero + kMaxNumber);
    const auto bits = static_cast<std::uint32_t>(code);
    texels_[4 * texel] = static_cast<std::uint8_t>(bits >> 16);
    texels_[4 * texel + 1] = static_cast<std::uint8_t>(bits >> 8);
    texels_[4 * texel + 2] = static_cast<std::uint8_t>(bits);
}

double GroundFocus::number_at(std::uint32_t texel) const {
    const std::uint8_t* const code = &texels_[4 * texel];
    return (65536.0 * code[0] + 256.0 * code[1] + code[2] - kZero) * unit_m_;
}

void GroundFocus::write_focus(std::uint32_t n) {
    const FocusRegion& at = region(n);
    const design::FocusBorder& border = (*foci_)[n].border;
    const std::uint32_t first = n * kTexelsOfFocus;
    write(first + kRadiusTexel, at.radius_m);
    write(first + kStepTexel, step_m(at, kMaxNumber * unit_m_));
    write(first + kSpacingTexel, focus_grid_spacing_m(at.radius_m));
    std::uint8_t* const kind = &texels_[std::size_t{4} * (first + kKindTexel)];
    kind[0] = static_cast<std::uint8_t>(steps(at));
    kind[1] = static_cast<std::uint8_t>((is_path(at) ? 1 : 0) + (at.is_square ? 2 : 0) +
                                        (at.context.distance == scene::FocusDistance::chebyshev ? 4 : 0));
    kind[2] = static_cast<std::uint8_t>(border.kind);
    std::uint8_t* const look = &texels_[std::size_t{4} * (first + kLookTexel)];
    look[0] = border.color.red;
    look[1] = border.color.green;
    look[2] = border.color.blue;
    look[3] = static_cast<std::uint8_t>(std::lround(kTenthsOfPixel * border.width_px));
    for (std::uint32_t point = 0; point < at.point_count; ++point) {
        write(first + kPointsTexel + 2 * point, at.points[point].x);
        write(first + kPointsTexel + 2 * point + 1, at.points[point].y);
    }
}

void GroundFocus::upload(gl::Gl& gl, gl::Texture& texture, std::uint32_t row) {
    if (!is_any_ || (is_uploaded_ && texels_ == uploaded_)) return;
    TEDAVIS_CHECK(texture.upload(gl, {0, row, kTexels, 1}, texels_.data()));
    uploaded_ = texels_;
    is_uploaded_ = true;
}

/// Distances of a part change by a metre a metre at most, by Chebyshev's measure too.
void GroundFocus::look_at(std::uint32_t n, const terrain::ChunkEntry& entry, double pixel_m, FocusOfChunk& chunk) const {
    const FocusRegion& at = region(n);
    const design::FocusBorder& border = (*foci_)[n].border;
    const bool has_border = border.kind != FocusBorderKind::none;
    const double margin_m = (2 + (has_border ? border.width_px : 0)) * pixel_m * kFarthestReach;
    const glm::dvec2 centre = in_focus_plane(at, centre_of(entry));
    const double reach_m = reach_in_plane_m(entry, at);
    const double looked_up_m = margin_m + (look_.is_any() ? at.context.width_m : 0);
    double nearest_m = std::numeric_limits<double>::infinity();
    std::uint32_t first = scene::kMaxFocusPoints, end = 0;
    for (std::uint32_t part = 0; part < focus_part_count(at); ++part) {
        const double distance_m = focus_part_distance_m(at, part, centre);
        nearest_m = std::fmin(nearest_m, distance_m);
        if (distance_m - reach_m > looked_up_m) continue;
        first = std::min(first, part);
        end = part + 1;
    }
    const bool is_within = nearest_m + reach_m < -margin_m;
    if (is_within) chunk.least_degree = 1;
    if (end <= first || (is_within && border.kind != FocusBorderKind::grid)) return;
    chunk.first[n] = static_cast<std::uint8_t>(first);
    chunk.count[n] = static_cast<std::uint8_t>(end - first);
}

FocusOfChunk GroundFocus::of_chunk(const terrain::ChunkEntry& entry, const terrain::View& view) const {
    FocusOfChunk chunk;
    if (!is_any_) return chunk;
    const double pixel_m = farthest_pixel_m(entry, view);
    for (std::uint32_t n = 0; n < count(); ++n)
        if (region(n).is_valid) look_at(n, entry, pixel_m, chunk);
    bool looks_up = false;
    for (std::uint32_t n = 0; n < count(); ++n) {
        // In another focus only rims are left to be seen.
        if (chunk.least_degree >= 1 && (*foci_)[n].border.kind == FocusBorderKind::none) chunk.count[n] = 0;
        looks_up = looks_up || chunk.count[n] > 0;
    }
    chunk.is_in_focus = !looks_up && (chunk.least_degree >= 1 || !look_.is_any());
    return chunk;
}

void GroundFocus::set_frame_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const glm::dvec3& origin) const {
    float axes[2 * scene::kMaxFoci][4]{};
    for (std::uint32_t n = 0; n < count(); ++n)
        for (int axis = 0; axis < 2; ++axis) {
            const glm::dvec3 along = axis == 0 ? region(n).east : region(n).north;
            float* const row = axes[2 * n + static_cast<std::uint32_t>(axis)];
            for (int k = 0; k < 3; ++k) row[k] = static_cast<float>(along[k]);
            row[3] = static_cast<float>(glm::dot(origin - region(n).anchor, along));
        }
    gl->Uniform4fv(program.uniform(first), 2 * scene::kMaxFoci, axes[0]);
    gl->Uniform4f(program.uniform(first + 2), static_cast<float>(look_.brightness), static_cast<float>(look_.saturation),
                  look_.sketch_outside ? 1.0f : 0.0f, static_cast<float>(unit_m_));
}

void GroundFocus::set_chunk_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const FocusOfChunk& chunk) {
    float parts[scene::kMaxFoci];
    for (std::size_t n = 0; n < scene::kMaxFoci; ++n) parts[n] = static_cast<float>(32 * chunk.count[n] + chunk.first[n]);
    gl->Uniform4f(program.uniform(first + 1), parts[0], parts[1], parts[2], parts[3]);
    gl->Uniform1f(program.uniform(first + 3), static_cast<float>(chunk.least_degree));
}

}  // namespace tedavis::draw
