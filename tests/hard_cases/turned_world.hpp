/// Generated terrain on a lattice that may go round the Earth or reach the north pole, turned about the Earth's axis as one
/// likes. Heights are above the ellipsoid: a FlatGeoid must live. The true surface is written anew, as in gdal_terrain.hpp; a
/// cell at the pole is one triangle with its apex there.
#pragma once

#include <cmath>

#include "host_sim/terrain_builder/fractal_terrain.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "tests/support/terrain/gdal_terrain.hpp"

namespace tedavis::test_support {

class TurnedWorld {
public:
    struct Shape {
        std::uint32_t columns, rows;
        double west_deg, north_deg, step_lon_deg, step_lat_deg;
        bool is_closed = false, has_pole = false;
        std::uint32_t every = 3;  ///< n-th post of the generated terrain
    };

    TurnedWorld(const Shape& shape, double turned_deg) : shape_(shape) {
        raster.columns = shape.columns;
        raster.rows = shape.rows;
        raster.west_deg = shape.west_deg + turned_deg;
        raster.north_deg = shape.north_deg;
        raster.step_lon_deg = shape.step_lon_deg;
        raster.step_lat_deg = shape.step_lat_deg;
        raster.vertical_datum = host_sim::VerticalDatum::ellipsoid;
        raster.source = "generated";
        const host_sim::FractalTerrain ground(5);
        for (std::uint32_t j = 0; j < shape.rows; ++j)
            for (std::uint32_t i = 0; i < shape.columns; ++i) {
                const float height_m = shape.has_pole ? height_about_pole(ground, i, j) : height_along(ground, i, j);
                raster.height_m.push_back(height_m);
                raster.post_class.push_back(height_m == 0 ? terrain::PostClass::sea : terrain::PostClass::land);
            }
    }

    host_sim::Raster raster;

    /// With the closing column and the row at the pole.
    [[nodiscard]] int columns() const { return static_cast<int>(shape_.columns) + (shape_.is_closed ? 1 : 0); }
    [[nodiscard]] int rows() const { return static_cast<int>(shape_.rows) + (shape_.has_pole ? 1 : 0); }
    [[nodiscard]] double latitude_deg(int j) const {
        return is_pole(j) ? 90 : raster.north_deg - raster.step_lat_deg * (j - (shape_.has_pole ? 1 : 0));
    }
    [[nodiscard]] double longitude_deg(int i) const { return raster.west_deg + raster.step_lon_deg * i; }
    [[nodiscard]] double height_m(int i, int j) const {
        if (!is_pole(j))
            return double{raster.height_m[raster.at(static_cast<std::uint32_t>(i) % shape_.columns,
                                                    static_cast<std::uint32_t>(j - (shape_.has_pole ? 1 : 0)))]};
        double sum = 0;
        for (std::uint32_t n = 0; n < shape_.columns; ++n) sum += double{raster.height_m[n]};
        return sum / shape_.columns;
    }
    [[nodiscard]] glm::dvec3 place(int i, int j) const {
        return GdalTerrain::ecef(latitude_deg(j), longitude_deg(i), height_m(i, j));
    }
    /// NaN outside.
    [[nodiscard]] double surface_at(double place_latitude_deg, double place_longitude_deg) const {
        double x = (place_longitude_deg - raster.west_deg) / raster.step_lon_deg;
        const double turn = 360 / raster.step_lon_deg;
        x -= turn * std::floor((x + 1e-6) / turn);
        int j = 0;
        while (j + 2 < rows() && latitude_deg(j + 1) > place_latitude_deg) ++j;
        const double v = (latitude_deg(j) - place_latitude_deg) / (latitude_deg(j) - latitude_deg(j + 1));
        if (!(x <= columns() - 1 + 1e-6 && v >= -1e-6 && v <= 1 + 1e-6)) return std::nan("");
        const int i = std::clamp(static_cast<int>(std::floor(x)), 0, columns() - 2);
        const double u = x - i, nw = height_m(i, j), ne = height_m(i + 1, j), sw = height_m(i, j + 1),
                     se = height_m(i + 1, j + 1);
        if (is_pole(j)) return nw + v * (sw + u * (se - sw) - nw);
        return u + v <= 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
    }

private:
    [[nodiscard]] float height_along(const host_sim::FractalTerrain& ground, std::uint32_t i, std::uint32_t j) const {
        // Round the Earth there and back, so that the ends meet.
        const std::uint32_t place = shape_.is_closed ? std::min(i, shape_.columns - i) : i;
        float height_m = 0;
        ground.read(static_cast<std::int32_t>(shape_.every * place), static_cast<std::int32_t>(shape_.every * j), 1, 1,
                    {&height_m, 1});
        return height_m;
    }
    /// On a plane, so that what lies side by side has heights to match, however close the columns are.
    [[nodiscard]] float height_about_pole(const host_sim::FractalTerrain& ground, std::uint32_t i, std::uint32_t j) const {
        constexpr double kMiddle = 50'000, kPostsPerDegree = 3600;
        const double radius = (90 - shape_.north_deg + shape_.step_lat_deg * j) * kPostsPerDegree,
                     angle = base::radians(shape_.step_lon_deg * i);
        const double x = kMiddle + radius * std::cos(angle), y = kMiddle + radius * std::sin(angle);
        float corners[4];
        ground.read(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), 2, 2, corners);
        const auto u = static_cast<float>(x - std::floor(x)), v = static_cast<float>(y - std::floor(y));
        const float north = corners[0] + u * (corners[1] - corners[0]), south = corners[2] + u * (corners[3] - corners[2]);
        return north + v * (south - north);
    }
    [[nodiscard]] bool is_pole(int j) const { return shape_.has_pole && j == 0; }

    Shape shape_;
};

}  // namespace tedavis::test_support
