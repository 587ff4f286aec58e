#include "render_core/draw/data/line_places.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace tedavis::draw {
namespace {

constexpr double kSecond_ns = 1e9;

/// Part of a spacing that a line has gone, by whole periods of nanoseconds: the same at all times, however large.
double gone_share(const design::ElementCues& cues, std::int64_t time_ns) {
    if (cues.lines_move == design::LineMotion::still) return 0;
    const std::int64_t period_ns =
        std::max<std::int64_t>(1, std::llround(cues.line_spacing_m / cues.line_speed_mps * kSecond_ns));
    const std::int64_t gone_ns = (time_ns % period_ns + period_ns) % period_ns;
    return static_cast<double>(gone_ns) / static_cast<double>(period_ns);
}

}  // namespace

void PolylineMeasure::add_leg(double length_m, const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 way = to - from;
    const double square = glm::dot(way, way);
    const double share = square > 0 ? std::clamp(-glm::dot(from, way) / square, 0.0, 1.0) : 0;
    const double distance_m = glm::length(from + way * share);
    if (distance_m < least_m_) {
        least_m_ = distance_m;
        nearest_m_ = length_m_ + share * length_m;
    }
    length_m_ += length_m;
}

LinePlaces::LinePlaces(const design::ElementCues& cues, const PolylineMeasure& way, bool from_end, std::int64_t time_ns)
    : spacing_m_(cues.line_spacing_m) {
    const double still_m = from_end ? std::fmod(way.length_m(), spacing_m_) : 0;
    const double gone_m = spacing_m_ * gone_share(cues, time_ns);
    if (cues.lines_move == design::LineMotion::away) parts_at_m_ = way.nearest_m();
    before_m_ = still_m - gone_m;
    behind_m_ = still_m + gone_m;
}

}  // namespace tedavis::draw
