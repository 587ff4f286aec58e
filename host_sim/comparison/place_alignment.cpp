#include "host_sim/comparison/place_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "host_sim/comparison/compared_run.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

/// The nearest place of a segment.
struct SegmentPlace {
    double share = 0;  // of the way along the segment, 0 to 1
    double distance_m = 0;
};

/// In a plane that touches the Earth at `from`; of the segment no less than `least_share`.
SegmentPlace nearest_on(const TrackPlace& from, const std::vector<TrackPlace>& other, std::size_t segment,
                        double least_share = 0) {
    const double narrow = std::cos(base::radians(from.latitude_deg));
    const auto east = [&](const TrackPlace& to) {
        return earth::wrap_longitude(base::radians(to.longitude_deg - from.longitude_deg)) * narrow * earth::kMeanRadius_m;
    };
    const auto north = [&](const TrackPlace& to) {
        return base::radians(to.latitude_deg - from.latitude_deg) * earth::kMeanRadius_m;
    };
    const TrackPlace& begin = other[segment];
    const bool is_point = !begin.joins_next || segment + 1 == other.size();
    const double x = east(begin), y = north(begin);
    if (is_point) return {0, std::hypot(x, y)};
    const double dx = east(other[segment + 1]) - x, dy = north(other[segment + 1]) - y, length2 = dx * dx + dy * dy;
    const double share = length2 > 0 ? std::clamp(-(x * dx + y * dy) / length2, least_share, 1.0) : least_share;
    return {share, std::hypot(x + share * dx, y + share * dy)};
}

/// For each place the best segment of the other track, in an order that does not go back.
std::vector<std::size_t> best_segments(const std::vector<TrackPlace>& track, const std::vector<TrackPlace>& other,
                                       double within_m) {
    const std::size_t columns = other.size();
    std::vector<double> sums(columns, 0.0);
    std::vector<std::uint32_t> came_from(track.size() * columns);
    for (std::size_t row = 0; row < track.size(); ++row) {
        std::size_t best = 0;
        double best_sum = sums[0];
        for (std::size_t column = 0; column < columns; ++column) {
            if (sums[column] < best_sum) best = column, best_sum = sums[column];
            const double distance_m = std::min(nearest_on(track[row], other, column).distance_m, within_m);
            came_from[row * columns + column] = static_cast<std::uint32_t>(best);
            sums[column] = best_sum + distance_m * distance_m;
        }
    }
    std::vector<std::size_t> segments(track.size());
    auto segment = static_cast<std::size_t>(std::min_element(sums.begin(), sums.end()) - sums.begin());
    for (std::size_t row = track.size(); row-- > 0;) {
        segments[row] = segment;
        segment = came_from[row * columns + segment];
    }
    return segments;
}

}  // namespace

std::vector<std::optional<PlacePair>> paired_places(const std::vector<TrackPlace>& track, const std::vector<TrackPlace>& other,
                                                    double within_m) {
    std::vector<std::optional<PlacePair>> pairs(track.size());
    if (track.empty() || other.empty()) return pairs;
    const std::vector<std::size_t> segments = best_segments(track, other, within_m);
    double along = 0;
    for (std::size_t n = 0; n < track.size(); ++n) {
        const auto segment = static_cast<double>(segments[n]);
        const SegmentPlace place = nearest_on(track[n], other, segments[n], std::clamp(along - segment, 0.0, 1.0));
        if (place.distance_m > within_m) continue;
        along = segment + place.share;
        pairs[n] = PlacePair{along, place.distance_m};
    }
    return pairs;
}

}  // namespace tedavis::host_sim
