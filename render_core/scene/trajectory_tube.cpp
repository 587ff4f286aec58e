#include "render_core/scene/trajectory_tube.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::scene {
namespace {

// Written so that NaN is none.
bool is_place(const glm::dvec3& p) {
    return std::abs(p.x) <= kFarthestTubePoint_m && std::abs(p.y) <= kFarthestTubePoint_m &&
           std::abs(p.z) <= kFarthestTubePoint_m;
}

bool is_usable(const TubePoint& point) {
    return is_place(point.position) && point.radius_m > 0 && point.radius_m <= kFarthestTubePoint_m;
}

double least_step_m(const glm::dvec3& place) { return std::max(kMinTubeStep_m, kMinTubeStepOfDistance * glm::length(place)); }

/// A straight way between two points that are kept.
struct Leg {
    glm::dvec3 direction{0};
    double length_m = 0;
};

Leg leg_between(const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 way = to - from;
    const double length_m = glm::length(way);
    return {way / length_m, length_m};
}

/// Of the circle through the three points: the nearer neighbour counts for more.
glm::dvec3 tangent_between(const Leg& in, const Leg& out) {
    return glm::normalize(out.length_m * in.direction + in.length_m * out.direction);
}

/// The circle through the three points has the radius |chord| / (2 sin(turn)).
bool bends_within(const Leg& in, const Leg& out, double radius_m) {
    const glm::dvec3 chord = in.length_m * in.direction + out.length_m * out.direction;
    return glm::length(chord) < 2 * radius_m * glm::length(glm::cross(in.direction, out.direction));
}

class TubeMaker {
public:
    TubeMaker(const glm::dvec3& up, base::Span<TubeRing> rings) : up_(up), rings_(rings) {}

    void add(const TubePoint& point, std::uint32_t source) {
        if (!is_usable(point)) {
            ++counts_.missing_points;
            end_piece();
            return;
        }
        if (has_time_ && point.time < time_) {
            ++counts_.times_back;
            end_piece();
        }
        time_ = point.time;
        has_time_ = true;
        if (is_open_ && glm::length(point.position - here_.centre) < least_step_m(point.position)) {
            ++counts_.close_points;
            return;
        }
        if (is_open_) go_to(point.position);
        here_.centre = point.position;
        here_.radius_m = point.radius_m;
        here_.source = source;
        is_open_ = true;
    }

    void end_piece() {
        if (!is_open_) return;
        here_.is_marker = !has_leg_;
        if (has_leg_) {
            place_ring(in_.direction);
        } else {
            place_first_ring({1, 0, 0});
        }
        close_piece();
        is_open_ = has_leg_ = here_.is_marker = false;
    }

    [[nodiscard]] bool is_full() const { return is_full_; }

    /// A piece that had room for its first ring only is none.
    [[nodiscard]] TubeCounts finish(std::size_t points) {
        end_piece();
        const std::uint32_t whole = rings_in_piece_ == 1 ? counts_.rings - 1 : counts_.rings;
        counts_.rings = whole;
        counts_.pieces = whole == 0 ? 0 : rings_[whole - 1].piece + 1;
        if (is_full_)
            counts_.points_left_out = static_cast<std::uint32_t>(points) - (whole == 0 ? 0 : rings_[whole - 1].source + 1);
        return counts_;
    }

private:
    /// Places the ring at the last point, now that the way on is known.
    void go_to(const glm::dvec3& next) {
        const Leg out = leg_between(here_.centre, next);
        if (!has_leg_) {
            place_first_ring(out.direction);
        } else if (glm::dot(in_.direction, out.direction) < kCuspCosine) {
            place_ring(in_.direction);
            close_piece();
            place({out.direction, normal_towards(frame_.normal, out.direction)});
            counts_.cusps += is_full_ ? 0 : 1;
        } else {
            here_.folds = bends_within(in_, out, here_.radius_m);
            place_ring(tangent_between(in_, out));
            here_.folds = false;
        }
        in_ = out;
        has_leg_ = true;
    }

    [[nodiscard]] glm::dvec3 upwards() const { return up_ == glm::dvec3(0) ? here_.centre : up_; }
    void place_first_ring(const glm::dvec3& tangent) { place({tangent, normal_towards(upwards(), tangent)}); }
    void place_ring(const glm::dvec3& tangent) { place(carried(frame_, here_.centre - frame_centre_, tangent)); }

    void place(const TubeFrame& frame) {
        frame_ = frame;
        frame_centre_ = here_.centre;
        is_full_ = counts_.rings == rings_.size();
        if (is_full_) return;
        here_.frame = frame;
        here_.piece = piece_;
        rings_[counts_.rings++] = here_;
        ++rings_in_piece_;
        counts_.markers += here_.is_marker ? 1 : 0;
        counts_.folds += here_.folds ? 1 : 0;
    }

    void close_piece() {
        if (is_full_) return;
        rings_in_piece_ = 0;
        ++piece_;
    }

    const glm::dvec3 up_;
    const base::Span<TubeRing> rings_;
    TubeCounts counts_;
    TubeRing here_;  ///< the last point that was kept; its ring waits for the way on
    Leg in_;         ///< the way to it
    TubeFrame frame_;
    glm::dvec3 frame_centre_{0};
    base::Time time_;
    std::uint32_t piece_ = 0, rings_in_piece_ = 0;
    bool has_time_ = false, is_open_ = false, has_leg_ = false, is_full_ = false;
};

}  // namespace

TubeCounts make_tube(base::Span<const TubePoint> points, const glm::dvec3& up, base::Span<TubeRing> rings) noexcept {
    TubeMaker maker(up, rings);
    for (std::size_t n = 0; n < points.size() && !maker.is_full(); ++n) maker.add(points[n], static_cast<std::uint32_t>(n));
    return maker.finish(points.size());
}

}  // namespace tedavis::scene
