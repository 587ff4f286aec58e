#include "target/self_test/geodesy_check.hpp"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render_core/base/units.hpp"

namespace tedavis::target {
namespace {

using base::radians;

// What tests/render_core/earth proves of the conversions, and some room.
constexpr double kLimit_m = 2e-6;
constexpr double kDistanceLimit = 1e-6;  // of the distance

constexpr double kLatitudes_deg[] = {-90, -89.999999, -66.5, -45, -12.25, 0, 1e-7, 23.4, 46.8, 60, 80.5, 89.9999, 90};
constexpr double kLongitudes_deg[] = {-180, -84.25, 179.999999};
constexpr double kHeights_m[] = {-430, 0, 20'000};

/// NaN counts as the greatest.
void take_greater(double& greatest, double difference) {
    if (!(difference <= greatest)) greatest = std::isnan(greatest) ? greatest : difference;
}

/// The distance between two places that are close to each other, by the reference's coordinates.
double distance_m(const earth::Ecef& a, const earth::Ecef& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

earth::Ecef reference_ecef(double latitude_deg, double longitude_deg, double height_m) {
    earth::Ecef place{};
    GeographicLib::Geocentric::WGS84().Forward(latitude_deg, longitude_deg, height_m, place.x, place.y, place.z);
    return place;
}

struct Differences {
    double to_ecef_m = 0, from_ecef_m = 0, distance_share = 0;
};

void compare_place(double latitude_deg, double longitude_deg, double height_m, const OwnGeodesy& own, Differences& differences) {
    const earth::Geodetic place{radians(latitude_deg), radians(longitude_deg), {height_m}};
    const earth::Ecef reference = reference_ecef(latitude_deg, longitude_deg, height_m);
    take_greater(differences.to_ecef_m, distance_m(own.to_ecef(place), reference));
    const earth::Geodetic back = own.from_ecef(reference);
    take_greater(differences.from_ecef_m,
                 distance_m(reference_ecef(base::degrees(back.latitude_rad), base::degrees(back.longitude_rad), back.height.m),
                            reference));
}

/// From the place to one 0.7 degrees north, or south of it near the north pole, and 1.3 degrees east.
void compare_distance(double latitude_deg, double longitude_deg, const OwnGeodesy& own, Differences& differences) {
    const double other_deg = latitude_deg > 89 ? latitude_deg - 0.7 : latitude_deg + 0.7, east_deg = longitude_deg + 1.3;
    double reference_m = 0;
    GeographicLib::Geodesic::WGS84().Inverse(latitude_deg, longitude_deg, other_deg, east_deg, reference_m);
    const double own_m = own.surface_distance_m({radians(latitude_deg), radians(longitude_deg), {0}},
                                                {radians(other_deg), radians(east_deg), {0}});
    take_greater(differences.distance_share, std::abs(own_m - reference_m) / reference_m);
}

void add(SelfTestReport& report, const char* name, double difference, double limit, const char* unit) {
    char finding[96];
    std::snprintf(finding, sizeof finding, "differs from GeographicLib by %.2g%s, allowed %.2g%s", difference, unit, limit, unit);
    report.add(name, difference <= limit, finding);
}

}  // namespace

void check_geodesy(SelfTestReport& report, const OwnGeodesy& own) noexcept {
    Differences differences;
    for (const double latitude_deg : kLatitudes_deg)
        for (const double longitude_deg : kLongitudes_deg) {
            for (const double height_m : kHeights_m) compare_place(latitude_deg, longitude_deg, height_m, own, differences);
            compare_distance(latitude_deg, longitude_deg, own, differences);
        }
    add(report, "geodetic_to_ecef", differences.to_ecef_m, kLimit_m, " m");
    add(report, "ecef_to_geodetic", differences.from_ecef_m, kLimit_m, " m");
    add(report, "surface_distance", differences.distance_share, kDistanceLimit, " of the distance");
}

}  // namespace tedavis::target
