#include "host_sim/accuracy/ground_errors.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "host_sim/accuracy/knob_pictures.hpp"
#include "host_sim/accuracy/knobs/terrain_tau_knob.hpp"
#include "render_core/raytrace/space/trace_ground.hpp"

namespace tedavis::host_sim {
namespace {

std::uint32_t cells_over(std::uint32_t pixels, std::uint32_t cell_px) { return (pixels + cell_px - 1) / cell_px; }

/// The first pixel of cell `n`, of `count` round the middle of `pixels`.
std::int64_t first_pixel_of(std::uint32_t n, std::uint32_t count, std::uint32_t cell_px, std::uint32_t pixels) {
    const std::int64_t beyond = std::int64_t{count} * cell_px - pixels;
    return std::int64_t{n} * cell_px - beyond / 2;
}

/// The same view with a pixel for each cell.
terrain::View coarse_view(const terrain::View& view, const GroundErrors& grid) {
    terrain::View coarse = view;
    coarse.width = grid.across;
    coarse.height = grid.down;
    coarse.focal_px = view.focal_px / grid.cell_px;
    return coarse;
}

void mix(std::uint8_t* pixel, const std::array<std::uint8_t, 3>& color, ErrorMapStyle style) {
    for (std::size_t n = 0; n < color.size(); ++n)
        pixel[n] = style == ErrorMapStyle::dots ? color[n] : static_cast<std::uint8_t>((pixel[n] + color[n] + 1) / 2);
}

}  // namespace

std::int64_t GroundErrors::left(std::uint32_t column) const { return first_pixel_of(column, across, cell_px, picture.width); }
std::int64_t GroundErrors::top(std::uint32_t row) const { return first_pixel_of(row, down, cell_px, picture.height); }

MeasuredError GroundErrors::summary() const {
    MeasuredError error;
    for (const double one : px) {
        if (std::isnan(one)) continue;
        ++error.places;
        error.mean_px += one;
        error.max_px = std::max(error.max_px, one);
    }
    if (error.places > 0) error.mean_px /= static_cast<double>(error.places);
    return error;
}

GroundErrors ground_errors(const TracedGround& ground, display::Display& display, std::uint32_t cell_px) {
    const terrain::View& view = display.planned().picture.camera.view;
    GroundErrors errors;
    errors.picture = {view.width, view.height};
    errors.cell_px = cell_px;
    errors.across = cells_over(view.width, cell_px);
    errors.down = cells_over(view.height, cell_px);
    errors.px.assign(std::size_t{errors.across} * errors.down, std::numeric_limits<double>::quiet_NaN());
    if (view.is_flat() || !view.magnifiers.empty()) return errors;
    TracedShotPlan plan;
    plan.width = errors.across;
    plan.height = errors.down;
    plan.view = coarse_view(view, errors);
    if (!raytrace::can_trace(ground.space(), *plan.view)) return errors;
    for (const SeenPlace& place : seen_ground(ground, plan)) {
        if (glm::distance(place.position, view.eye) < kNearestSeenPlace_m) continue;
        if (const auto error = terrain_error_px(display, place))
            errors.px[std::size_t{place.y} * errors.across + place.x] = *error;
    }
    return errors;
}

std::array<std::uint8_t, 3> error_color(double px, double full_px) {
    const RgbaPicture one = error_map({px}, 1, full_px);
    return {one.pixels[0], one.pixels[1], one.pixels[2]};
}

void draw_ground_errors(RgbaPicture& picture, const GroundErrors& errors, double full_px, ErrorMapStyle style) {
    const std::int64_t inset = style == ErrorMapStyle::dots ? errors.cell_px / 4 : 0, side = errors.cell_px - 2 * inset;
    const auto within = [](std::int64_t place, std::uint32_t end) { return std::clamp<std::int64_t>(place, 0, end); };
    for (std::uint32_t row = 0; row < errors.down; ++row)
        for (std::uint32_t column = 0; column < errors.across; ++column) {
            const double px = errors.px[std::size_t{row} * errors.across + column];
            if (std::isnan(px)) continue;
            const std::array<std::uint8_t, 3> color = error_color(px, full_px);
            const std::int64_t left = errors.left(column) + inset, top = errors.top(row) + inset;
            for (std::int64_t y = within(top, picture.height); y < within(top + side, picture.height); ++y)
                for (std::int64_t x = within(left, picture.width); x < within(left + side, picture.width); ++x)
                    mix(&picture.pixels[static_cast<std::size_t>((y * picture.width + x) * 4)], color, style);
        }
}

}  // namespace tedavis::host_sim
