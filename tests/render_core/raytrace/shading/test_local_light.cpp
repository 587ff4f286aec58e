#include "render_core/raytrace/shading/local_light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>

#include "render_core/raytrace/surface/surface_height.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/raytrace/held_heights.hpp"

namespace tedavis::raytrace::test_local_light {
namespace {

TEST(LocalLight, LambertIsGdaldemsHillshade) {
    // The slope of the bicubic surface at a post is Zevenbergen and Thorne's.
    const test_support::TemporaryFolder folder;
    const std::string in = folder.path() + "/in.asc", out = folder.path() + "/out.asc";
    constexpr std::uint32_t kSide = 40;
    const auto heights = test_support::hilly_heights<std::int16_t>(kSide, kSide, 3, 900);
    {
        std::ofstream file(in);
        file << "ncols " << kSide << "\nnrows " << kSide << "\nxllcorner 0\nyllcorner 0\ncellsize 30\n";
        for (const std::int16_t height : heights.posts) file << height << ' ';
    }
    const std::string command = "gdaldem hillshade -q -alg ZevenbergenThorne -az 315 -alt 35 -of AAIGrid " + in + " " + out;
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::ifstream file(out);
    std::string line;
    for (int n = 0; n < 6; ++n) std::getline(file, line);
    const double azimuth = 315 * 3.14159265358979 / 180, altitude = 35 * 3.14159265358979 / 180;
    // Rows go south.
    const glm::dvec3 sun(std::cos(altitude) * std::sin(azimuth), -std::cos(altitude) * std::cos(azimuth), std::sin(altitude));
    SurfaceSettings settings;
    settings.kind = SurfaceKind::bicubic;
    double worst = 0, most = 0;
    for (std::uint32_t row = 0; row < kSide; ++row)
        for (std::uint32_t column = 0; column < kSide; ++column) {
            double shade = 0;
            ASSERT_TRUE(static_cast<bool>(file >> shade));
            if (row == 0 || column == 0 || row + 1 == kSide || column + 1 == kSide) continue;
            SurfacePoint point;
            ASSERT_TRUE(find_surface(heights.grid(), settings, column, row, point));
            const double ours = 1 + 254 * lambert(normal_of(point, {30, 30, 1}), sun);
            worst = std::max(worst, std::abs(ours - shade));
            most = std::max(most, shade);
        }
    EXPECT_LE(worst, 1) << "of 255";
    EXPECT_GT(most, 200);
}

TEST(LocalLight, PhongIsBrightestWhereTheMirrorPoints) {
    const glm::dvec3 normal(0, 0, 1), light = glm::normalize(glm::dvec3(1, 0, 1)), mirrored(-light.x, 0, light.z);
    EXPECT_NEAR(phong(normal, light, mirrored, 50), 1, 1e-12);
    EXPECT_EQ(phong(normal, light, light * glm::dvec3(1, 1, -1), 50), 0);
    EXPECT_EQ(phong(normal, -light, mirrored, 50), 0) << "no highlight from behind";
    for (const std::uint32_t sharpness : {1u, 2u, 7u, 50u, 65536u})
        EXPECT_NEAR(phong(normal, light, normal, sharpness), std::pow(std::sqrt(0.5), sharpness), 1e-12);
}

TEST(LocalLight, SkyAndSunAddUp) {
    Material material;
    material.color = {0.5f, 0.25f, 1};
    const DirectedLight sun{{0, 0, 1}, glm::vec3(2)};
    const glm::dvec3 up(0, 0, 1), aside = glm::normalize(glm::dvec3(1, 0, 1));
    const glm::vec3 dark = local_light(material, up, aside, sun, 0, glm::vec3(1), 0.5);
    EXPECT_FLOAT_EQ(dark.x, 0.25f);
    const glm::vec3 bright = local_light(material, up, aside, sun, 1, glm::vec3(1), 0.5);
    EXPECT_FLOAT_EQ(bright.x, 0.25f + 1);
    EXPECT_FLOAT_EQ(bright.y, 0.125f + 0.5f);
    material.gloss = 1;
    material.sharpness = 2;
    EXPECT_FLOAT_EQ(local_light(material, up, aside, sun, 1, glm::vec3(0), 0).x, 1 + 2 * 0.5f);
}

}  // namespace
}  // namespace tedavis::raytrace::test_local_light
