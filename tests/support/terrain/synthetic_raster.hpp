/// Rasters made from formulas, for tests of everything that stands on terrain.
#pragma once

#include <functional>
#include <random>

#include "host_sim/terrain_builder/raster.hpp"

namespace tedavis::test_support {

inline host_sim::Raster make_raster(std::uint32_t columns, std::uint32_t rows,
                                    const std::function<float(std::uint32_t, std::uint32_t)>& height, double west_deg = 9.6,
                                    double north_deg = 47.1, double step_deg = 1.0 / 1200) {
    host_sim::Raster raster;
    raster.columns = columns;
    raster.rows = rows;
    raster.west_deg = west_deg;
    raster.north_deg = north_deg;
    raster.step_lon_deg = raster.step_lat_deg = step_deg;
    raster.source = "synthetic";
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const float h = height(i, j);
            const bool is_void = !(h == h);
            raster.height_m.push_back(h);
            raster.post_class.push_back(is_void ? terrain::PostClass::void_ : terrain::PostClass::land);
            raster.void_posts += is_void ? 1 : 0;
        }
    return raster;
}

/// Rough terrain: waves of halving length plus noise, seeded.
inline host_sim::Raster make_rough_raster(std::uint32_t columns, std::uint32_t rows, std::uint32_t seed = 1) {
    std::mt19937 random(seed);
    std::vector<float> noise(std::size_t{columns} * rows);
    for (float& n : noise) n = static_cast<float>(random() % 1000) * 0.002f;
    return make_raster(columns, rows, [&](std::uint32_t i, std::uint32_t j) {
        float h = 1000;
        for (int octave = 0; octave < 6; ++octave) {
            const float length = 128.0f / static_cast<float>(1 << octave);
            h += 4 * length * std::sin(static_cast<float>(i) / length) *
                 std::cos(static_cast<float>(j) / length * 1.3f + static_cast<float>(octave));
        }
        return h + noise[std::size_t{j} * columns + i];
    });
}

}  // namespace tedavis::test_support
