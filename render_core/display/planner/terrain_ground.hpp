/// The terrain as the ground that spatial data stand on: heights of its true surface, or of the plane that it is drawn as, and of
/// the surface that the frame draws. Each query reads a bounded amount.
#pragma once

#include <cmath>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/display/planner/terrain_planner.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/policy/ground_bound.hpp"

namespace tedavis::display {

class TerrainGround final : public scene::Ground, public policy::GroundBound {
public:
    /// The terrain must have been started, and must outlive the object.
    TerrainGround(TerrainPlanner& terrain, const terrain::View& view) : terrain_(terrain), flat_msl_m_(view.flat_msl_m) {}

    [[nodiscard]] double height_m(double latitude_rad, double longitude_rad) override {
        const terrain::HeightAnswer ground = terrain_.true_height(latitude_rad, longitude_rad);
        if (ground.status != terrain::HeightStatus::land && ground.status != terrain::HeightStatus::sea)
            return std::numeric_limits<double>::quiet_NaN();
        return (std::isnan(flat_msl_m_) ? ground.height.m : flat_msl_m_) + ground.undulation.m;
    }
    [[nodiscard]] double drawn_height_m(double latitude_rad, double longitude_rad) override {
        const terrain::DrawnPoint drawn =
            std::isnan(flat_msl_m_) ? terrain_.drawn_point(latitude_rad, longitude_rad) : terrain::DrawnPoint{};
        const bool is_ground = drawn.found && drawn.post_class != terrain::PostClass::void_;
        return is_ground ? earth::from_ecef(drawn.position).height.m : height_m(latitude_rad, longitude_rad);
    }
    [[nodiscard]] double undulation_m(double latitude_rad, double longitude_rad) override {
        return terrain_.database().undulation(latitude_rad, longitude_rad).m;
    }

    [[nodiscard]] double highest_m(double latitude_rad, double longitude_rad, double radius_m, double floor_m) override {
        if (!(std::fabs(latitude_rad) <= base::kPi / 2)) return -std::numeric_limits<double>::infinity();  // beyond a pole
        return terrain_.ceiling().over(latitude_rad, longitude_rad, radius_m, floor_m).height_m;
    }

private:
    TerrainPlanner& terrain_;
    double flat_msl_m_;  ///< NaN: as it is
};

}  // namespace tedavis::display
