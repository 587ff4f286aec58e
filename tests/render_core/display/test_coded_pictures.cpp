// The picture that comes by way of one off-screen, as codes or as colours with distances, is the one that is drawn in colours at
// once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "host_sim/scenario/posed_aircraft.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/flights/default_flight.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::display::test_coded_pictures {
namespace {

constexpr std::uint32_t kWidth = 400, kHeight = 300;

/// Land, sea and ground without data.
const test_support::BuiltDatabase& coast() {
    static const test_support::BuiltDatabase built([] {
        host_sim::Raster raster = test_support::make_rough_raster(161, 161);
        for (std::uint32_t j = 0; j < 161; ++j)
            for (std::uint32_t i = 0; i < 161; ++i) {
                const std::size_t at = raster.at(i, j);
                if (i + j < 130) raster.height_m[at] = 0;
                if (i + j < 130) raster.post_class[at] = terrain::PostClass::sea;
                if (i > 110 && j > 100 && j < 130) raster.post_class[at] = terrain::PostClass::void_;
            }
        return raster;
    }());
    return built;
}

design::DesignSettings design_without_silhouettes() {
    design::DesignSettings design = test_support::shipped_design("default");
    design.terrain.style.sketch.silhouettes = 0;
    return design;
}

std::vector<std::uint8_t> picture(const design::DesignSettings& design, const char* device, bool off_screen,
                                  const host_sim::AircraftPose& pose) {
    test_support::MemoryBytes bytes(coast().image);
    effects::DeviceSettings settings = test_support::shipped_device(device);
    settings.capability.depth24_targets = off_screen;
    test_support::HeadlessDisplay headless("egl", settings, kWidth, kHeight, &bytes, design);
    const flight::AircraftState aircraft = host_sim::posed_aircraft(pose, headless.display());
    std::vector<std::uint8_t> rgba = test_support::settled_pixels(headless, aircraft, host_sim::kPosedTime);
    EXPECT_GT(headless.display().record().terrain.triangles, 100u);
    return rgba;
}

/// Share of pixels in which a channel differs by more than `steps`.
double share_apart(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b, int steps) {
    std::size_t apart = 0;
    for (std::size_t n = 0; n < a.size(); n += 4) {
        bool differs = false;
        for (std::size_t c = n; c < n + 3; ++c) differs = differs || std::abs(int{a[c]} - int{b[c]}) > steps;
        apart += differs ? 1 : 0;
    }
    return static_cast<double>(apart) / (0.25 * static_cast<double>(a.size()));
}

/// Light comes from the corners of a triangle instead of from each pixel's own normal, heights have 16 bits, distances steps of
/// 3.6 %: a few colour steps, more where the light leaves rough ground within a triangle. A limit between two colours may fall on
/// the other side of a pixel's middle.
TEST(CodedPictures, ShowWhatColorsDrawnAtOnceShow) {
    const design::DesignSettings design = design_without_silhouettes();
    const host_sim::AircraftPose poses[] = {
        {47.0, 9.64, 2000, 30, -12, 0}, {46.99, 9.7, 1500, 300, -5, 25}, {47.06, 9.62, 3500, 150, -35, 0}};
    for (const char* device : {"es2-small", "es3-mid"})
        for (const host_sim::AircraftPose& pose : poses) {
            const auto coded = picture(design, device, true, pose), direct = picture(design, device, false, pose);
            EXPECT_LT(share_apart(coded, direct, 3), 0.02) << device << " heading " << pose.heading_deg;
            EXPECT_LT(share_apart(coded, direct, 10), 0.012) << device << " heading " << pose.heading_deg;
        }
}

design::DesignSettings design_with_air(double visibility_m) {
    design::DesignSettings design = design_without_silhouettes();
    design.sky.air.is_shown = true;
    design.sky.air.visibility_m = visibility_m;
    return design;
}

struct Apart {
    double mean = 0;  ///< of all channels, in steps of 1/255
    int most = 0;
};
Apart apart(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    Apart apart;
    for (std::size_t n = 0; n < a.size(); ++n) {
        const int steps = std::abs(int{a[n]} - int{b[n]});
        apart.mean += steps / (0.75 * static_cast<double>(a.size()));  // alpha is 255 in both
        apart.most = std::max(apart.most, steps);
    }
    return apart;
}

/// Colours have 7 bits before the air, distances quarters of a step of 3.6 %.
TEST(CodedPictures, AirOnceAPixelIsThatOfEveryTriangle) {
    const host_sim::AircraftPose poses[] = {
        {47.0, 9.64, 2000, 30, -12, 0}, {47.0, 9.64, 1500, 30, -5, 25}, {47.0, 9.64, 9000, 30, -40, 0}};
    for (const double visibility_m : {15'000.0, 60'000.0})
        for (const host_sim::AircraftPose& pose : poses) {
            const auto direct = picture(design_with_air(visibility_m), "es3-mid", false, pose);
            const Apart found = apart(direct, picture(design_with_air(visibility_m), "es3-mid", true, pose));
            EXPECT_LE(found.most, 3) << "heading " << pose.heading_deg << ", visibility " << visibility_m;
            EXPECT_LE(found.mean, 0.5) << "heading " << pose.heading_deg << ", visibility " << visibility_m;
            if (visibility_m > 20'000) continue;
            const Apart clearer = apart(direct, picture(design_with_air(20'000), "es3-mid", true, pose));
            EXPECT_GT(clearer.most, 4) << "a third more visibility is seen";
        }
}

TEST(CodedPictures, AnotherLightIsSeen) {
    design::DesignSettings other = design_without_silhouettes();
    other.terrain.style.shade.lights[0].azimuth_rad += 1;
    const host_sim::AircraftPose pose{47.0, 9.64, 2000, 30, -12, 0};
    EXPECT_GT(share_apart(picture(design_without_silhouettes(), "es3-mid", true, pose), picture(other, "es3-mid", true, pose), 3),
              0.05);
}

}  // namespace
}  // namespace tedavis::display::test_coded_pictures
