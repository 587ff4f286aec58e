/// Heights of a grid for the ray tracer, held by the test.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "render_core/raytrace/height_grid.hpp"

namespace tedavis::test_support {

/// A sequence of numbers that is the same everywhere.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u + 0x1234567u) {}
    std::uint32_t bits() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        const auto mixed = static_cast<std::uint32_t>(((state_ >> 18) ^ state_) >> 27);
        const auto turn = static_cast<std::uint32_t>(state_ >> 59);
        return (mixed >> turn) | (mixed << ((32 - turn) & 31));
    }
    /// 0..1, 1 left out.
    double unit() { return bits() * 0x1p-32; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(unit() * count); }

private:
    std::uint64_t state_;
};

template <class Height>
struct HeldHeights {
    std::uint32_t columns, rows;
    std::vector<Height> posts;

    HeldHeights(std::uint32_t across, std::uint32_t down, Height all = 0)
        : columns(across), rows(down), posts(std::size_t{across} * down, all) {}

    Height& at(std::uint32_t column, std::uint32_t row) { return posts[std::size_t{row} * columns + column]; }
    [[nodiscard]] raytrace::HeightGrid<Height> grid() const { return {posts.data(), columns, rows, columns}; }

    template <class Formula>
    HeldHeights& fill(Formula formula) {
        for (std::uint32_t row = 0; row < rows; ++row)
            for (std::uint32_t column = 0; column < columns; ++column)
                at(column, row) = static_cast<Height>(formula(column, row));
        return *this;
    }
};

/// Hills of all sizes: sums of waves whose heights fall with their length, and some roughness.
template <class Height>
HeldHeights<Height> hilly_heights(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed, double height = 300) {
    Dice dice(seed);
    struct Wave {
        double x, y, phase, height;
    };
    std::vector<Wave> waves;
    for (double length = 64; length > 3; length /= 1.6)
        for (int n = 0; n < 3; ++n) {
            const double turn = dice.between(0, 6.2831853);
            waves.push_back({std::cos(turn) * 6.2831853 / length, std::sin(turn) * 6.2831853 / length, dice.between(0, 6.28),
                             height * length / 64 * dice.between(0.2, 0.5)});
        }
    return HeldHeights<Height>(columns, rows).fill([&](std::uint32_t x, std::uint32_t y) {
        double sum = dice.between(-0.01, 0.01) * height;
        for (const Wave& wave : waves) sum += wave.height * std::sin(wave.x * x + wave.y * y + wave.phase);
        return std::floor(sum);
    });
}

/// The worst case for whatever goes smoothly through posts.
template <class Height>
HeldHeights<Height> dice_heights(std::uint32_t columns, std::uint32_t rows, std::uint64_t seed, double height = 500) {
    Dice dice(seed);
    return HeldHeights<Height>(columns, rows).fill([&](std::uint32_t, std::uint32_t) { return dice.between(-height, height); });
}

}  // namespace tedavis::test_support
