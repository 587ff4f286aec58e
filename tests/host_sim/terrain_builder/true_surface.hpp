/// The true surface of a raster as DESIGN defines it: two triangles a cell, diagonal from north-east to south-west, heights
/// linear over the lattice, on the ellipsoid plus undulation. Written anew, in degrees, for tests of everything that states an
/// error against it.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/terrain_builder/raster.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::test_support {

class TrueSurface {
public:
    /// `closed`: the raster goes round the Earth, and rows at the poles are made where it ends beside them.
    explicit TrueSurface(const host_sim::Raster& raster, bool closed = false) : raster_(raster), closed_(closed) {
        for (std::uint32_t j = 0; j < raster.rows; ++j) {
            latitudes_deg_.push_back(raster.north_deg - raster.step_lat_deg * j);
            add_row(j);
        }
        if (closed) add_poles();
    }

    /// Above the ellipsoid; empty outside and where a corner of the cell is void.
    [[nodiscard]] std::optional<double> at(double latitude_deg, double longitude_deg) const {
        const auto columns = static_cast<std::int64_t>(rows_.front().size());
        const double east_deg = longitude_deg - raster_.west_deg;
        double x = (east_deg - 360 * std::floor((east_deg + 1e-9) / 360)) / raster_.step_lon_deg;
        if (x < 0) x = 0;
        std::size_t j = 0;
        while (j + 2 < latitudes_deg_.size() && latitudes_deg_[j + 1] >= latitude_deg) ++j;
        const double v = (latitudes_deg_[j] - latitude_deg) / (latitudes_deg_[j] - latitudes_deg_[j + 1]);
        const auto last = static_cast<double>(columns - (closed_ ? 0 : 1));
        if (v < -1e-9 || v > 1 + 1e-9 || x > last + 1e-9) return std::nullopt;
        const auto i = static_cast<std::int64_t>(std::min(std::floor(x), last - 1));
        const double u = x - static_cast<double>(i);
        const auto post = [&](std::int64_t a, std::size_t b) { return rows_[b][static_cast<std::size_t>(a % columns)]; };
        const double nw = post(i, j), ne = post(i + 1, j), sw = post(i, j + 1), se = post(i + 1, j + 1);
        if (std::isnan(nw + ne + sw + se)) return std::nullopt;
        return u + v <= 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
    }

private:
    void add_row(std::uint32_t j) {
        std::vector<double> row;
        for (std::uint32_t i = 0; i < raster_.columns; ++i) {
            const std::size_t n = raster_.at(i, j);
            const bool is_void = raster_.post_class[n] == terrain::PostClass::void_;
            row.push_back(is_void ? std::nan("") : raster_.height_m[n] + undulation_m(latitudes_deg_.back(), i));
        }
        rows_.push_back(row);
    }
    [[nodiscard]] double undulation_m(double latitude_deg, std::uint32_t i) const {
        return geoid_.undulation(base::radians(latitude_deg), base::radians(raster_.west_deg + raster_.step_lon_deg * i)).m;
    }
    void add_poles() {
        const auto pole = [&](double latitude_deg, std::uint32_t ring) {
            double sum = 0;
            for (std::uint32_t i = 0; i < raster_.columns; ++i) sum += raster_.height_m[raster_.at(i, ring)];
            return std::vector<double>(raster_.columns, sum / raster_.columns + undulation_m(latitude_deg, 0));
        };
        if (90 - latitudes_deg_.front() < raster_.step_lat_deg + 1e-9) {
            rows_.insert(rows_.begin(), pole(90, 0));
            latitudes_deg_.insert(latitudes_deg_.begin(), 90);
        }
        if (latitudes_deg_.back() + 90 < raster_.step_lat_deg + 1e-9) {
            rows_.push_back(pole(-90, raster_.rows - 1));
            latitudes_deg_.push_back(-90);
        }
    }

    const host_sim::Raster& raster_;
    const bool closed_;
    host_sim::GeoidEgm96 geoid_ = host_sim::GeoidEgm96::installed();
    std::vector<double> latitudes_deg_;
    std::vector<std::vector<double>> rows_;
};

}  // namespace tedavis::test_support
