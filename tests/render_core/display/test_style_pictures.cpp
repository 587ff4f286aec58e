// Whatever the style: sea, land and missing data are told apart at a glance, and missing data are never blue.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/display/display.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/flights/default_flight.hpp"
#include "tests/support/flights/placed_aircraft.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::display::test_style_pictures {
namespace {

using base::radians;
using terrain::PostClass;

constexpr std::uint32_t kWidth = 200, kHeight = 150, kSide = 193;
constexpr base::Time kNow{1'700'000'000'000'000'000};
constexpr double kShip_m = 900, kEye_m = 15000, kFocal_px = 200;

/// Sea in the west, hills in the middle, nothing known in the east.
const test_support::BuiltDatabase& coast_and_gap() {
    static const test_support::BuiltDatabase built([] {
        host_sim::Raster raster = test_support::make_raster(kSide, kSide, [](std::uint32_t i, std::uint32_t j) {
            return i < 64 ? 0.0f : 260.0f + 200.0f * std::sin(static_cast<float>(i) / 7) * std::cos(static_cast<float>(j) / 9);
        });
        for (std::uint32_t j = 0; j < kSide; ++j)
            for (std::uint32_t i = 0; i < kSide; ++i) {
                if (i < 64) raster.post_class[raster.at(i, j)] = PostClass::sea;
                if (i < 128) continue;
                raster.height_m[raster.at(i, j)] = std::nanf("");
                raster.post_class[raster.at(i, j)] = PostClass::void_;
                ++raster.void_posts;
            }
        return raster;
    }());
    return built;
}

/// Straight down from over the middle, north up, without symbols.
std::vector<std::uint8_t> picture_of(const design::DesignSettings& design, const std::string& device) {
    test_support::MemoryBytes bytes(coast_and_gap().image);
    test_support::HeadlessDisplay display("egl", device, kWidth, kHeight, &bytes, design);
    const earth::Geodetic ship{radians(47.1 - kSide / 2 / 1200.0), radians(9.6 + kSide / 2 / 1200.0), {kShip_m}};
    const earth::Geodetic eye{ship.latitude_rad, ship.longitude_rad, {kEye_m}};
    const glm::dmat3 axes = earth::north_east_down(eye.latitude_rad, eye.longitude_rad);
    display.display().planner().set_free_view(
        {earth::to_ecef(eye), axes[2], axes[1], -axes[0], kFocal_px, kWidth, kHeight, 100, 100000, {}});
    return test_support::settled_pixels(display, test_support::aircraft_at(ship, kNow), kNow);
}

struct Region {
    glm::dvec3 mean{0};
    double blue_share = 0;     ///< of pixels that anybody would call blue
    double striped_share = 0;  ///< of pixels as dark as the dark stripes of missing data
};

Region region_of(const std::vector<std::uint8_t>& rgba, std::uint32_t first, std::uint32_t last) {
    Region region;
    int count = 0;
    for (std::uint32_t y = 10; y < kHeight - 10; ++y)
        for (std::uint32_t x = first; x < last; ++x, ++count) {
            const std::uint8_t* p = rgba.data() + (std::size_t{y} * kWidth + x) * 4;
            region.mean += glm::dvec3(p[0], p[1], p[2]);
            region.blue_share += p[2] > p[0] + 24 ? 1 : 0;
            region.striped_share += p[0] < 46 && p[1] < 40 && p[2] < 32 ? 1 : 0;
        }
    region.mean /= count;
    region.blue_share /= count;
    region.striped_share /= count;
    return region;
}

std::vector<std::string> shipped_styles() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(test_support::source_dir() + "/configs/designs/styles"))
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class StylePictures : public testing::TestWithParam<std::string> {};

TEST_P(StylePictures, SeaLandAndMissingDataAreToldApart) {
    design::DesignSettings design = test_support::shipped_design("styles/" + GetParam());
    design.sky.haze_distance_m = 0;
    for (const char* device : {"es2-small", "es3-mid"}) {
        const std::vector<std::uint8_t> rgba = picture_of(design, device);
        // A post is 63 m and nearly a pixel wide; the middle of each third.
        const Region sea = region_of(rgba, 20, 50), land = region_of(rgba, 80, 118), gap = region_of(rgba, 145, 180);
        EXPECT_GT(glm::distance(sea.mean, land.mean), 40) << device;
        EXPECT_GT(glm::distance(gap.mean, land.mean), 28) << device;
        EXPECT_GT(glm::distance(gap.mean, sea.mean), 28) << device;
        EXPECT_GT(sea.blue_share, 0.9) << device;
        EXPECT_EQ(gap.blue_share, 0) << device;
        EXPECT_LT(land.blue_share, 0.1) << device;
        EXPECT_GT(gap.striped_share, 0.3) << device << ": hatched";
        EXPECT_LT(gap.striped_share, 0.6) << device;
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, StylePictures, testing::ValuesIn(shipped_styles()),
                         [](const auto& style) { return style.param; });

}  // namespace
}  // namespace tedavis::display::test_style_pictures
