/// A raster, its database and views on it from places given in posts.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/view.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::test_support {

/// The database of a raster, built once for all scenes of a process that show the same ground.
inline const std::vector<std::uint8_t>& kept_image(const host_sim::Raster& raster) {
    static std::map<std::string, std::vector<std::uint8_t>> kept;
    std::string key = raster.source + '\n';
    const auto add = [&key](const auto* first, std::size_t count) {
        key.append(reinterpret_cast<const char*>(first), count * sizeof *first);
    };
    const double place[] = {static_cast<double>(raster.columns),
                            static_cast<double>(raster.rows),
                            raster.west_deg,
                            raster.north_deg,
                            raster.step_lon_deg,
                            raster.step_lat_deg};
    add(place, std::size(place));
    add(&raster.vertical_datum, 1);
    add(raster.height_m.data(), raster.height_m.size());
    add(raster.post_class.data(), raster.post_class.size());
    std::vector<std::uint8_t>& image = kept[key];
    if (image.empty()) image = build_image(raster);
    return image;
}

struct RasterScene {
    static constexpr std::uint32_t kWidth = 320, kHeight = 240;

    host_sim::Raster raster;
    BuiltDatabase built;

    explicit RasterScene(const host_sim::Raster& r) : raster(r), built(kept_image(raster)) {}
    /// `database` was built from the raster.
    RasterScene(const host_sim::Raster& r, std::vector<std::uint8_t> database) : raster(r), built(std::move(database)) {}

    [[nodiscard]] earth::Geodetic place(double i, double j, double msl_m) const {
        const double latitude = base::radians(raster.north_deg - j * raster.step_lat_deg),
                     longitude = base::radians(raster.west_deg + i * raster.step_lon_deg);
        return {latitude, longitude, {msl_m + built.database.undulation(latitude, longitude).m}};
    }
    [[nodiscard]] glm::dvec3 post(std::uint32_t i, std::uint32_t j) const {
        return earth::to_ecef(place(i, j, double{raster.height_m[raster.at(i, j)]}));
    }
    /// 60 degrees wide.
    [[nodiscard]] terrain::View view(double i, double j, double msl_m, double heading_deg, double pitch_deg) const {
        const earth::Geodetic at = place(i, j, msl_m);
        const glm::dmat3 body =
            earth::body_axes(at.latitude_rad, at.longitude_rad, base::radians(heading_deg), base::radians(pitch_deg), 0);
        const double focal_px = kWidth / 2 / std::tan(base::radians(30));
        return {earth::to_ecef(at), body[0], body[1], body[2], focal_px, kWidth, kHeight, 5, 300000, {}};
    }
};

/// Where a point is seen, if it is, the outermost pixels aside.
[[nodiscard]] inline std::optional<glm::dvec2> pixel_of(const terrain::View& view, const glm::dvec3& point) {
    const glm::dvec3 d = point - view.eye;
    const double depth = glm::dot(d, view.forward);
    const glm::dvec2 at(0.5 * view.width + view.focal_px * glm::dot(d, view.right) / depth,
                        0.5 * view.height + view.focal_px * glm::dot(d, view.down) / depth);
    if (depth < view.near_m || at.x < 1 || at.y < 1 || at.x >= view.width - 1 || at.y >= view.height - 1) return std::nullopt;
    return at;
}

}  // namespace tedavis::test_support
