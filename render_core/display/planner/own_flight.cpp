#include "render_core/display/planner/own_flight.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/display/planner/stated_layer.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::display {
namespace {

using flight::FlightTrail;
using flight::FlownPoint;

double height_over_ellipsoid_m(const FlownPoint& point, scene::Ground& ground) {
    const double height_m = static_cast<double>(point.height_m);
    return point.is_geometric ? height_m : height_m + ground.undulation_m(point.latitude_rad, point.longitude_rad);
}

bool has_wind(const FlownPoint& point) { return std::isfinite(point.wind_speed_mps); }

}  // namespace

OwnFlight::OwnFlight() {
    name_layer(trail_entry_, "own_trail", "Own ship");
    trail_entry_.shape = scene::LayerShape::lines;
    trail_entry_.role = scene::LayerRole::trajectory;
    trail_entry_.position_accuracy_m = trail_entry_.height_accuracy_m = kUnstatedAccuracy_m;
    name_layer(winds_entry_, "own_wind", "Measured wind");
    winds_entry_.shape = scene::LayerShape::points;
    winds_entry_.role = scene::LayerRole::wind;
    constexpr std::string_view kNames[kAttributes] = {"position_accuracy", "height_accuracy", "wind_speed", "temperature"};
    constexpr std::string_view kUnits[kAttributes] = {"m", "m", "m/s", "K"};
    for (std::size_t n = 0; n < kAttributes; ++n) {
        name_attribute(trail_attribute_entries_[n], kNames[n], kUnits[n]);
        trail_attributes_[n].entry = &trail_attribute_entries_[n];
    }
    name_attribute(wind_speed_entry_, "speed", "m/s");
    wind_speed_.entry = &wind_speed_entry_;
    trail_.entry = &trail_entry_;
    trail_.attributes = trail_attributes_;
    winds_.entry = &winds_entry_;
    winds_.attributes = {&wind_speed_, 1};
}

bool OwnFlight::start(base::Arena& arena) {
    points_ = arena.allocate_array<scene::ScenePoint>(kMaxPoints);
    starts_ = arena.allocate_array<std::uint32_t>(kMaxPoints + 1);
    for (auto& values : values_) values = arena.allocate_array<float>(kMaxPoints);
    measured_ = arena.allocate_array<FlownPoint>(kMaxWinds);
    glyphs_ = arena.allocate_array<scene::SelectedGlyph>(kMaxWinds);
    return !points_.empty() && !starts_.empty() && !values_[kAttributes - 1].empty() && !measured_.empty() && !glyphs_.empty();
}

void OwnFlight::take(const OwnFlightFrame& frame, const flight::FlightTime& time, scene::Ground& ground) {
    point_count_ = part_count_ = wind_count_ = 0;
    ahead_ = time.utc - frame.now;
    if (frame.way != nullptr && frame.aircraft != nullptr) {
        const FlightTrail& way = *frame.way;
        for (std::size_t n = 0; n < way.size(); ++n) {
            add(way[n], n == 0 || way[n].begins, ground);
            if ((way.number_of_oldest() + n) % kWindEvery == 0) add_wind(way[n], ground);
        }
        const FlownPoint here = flight::flown_point(*frame.aircraft, frame.now);
        const bool is_here = frame.aircraft->own_ship.state == base::SignalState::valid && way.goes_on_to(here);
        if (is_here) add(here, false, ground);
        if (is_here && has_wind(here))
            add_wind(here, ground);
        else
            wind_count_ = 0;
    }
    finish_trail();
    finish_winds();
}

void OwnFlight::add(const FlownPoint& point, bool begins, scene::Ground& ground) {
    if (begins) starts_[part_count_++] = point_count_;
    points_[point_count_] = {point.latitude_rad, point.longitude_rad, static_cast<float>(height_over_ellipsoid_m(point, ground)),
                             0, (point.at + ahead_).ns};
    values_[kPositionAccuracy][point_count_] = point.position_accuracy_m;
    values_[kHeightAccuracy][point_count_] = point.height_accuracy_m;
    values_[kWindSpeed][point_count_] = point.wind_speed_mps;
    values_[kTemperature][point_count_] = point.temperature_k;
    ++point_count_;
}

void OwnFlight::add_wind(const FlownPoint& point, scene::Ground& ground) {
    if (!has_wind(point)) return;
    measured_[wind_count_] = point;
    measured_[wind_count_++].height_m = static_cast<float>(height_over_ellipsoid_m(point, ground));
}

void OwnFlight::finish_trail() {
    starts_[part_count_] = point_count_;
    trail_.points = {points_.data(), point_count_};
    trail_.starts = {starts_.data(), std::size_t{part_count_} + 1};
    trail_entry_.feature_count = part_count_;
    trail_entry_.point_count = point_count_;
    trail_entry_.data_time_ns = point_count_ > 0 ? points_[point_count_ - 1].time_ns : scene::kNoTime;
    for (std::size_t n = 0; n < kAttributes; ++n) {
        trail_attributes_[n].values = {values_[n].data(), point_count_};
        set_range(trail_attributes_[n].values, trail_attribute_entries_[n]);
    }
}

void OwnFlight::finish_winds() {
    winds_entry_.feature_count = winds_entry_.point_count = wind_count_;
    winds_entry_.data_time_ns = wind_count_ > 0 ? (measured_[wind_count_ - 1].at + ahead_).ns : scene::kNoTime;
}

base::Span<const scene::SelectedGlyph> OwnFlight::wind_glyphs(const glm::dvec3& eye) {
    for (std::size_t n = 0; n < wind_count_; ++n) {
        const FlownPoint& at = measured_[n];
        scene::GlyphSummary& summary = glyphs_[n].summary;
        summary = {};
        summary.place = glm::vec3(earth::to_ecef({at.latitude_rad, at.longitude_rad, {static_cast<double>(at.height_m)}}) - eye);
        summary.value = -at.wind_speed_mps * std::sin(at.wind_from_rad);
        summary.north_mps = -at.wind_speed_mps * std::cos(at.wind_from_rad);
        summary.speed_mps = at.wind_speed_mps;
        summary.members = 1;
        summary.state = scene::ValueState::valid;
        glyphs_[n].is_aggregate = false;
    }
    return {glyphs_.data(), wind_count_};
}

}  // namespace tedavis::display
