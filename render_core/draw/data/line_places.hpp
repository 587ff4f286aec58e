/// Positions of vertical lines along a path (trajectory_cues.hpp), at a constant spacing, fixed or moving. Pure.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>

#include "render_core/design/element_cues.hpp"

namespace tedavis::draw {

/// Measures a path's length, and the distance along it to the point nearest to the eye point.
class PolylineMeasure {
public:
    /// `from` and `to` are relative to the eye point, m.
    void add_leg(double length_m, const glm::dvec3& from, const glm::dvec3& to);

    [[nodiscard]] double length_m() const { return length_m_; }
    [[nodiscard]] double nearest_m() const { return nearest_m_; }

private:
    double length_m_ = 0, nearest_m_ = 0, least_m_ = std::numeric_limits<double>::infinity();
};

class LinePlaces {
public:
    /// `from_end`: fixed lines are counted from the path's end backwards.
    LinePlaces(const design::ElementCues& cues, const PolylineMeasure& way, bool from_end, std::int64_t time_ns);

    /// Calls `visitor` with the distance along the path of each line in [begin_m, end_m); for the last leg `end_m` is included.
    template <class Visitor>
    void visit(double begin_m, double end_m, bool is_last, Visitor visitor) const {
        constexpr double kRounding_m = 1e-3;
        const double stop_m = is_last ? end_m + kRounding_m : end_m;
        visit_part(begin_m, std::fmin(stop_m, parts_at_m_), before_m_, visitor);
        visit_part(std::fmax(begin_m, parts_at_m_), stop_m, behind_m_, visitor);
    }

private:
    template <class Visitor>
    void visit_part(double begin_m, double end_m, double offset_m, Visitor visitor) const {
        if (!(begin_m < end_m)) return;
        const auto first = static_cast<std::int64_t>(std::ceil((begin_m - offset_m) / spacing_m_));
        const auto last = static_cast<std::int64_t>(std::ceil((end_m - offset_m) / spacing_m_));
        for (std::int64_t n = first; n < last; ++n) visitor(offset_m + spacing_m_ * static_cast<double>(n));
    }

    double spacing_m_;
    double parts_at_m_ = 0;               ///< distance at which the path is nearest to the eye point
    double before_m_ = 0, behind_m_ = 0;  ///< position of one line on either side of parts_at_m_
};

}  // namespace tedavis::draw
