// The smallest device flies low over real mountains: what holds over generated terrain holds there, frames state their error, and
// pictures on the way have the skyline of the whole raster within it. Where ground has no data, the search for holes is left out.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/budget_flight.hpp"
#include "tests/support/terrain/picture_proof.hpp"

namespace tedavis::test_budget_flight {
namespace {

using test_support::BudgetFlight;
using test_support::FlownGround;
using test_support::GdalTerrain;

constexpr int kLegs = 12;

struct Mountains {
    const char* name;
    const char* file;
};
void PrintTo(const Mountains& mountains, std::ostream* out) { *out << mountains.name; }

/// Void ground is as high as the highest ground round it.
double flown_ground_m(const GdalTerrain& truth, double latitude_deg, double longitude_deg) {
    double highest_m = truth.surface_at(latitude_deg, longitude_deg);
    for (double reach_deg = 0.001; std::isnan(highest_m) && reach_deg < 0.1; reach_deg *= 2)
        for (const double north : {-1.0, 0.0, 1.0})
            for (const double east : {-1.0, 0.0, 1.0})
                highest_m =
                    std::fmax(highest_m, truth.surface_at(latitude_deg + north * reach_deg, longitude_deg + east * reach_deg));
    return highest_m;
}

FlownGround low_over(const GdalTerrain& truth) {
    FlownGround ground;
    ground.north_deg = truth.latitude_deg(0);
    ground.west_deg = truth.longitude_deg(0);
    ground.side_s = 3600 * std::min(ground.north_deg - truth.latitude_deg(truth.rows() - 1),
                                    truth.longitude_deg(truth.columns() - 1) - ground.west_deg);
    ground.ellipsoid_m = [&truth](double latitude_deg, double longitude_deg) {
        return flown_ground_m(truth, latitude_deg, longitude_deg);
    };
    ground.looking_down_m = 300;
    ground.looking_ahead_m = 150;
    return ground;
}

class BudgetFlightOverMountains : public ::testing::TestWithParam<Mountains> {
protected:
    BudgetFlightOverMountains() {
        host_sim::build_terrain(host_sim::PostReaderFactory([this] {
                                    return std::make_unique<host_sim::PostSource>(std::vector<std::string>{file_},
                                                                                  host_sim::RasterOptions());
                                }),
                                folder_.file("t.tdb"), {});
    }

    /// At the beginning and in the middle of every leg that looks ahead, with everything arrived.
    void expect_true_skylines(BudgetFlight& flight) const {
        test_support::PictureProof proof;
        for (std::size_t n = 0; n < flight.route().size(); n += BudgetFlight::kFramesOfALeg / 2) {
            const BudgetFlight::Stop& stop = flight.route()[n];
            if (stop.first_ground_row == 0) continue;
            const test_support::TerrainPicture picture(flight.headless(), stop.view, stop.ship);
            if (flight.has_flag(picture.record(), "terrain.void")) continue;
            proof.include(picture, test_support::TrueView(truth_, stop.view), static_cast<std::uint32_t>(n));
        }
        std::printf("%s\n", proof.text().c_str());
        EXPECT_GE(proof.pictures, 1) << "control";
        EXPECT_EQ(proof.too_high + proof.too_low + proof.cracks + proof.unsettled, 0) << proof.text();
    }

    std::string file_ = test_support::real_data_dir() + "/terrain/" + GetParam().file;
    test_support::TemporaryFolder folder_;
    GdalTerrain truth_{file_};
};

TEST_P(BudgetFlightOverMountains, LowStaysWithinTheSmallestDeviceAndStatesItsError) {
    BudgetFlight flight(folder_.file("t.tdb"), "es2-small", low_over(truth_), kLegs);
    const test_support::FlownBudget flown = flight.fly();
    EXPECT_EQ(flown.frames, kLegs * BudgetFlight::kFramesOfALeg);
    test_support::expect_within_device(flown, kLegs);
    std::printf("%s: %.0f triangles, taken away in %d frames, %d searched for holes, %.1f ms (p99 %.1f ms) of processor time\n",
                GetParam().name, flown.mean_triangles, flown.taken_away, flown.proved_whole, flown.quantile_ms(0.5),
                flown.quantile_ms(0.99));
    EXPECT_GT(flown.proved_whole, flown.frames / 2) << "control";
    EXPECT_GT(flown.raised, 0) << "control: the device is too small for some of it";
    EXPECT_EQ(flight.slowest_refinement(), BudgetFlight::kArrivalFrames);
    expect_true_skylines(flight);
}

INSTANTIATE_TEST_SUITE_P(Terrains, BudgetFlightOverMountains,
                         ::testing::Values(Mountains{"davos", "davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif"},
                                           Mountains{"pyrenees_with_voids", "N42E001_pyrenees_andorra_srtm3.hgt.zip"}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tedavis::test_budget_flight
