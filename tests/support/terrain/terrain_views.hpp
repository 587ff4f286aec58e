/// Views over a written database.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/view.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::test_support {

/// From above a lattice place; the height is above its nearest post.
[[nodiscard]] inline terrain::View view_from(const WrittenTdb& tdb, double i, double j, double above_m, double heading_deg,
                                             double pitch_deg, double roll_deg = 0) {
    const auto post_i = static_cast<std::uint32_t>(std::lround(i)), post_j = static_cast<std::uint32_t>(std::lround(j));
    const double latitude = tdb.lattice().latitude_rad(post_j), longitude = tdb.lattice().longitude_rad(post_i);
    const glm::dmat3 body =
        earth::body_axes(latitude, longitude, base::radians(heading_deg), base::radians(pitch_deg), base::radians(roll_deg));
    const double ground_m = tdb.height_m(post_i, post_j) + WrittenTdb::undulation_m(latitude);
    return free_view(tdb.lattice().position(post_i, post_j, ground_m + above_m), body, 1024, 768, 5);
}

/// Near the ground more often than not, `scale` times as far from it as over posts some tens of metres apart.
[[nodiscard]] inline std::vector<terrain::View> some_views(const WrittenTdb& tdb, int count, unsigned seed = 7,
                                                           double scale = 1) {
    std::vector<terrain::View> views;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const double columns = tdb.lattice().columns() - 1, rows = tdb.lattice().rows() - 1;
    for (int n = 0; n < count; ++n)
        views.push_back(view_from(tdb, unit(random) * columns, (0.02 + 0.96 * unit(random)) * rows,
                                  scale * (20 + 3000 * unit(random) * unit(random)), 360 * unit(random), -40 * unit(random) + 5,
                                  60 * unit(random) - 30));
    return views;
}

struct Pixel {
    double x = 0, y = 0;
    bool visible = false;
};

[[nodiscard]] inline Pixel project(const terrain::View& view, const glm::dvec3& point) {
    const glm::dvec3 d = point - view.eye;
    const double depth = glm::dot(d, view.forward);
    if (depth < view.near_m) return {};
    const double x = 0.5 * view.width + view.focal_px * glm::dot(d, view.right) / depth,
                 y = 0.5 * view.height + view.focal_px * glm::dot(d, view.down) / depth;
    return {x, y, x >= 0 && y >= 0 && x <= view.width && y <= view.height};
}

}  // namespace tedavis::test_support
