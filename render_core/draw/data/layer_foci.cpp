#include "render_core/draw/data/layer_foci.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/scene/data_time.hpp"

namespace tedavis::draw {
namespace {

using scene::FocusMap;
using scene::FocusRegion;

bool is_run(const scene::Layer& layer) {
    return layer.entry->shape == scene::LayerShape::lines || layer.entry->shape == scene::LayerShape::areas;
}

double distance_of_leg(const FocusRegion& region, const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 along = to - from;
    const double square = glm::dot(along, along);
    double least = scene::focus_distance_m(region, from);
    for (std::uint32_t n = 0; n < region.point_count && square > 0; ++n) {
        const double part = std::clamp(glm::dot(region.points[n] - from, along) / square, 0.0, 1.0);
        least = std::fmin(least, scene::focus_distance_m(region, from + along * part));
    }
    return least;
}

/// Whether a ray from a point towards east crosses a side.
bool crosses(const glm::dvec2& point, const glm::dvec2& from, const glm::dvec2& to) {
    if ((from.y > point.y) == (to.y > point.y)) return false;
    return from.x + (to.x - from.x) * (point.y - from.y) / (to.y - from.y) > point.x;
}

/// A line's or an area's way past a region.
class Outline {
public:
    Outline(const FocusRegion& region, const FocusMap& map, const scene::Layer& layer, const scene::Run& run)
        : region_(region), map_(map), layer_(layer), run_(run) {}

    [[nodiscard]] double degree() const {
        const bool is_area = layer_.entry->shape == scene::LayerShape::areas;
        double least = std::numeric_limits<double>::infinity();
        unsigned inside = 0, all = ~0u;
        const std::uint32_t sides = is_area || run_.count == 1 ? run_.count : run_.count - 1;
        for (std::uint32_t n = 0; n < run_.count; ++n) all &= beyond(n);
        for (std::uint32_t n = 0; n < sides && all == 0 && least > 0; ++n) {
            const std::uint32_t next = (n + 1) % run_.count;
            const bool is_past = (beyond(n) & beyond(next)) != 0;
            if (is_past && !is_area) continue;
            const glm::dvec2 from = place(n), to = place(next);
            if (!is_past) least = std::fmin(least, distance_of_leg(region_, from, to));
            for (std::uint32_t k = 0; is_area && k < region_.point_count; ++k)
                if (crosses(region_.points[k], from, to)) inside ^= 1u << k;
        }
        if (least <= 0 || inside != 0) return 1;
        return scene::degree_at_distance(region_.context, least);
    }

private:
    [[nodiscard]] const scene::ScenePoint& point(std::uint32_t n) const { return layer_.points[run_.first + n]; }
    [[nodiscard]] unsigned beyond(std::uint32_t n) const { return map_.beyond(point(n).latitude_rad, point(n).longitude_rad); }
    [[nodiscard]] glm::dvec2 place(std::uint32_t n) const {
        return map_.in_plane(region_, point(n).latitude_rad, point(n).longitude_rad);
    }

    const FocusRegion& region_;
    const FocusMap& map_;
    const scene::Layer& layer_;
    scene::Run run_;
};

}  // namespace

bool is_hazard(scene::LayerRole role) noexcept {
    return role == scene::LayerRole::obstacle || role == scene::LayerRole::traffic || role == scene::LayerRole::no_go ||
           role == scene::LayerRole::storm_cell;
}

LayerFoci::LayerFoci(const FrameFoci* frame, const scene::Layer& layer, std::int64_t time_ns, bool has_date)
    : frame_(frame), layer_(&layer) {
    if (frame == nullptr) return;
    changes_ = frame->changes_data() && !is_hazard(layer.entry->role);
    const std::int64_t shown_ns = has_date ? scene::start_of_data_step(time_ns) : scene::own_time_ns(layer);
    for (std::size_t n = 0; n < frame->regions.size(); ++n) {
        const design::FocusSettings& focus = (*frame->foci)[n];
        if (focus.shape == design::FocusShape::data && is_meant(focus.data, layer))
            values_[n].emplace(layer, focus.data.attribute.view(), shown_ns);
    }
}

double LayerFoci::by_place(std::size_t focus, const ElementInput& input, std::uint32_t feature) const {
    const FocusRegion& region = frame_->regions[focus];
    const FocusMap& map = frame_->maps[focus];
    if (is_run(*layer_)) return Outline(region, map, *layer_, layer_->points_of(feature)).degree();
    const scene::ScenePoint& point = layer_->points[feature];
    const double degree = map.degree(region, point.latitude_rad, point.longitude_rad);
    if (!region.is_volume || degree <= scene::kMaxBesideVolume) return degree;
    const Placed at = placed(input, point);
    return at.is_known ? scene::focus_degree(region, at.place, at.height_m) : degree;
}

/// Of points of a feature that have values of their own the one that is most in focus.
double LayerFoci::by_value(std::size_t focus, std::uint32_t feature) const {
    const LayerValues& values = *values_[focus];
    const scene::FocusValueRange& range = frame_->ranges[focus];
    if (!is_run(*layer_) || !values.is_of_points())
        return feature < values.size() ? scene::degree_of_value(range, values[feature]) : 0;
    const scene::Run run = layer_->points_of(feature);
    double greatest = 0;
    for (std::uint32_t n = 0; n < run.count; ++n)
        greatest = std::fmax(greatest, scene::degree_of_value(range, values[run.first + n]));
    return greatest;
}

double LayerFoci::degree_in(std::size_t focus, const ElementInput& input, std::uint32_t feature) const {
    if (values_[focus].has_value()) return by_value(focus, feature);
    return frame_->regions[focus].is_valid ? by_place(focus, input, feature) : 0;
}

double LayerFoci::degree(const ElementInput& input, std::uint32_t feature) const {
    if (frame() == nullptr) return 1;
    double greatest = 0;
    for (std::size_t n = 0; n < frame_->regions.size() && greatest < 1; ++n)
        greatest = std::fmax(greatest, degree_in(n, input, feature));
    return greatest;
}

FocusLook LayerFoci::look(const ElementInput& input, std::uint32_t feature) const {
    return frame() == nullptr ? FocusLook() : look_at(*frame_, degree(input, feature));
}

FocusLook LayerFoci::look_of_point(const scene::PointOfFeature& of) const {
    if (frame() == nullptr) return {};
    const scene::ScenePoint& point = layer_->points[of.point];
    double greatest = 0;
    for (std::size_t n = 0; n < frame_->regions.size() && greatest < 1; ++n) {
        const FocusRegion& region = frame_->regions[n];
        if (values_[n].has_value())
            greatest = std::fmax(
                greatest,
                scene::degree_of_value(frame_->ranges[n], (*values_[n])[values_[n]->is_of_points() ? of.point : of.feature]));
        else if (region.is_valid)
            greatest = std::fmax(greatest, frame_->maps[n].degree(region, point.latitude_rad, point.longitude_rad));
    }
    FocusLook look = look_at(*frame_, greatest);
    look.is_hidden = false;
    return look;
}

FocusLook look_of_feature(const ElementInput& input, std::uint32_t feature) {
    return input.foci == nullptr ? FocusLook() : input.foci->look(input, feature);
}

namespace {

FocusCounts count_values(const LayerValues& values, const scene::FocusValueRange& range) {
    std::uint32_t in_focus = 0, beside = 0;
    const auto count = static_cast<std::uint32_t>(values.size());
    for (std::uint32_t n = 0; n < count; ++n) {
        const double value = values[n];
        // Without branches: what comes next cannot be guessed.
        const unsigned is_in = static_cast<unsigned>(value >= range.low) & static_cast<unsigned>(value <= range.high);
        const unsigned is_similar =
            static_cast<unsigned>(range.low - value < range.similar) & static_cast<unsigned>(value - range.high < range.similar);
        in_focus += is_in;
        beside += is_similar & ~is_in;
    }
    return {in_focus, beside, count - in_focus - beside};
}

FocusCounts count_posts(const FocusRegion& region, const FocusMap& map, const scene::GridShape& grid) {
    std::uint32_t parts[3] = {};
    for (std::uint32_t row = 0; row < grid.rows; ++row)
        for (std::uint32_t column = 0; column < grid.columns; ++column)
            ++parts[map.part(region, grid.north_rad - row * grid.step_lat_rad, grid.west_rad + column * grid.step_lon_rad)];
    return {parts[2], parts[1], parts[0]};
}

FocusCounts count_points(const FocusRegion& region, const FocusMap& map, const scene::Layer& layer) {
    std::uint32_t in_focus = 0, reached = 0;
    for (const scene::ScenePoint& point : layer.points) {
        const int part = map.part(region, point.latitude_rad, point.longitude_rad);
        in_focus += part == 2 ? 1 : 0;
        reached += part > 0 ? 1 : 0;
    }
    return {in_focus, reached - in_focus, static_cast<std::uint32_t>(layer.points.size()) - reached};
}

}  // namespace

FocusCounts count_in_focus(const FrameFoci& foci, std::size_t focus, const LayerFoci& layer, const ElementInput& input) {
    const scene::LayerEntry& entry = *input.layer.entry;
    const bool is_grid = entry.shape == scene::LayerShape::grid;
    const FocusRegion& region = foci.regions[focus];
    if (is_grid && layer.is_by_value(focus)) return count_values(layer.values(focus), foci.ranges[focus]);
    if (!region.is_valid && !layer.is_by_value(focus))
        return {0, 0, is_grid ? entry.grid.columns * entry.grid.rows : entry.feature_count};
    if (is_grid) return count_posts(region, foci.maps[focus], entry.grid);
    if (!is_run(input.layer) && !region.is_volume && !layer.is_by_value(focus))
        return count_points(region, foci.maps[focus], input.layer);
    FocusCounts counts;
    for (std::uint32_t n = 0; n < entry.feature_count; ++n) {
        const double degree = layer.degree_in(focus, input, n);
        ++(degree >= 1 ? counts.in_focus : degree > 0 ? counts.intermediate : counts.context);
    }
    return counts;
}

}  // namespace tedavis::draw
