#include "render_core/draw/data/focus_place.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/planned_track.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

using design::FocusAt;
using design::FocusSettings;
using design::FocusShape;
using scene::FocusRegion;

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

/// A place on the ground, or of the own ship.
struct FoundPlace {
    FocusState state = FocusState::no_such_place;
    double latitude_rad = 0, longitude_rad = 0;
    double height_m = kNowhere;  ///< over the ellipsoid
};

FocusState state_of(const flight::OwnShipEstimate& own_ship) {
    switch (own_ship.state) {
        case base::SignalState::valid: return FocusState::shown;
        case base::SignalState::stale: return FocusState::position_stale;
        default: return FocusState::no_position;
    }
}

FoundPlace found_at(double latitude_rad, double longitude_rad, scene::Ground& ground) {
    return {FocusState::shown, latitude_rad, longitude_rad, ground.height_m(latitude_rad, longitude_rad)};
}

/// The middle of a feature's points, in the plane of angles at the first one.
FoundPlace middle_of(const scene::Layer& layer, std::uint32_t feature, scene::Ground& ground) {
    const bool is_run = layer.entry->shape == scene::LayerShape::lines || layer.entry->shape == scene::LayerShape::areas;
    const scene::Run run = is_run ? layer.points_of(feature) : scene::Run{feature, 1};
    if (run.count == 0) return {};
    const scene::ScenePoint& first = layer.points[run.first];
    double north = 0, east = 0;
    for (std::uint32_t n = 0; n < run.count; ++n) {
        const scene::ScenePoint& point = layer.points[run.first + n];
        north += (point.latitude_rad - first.latitude_rad) / run.count;
        east += std::remainder(point.longitude_rad - first.longitude_rad, 2 * base::kPi) / run.count;
    }
    return found_at(first.latitude_rad + north, earth::wrap_longitude(first.longitude_rad + east), ground);
}

FoundPlace named_in(const scene::Layer& layer, std::string_view name, scene::Ground& ground) {
    if (layer.entry->shape == scene::LayerShape::grid) return {};
    for (std::uint32_t feature = 0; feature < layer.entry->feature_count; ++feature)
        if (layer.name_of(feature) == name) return middle_of(layer, feature, ground);
    return {};
}

FoundPlace named(const FocusFrame& frame, std::string_view name, scene::LayerRole first, bool others_too) {
    for (const bool is_first : {true, false}) {
        if (frame.scene == nullptr || (!is_first && !others_too)) break;
        for (const scene::Layer& layer : frame.scene->layers()) {
            if ((layer.entry->role == first) != is_first) continue;
            const FoundPlace found = named_in(layer, name, frame.ground);
            if (is_shown(found.state)) return found;
        }
    }
    return {};
}

PlannedTrack way_of(const FocusFrame& frame) {
    if (frame.scene == nullptr || !is_shown(state_of(frame.own_ship))) return {};
    return planned_track(*frame.scene, frame.own_ship.position, frame.time.utc.ns, frame.time.is_date, kFarthestTrack_m);
}

FoundPlace nearest_runway(const FocusFrame& frame, const earth::Geodetic& to) {
    FoundPlace nearest;
    nearest.state = FocusState::no_runway;
    double least_m = std::numeric_limits<double>::infinity();
    for (const scene::Layer& layer : frame.scene->layers()) {
        if (layer.entry->role != scene::LayerRole::runway) continue;
        for (std::uint32_t feature = 0; feature < layer.entry->feature_count; ++feature) {
            const FoundPlace found = middle_of(layer, feature, frame.ground);
            const double distance_m = glm::distance(earth::to_ecef({found.latitude_rad, found.longitude_rad, {0}}),
                                                    earth::to_ecef({to.latitude_rad, to.longitude_rad, {0}}));
            if (!is_shown(found.state) || !(distance_m < least_m)) continue;
            least_m = distance_m;
            nearest = found;
        }
    }
    return nearest;
}

FoundPlace destination(const FocusSettings& focus, const FocusFrame& frame) {
    FoundPlace none;
    none.state = FocusState::no_runway;
    if (frame.scene == nullptr) return none;
    if (!focus.place.empty()) {
        const FoundPlace found = named(frame, focus.place.view(), scene::LayerRole::runway, false);
        return is_shown(found.state) ? found : none;
    }
    const FocusState own = state_of(frame.own_ship);
    none.state = own;
    if (!is_shown(own)) return none;
    const PlannedTrack way = way_of(frame);
    if (way.layer == nullptr) return nearest_runway(frame, frame.own_ship.position);
    const scene::ScenePoint& last = way.layer->points[way.run.first + way.run.count - 1];
    return nearest_runway(frame, {last.latitude_rad, last.longitude_rad, {0}});
}

FoundPlace find(const FocusSettings& focus, const FocusFrame& frame) {
    const earth::Geodetic& own = frame.own_ship.position;
    switch (focus.at) {
        case FocusAt::destination: return destination(focus, frame);
        case FocusAt::place: return named(frame, focus.place.view(), scene::LayerRole::place, true);
        case FocusAt::hazard:
            if (frame.hazard == nullptr) return {FocusState::no_hazard};
            return {FocusState::shown, frame.hazard->latitude_rad, frame.hazard->longitude_rad, frame.hazard->height.m};
        case FocusAt::position: return found_at(focus.latitude_rad, focus.longitude_rad, frame.ground);
        default: return {state_of(frame.own_ship), own.latitude_rad, own.longitude_rad, frame.own_height_m};
    }
}

void make_volume(const FocusSettings& focus, const FoundPlace& found, scene::Ground& ground, FocusRegion& region) {
    const double geoid_m = ground.undulation_m(found.latitude_rad, found.longitude_rad);
    region.is_ball = focus.shape == FocusShape::sphere;
    region.is_volume = region.is_ball || focus.shape == FocusShape::cuboid;
    if (!region.is_volume) return;
    const double middle_m = focus.has_height ? focus.height_m + geoid_m : found.height_m;
    region.lower_m = region.is_ball ? middle_m : focus.lower_m + geoid_m;
    region.upper_m = region.is_ball ? middle_m : focus.upper_m + geoid_m;
}

FocusRegion region_of(const FocusSettings& focus, double latitude_rad, double longitude_rad) {
    FocusRegion region = scene::focus_region_at(latitude_rad, longitude_rad);
    region.context = focus.context;
    region.radius_m = focus.radius_m;
    region.is_square = focus.shape == FocusShape::square || focus.shape == FocusShape::cuboid;
    region.point_count = 1;
    return region;
}

glm::dvec2 in_plane(const FocusRegion& region, const scene::ScenePoint& point) {
    return scene::in_focus_plane(region, earth::to_ecef({point.latitude_rad, point.longitude_rad, {0}}));
}

double distance_to_leg(const glm::dvec2& place, const glm::dvec2& from, const glm::dvec2& to) {
    const glm::dvec2 along = to - from, way = place - from;
    const double square = glm::dot(along, along);
    return glm::length(way - along * (square > 0 ? std::clamp(glm::dot(way, along) / square, 0.0, 1.0) : 0));
}

/// A part of the way: corners from `first` to `end`, between its two ends.
struct Ahead {
    const PlannedTrack& way;
    std::uint32_t first = 0, end = 0;
    scene::ScenePoint last{};
};

double length_m(const scene::ScenePoint& from, const scene::ScenePoint& to) {
    return glm::distance(earth::to_ecef({from.latitude_rad, from.longitude_rad, {0}}),
                         earth::to_ecef({to.latitude_rad, to.longitude_rad, {0}}));
}

/// By the times of the way's points, else by the speed.
Ahead ahead_of(const PlannedTrack& way, const FocusSettings& focus, const FocusFrame& frame) {
    const scene::ScenePoint here = point_on(way, way.leg, way.part);
    const bool by_time = here.time_ns != scene::kNoTime;
    const double speed_mps = std::hypot(frame.own_ship.velocity_east_mps, frame.own_ship.velocity_north_mps);
    double left = by_time ? focus.ahead_s : focus.ahead_s * speed_mps;
    Ahead ahead{way, way.leg + 1, way.leg + 1, here};
    double part = way.part;
    for (std::uint32_t leg = way.leg; leg + 1 < way.run.count && left > 0; ++leg, part = 0) {
        const scene::ScenePoint from = point_on(way, leg, part), &to = way.layer->points[way.run.first + leg + 1];
        if (by_time && (from.time_ns == scene::kNoTime || to.time_ns == scene::kNoTime)) break;
        const double length = by_time ? 1e-9 * static_cast<double>(to.time_ns - from.time_ns) : length_m(from, to);
        ahead.end = leg + 1;
        ahead.last = length > left ? point_on(way, leg, part + (1 - part) * left / length) : to;
        left -= length;
    }
    return ahead;
}

/// The two ends, then corner by corner the one farthest from what there is.
void keep_corners(const Ahead& ahead, const scene::ScenePoint& here, FocusRegion& region) {
    std::array<std::uint32_t, scene::kMaxFocusPoints> numbers{};
    region.points[0] = in_plane(region, here);
    region.points[1] = in_plane(region, ahead.last);
    numbers[0] = ahead.first - 1;
    numbers[1] = ahead.end;
    region.point_count = 2;
    constexpr double kSameShare = 0.02;  // share of the radius; such a corner is invisible
    const double same_m = kSameShare * region.radius_m;
    while (region.point_count < scene::kMaxFocusPoints) {
        double farthest_m = same_m;
        std::uint32_t number = 0, after = 0;
        for (std::uint32_t n = 0; n + 1 < region.point_count; ++n)
            for (std::uint32_t k = numbers[n] + 1; k < numbers[n + 1]; ++k) {
                const glm::dvec2 place = in_plane(region, ahead.way.layer->points[ahead.way.run.first + k]);
                const double distance_m = distance_to_leg(place, region.points[n], region.points[n + 1]);
                if (distance_m <= farthest_m) continue;
                farthest_m = distance_m;
                number = k;
                after = n;
            }
        if (farthest_m <= same_m) return;
        for (std::uint32_t n = region.point_count; n > after + 1; --n) {
            region.points[n] = region.points[n - 1];
            numbers[n] = numbers[n - 1];
        }
        region.points[after + 1] = in_plane(region, ahead.way.layer->points[ahead.way.run.first + number]);
        numbers[after + 1] = number;
        ++region.point_count;
    }
}

FocusPlace path_ahead(const FocusSettings& focus, const FocusFrame& frame) {
    FocusPlace place{state_of(frame.own_ship), {}, frame.own_height_m};
    if (!is_shown(place.state)) return place;
    const earth::Geodetic& own = frame.own_ship.position;
    FocusRegion region = region_of(focus, own.latitude_rad, own.longitude_rad);
    region.kind = scene::FocusPoints::path;
    const PlannedTrack way = way_of(frame);
    if (way.layer != nullptr) {
        keep_corners(ahead_of(way, focus, frame), point_on(way, way.leg, way.part), region);
    } else {
        const glm::dvec2 velocity{frame.own_ship.velocity_east_mps, frame.own_ship.velocity_north_mps};
        if (glm::length(velocity) < kMinSpeed_mps) return {FocusState::no_motion, {}, frame.own_height_m};
        region.points[1] = velocity * focus.ahead_s;
        region.point_count = 2;
    }
    place.region = region;
    return place;
}

}  // namespace

const char* reason_of(FocusState state) noexcept {
    switch (state) {
        case FocusState::shown: return "";
        case FocusState::position_stale: return "the own ship's position is held";
        case FocusState::no_position: return "the own ship's position is not known";
        case FocusState::no_motion: return "the own ship stands, and no way is planned here";
        case FocusState::no_such_place: return "the scene has no feature of that name";
        case FocusState::no_runway: return "the scene has no such runway";
        case FocusState::no_hazard: return "no hazard lies on the way";
        case FocusState::no_such_data: return "no data of that kind hold now";
        case FocusState::no_such_value: return "no data have such a value now";
    }
    return "";
}

FocusPlace place_of(const FocusSettings& focus, const FocusFrame& frame) {
    if (focus.shape == FocusShape::path) return path_ahead(focus, frame);
    const FoundPlace found = find(focus, frame);
    FocusPlace place{found.state, {}, found.height_m};
    if (!is_shown(found.state)) return place;
    place.region = region_of(focus, found.latitude_rad, found.longitude_rad);
    make_volume(focus, found, frame.ground, place.region);
    return place;
}

}  // namespace tedavis::draw
