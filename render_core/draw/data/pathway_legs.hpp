/// The legs of a layer's line in space, and how far along the line they are.
///
/// Pure, apart from queries to the ground. Bounded: the line's points. Thread  the ground's.
#pragma once

#include <glm/geometric.hpp>

#include "render_core/draw/data/placement.hpp"

namespace tedavis::draw {

struct PathwayLeg {
    glm::dvec3 from{0}, to{0};     ///< ECEF
    double from_m = 0, to_m = 0;   ///< along the line
    std::uint32_t leg = 0;         ///< from the line's leg-th point to the next one
    std::uint32_t from_point = 0;  ///< number of the leg's first point in the layer
    bool goes_on = false;          ///< the leg before has a place, too

    [[nodiscard]] glm::dvec3 at(double along_m) const {
        return to_m > from_m ? from + (to - from) * ((along_m - from_m) / (to_m - from_m)) : from;
    }
};

/// Calls `visit(const PathwayLeg&)`, in order, for the legs of a line of which both ends have a place; distances along the line
/// count these legs only. Legs of length 0 are left out.
template <class Visitor>
void visit_legs(const ElementInput& input, std::uint32_t feature, Visitor visit) {
    const scene::Run run = input.layer.points_of(feature);
    PathwayLeg leg;
    Placed before;
    for (std::uint32_t n = 0; n < run.count; ++n) {
        const Placed here = placed(input, input.layer.points[run.first + n]);
        const double long_m = before.is_known && here.is_known ? glm::distance(before.place, here.place) : 0;
        if (long_m > 0) {
            leg = {before.place, here.place, leg.to_m, leg.to_m + long_m, n - 1, run.first + n - 1, leg.goes_on};
            visit(static_cast<const PathwayLeg&>(leg));
        }
        leg.goes_on = here.is_known && (long_m > 0 || leg.goes_on);
        before = here;
    }
}

}  // namespace tedavis::draw
