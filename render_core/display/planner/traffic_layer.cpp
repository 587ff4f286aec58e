#include "render_core/display/planner/traffic_layer.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "render_core/display/planner/stated_layer.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::display {
namespace {

using flight::TrafficPlace;
using flight::TrafficReport;

/// Of standard deviations: within the circle that 95 % of a normal distribution's places lie in, and the interval of its heights.
constexpr double kCircleOf95 = 2.4477468306808166, kIntervalOf95 = 1.959963984540054;

float accuracy_m(float deviation_m, double factor) {
    return deviation_m > 0 ? static_cast<float>(factor * static_cast<double>(deviation_m))
                           : std::numeric_limits<float>::quiet_NaN();
}

/// Where it was by its velocity. Beside a pole east is nowhere.
TrafficPlace place_before(const TrafficReport& report, double seconds) {
    TrafficPlace place = report.place;
    const double latitude = place.latitude_rad, track = static_cast<double>(report.true_track_rad);
    const double gone_m = static_cast<double>(report.ground_speed_mps) * seconds;
    place.latitude_rad -= gone_m * std::cos(track) / earth::meridian_radius_m(latitude);
    const double circle_m = earth::prime_vertical_radius_m(latitude) * std::cos(latitude);
    if (circle_m > 1) place.longitude_rad = earth::wrap_longitude(place.longitude_rad - gone_m * std::sin(track) / circle_m);
    place.height_m -= static_cast<float>(static_cast<double>(report.climb_mps) * seconds);
    place.at = place.at - base::Duration::from_seconds(seconds);
    return place;
}

/// Six hexadecimal digits, as an address of 24 bits is written.
void write_address(std::uint32_t address, char* text) {
    for (int digit = 0; digit < 6; ++digit) text[digit] = "0123456789ABCDEF"[address >> (20 - 4 * digit) & 0xFu];
}

}  // namespace

TrafficLayer::TrafficLayer() {
    name_layer(entry_, "received_traffic", "Traffic");
    entry_.shape = scene::LayerShape::lines;
    entry_.role = scene::LayerRole::traffic;
    constexpr std::string_view kNames[kAttributes] = {"position_accuracy", "height_accuracy"};
    for (std::size_t n = 0; n < kAttributes; ++n) {
        name_attribute(attribute_entries_[n], kNames[n], "m");
        attributes_[n].entry = &attribute_entries_[n];
    }
    layer_.entry = &entry_;
    layer_.attributes = attributes_;
}

bool TrafficLayer::start(base::Arena& arena) {
    points_ = arena.allocate_array<scene::ScenePoint>(kMaxPoints);
    starts_ = arena.allocate_array<std::uint32_t>(flight::kMaxTraffic + 1);
    names_ = arena.allocate_array<char>(flight::kMaxTraffic * scene::kNameBytes);
    for (auto& values : values_) values = arena.allocate_array<float>(kMaxPoints);
    return !points_.empty() && !starts_.empty() && !names_.empty() && !values_[0].empty() && !values_[1].empty();
}

void TrafficLayer::take(const flight::Traffic& traffic, base::Duration ahead) {
    ahead_ = ahead;
    point_count_ = aircraft_count_ = 0;
    entry_.data_time_ns = scene::kNoTime;
    for (const TrafficReport& report : traffic.reports) add(report);
    starts_[aircraft_count_] = point_count_;
    layer_.points = {points_.data(), point_count_};
    layer_.starts = {starts_.data(), std::size_t{aircraft_count_} + 1};
    layer_.names = {names_.data(), std::size_t{aircraft_count_} * scene::kNameBytes};
    entry_.feature_count = aircraft_count_;
    entry_.point_count = point_count_;
    for (std::size_t n = 0; n < kAttributes; ++n) {
        attributes_[n].values = {values_[n].data(), point_count_};
        set_range(attributes_[n].values, attribute_entries_[n]);
    }
}

void TrafficLayer::add(const TrafficReport& report) {
    starts_[aircraft_count_] = point_count_;
    const TrafficPlace before = place_before(report, kBefore.to_seconds());
    for (const TrafficPlace& place : report.before)
        if (place.at < before.at) add_point(place);
    add_point(before);
    add_point(report.place);
    char* const name = names_.data() + std::size_t{aircraft_count_} * scene::kNameBytes;
    std::memset(name, 0, scene::kNameBytes);
    if (report.callsign.empty())
        write_address(report.address, name);
    else
        std::memcpy(name, report.callsign.c_str(), report.callsign.size());
    entry_.data_time_ns = std::max(entry_.data_time_ns, points_[point_count_ - 1].time_ns);
    ++aircraft_count_;
}

void TrafficLayer::add_point(const TrafficPlace& place) {
    points_[point_count_] = {place.latitude_rad, place.longitude_rad, place.height_m, 0, (place.at + ahead_).ns};
    values_[0][point_count_] = accuracy_m(place.position_deviation_m, kCircleOf95);
    values_[1][point_count_] = accuracy_m(place.height_deviation_m, kIntervalOf95);
    ++point_count_;
}

}  // namespace tedavis::display
