/// Views into a terrain, random ones and ones that are made to hurt. The n-th of a seed is always the same.
#pragma once

#include <random>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/terrain/view.hpp"
#include "tests/support/terrain/gdal_terrain.hpp"

namespace tedavis::test_support {

enum class PoseKind {
    random,
    random_low,
    random_rolled,
    on_the_ground,
    in_a_valley,
    on_a_peak,
    in_a_box,
    over_a_corner,
    over_an_edge,
    straight_down,
    straight_up,
    almost_straight,
    upside_down,
    along_the_horizon,
    far_above,
    from_outside,
    count
};

[[nodiscard]] inline const char* to_string(PoseKind kind) {
    static constexpr const char* kNames[] = {
        "random",       "random, low",           "random, rolled",    "on the ground", "in a valley", "on a peak",
        "inside a box", "over a chunk's corner", "over a chunk edge", "straight down", "straight up", "at 89.9 degrees",
        "upside down",  "along the horizon",     "far above",         "from outside"};
    return kNames[static_cast<int>(kind)];
}

/// Above a place of the lattice, 1024 x 768, 60 degrees wide.
[[nodiscard]] inline terrain::View view_from_above(const GdalTerrain& terrain, double i, double j, double above_m,
                                                   double heading_deg, double pitch_deg, double roll_deg = 0) {
    const double latitude_deg = terrain.latitude_deg(j), longitude_deg = terrain.longitude_deg(i);
    const double ground_m = terrain.surface_m(i, j);
    const glm::dmat3 body = earth::body_axes(base::radians(latitude_deg), base::radians(longitude_deg),
                                             base::radians(heading_deg), base::radians(pitch_deg), base::radians(roll_deg));
    terrain::View view;
    view.eye = GdalTerrain::ecef(latitude_deg, longitude_deg, (std::isnan(ground_m) ? 0 : ground_m) + above_m);
    view.forward = body[0];
    view.right = body[1];
    view.down = body[2];
    view.width = 1024;
    view.height = 768;
    view.focal_px = 512 / std::tan(base::radians(30));
    view.near_m = std::clamp(0.02 * above_m, 1.0, 50.0);
    return view;
}

class HardPose {
public:
    HardPose(const GdalTerrain& terrain, std::uint32_t seed, std::uint32_t number)
        : kind(static_cast<PoseKind>(number % static_cast<std::uint32_t>(PoseKind::count))), terrain_(terrain) {
        std::seed_seq both{seed, number};
        random_.seed(both);
        i_ = uniform(2, terrain.columns() - 3.0);
        j_ = uniform(2, terrain.rows() - 3.0);
        above_m_ = std::exp(uniform(std::log(2), std::log(12'000)));
        heading_deg_ = uniform(0, 360);
        pitch_deg_ = uniform(-25, 15);
        choose();
        make_view();
    }

    PoseKind kind;
    terrain::View view;

private:
    void choose() {
        switch (kind) {
            case PoseKind::random_low: above_m_ = uniform(20, 500); break;
            case PoseKind::random_rolled: roll_deg_ = uniform(-180, 180), pitch_deg_ = uniform(-90, 90); break;
            case PoseKind::on_the_ground: above_m_ = 2; break;
            case PoseKind::in_a_valley: go_to_extreme(-1), above_m_ = uniform(2, 200); break;
            case PoseKind::on_a_peak: go_to_extreme(1), above_m_ = uniform(2, 50); break;
            case PoseKind::in_a_box: go_to_extreme(-1), above_m_ = uniform(2, 800); break;
            case PoseKind::over_a_corner: go_to_border(true, true); break;
            case PoseKind::over_an_edge: go_to_border(random_() % 2 == 0, false); break;
            case PoseKind::straight_down: pitch_deg_ = -90; break;
            case PoseKind::straight_up: pitch_deg_ = 90, above_m_ = 2; break;
            case PoseKind::almost_straight: pitch_deg_ = random_() % 4 == 0 ? 89.9 : -89.9; break;
            case PoseKind::upside_down: roll_deg_ = 180; break;
            case PoseKind::along_the_horizon: above_m_ = uniform(2, 4000), pitch_deg_ = -horizon_dip_deg(); break;
            case PoseKind::far_above:
                above_m_ = std::exp(uniform(std::log(20e3), std::log(800e3))), pitch_deg_ = uniform(-90, -50);
                break;
            case PoseKind::from_outside: go_outside(); break;
            default: break;
        }
    }
    /// The lowest or highest of some places within a square of a few kilometres.
    void go_to_extreme(int sign) {
        const double middle_i = i_, middle_j = j_;
        double best = -1e9;
        for (int n = 0; n < 300; ++n) {
            const double i = std::clamp(middle_i + uniform(-60, 60), 1.0, terrain_.columns() - 2.0),
                         j = std::clamp(middle_j + uniform(-60, 60), 1.0, terrain_.rows() - 2.0);
            const double height = sign * terrain_.surface_m(i, j);
            if (!(height > best)) continue;
            best = height;
            i_ = i;
            j_ = j;
        }
    }
    void go_to_border(bool west, bool north) {
        const double side = 32 << (random_() % 4);
        if (west) i_ = std::clamp(side * std::round(i_ / side), 2.0, terrain_.columns() - 3.0);
        if (north || !west) j_ = std::clamp(side * std::round(j_ / side), 2.0, terrain_.rows() - 3.0);
        if (random_() % 2 == 0) above_m_ = uniform(1.5, 30);
    }
    void go_outside() {
        const bool beside = random_() % 2 == 0;
        if (beside) i_ = random_() % 2 == 0 ? -uniform(1, 200) : terrain_.columns() + uniform(1, 200);
        if (!beside) j_ = random_() % 2 == 0 ? -uniform(1, 200) : terrain_.rows() + uniform(1, 200);
        const double to_east = 0.5 * terrain_.columns() - i_, to_north = j_ - 0.5 * terrain_.rows();
        heading_deg_ = base::degrees(std::atan2(to_east, to_north)) + uniform(-20, 20);
        above_m_ = uniform(500, 6000);
    }
    [[nodiscard]] double horizon_dip_deg() const { return base::degrees(std::acos(6.37e6 / (6.37e6 + above_m_))); }
    void make_view() {
        view = view_from_above(terrain_, i_, j_, above_m_, heading_deg_, pitch_deg_, roll_deg_);
        if (random_() % 4 == 0) view.focal_px = 512 / std::tan(base::radians(uniform(20, 110) / 2));
    }
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

    const GdalTerrain& terrain_;
    std::mt19937 random_;
    double i_ = 0, j_ = 0, above_m_ = 0, heading_deg_ = 0, pitch_deg_ = 0, roll_deg_ = 0;
};

}  // namespace tedavis::test_support
