#include "render_core/draw/data/focus_values.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/data_time.hpp"
#include "render_core/scene/focus_map.hpp"

namespace tedavis::draw {
namespace {

using design::FocusOfData;
using design::FocusValues;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// Angles from a place of reference, so that they do not break at the antimeridian.
struct AngleBox {
    double south = kInfinite, north = -kInfinite, west = kInfinite, east = -kInfinite;

    [[nodiscard]] bool is_empty() const { return south > north; }
    void add(double latitude, double longitude) {
        if (latitude < south) south = latitude;
        if (latitude > north) north = latitude;
        if (longitude < west) west = longitude;
        if (longitude > east) east = longitude;
    }
};

/// All places of the values that one layer has, from the same place of reference.
template <class Take>
void each_place(const LayerValues& values, std::size_t n, const scene::Layer& layer, double reference_rad, const Take& take) {
    const auto from = [&](double longitude_rad) {
        const double east = longitude_rad - reference_rad;
        return east > base::kPi ? east - 2 * base::kPi : east < -base::kPi ? east + 2 * base::kPi : east;
    };
    if (values.is_grid()) {
        const LayerValues::Place post = values.post(n);
        take(post.latitude_rad, from(post.longitude_rad));
        return;
    }
    const scene::Run run = values.points_of(n);
    for (std::uint32_t k = 0; k < run.count; ++k) {
        const scene::ScenePoint& point = layer.points[run.first + k];
        take(point.latitude_rad, from(point.longitude_rad));
    }
}

template <class Take>
void each_meant_layer(const FocusOfData& data, const FocusFrame& frame, const Take& take) {
    if (frame.scene == nullptr) return;
    for (const scene::Layer& layer : frame.scene->layers())
        if (is_meant(data, layer) && holds_now(layer, frame.time))
            take(layer, LayerValues(layer, data.attribute.view(), shown_time_ns(layer, frame.time)));
}

void set_range(const FocusOfData& data, const FocusFrame& frame, scene::FocusValueRange& range) {
    range.low = data.low;
    range.high = data.high;
    if (data.values == FocusValues::interval) return;
    double low = kInfinite, high = -kInfinite;
    each_meant_layer(data, frame, [&](const scene::Layer&, const LayerValues& values) {
        for (std::size_t n = 0; n < values.size(); ++n) {
            const double value = values[n];
            if (value < low) low = value;
            if (value > high) high = value;
        }
    });
    const bool is_highest = data.values == FocusValues::highest;
    range.low = is_highest ? high - data.within : low;
    range.high = is_highest ? high : low + data.within;
}

/// Boxes of places, by the cells of the layers' extent.
class Cells {
public:
    explicit Cells(const AngleBox& extent) : extent_(extent) {
        const auto step = [](double length) { return length > 0 ? kFocusCells / length : 0; };
        rows_per_rad_ = step(extent.north - extent.south);
        columns_per_rad_ = step(extent.east - extent.west);
    }
    void add(double latitude, double longitude) {
        const auto cell = [](double number) { return std::min(static_cast<std::size_t>(number), kFocusCells - 1); };
        const std::size_t row = cell((latitude - extent_.south) * rows_per_rad_);
        boxes_[row * kFocusCells + cell((longitude - extent_.west) * columns_per_rad_)].add(latitude, longitude);
    }
    [[nodiscard]] const std::array<AngleBox, kFocusCells * kFocusCells>& boxes() const { return boxes_; }

private:
    AngleBox extent_;
    double rows_per_rad_ = 0, columns_per_rad_ = 0;
    std::array<AngleBox, kFocusCells * kFocusCells> boxes_;
};

struct Disc {
    glm::dvec2 middle{0};
    double reach_m = 0;
};

/// Every disc lies within `radius_m` of one of the points that are chosen.
void cover(base::Span<const Disc> discs, scene::FocusRegion& region) {
    const auto uncovered_m = [&](const Disc& disc) {
        double least = kInfinite;
        for (std::uint32_t n = 0; n < region.point_count; ++n)
            least = std::fmin(least, glm::distance(disc.middle, region.points[n]));
        return least;
    };
    region.point_count = 0;
    while (region.point_count < scene::kMaxFocusPoints) {
        std::size_t farthest = 0;
        double farthest_m = -1;
        for (std::size_t n = 0; n < discs.size(); ++n) {
            const double distance_m = uncovered_m(discs[n]);
            if (distance_m <= farthest_m) continue;
            farthest_m = distance_m;
            farthest = n;
        }
        if (farthest_m <= 0) break;
        region.points[region.point_count++] = discs[farthest].middle;
    }
    double most_m = 0;
    for (const Disc& disc : discs) most_m = std::fmax(most_m, uncovered_m(disc) + disc.reach_m);
    region.radius_m += most_m;
}

/// Posts of it. The first row and the last one of a grid reach as far as all of them.
std::size_t first_row(const scene::Layer& layer) { return layer.entry->grid.columns; }

struct Extent {
    AngleBox box;
    double reference_rad = kInfinite;  ///< longitude
};

Extent extent_of(const FocusOfData& data, const FocusFrame& frame) {
    Extent extent;
    each_meant_layer(data, frame, [&](const scene::Layer& layer, const LayerValues& values) {
        for (std::size_t n = 0; n < values.size(); ++n) {
            if (extent.reference_rad == kInfinite)
                extent.reference_rad = values.is_grid()                ? values.post(n).longitude_rad
                                       : values.points_of(n).count > 0 ? layer.points[values.points_of(n).first].longitude_rad
                                                                       : kInfinite;
            if (extent.reference_rad == kInfinite) continue;
            if (values.is_grid() && n >= first_row(layer) && n + first_row(layer) < values.size()) continue;
            each_place(values, n, layer, extent.reference_rad, [&](double lat, double lon) { extent.box.add(lat, lon); });
        }
    });
    return extent;
}

Cells cells_of(const FocusOfData& data, const FocusFrame& frame, const Extent& extent, const scene::FocusValueRange& range) {
    Cells cells(extent.box);
    each_meant_layer(data, frame, [&](const scene::Layer& layer, const LayerValues& values) {
        for (std::size_t n = 0; n < values.size(); ++n)
            if (const double value = values[n]; value >= range.low && value <= range.high)
                each_place(values, n, layer, extent.reference_rad, [&](double lat, double lon) { cells.add(lat, lon); });
    });
    return cells;
}

/// Round a cell's places, in the region's plane.
Disc disc_round(const AngleBox& cell, double reference_rad, const scene::FocusRegion& region) {
    const auto at = [&](double lat, double lon) {
        return scene::in_focus_plane(region, earth::to_ecef({lat, reference_rad + lon, {0}}));
    };
    Disc disc{at(0.5 * (cell.south + cell.north), 0.5 * (cell.west + cell.east)), 0};
    for (const double lat : {cell.south, cell.north})
        for (const double lon : {cell.west, cell.east})
            disc.reach_m = std::fmax(disc.reach_m, glm::distance(disc.middle, at(lat, lon)));
    return disc;
}

scene::FocusRegion where(const design::FocusSettings& focus, const FocusFrame& frame, const scene::FocusValueRange& range) {
    const Extent extent = extent_of(focus.data, frame);
    if (extent.box.is_empty()) return {};
    const AngleBox& box = extent.box;
    scene::FocusRegion region = scene::focus_region_at(0.5 * (box.south + box.north),
                                                       earth::wrap_longitude(extent.reference_rad + 0.5 * (box.west + box.east)));
    const Cells cells = cells_of(focus.data, frame, extent, range);
    base::FixedVector<Disc, kFocusCells * kFocusCells> discs;
    for (const AngleBox& cell : cells.boxes())
        if (!cell.is_empty()) static_cast<void>(discs.try_push_back(disc_round(cell, extent.reference_rad, region)));
    region.context = focus.context;
    region.radius_m = focus.radius_m;
    cover({discs.data(), discs.size()}, region);
    region.is_valid = region.point_count > 0;
    return region;
}

}  // namespace

std::int64_t shown_time_ns(const scene::Layer& layer, const flight::FlightTime& time) noexcept {
    return time.is_date ? scene::start_of_data_step(time.utc.ns) : scene::own_time_ns(layer);
}

bool holds_now(const scene::Layer& layer, const flight::FlightTime& time) noexcept {
    return !time.is_date || (time.utc.ns >= layer.entry->valid_from_ns && time.utc.ns <= layer.entry->valid_until_ns);
}

FoundData data_of(const design::FocusSettings& focus, const FocusFrame& frame) {
    FoundData found;
    bool is_any = false;
    each_meant_layer(focus.data, frame, [&](const scene::Layer&, const LayerValues&) { is_any = true; });
    if (!is_any) return found;
    found.range.similar = focus.data.similar;
    found.range.levels = focus.context.levels;
    set_range(focus.data, frame, found.range);
    found.region = where(focus, frame, found.range);
    found.state = found.region.is_valid ? FocusState::shown : FocusState::no_such_value;
    return found;
}

DerivedInterval values_in(const scene::FocusRegion& region, const LayerValues& values, const scene::Layer& layer) {
    DerivedInterval interval;
    if (!region.is_valid) return interval;
    const scene::FocusMap map(region);
    double low = kInfinite, high = -kInfinite;
    for (std::size_t n = 0; n < values.size(); ++n) {
        const double value = values[n];
        if (std::isnan(value)) continue;
        bool is_in = false;
        each_place(values, n, layer, 0, [&](double lat, double lon) { is_in = is_in || map.degree(region, lat, lon) >= 1; });
        if (!is_in) continue;
        low = std::fmin(low, value);
        high = std::fmax(high, value);
        ++interval.count;
    }
    if (interval.count > 0) {
        interval.low = low;
        interval.high = high;
    }
    return interval;
}

}  // namespace tedavis::draw
