#include "host_sim/sweep/swept_ground.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/check.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {

SweptGround::SweptGround(const terrain::TerrainDatabase& database)
    : database_(database), memory_(terrain::HeightQuery::bytes_needed()) {
    base::Arena arena(memory_.data(), memory_.size());
    TEDAVIS_CHECK(query_.start(database, arena));
}

bool SweptGround::hides(const earth::Geodetic& place, const earth::Geodetic& eye) {
    constexpr double kReach = 0.99;
    const earth::Ecef from = earth::to_ecef(eye), way = earth::to_ecef(place) - from;
    const terrain::FileHeader& header = database_.header();
    const double narrow_deg = std::min(header.step_lat_deg, header.step_lon_deg * std::max(std::cos(place.latitude_rad), 0.01));
    const double step_m = base::radians(narrow_deg) * earth::kMeanRadius_m / 8;
    const auto steps = static_cast<std::size_t>(std::ceil(glm::length(way) / step_m));
    for (std::size_t n = 1; n < steps; ++n) {
        const double share = kReach * static_cast<double>(n) / static_cast<double>(steps);
        const earth::Geodetic point = earth::from_ecef(from + way * share);
        const terrain::HeightAnswer ground = at(point.latitude_rad, point.longitude_rad);
        const bool is_known = ground.status == terrain::HeightStatus::land || ground.status == terrain::HeightStatus::sea;
        if (is_known && earth::to_ellipsoid(ground.height, ground.undulation).m > point.height.m) return true;
    }
    return false;
}

earth::Geodetic SweptGround::middle() const {
    const terrain::Lattice& lattice = database_.lattice();
    return {lattice.latitude_rad(lattice.rows() / 2), earth::wrap_longitude(lattice.longitude_rad(lattice.columns() / 2)), {}};
}

}  // namespace tedavis::host_sim
