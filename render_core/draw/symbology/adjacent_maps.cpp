#include "render_core/draw/symbology/adjacent_maps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/painter.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/member_choice.hpp"

namespace tedavis::draw {
namespace {

using design::AdjacentShows;
using policy::Element;
using policy::ElementShow;

constexpr double kMaxLatitude_rad = base::radians(89.875), kLatitudeStep_rad = base::radians(0.125);
constexpr float kMinCell_px = 4;
constexpr float kDot_px = 3, kStroke_px = 2;
constexpr float kGap_px = 1;  // round interpolated values

// In texts.
constexpr float kLine = 0.85f, kSmall = 0.65f;
constexpr float kMark = 0.45f;
constexpr float kMarkShare = 0.13f;  // of a map's side, at most

/// Away from the equator to a step, so that cells hardly ever change their width on the way, and are never narrower than asked.
double lattice_latitude_rad(double latitude_rad) {
    const double steps = std::ceil(std::fabs(latitude_rad) / kLatitudeStep_rad);
    return std::fmin(steps * kLatitudeStep_rad, kMaxLatitude_rad);
}

/// Of a number of cells that a map is wide, with those cut at its edges.
std::uint32_t lines_between(double low, double high) { return static_cast<std::uint32_t>(std::ceil(high) - std::floor(low)); }

void build_cell(const Painter& painter, const MapCell& cell, const design::Color& sign) {
    QuadBatch& batch = painter.batch();
    const Rect& box = cell.box;
    switch (cell.sign) {
        case CellSign::none: static_cast<void>(batch.box(box, cell.color)); break;
        case CellSign::interpolated: static_cast<void>(batch.box(box.shrunk(kGap_px), cell.color)); break;
        case CellSign::unknown:
            static_cast<void>(batch.line({box.x + 1, box.bottom() - 1}, {box.right() - 1, box.y + 1}, kStroke_px, sign));
            break;
        case CellSign::missing: {
            const float dot = std::max(1.0f, std::min(kDot_px, std::floor(std::min(box.width, box.height) / 2)));
            static_cast<void>(
                batch.box({std::floor(box.center().x - dot / 2), std::floor(box.center().y - dot / 2), dot, dot}, sign));
            break;
        }
    }
}

/// One map in its box.
class MapBuilder {
public:
    MapBuilder(const Painter& painter, const SymbologyInput& input, const Rect& box)
        : painter_(painter), input_(input), box_(box) {}

    void build(const scene::Attribute& attribute) const {
        const AdjacentInput& maps = input_.adjacent;
        painter_.batch().box(box_, painter_.color(SymbolRole::readout_ground));  // in no scale of data
        const MapLattice lattice(maps, box_);
        const scene::GridField field(*maps.layer, attribute);
        for (std::uint32_t row = 0; row < lattice.rows(); ++row)
            for (std::uint32_t column = 0; column < lattice.columns(); ++column) {
                MapCell cell = cell_of(
                    field.at(lattice.latitude_rad(row), lattice.longitude_rad(column), maps.height_m, maps.time_ns), maps);
                cell.box = lattice.box_of(column, row);
                if (!cell.box.empty()) build_cell(painter_, cell, maps.sign);
            }
        build_own_ship();
        painter_.batch().frame(box_, painter_.stroke_px(), painter_.color(SymbolRole::scale));
    }
    void number(std::uint32_t member) const {
        const float t = painter_.text_px();
        painter_.text(whole_number(member + 1).view(), {box_.x + 0.15f * t, box_.y + 0.4f * t}, TextAnchor::left, kSmall);
    }

private:
    /// A wedge along the heading; without one, or where a track stands for it, as on the map (map_symbols.cpp).
    void build_own_ship() const {
        const flight::Signal heading = input_.decisions.view_heading;
        const bool is_trusted = input_.decisions[Element::position].show == ElementShow::normal,
                   is_heading = heading != flight::Signal::true_track;
        const design::Color color = painter_.color(is_trusted && is_heading ? SymbolRole::reference : SymbolRole::caution);
        const float size = std::min(kMark * painter_.text_px(), kMarkShare * box_.width);
        const Point center = box_.center();
        if (heading == flight::Signal::count_) {
            painter_.batch().box({center.x - size / 2, center.y - size / 2, size, size}, painter_.color(SymbolRole::rim));
            painter_.batch().box({center.x - size / 4, center.y - size / 4, size / 2, size / 2}, color);
            return;
        }
        const auto off = [&](double angle_rad, float distance) {
            return Point{center.x + distance * static_cast<float>(std::sin(angle_rad)),
                         center.y - distance * static_cast<float>(std::cos(angle_rad))};
        };
        constexpr double kBack_rad = 2.5;
        const double ahead = input_.view_heading_rad;
        const Point wedge[4] = {off(ahead, size), off(ahead - kBack_rad, size), off(ahead, -0.3f * size),
                                off(ahead + kBack_rad, size)};
        painter_.batch().polyline(wedge, 1.5f * painter_.stroke_px(), painter_.color(SymbolRole::rim), true);
        painter_.batch().triangle(wedge[0], wedge[1], wedge[2], color);
        painter_.batch().triangle(wedge[0], wedge[2], wedge[3], color);
    }

    const Painter& painter_;
    const SymbologyInput& input_;
    Rect box_;
};

base::FixedString<31> title_of(const AdjacentInput& input) {
    base::FixedString<31> title(input.title.view());
    if (input.view.shows == AdjacentShows::uncertainty) title.append(" \xC2\xB1");
    if (input.view.shows == AdjacentShows::members) title.append(" MEMBERS");
    return title;
}

/// Two lines: what it is, and how far it reaches to the edges; north is up.
void build_caption(const Painter& painter, const AdjacentInput& input, base::DisplayUnits units, const Rect& box) {
    const float t = painter.text_px();
    painter.plate({box.x, box.y, box.width, kLine * t}, title_of(input).view(), 0.75f, painter.color(SymbolRole::scale));
    char number[24];
    const base::DisplayUnit unit = base::distance_unit(units);
    std::snprintf(number, sizeof number, "RNG %.4g ", unit.of(input.view.range_m));
    ShortText range(number);
    range.append(unit.text);
    const Rect line{box.x, box.y + kLine * t, box.width, kLine * t};
    painter.batch().box(line, painter.color(SymbolRole::readout_ground));
    const float arrow = 1.2f * t;
    painter.fitted_text(range.view(), {line.x, line.y, line.width - arrow, line.height}, TextAnchor::left, kSmall,
                        painter.color(SymbolRole::scale), TextRim::none);
    painter.text("N", {line.right() - 0.75f * t, line.center().y}, TextAnchor::right, kSmall, painter.color(SymbolRole::scale), 0,
                 TextRim::none);
    const Point at{line.right() - 0.45f * t, line.center().y};
    painter.batch().triangle({at.x, at.y - 0.35f * t}, {at.x + 0.22f * t, at.y + 0.3f * t}, {at.x - 0.22f * t, at.y + 0.3f * t},
                             painter.color(SymbolRole::scale));
}

}  // namespace

std::uint32_t map_count(const AdjacentInput& input) noexcept {
    if (input.layer == nullptr) return 0;
    if (input.view.shows != AdjacentShows::members) return 1;
    return std::min(input.view.most_members, input.attribute->member_count());
}

std::uint32_t cells_across(const AdjacentInput& input, float side_px) noexcept {
    const double share = std::sqrt(double{kAdjacentCells} / std::max(map_count(input), 1u));
    const auto legible = static_cast<std::uint32_t>(std::max(side_px / kMinCell_px, 1.0f));
    return std::min({input.view.cells, static_cast<std::uint32_t>(share) - 1, legible});
}

AdjacentNeed adjacent_need(const AdjacentInput& input) noexcept {
    return {map_count(input), static_cast<float>(input.view.size)};
}

MapLattice::MapLattice(const AdjacentInput& input, const Rect& box)
    : box_(box), latitude_rad_(input.latitude_rad), longitude_rad_(input.longitude_rad) {
    const double cell_m = 2 * input.view.range_m / cells_across(input, box.width),
                 px_per_m = static_cast<double>(box.width) / (2 * input.view.range_m);
    const double near_rad = std::fmin(std::fabs(latitude_rad_), kMaxLatitude_rad), line_rad = lattice_latitude_rad(latitude_rad_);
    const double north_m = earth::meridian_radius_m(latitude_rad_);
    px_per_lat_rad_ = px_per_m * north_m;
    px_per_lon_rad_ = px_per_m * earth::prime_vertical_radius_m(near_rad) * std::cos(near_rad);
    // Radii of curvature are least at the equator: there are never more cells than asked for, and one that is cut.
    step_lat_rad_ = cell_m / earth::meridian_radius_m(0);
    step_lon_rad_ = cell_m / (earth::prime_vertical_radius_m(0) * std::cos(line_rad));
    const double half_lat = box.height / 2.0 / px_per_lat_rad_ / step_lat_rad_,
                 half_lon = box.width / 2.0 / px_per_lon_rad_ / step_lon_rad_;
    const double column = longitude_rad_ / step_lon_rad_, row = latitude_rad_ / step_lat_rad_;
    west_ = std::floor(column - half_lon);
    north_ = std::ceil(row + half_lat);
    columns_ = lines_between(column - half_lon, column + half_lon);
    rows_ = lines_between(row - half_lat, row + half_lat);
}

float MapLattice::x_of(double longitude_rad) const {
    const double x = static_cast<double>(box_.center().x) + (longitude_rad - longitude_rad_) * px_per_lon_rad_;
    return std::clamp(std::round(static_cast<float>(x)), box_.x, box_.right());
}

float MapLattice::y_of(double latitude_rad) const {
    const double y = static_cast<double>(box_.center().y) + (latitude_rad_ - latitude_rad) * px_per_lat_rad_;
    return std::clamp(std::round(static_cast<float>(y)), box_.y, box_.bottom());
}

Rect MapLattice::box_of(std::uint32_t column, std::uint32_t row) const {
    const float left = x_of((west_ + column) * step_lon_rad_), right = x_of((west_ + column + 1) * step_lon_rad_);
    const float top = y_of((north_ - row) * step_lat_rad_), bottom = y_of((north_ - row - 1) * step_lat_rad_);
    return {left, top, right - left, bottom - top};
}

MapCell cell_of(const scene::FieldValue& value, const AdjacentInput& input) noexcept {
    MapCell cell;
    cell.sign = CellSign::missing;
    if (value.state == scene::ValueState::missing || !std::isfinite(value.value)) return cell;
    const bool is_uncertainty = input.view.shows == AdjacentShows::uncertainty;
    cell.sign = CellSign::unknown;
    if (is_uncertainty && !value.uncertainty.is_known()) return cell;
    cell.sign = value.state == scene::ValueState::interpolated ? CellSign::interpolated : CellSign::none;
    cell.color = scale_color(input.view.scale, is_uncertainty ? value.uncertainty.level() : value.value);
    return cell;
}

void build_adjacent_maps(const Painter& painter, const SymbologyInput& input) {
    const Rect& panel = painter.layout().adjacent;
    const AdjacentInput& maps = input.adjacent;
    const std::uint32_t count = map_count(maps);
    if (panel.empty() || count == 0) return;
    build_caption(painter, maps, input.shown.units, panel);
    const AdjacentPlan plan = plan_adjacent(panel, count, painter.text_px());
    const bool is_members = maps.view.shows == AdjacentShows::members;
    for (std::uint32_t n = 0; n < count; ++n) {
        const MapBuilder map(painter, input, plan.box_of(n));
        if (!is_members) {
            map.build(*maps.attribute);
            continue;
        }
        const std::uint32_t member = scene::spaced_member(n, count, maps.attribute->member_count());
        map.build(maps.attribute->member(member));
        map.number(member);
    }
}

}  // namespace tedavis::draw
