// What the uniforms place on the ground, in pictures from straight above: parallel ridges whose places are known.
#include "render_core/draw/terrain_uniforms.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/commands/terrain.hpp"
#include "host_sim/replay/posed_frame.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/command_run.hpp"
#include "tests/support/raster_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace tedavis::draw {
namespace {

constexpr int kColumns = 257, kCellsAWave = 32;
constexpr double kStep_deg = 0.001, kWest_deg = 9.6, kNorth_deg = 47.1;
constexpr std::uint32_t kSide_px = 320;
constexpr double kRange_m = 4000;
constexpr int kMiddleWave = 4;  ///< the ridge that the aircraft stands over

double ridge_longitude_deg(int wave) { return kWest_deg + (wave * kCellsAWave + 0.5) * kStep_deg; }
double latitude_deg() { return kNorth_deg - (kColumns / 2) * kStep_deg; }

/// Ridges from north to south, 32 posts from one to the next, 500 m above the valleys between them.
class RidgedGround {
public:
    RidgedGround() {
        test_support::RasterFile raster;
        raster.columns = raster.rows = kColumns;
        raster.transform = {kWest_deg, kStep_deg, 0, kNorth_deg, 0, -kStep_deg};
        raster.value = [](int i, int) { return 500 + 250 * std::cos(2 * base::kPi * i / kCellsAWave); };
        host_sim::TerrainBuildOptions build;
        build.rasters = {raster.write(folder_.file("ridges.tif"))};
        build.output = folder_.file("ridges.tdb");
        EXPECT_EQ(test_support::run_command([&](host_sim::Console& console) { return run_terrain_build(build, console); }).code,
                  0);
    }

    /// Ink of a column of the map, 0..1: the mean over its upper third, which the own ship does not reach. `style`: keys of
    /// [terrain.sketch].
    [[nodiscard]] std::vector<double> ink(const std::string& style) const {
        host_sim::PictureOptions options;
        options.terrain = folder_.file("ridges.tdb");
        options.size = host_sim::PictureSize{kSide_px, kSide_px};
        options.symbology = false;
        options.design =
            folder_.write("map.toml",
                          "name = 'map'\n[view]\nmode = 'map'\nmap_range_m = 4000\n[symbology]\nmap = false\nlegend = false\n"
                          "[sky]\nhaze_distance_m = 0\n[warning]\nenabled = false\n[terrain.texture]\ntechnique = 'plain'\n"
                          "plain_color = '#ffffff'\n[terrain.shade]\ntechnique = 'none'\n[[terrain.shade.light]]\n"
                          "azimuth_deg = 270\nelevation_deg = 30\n[terrain.sketch]\nline_color = '#000000'\n" +
                              style);
        host_sim::DisplaySession session(options, false);
        (void)posed_frame(session, {latitude_deg(), ridge_longitude_deg(kMiddleWave), 3000, 0, 0, 0}, {});
        std::vector<double> columns(kSide_px);
        for (std::uint32_t x = 0; x < kSide_px; ++x)
            for (std::uint32_t y = kSide_px / 6; y < kSide_px / 3; ++y)
                columns[x] += (1 - session.pixels().row(y)[x * 4] / 255.0) / (kSide_px / 3 - kSide_px / 6);
        return columns;
    }

private:
    test_support::TemporaryFolder folder_;
};

const RidgedGround& ground() {
    static const RidgedGround kGround;
    return kGround;
}

/// Column of the picture at so many waves east of its middle.
double column_at(double waves) {
    const double latitude = base::radians(latitude_deg());
    const double wave_m = base::radians(kCellsAWave * kStep_deg) * earth::prime_vertical_radius_m(latitude) * std::cos(latitude);
    return kSide_px / 2.0 + waves * wave_m / kRange_m * (kSide_px / 2.0);
}

double ink_between(const std::vector<double>& ink, double from, double to) {
    double sum = 0;
    for (auto x = static_cast<std::size_t>(from); x < static_cast<std::size_t>(to); ++x) sum += ink[x];
    return sum;
}

/// The line's middle near a column, and its width in pixels of full ink.
void expect_line(const std::vector<double>& ink, double column) {
    double sum = 0, moment = 0;
    for (int x = static_cast<int>(column) - 8; x <= static_cast<int>(column) + 8; ++x) {
        sum += ink[static_cast<std::size_t>(x)];
        moment += ink[static_cast<std::size_t>(x)] * (x + 0.5);
    }
    ASSERT_GT(sum, 0.5) << "no line near column " << column;
    EXPECT_LT(sum, 3) << "a thick line";
    EXPECT_NEAR(moment / sum, column, 1.5);
}

TEST(TerrainUniforms, RidgesAndValleysAreDrawnWhereTheyLie) {
    const std::vector<double> ridges = ground().ink("ridges = 1.0\n"), valleys = ground().ink("valleys = 1.0\n");
    for (const double waves : {-1.0, 0.0, 1.0}) expect_line(ridges, column_at(waves));
    for (const double waves : {-0.5, 0.5}) expect_line(valleys, column_at(waves));
    for (const double waves : {-0.5, 0.5})
        EXPECT_LT(ink_between(ridges, column_at(waves) - 8, column_at(waves) + 8), 0.1) << "no ridge in a valley";
    for (const double waves : {-1.0, 0.0, 1.0})
        EXPECT_LT(ink_between(valleys, column_at(waves) - 8, column_at(waves) + 8), 0.1) << "no valley on a ridge";
}

TEST(TerrainUniforms, ContoursFollowHeights) {
    // 500 m is half way between ridge and valley, the only contour of this interval.
    const std::vector<double> ink = ground().ink("contours = 1.0\ncontour_interval_m = 500\n");
    for (const double waves : {-0.75, -0.25, 0.25, 0.75}) expect_line(ink, column_at(waves));
    for (const double waves : {-0.5, 0.0, 0.5}) EXPECT_LT(ink_between(ink, column_at(waves) - 8, column_at(waves) + 8), 0.1);
}

TEST(TerrainUniforms, HatchesAndDotsFillTheSlopesInTheShade) {
    for (const char* style : {"hatching = 1.0\n", "stippling = 1.0\n"}) {
        const std::vector<double> ink = ground().ink(style);
        const double shade = ink_between(ink, column_at(0.1), column_at(0.4));  // east of a ridge, the light comes from the west
        const double light = ink_between(ink, column_at(-0.4), column_at(-0.1));
        EXPECT_GT(shade, 2) << style;
        EXPECT_LT(light, 0.2 * shade) << style;
    }
}

TEST(TerrainUniforms, NothingIsInkedWhereNoLineIsAskedFor) {
    const std::vector<double> ink = ground().ink("");
    EXPECT_EQ(ink_between(ink, 0, kSide_px), 0);
}

}  // namespace
}  // namespace tedavis::draw
