/// Positions of points in a picture with signs. Plain data and pure functions; any thread.
#pragma once

#include "render_core/draw/rect.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

/// Height of icons above their positions on the short stem, in text sizes.
inline constexpr float kSignStem = 0.7f;

struct SignSpot {
    Point at;
    double distance_m = 0;  ///< along the view
    bool is_ahead = false;  ///< beyond the near plane; if false the other members are meaningless
};

struct SignView {
    terrain::View view;
    float text_px = 16;  ///< of the display's ordinary text

    /// `place` in ECEF, m.
    [[nodiscard]] SignSpot spot(const glm::dvec3& place) const;
    /// Distance scaled to a field of view of 60 degrees; distant features are ranked and left out by it.
    [[nodiscard]] double seen_distance_m(double distance_m) const;
};

}  // namespace tedavis::draw
