/// The straight ways over the ground as it is that a straight way through the picture of magnifiers is made of: one in each cell
/// that it passes through. Pure; any thread.
#pragma once

#include "render_core/earth/magnifier.hpp"

namespace tedavis::earth {

struct TrueWay {
    Ecef begin{0}, end{0};
};

/// Calls with each part of the way from begin to end, ECEF, in no order, until one is answered with true; returns whether any
/// was.
template <class Visitor>
[[nodiscard]] bool any_true_way(const Magnifiers& magnifiers, const TrueWay& shown, Visitor visitor);

namespace magnified_way {

/// Shares of a way; none where it ends before it begins.
struct Shares {
    double from = 0, to = 1;
    [[nodiscard]] bool is_any() const { return from < to; }
};
/// Of the way from a place of the plane along `by`, within edges.
[[nodiscard]] Shares within(const Magnifier::Cell& cell, const glm::dvec2& begin, const glm::dvec2& by);
/// What of a shown way is over a cell, and where that is.
[[nodiscard]] bool part_over(const Magnifier& magnifier, const Magnifier::Cell& cell, const TrueWay& shown, TrueWay& part);

/// Shares of a way that are over what magnifiers move, in their order along it.
struct Moved {
    Shares of[Magnifiers::kMax];
    std::size_t count = 0;
};
[[nodiscard]] Moved moved_shares(const Magnifiers& magnifiers, const TrueWay& shown);

}  // namespace magnified_way

template <class Visitor>
bool any_true_way(const Magnifiers& magnifiers, const TrueWay& shown, Visitor visitor) {
    const glm::dvec3 way = shown.end - shown.begin;
    const magnified_way::Moved moved = magnified_way::moved_shares(magnifiers, shown);
    double from = 0;
    for (std::size_t n = 0; n <= moved.count; ++n) {
        const double to = n < moved.count ? moved.of[n].from : 1;
        if (from < to && visitor(TrueWay{shown.begin + way * from, shown.begin + way * to})) return true;
        if (n < moved.count) from = moved.of[n].to;
    }
    for (const Magnifier& magnifier : magnifiers)
        for (std::size_t n = 0; n + 1 < magnifier.cell_count(); ++n)
            if (TrueWay part; magnified_way::part_over(magnifier, magnifier.cell(n), shown, part) && visitor(part)) return true;
    return false;
}

}  // namespace tedavis::earth
