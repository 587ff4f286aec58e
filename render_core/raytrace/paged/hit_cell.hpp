/// The cell of a hit over paged ground: what shading needs of it when its chunk is no longer in memory.
#pragma once

#include "render_core/raytrace/hit_place.hpp"

namespace tedavis::raytrace {

/// Only valid with a hit.
template <class Height>
struct HitCell {
    HitPlace place;
    Height corner[4];  ///< its posts: (column, row), (column + 1, row), (column, row + 1), (column + 1, row + 1)
};

}  // namespace tedavis::raytrace
