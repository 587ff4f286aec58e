// A flight along 46.7 N over the real Alps, with the camera at every pitch: no number that is none, no hole, errors within tau,
// skylines those of the whole raster.
#include <gtest/gtest.h>

#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/terrain/picture_proof.hpp"
#include "tests/support/terrain/watched_surface.hpp"

namespace tedavis::test_flight_along_46_north {
namespace {

using test_support::GdalTerrain;
using test_support::HeadlessDisplay;
using test_support::PictureProof;
using test_support::TerrainPicture;
using test_support::WatchedSurface;

constexpr std::uint32_t kWidth = 320, kHeight = 240;
constexpr int kPitches = 25;  // from straight down to straight up
constexpr double kLatitude_deg = 46.7, kWest_deg = 9.65, kEast_deg = 10.15, kHeight_m = 4200;

terrain::View view_at(int n) {
    const double latitude = base::radians(kLatitude_deg),
                 longitude = base::radians(kWest_deg + (n + 0.5) / kPitches * (kEast_deg - kWest_deg));
    const glm::dmat3 body = earth::body_axes(latitude, longitude, base::kPi / 2, test_support::pitch_rad(n, kPitches), 0);
    return test_support::free_view(earth::to_ecef({latitude, longitude, {kHeight_m}}), body, kWidth, kHeight, 20);
}

TEST(FlightAlong46North, EveryPitchIsWithoutAHoleAndWithinTau) {
    const std::string file = test_support::real_data_dir() + "/terrain/davos_engadin_srtm1_1arcsec_2160x2160_wgs84.tif";
    const GdalTerrain truth(file);
    const std::vector<std::uint8_t> image = test_support::build_image_of_file(file);
    test_support::MemoryBytes bytes(image);
    HeadlessDisplay headless("egl", "desktop", kWidth, kHeight, &bytes, test_support::garish_design(1, false),
                             [](std::unique_ptr<base::Surface> surface) {
                                 return std::unique_ptr<base::Surface>(std::make_unique<WatchedSurface>(std::move(surface)));
                             });
    PictureProof proof;
    int enclosed = 0, ground = 0;
    for (int n = 0; n < kPitches; ++n) {
        const terrain::View view = view_at(n);
        const TerrainPicture picture(headless, view, truth.middle());
        EXPECT_TRUE(std::isfinite(picture.record().terrain.worst_error_px)) << n;
        EXPECT_LE(picture.record().terrain.worst_error_px, 1) << n;
        proof.include(picture, test_support::TrueView(truth, view), static_cast<std::uint32_t>(n));
        enclosed += picture.enclosed_background();
        ground += picture.width() * picture.height() - picture.background();
    }
    EXPECT_EQ(WatchedSurface::counts().not_finite, 0u);
    EXPECT_EQ(proof.met, kPitches) << proof.text();
    EXPECT_EQ(proof.too_high + proof.too_low + proof.cracks + enclosed + proof.unsettled, 0) << proof.text();
    EXPECT_GT(ground, kPitches * int{kWidth} * int{kHeight} / 4) << "control: ground was seen";
}

}  // namespace
}  // namespace tedavis::test_flight_along_46_north
