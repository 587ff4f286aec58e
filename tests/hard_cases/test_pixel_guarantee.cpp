// The pixel error that a frame states is never exceeded, measured on drawn triangles against the raster.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <random>
#include <string>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/default_flight.hpp"
#include "tests/support/pixel_error_probe.hpp"

namespace tedavis {
namespace {

using base::radians;

constexpr int kPointsOfAPose = 600;
constexpr double kNearPlaneHighUp_m = 4;  // of an eye 200 m above the ground

/// Poses in a raster, a few of them made to hurt: on the ground, in a corner of chunks, straight down, upside down.
class Poses {
public:
    Poses(const host_sim::Raster& raster, const test_support::RasterRayCaster& truth, std::uint32_t seed)
        : raster_(raster), truth_(truth), random_(seed) {}

    terrain::View next() {
        const bool adversarial = random_() % 3 == 0;
        double i = uniform(2, raster_.columns - 3.0), j = uniform(2, raster_.rows - 3.0);
        if (adversarial) {  // over a border or a corner of chunks
            i = std::clamp(32 * std::round(i / 32), 2.0, raster_.columns - 3.0);
            if (random_() % 2 == 0) j = std::clamp(32 * std::round(j / 32), 2.0, raster_.rows - 3.0);
        }
        const double lat_deg = raster_.north_deg - raster_.step_lat_deg * j,
                     lon_deg = raster_.west_deg + raster_.step_lon_deg * i;
        const double ground_m = truth_.surface_m(lat_deg, lon_deg).value_or(0);
        const double above_m =
            adversarial && random_() % 2 == 0 ? uniform(1.5, 30) : std::exp(uniform(std::log(2), std::log(12'000)));
        const double pitch = adversarial && random_() % 4 == 0 ? uniform(-90, 90) : uniform(-25, 15);
        return view_at(lat_deg, lon_deg, ground_m + above_m, uniform(0, 360), pitch, uniform(-180, 180) * (random_() % 4 == 0),
                       above_m);
    }

private:
    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

    static terrain::View view_at(double lat_deg, double lon_deg, double height_m, double heading_deg, double pitch_deg,
                                 double roll_deg, double above_m) {
        terrain::View view;
        view.eye = earth::to_ecef({radians(lat_deg), radians(lon_deg), {height_m}});
        const glm::dmat3 body =
            earth::body_axes(radians(lat_deg), radians(lon_deg), radians(heading_deg), radians(pitch_deg), radians(roll_deg));
        view.forward = body[0];
        view.right = body[1];
        view.down = body[2];
        view.width = 1024;
        view.height = 768;
        view.focal_px = 512 / std::tan(radians(30));
        view.near_m = std::clamp(0.02 * above_m, 1.0, 50.0);
        return view;
    }

    const host_sim::Raster& raster_;
    const test_support::RasterRayCaster& truth_;
    std::mt19937 random_;
};

struct Proof {
    double worst_excess_px = -1e9;  ///< measured minus stated
    double worst_when_met_px = 0;   ///< measured over tau where the frame says that tau is met
    int poses_met = 0, poses_at_data_limit = 0, poses = 0;
    std::uint64_t points = 0;
    std::map<std::string, int> reasons;  ///< poses by what kept them from tau
};

Proof prove(test_support::DrawnTerrain& drawn, const host_sim::Raster& raster, double tau_px, int poses, std::uint32_t seed,
            double lie = 1) {
    const test_support::PixelErrorProbe probe(raster);
    const test_support::RasterRayCaster truth(raster);
    Poses source(raster, truth, seed);
    std::mt19937 random(seed + 1);
    Proof proof;
    terrain::LodSettings settings;
    settings.tau_px = tau_px;
    for (; proof.poses < poses; ++proof.poses) {
        const terrain::View view = source.next();
        const terrain::LodResult stated = drawn.select(view, settings);
        const test_support::ProbedError measured = probe.probe(drawn, view, kPointsOfAPose, random);
        proof.points += measured.points;
        proof.worst_excess_px = std::max(proof.worst_excess_px, measured.worst_px - lie * stated.worst_error_px);
        ++proof.reasons[terrain::to_string(stated.reason)];
        // Close to the ground a database has no finer mesh to give, and says so.
        if (stated.reason == terrain::LodStop::at_data_limit && view.near_m < kNearPlaneHighUp_m) ++proof.poses_at_data_limit;
        if (stated.reason != terrain::LodStop::met) continue;
        ++proof.poses_met;
        proof.worst_when_met_px = std::max(proof.worst_when_met_px, measured.worst_px / tau_px);
    }
    return proof;
}

TEST(PixelGuarantee, HoldsOverTheDefaultTerrainForEveryTau) {
    test_support::DefaultTerrain terrain;
    const host_sim::Raster raster =
        host_sim::load_rasters({std::string(TEDAVIS_SOURCE_DIR) + "/configs/data/jacksboro_srtm3.tif"}, {});
    test_support::DrawnTerrain drawn(terrain.bytes);
    for (const double tau : {0.5, 1.0, 2.0, 4.0}) {
        const Proof proof = prove(drawn, raster, tau, 120, static_cast<std::uint32_t>(100 * tau));
        EXPECT_LE(proof.worst_excess_px, 1e-6) << "tau " << tau;
        EXPECT_LE(proof.worst_when_met_px, 1 + 1e-6) << "tau " << tau;
        EXPECT_EQ(proof.poses_met + proof.poses_at_data_limit, proof.poses) << "tau " << tau;
        EXPECT_GE(proof.poses_met, proof.poses / 4) << "tau " << tau;
        EXPECT_GT(proof.points, 20'000u);
    }
}

TEST(PixelGuarantee, ALieAboutTheErrorIsFound) {
    test_support::DefaultTerrain terrain;
    const host_sim::Raster raster =
        host_sim::load_rasters({std::string(TEDAVIS_SOURCE_DIR) + "/configs/data/jacksboro_srtm3.tif"}, {});
    test_support::DrawnTerrain drawn(terrain.bytes);
    EXPECT_GT(prove(drawn, raster, 4, 60, 5, 0.1).worst_excess_px, 0);
}

}  // namespace
}  // namespace tedavis
