/// Maps a straight segment through the magnified picture back to the undistorted ground, where it is a chain of straight
/// segments, one in each cell that it passes through. Pure; any thread.
#pragma once

#include "render_core/earth/magnifier.hpp"

namespace tedavis::earth {

struct TrueSegment {
    Ecef begin{0}, end{0};
};

/// Calls the visitor with each true segment of the shown one (ECEF), in no particular order, until a call returns true. Returns
/// whether one did.
template <class Visitor>
[[nodiscard]] bool any_true_segment(const Magnifiers& magnifiers, const TrueSegment& shown, Visitor visitor);

namespace magnified_segment {

/// An interval of a segment, as shares 0..1 of its length; empty where `to` is not above `from`.
struct Shares {
    double from = 0, to = 1;
    [[nodiscard]] bool is_any() const { return from < to; }
};
/// Returns the interval of the segment from `begin` along `by`, in the magnifier's plane, that lies within the cell's edges.
[[nodiscard]] Shares within(const Magnifier::Cell& cell, const glm::dvec2& begin, const glm::dvec2& by);
/// Computes the true segment below the part of the shown one that is over the cell; returns false where there is none.
[[nodiscard]] bool part_over(const Magnifier& magnifier, const Magnifier::Cell& cell, const TrueSegment& shown,
                             TrueSegment& part);

/// Intervals of a segment over ground that magnifiers move, in order along the segment.
struct Moved {
    Shares of[Magnifiers::kMax];
    std::size_t count = 0;
};
[[nodiscard]] Moved moved_shares(const Magnifiers& magnifiers, const TrueSegment& shown);

}  // namespace magnified_segment

template <class Visitor>
bool any_true_segment(const Magnifiers& magnifiers, const TrueSegment& shown, Visitor visitor) {
    const glm::dvec3 way = shown.end - shown.begin;
    const magnified_segment::Moved moved = magnified_segment::moved_shares(magnifiers, shown);
    double from = 0;
    for (std::size_t n = 0; n <= moved.count; ++n) {
        const double to = n < moved.count ? moved.of[n].from : 1;
        if (from < to && visitor(TrueSegment{shown.begin + way * from, shown.begin + way * to})) return true;
        if (n < moved.count) from = moved.of[n].to;
    }
    for (const Magnifier& magnifier : magnifiers)
        for (std::size_t n = 0; n + 1 < magnifier.cell_count(); ++n)
            if (TrueSegment part; magnified_segment::part_over(magnifier, magnifier.cell(n), shown, part) && visitor(part))
                return true;
    return false;
}

}  // namespace tedavis::earth
