/// A height raster of longitude and latitude, whole and as GDAL reads it, with the geoid as GDAL reads that: the true surface as
/// DESIGN defines it (two triangles a cell, diagonal from north-east to south-west, on WGS84 plus undulation). An oracle that
/// shares nothing with builder and display. Places by GeographicLib.
#pragma once

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>

#include <GeographicLib/Geocentric.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::test_support {

/// One band of doubles; voids are NaN.
struct GdalBand {
    int columns = 0, rows = 0;
    double west_deg = 0, north_deg = 0, step_lon_deg = 0, step_lat_deg = 0;  ///< of the centres of pixels
    std::vector<double> value;

    explicit GdalBand(const std::string& file) {
        GDALAllRegister();
        const std::string path = path_of(file);
        std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> data(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
        if (data == nullptr) throw std::runtime_error(file + ": GDAL reads no raster there");
        columns = data->GetRasterXSize();
        rows = data->GetRasterYSize();
        double transform[6];
        data->GetGeoTransform(transform);
        step_lon_deg = transform[1];
        step_lat_deg = -transform[5];
        west_deg = transform[0] + 0.5 * step_lon_deg;
        north_deg = transform[3] - 0.5 * step_lat_deg;
        value.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
        GDALRasterBand& band = *data->GetRasterBand(1);
        if (band.RasterIO(GF_Read, 0, 0, columns, rows, value.data(), columns, rows, GDT_Float64, 0, 0) != CE_None)
            throw std::runtime_error(file + ": cannot be read");
        int has_void = 0;
        const double void_value = band.GetNoDataValue(&has_void);
        if (has_void != 0) std::replace(value.begin(), value.end(), void_value, std::nan(""));
    }
    [[nodiscard]] double at(std::int64_t i, std::int64_t j) const { return value[static_cast<std::size_t>(j * columns + i)]; }
    /// Of an archive, the only file in it.
    [[nodiscard]] static std::string path_of(const std::string& file) {
        if (file.size() < 4 || file.compare(file.size() - 4, 4, ".zip") != 0) return file;
        const std::string archive = "/vsizip/" + file;
        const CPLStringList names(VSIReadDir(archive.c_str()));
        return names.empty() ? file : archive + "/" + names[0];
    }
};

class GdalTerrain {
public:
    explicit GdalTerrain(const std::string& file) : posts_(file) {
        const GdalBand geoid("/usr/share/proj/egm96_15.gtx");
        place_.reserve(posts_.value.size());
        for (int j = 0; j < posts_.rows; ++j)
            for (int i = 0; i < posts_.columns; ++i) {
                const double latitude_deg = posts_.north_deg - posts_.step_lat_deg * j,
                             longitude_deg = posts_.west_deg + posts_.step_lon_deg * i;
                double& height_m = posts_.value[place_.size()];
                height_m += bilinear_round_the_earth(geoid, latitude_deg, longitude_deg);
                place_.push_back(ecef(latitude_deg, longitude_deg, height_m));
            }
    }

    [[nodiscard]] int columns() const { return posts_.columns; }
    [[nodiscard]] int rows() const { return posts_.rows; }
    [[nodiscard]] double latitude_deg(double j) const { return posts_.north_deg - posts_.step_lat_deg * j; }
    [[nodiscard]] double longitude_deg(double i) const { return posts_.west_deg + posts_.step_lon_deg * i; }

    /// A kilometre above the sea.
    [[nodiscard]] earth::Geodetic middle() const {
        return {base::radians(latitude_deg(0.5 * rows())), base::radians(longitude_deg(0.5 * columns())), {1000}};
    }

    /// Above the ellipsoid at a place between posts; NaN outside and where a corner of the cell is void.
    [[nodiscard]] double surface_m(double i, double j) const {
        constexpr double kRounding = 1e-6;
        if (!(i >= -kRounding && j >= -kRounding && i <= columns() - 1 + kRounding && j <= rows() - 1 + kRounding))
            return std::nan("");
        return between<double>(i, j, [this](std::int64_t a, std::int64_t b) { return posts_.at(a, b); });
    }
    [[nodiscard]] double surface_at(double latitude_deg, double longitude_deg) const {
        return surface_m((longitude_deg - posts_.west_deg) / posts_.step_lon_deg,
                         (posts_.north_deg - latitude_deg) / posts_.step_lat_deg);
    }
    /// ECEF of a post; NaN where it is void.
    [[nodiscard]] const glm::dvec3& place(std::int64_t i, std::int64_t j) const {
        return place_[static_cast<std::size_t>(j * columns() + i)];
    }
    /// Inside the raster. A triangle's place as a flat one in space: by less than the square of a cell over eight radii wrong.
    [[nodiscard]] glm::dvec3 place_between(double i, double j) const {
        return between<glm::dvec3>(i, j, [this](std::int64_t a, std::int64_t b) { return place(a, b); });
    }
    [[nodiscard]] static glm::dvec3 ecef(double latitude_deg, double longitude_deg, double ellipsoid_m) {
        glm::dvec3 p;
        GeographicLib::Geocentric::WGS84().Forward(latitude_deg, longitude_deg, ellipsoid_m, p.x, p.y, p.z);
        return p;
    }

private:
    template <class T, class Value>
    [[nodiscard]] T between(double i, double j, const Value& value) const {
        const double a = std::clamp(std::floor(i), 0.0, columns() - 2.0), b = std::clamp(std::floor(j), 0.0, rows() - 2.0);
        const double u = i - a, v = j - b;
        const auto x = static_cast<std::int64_t>(a), y = static_cast<std::int64_t>(b);
        const T nw = value(x, y), ne = value(x + 1, y), sw = value(x, y + 1), se = value(x + 1, y + 1);
        const T no_void = 0.0 * (nw + ne + sw + se);
        if (u + v <= 1) return no_void + nw + u * (ne - nw) + v * (sw - nw);
        return no_void + se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
    }
    [[nodiscard]] static double bilinear_round_the_earth(const GdalBand& geoid, double latitude_deg, double longitude_deg) {
        const double x = (longitude_deg - geoid.west_deg) / geoid.step_lon_deg,
                     y = std::clamp((geoid.north_deg - latitude_deg) / geoid.step_lat_deg, 0.0, geoid.rows - 1.0);
        const double a = std::floor(x), b = std::min(std::floor(y), geoid.rows - 2.0);
        const auto node = [&](double i, double j) {
            const double turned = std::fmod(std::fmod(i, geoid.columns) + geoid.columns, geoid.columns);
            return geoid.at(static_cast<std::int64_t>(turned), static_cast<std::int64_t>(j));
        };
        const double u = x - a, v = y - b;
        return (1 - v) * ((1 - u) * node(a, b) + u * node(a + 1, b)) + v * ((1 - u) * node(a, b + 1) + u * node(a + 1, b + 1));
    }

    GdalBand posts_;  ///< above the ellipsoid
    std::vector<glm::dvec3> place_;
};

}  // namespace tedavis::test_support
