/// The terrain as the ground that spatial data stand on: heights of its true surface. What is read for an answer is bounded.
#pragma once

#include <limits>

#include "render_core/display/terrain_scene.hpp"
#include "render_core/draw/data/element_input.hpp"

namespace tedavis::display {

class TerrainGround final : public draw::Ground {
public:
    /// The terrain must be started, and stay.
    explicit TerrainGround(TerrainScene& terrain) : terrain_(terrain) {}

    [[nodiscard]] double height_m(double latitude_rad, double longitude_rad) override {
        const terrain::HeightAnswer ground = terrain_.true_height(latitude_rad, longitude_rad);
        if (ground.status != terrain::HeightStatus::land && ground.status != terrain::HeightStatus::sea)
            return std::numeric_limits<double>::quiet_NaN();
        return ground.height.m + ground.undulation.m;
    }
    [[nodiscard]] double undulation_m(double latitude_rad, double longitude_rad) override {
        return terrain_.database().undulation(latitude_rad, longitude_rad).m;
    }

private:
    TerrainScene& terrain_;
};

}  // namespace tedavis::display
