/// Where places are in a picture with signs. Plain data and pure functions; any thread.
#pragma once

#include "render_core/draw/rect.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

/// How high icons stand over their places, of the text's size.
inline constexpr float kSignStem = 0.7f;

struct SignSpot {
    Point at;
    double distance_m = 0;  ///< along the view
    bool is_ahead = false;  ///< beyond the near plane; else the rest means nothing
};

struct SignView {
    terrain::View view;
    float text_px = 16;  ///< of the display's ordinary text

    /// `place` in ECEF, m.
    [[nodiscard]] SignSpot spot(const glm::dvec3& place) const;
    /// How far away 60 degrees of view would show as much: by this things far away are ranked and left out.
    [[nodiscard]] double seen_distance_m(double distance_m) const;
};

}  // namespace tedavis::draw
