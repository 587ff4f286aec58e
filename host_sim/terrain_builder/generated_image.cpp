#include "host_sim/terrain_builder/generated_image.hpp"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "host_sim/atomic_file.hpp"
#include "host_sim/quiet_gdal.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

struct Color {
    double red, green, blue;
};

constexpr double kDistrict_m = 2400, kParcelLength_m = 420, kParcelWidth_m = 210, kHedge_m = 14, kRoad_m = 17;
constexpr double kVillage_m = 330, kHouse_m = 46;
constexpr double kWoodsFrom = 0.12, kWoodsTo = 0.34;  // slope, with some chance between
constexpr Color kWater{38, 58, 66}, kRoad{188, 182, 170}, kHedge{58, 78, 44}, kGarden{104, 124, 70};
constexpr Color kCrops[] = {{118, 146, 74}, {164, 158, 92},  {196, 178, 118}, {136, 112, 82},
                            {92, 128, 62},  {178, 184, 104}, {150, 136, 98}};
constexpr Color kRoofs[] = {{206, 198, 190}, {168, 96, 74}, {142, 132, 126}, {224, 220, 212}};

/// 64 bits of chance for a place.
std::uint64_t chance_bits(std::int64_t a, std::int64_t b, std::uint64_t what) {
    std::uint64_t z = static_cast<std::uint64_t>(a) * 0x9E3779B97F4A7C15u + static_cast<std::uint64_t>(b) * 0xD1B54A32D192ED03u +
                      what * 0xA0761D6478BD642Fu;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}
/// 0..1
double chance(std::int64_t a, std::int64_t b, std::uint64_t what) {
    return static_cast<double>(chance_bits(a, b, what) >> 11) * 0x1p-53;
}

std::int64_t cell_of(double metres, double size_m) { return static_cast<std::int64_t>(std::floor(metres / size_m)); }

/// Smooth chance, -1..1, whose lumps are `size_m` wide.
double lumps(double x, double y, double size_m, std::uint64_t what) {
    const std::int64_t i = cell_of(x, size_m), j = cell_of(y, size_m);
    const auto eased = [](double t) { return t * t * (3 - 2 * t); };
    const double u = eased(x / size_m - static_cast<double>(i)), v = eased(y / size_m - static_cast<double>(j));
    const double north = chance(i, j, what) * (1 - u) + chance(i + 1, j, what) * u;
    const double south = chance(i, j + 1, what) * (1 - u) + chance(i + 1, j + 1, what) * u;
    return 2 * (north * (1 - v) + south * v) - 1;
}

Color scaled(Color c, double by) { return {c.red * by, c.green * by, c.blue * by}; }
Color mixed(Color a, Color b, double share) {
    return {a.red + (b.red - a.red) * share, a.green + (b.green - a.green) * share, a.blue + (b.blue - a.blue) * share};
}

/// The district of a place: the nearest of one scattered centre in every cell (Worley, "A Cellular Texture Basis Function",
/// SIGGRAPH 1996), and how far its border is.
struct District {
    std::int64_t i = 0, j = 0;
    double x = 0, y = 0;  // from its centre, metres
    double border_m = 0;
};

District district_at(double x, double y) {
    const std::int64_t i = cell_of(x, kDistrict_m), j = cell_of(y, kDistrict_m);
    District nearest;
    double best = 1e30, second = 1e30;
    for (std::int64_t b = j - 1; b <= j + 1; ++b)
        for (std::int64_t a = i - 1; a <= i + 1; ++a) {
            const double east = x - (static_cast<double>(a) + 0.15 + 0.7 * chance(a, b, 1)) * kDistrict_m;
            const double south = y - (static_cast<double>(b) + 0.15 + 0.7 * chance(a, b, 2)) * kDistrict_m;
            const double distance = std::hypot(east, south);
            if (distance >= best) {
                second = std::min(second, distance);
                continue;
            }
            second = best;
            best = distance;
            nearest = {a, b, east, south, 0};
        }
    nearest.border_m = 0.5 * (second - best);
    return nearest;
}

/// Parcels lie along one direction in a district: one of four with a rational sine, so that nothing depends on a library's.
Color parcels(const District& d) {
    constexpr double kImageTurns[4][2] = {{1, 0}, {0.8, 0.6}, {0.6, 0.8}, {12 / 13.0, -5 / 13.0}};
    const double* const turn = kImageTurns[chance_bits(d.i, d.j, 3) % 4];
    const double x = d.x * turn[0] + d.y * turn[1], y = d.y * turn[0] - d.x * turn[1];
    const std::int64_t row = cell_of(y, kParcelWidth_m);
    const double shifted = x + kParcelLength_m * chance(row, d.i, 4);
    const std::int64_t column = cell_of(shifted, kParcelLength_m);
    const double inside_x = shifted - static_cast<double>(column) * kParcelLength_m,
                 inside_y = y - static_cast<double>(row) * kParcelWidth_m;
    if (std::min({inside_x, kParcelLength_m - inside_x, inside_y, kParcelWidth_m - inside_y}) < kHedge_m) return kHedge;
    const std::uint64_t crop = chance_bits(column + 131 * d.i, row + 131 * d.j, 5);
    const double furrows = cell_of(inside_y, 30) % 2 == 0 ? 1.03 : 0.97;
    return scaled(kCrops[crop % std::size(kCrops)], furrows * (0.92 + 0.16 * chance(column + 131 * d.i, row + 131 * d.j, 6)));
}

Color woods(double x, double y) {
    const double crowns = chance(cell_of(x, 24), cell_of(y, 24), 7);
    const Color stand = mixed({44, 68, 38}, {74, 92, 48}, 0.5 + 0.5 * lumps(x, y, 500, 8));
    return scaled(stand, 0.66 + 0.6 * crowns);
}

Color village(double x, double y) {
    const std::int64_t i = cell_of(x, kHouse_m), j = cell_of(y, kHouse_m);
    if (i % 4 == 0) return kRoad;
    return chance(i, j, 9) < 0.5 ? kRoofs[chance_bits(i, j, 10) % std::size(kRoofs)] : kGarden;
}

double metres_of_degrees_south(const Raster& raster, double latitude_rad) {
    return base::radians(raster.step_lat_deg) * earth::meridian_radius_m(latitude_rad);
}

}  // namespace

GeneratedImage::GeneratedImage(const Raster& raster) : raster_(raster) {
    const double latitude = base::radians(raster.north_deg - 0.5 * raster.rows * raster.step_lat_deg);
    south_m_ = metres_of_degrees_south(raster, latitude);
    east_m_ = base::radians(raster.step_lon_deg) * earth::prime_vertical_radius_m(latitude) * std::cos(latitude);
}

/// Beyond the border and over voids the nearest thing that is known well enough: the border, and zero.
double GeneratedImage::height(int i, int j) const {
    const auto column = static_cast<std::uint32_t>(std::clamp(i, 0, static_cast<int>(raster_.columns) - 1)),
               row = static_cast<std::uint32_t>(std::clamp(j, 0, static_cast<int>(raster_.rows) - 1));
    const double known = raster_.height_m[raster_.at(column, row)];
    return std::isnan(known) ? 0 : known;
}

GeneratedImage::Ground GeneratedImage::ground(int column, int row) const {
    const double u = (column + 0.5) / kPixelsPerPost - 0.5, v = (row + 0.5) / kPixelsPerPost - 0.5;
    const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
    const double x = u - i, y = v - j;
    Ground g{u * east_m_, v * south_m_, 0, 0, true};
    // Slopes between posts, from central differences at the four round the place.
    for (int n = 0; n < 4; ++n) {
        const int a = i + n % 2, b = j + n / 2;
        const double weight = (n % 2 == 0 ? 1 - x : x) * (n / 2 == 0 ? 1 - y : y);
        g.east_slope += weight * (height(a + 1, b) - height(a - 1, b)) / (2 * east_m_);
        g.north_slope += weight * (height(a, b - 1) - height(a, b + 1)) / (2 * south_m_);
    }
    const double here = height(static_cast<int>(std::floor(u + 0.5)), static_cast<int>(std::floor(v + 0.5)));
    for (int b = -2; b <= 2; ++b)
        for (int a = -2; a <= 2; ++a)
            g.is_level = g.is_level &&
                         std::abs(height(static_cast<int>(std::floor(u + 0.5)) + a, static_cast<int>(std::floor(v + 0.5)) + b) -
                                  here) < 0.5;
    return g;
}

std::array<std::uint8_t, 3> GeneratedImage::pixel(int column, int row) const {
    const Ground g = ground(column, row);
    // Borders of what grows do not follow the map's axes.
    const double x = g.east_m + 120 * lumps(g.east_m, g.south_m, 900, 11),
                 y = g.south_m + 120 * lumps(g.east_m, g.south_m, 900, 12);
    const District district = district_at(x, y);
    const double slope = std::hypot(g.east_slope, g.north_slope);
    const double wooded = (slope - kWoodsFrom) / (kWoodsTo - kWoodsFrom) + 0.9 * lumps(g.east_m, g.south_m, 700, 13);
    const bool inhabited = chance(district.i, district.j, 14) < 0.45;
    Color color = wooded > 0.5 ? woods(g.east_m, g.south_m) : parcels(district);
    if (inhabited && wooded <= 0.5 && std::hypot(district.x, district.y) < kVillage_m * (1 + 0.4 * lumps(x, y, 150, 15)))
        color = village(g.east_m, g.south_m);
    if (district.border_m < kRoad_m) color = kRoad;
    if (g.is_level) color = kWater;
    // From the north-west, 45 degrees high.
    const double facing = (0.5 * g.east_slope - 0.5 * g.north_slope + std::sqrt(0.5)) / std::sqrt(1 + slope * slope);
    const double light = (0.55 + 0.64 * std::max(facing, 0.0)) * (1 + 0.05 * (2 * chance(column, row, 16) - 1));
    const auto byte = [light](double value) { return static_cast<std::uint8_t>(std::clamp(value * light + 0.5, 0.0, 255.0)); };
    return {byte(color.red), byte(color.green), byte(color.blue)};
}

void write_generated_image(const std::string& raster_file, const std::string& path) {
    const Raster raster = load_rasters({raster_file}, {});
    const GeneratedImage image(raster);
    const QuietGdal quiet;
    const int columns = image.columns(), rows = image.rows();
    bool written = false;
    {
        const std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(
            GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), columns, rows, 3, GDT_Byte, nullptr));
        written = file != nullptr;
        if (written) {
            const double step_lon = raster.step_lon_deg / GeneratedImage::kPixelsPerPost,
                         step_lat = raster.step_lat_deg / GeneratedImage::kPixelsPerPost;
            double transform[6] = {raster.west_deg - 0.5 * raster.step_lon_deg,  step_lon, 0,
                                   raster.north_deg + 0.5 * raster.step_lat_deg, 0,        -step_lat};
            file->SetGeoTransform(transform);
            OGRSpatialReference wgs84;
            wgs84.importFromEPSG(4326);
            file->SetSpatialRef(&wgs84);
        }
        std::vector<std::uint8_t> line(static_cast<std::size_t>(columns) * 3);
        for (int row = 0; written && row < rows; ++row) {
            for (int column = 0; column < columns; ++column) {
                const std::array<std::uint8_t, 3> rgb = image.pixel(column, row);
                std::copy(rgb.begin(), rgb.end(), line.begin() + 3 * column);
            }
            written =
                file->RasterIO(GF_Write, 0, row, columns, 1, line.data(), columns, 1, GDT_Byte, 3, nullptr, 3, 0, 1) == CE_None;
        }
    }  // closing it writes what is left
    if (!written || CPLGetLastErrorType() >= CE_Failure)
        throw UserError(path + ": could not be written to its end (" + QuietGdal::last_message() + "); check the free space");
}

}  // namespace tedavis::host_sim
