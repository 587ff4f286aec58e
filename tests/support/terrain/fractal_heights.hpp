/// Generated heights for the tracer, in its own grid: hills of eight octaves, with needles, voids, steps. Equal on every machine.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "render_core/raytrace/height_grid.hpp"

namespace tedavis::test_support {

/// Posts with their own memory.
template <class Height>
struct HeightField {
    std::uint32_t columns, rows, stride;
    std::vector<Height> posts;

    HeightField(std::uint32_t c, std::uint32_t r, Height height = 0)
        : columns(c), rows(r), stride(c), posts(std::size_t{c} * r, height) {}

    [[nodiscard]] raytrace::HeightGrid<Height> grid() const { return {posts.data(), columns, rows, stride}; }
    Height& at(std::uint32_t column, std::uint32_t row) { return posts[std::size_t{row} * stride + column]; }
    Height at(std::uint32_t column, std::uint32_t row) const { return posts[std::size_t{row} * stride + column]; }
};

/// Of `number`, well mixed (the finalizer of MurmurHash3 by Appleby).
inline std::uint32_t mixed_bits(std::uint32_t number) {
    number = (number ^ (number >> 16)) * 0x85ebca6bu;
    number = (number ^ (number >> 13)) * 0xc2b2ae35u;
    return number ^ (number >> 16);
}

/// How many height steps make the width of a cell in fractal_heights(): a power of two, so that heights in cells are exact.
inline double steps_a_cell(std::uint32_t side) { return std::exp2(std::round(std::log2(131072.0 / side))); }

/// Value noise, eight octaves of halved wavelength and amplitude: the highest are 0.15 side above the lowest.
inline HeightField<std::int16_t> fractal_heights(std::uint32_t side, std::uint32_t seed = 1) {
    constexpr int kOctaves = 8;
    HeightField<std::int16_t> field(side, side);
    std::vector<float> sums(side), lattice;
    const double steps = 0.15 * side * steps_a_cell(side) / 1.7;  // the octaves reach 0.15 to 0.85 of what they could
    for (std::uint32_t row = 0; row < side; ++row) {
        std::fill(sums.begin(), sums.end(), 0.0F);
        for (int octave = 0; octave < kOctaves; ++octave) {
            const double cells = 3.3 * (1 << octave) / side, at = row * cells;
            const auto line = static_cast<std::uint32_t>(at);
            const auto smooth = [](float f) { return f * f * (3 - 2 * f); };
            const float weight = smooth(static_cast<float>(at - line));
            const auto node = [&](std::uint32_t column, std::uint32_t j) {
                return static_cast<float>(mixed_bits(column ^ mixed_bits(j ^ mixed_bits(seed * 8 + octave))) >> 8) * 0x1p-23F;
            };
            lattice.resize(static_cast<std::size_t>(cells * side) + 2);
            for (std::uint32_t n = 0; n < lattice.size(); ++n)
                lattice[n] = node(n, line) * (1 - weight) + node(n, line + 1) * weight;
            const float amplitude = std::exp2(-static_cast<float>(octave + 1));
            for (std::uint32_t column = 0; column < side; ++column) {
                const double x = column * cells;
                const auto left = static_cast<std::uint32_t>(x);
                const float f = smooth(static_cast<float>(x - left));
                sums[column] += amplitude * (lattice[left] * (1 - f) + lattice[left + 1] * f);
            }
        }
        for (std::uint32_t column = 0; column < side; ++column)
            field.at(column, row) = static_cast<std::int16_t>(std::lround(steps * double{sums[column]}));
    }
    return field;
}

/// Raises one post in 2000 by a fiftieth of the side.
inline void add_needles(HeightField<std::int16_t>& field) {
    const double height = field.columns / 50 * steps_a_cell(field.columns);
    for (std::uint32_t n = 0; n < field.posts.size(); ++n) {
        if (mixed_bits(n ^ 0x5eedu) % 2000 != 0) continue;
        field.posts[n] = static_cast<std::int16_t>(std::min(32767.0, field.posts[n] + height));
    }
}

/// Takes the height from one post in `every`.
template <class Height>
void add_voids(HeightField<Height>& field, std::uint32_t every) {
    for (std::uint32_t n = 0; n < field.posts.size(); ++n)
        if (mixed_bits(n ^ 0x701d5u) % every == 0) field.posts[n] = raytrace::HeightGrid<Height>::kVoid;
}

/// Any height from 0 to `most`, each post for itself: the steepest cells that there are.
inline HeightField<std::int16_t> rough_heights(std::uint32_t columns, std::uint32_t rows, int most, std::uint32_t seed) {
    HeightField<std::int16_t> field(columns, rows);
    for (std::uint32_t n = 0; n < field.posts.size(); ++n)
        field.posts[n] = static_cast<std::int16_t>(mixed_bits(n ^ mixed_bits(seed)) % static_cast<unsigned>(most + 1));
    return field;
}

}  // namespace tedavis::test_support
