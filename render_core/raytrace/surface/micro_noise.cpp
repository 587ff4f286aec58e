#include "render_core/raytrace/surface/micro_noise.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::raytrace {
namespace {

constexpr double kHalfDiagonal = 0.70710678118654752440;  // the highest that gradient noise of unit slopes gets: amid a cell

std::uint32_t stirred(std::uint32_t bits) {
    bits = (bits ^ (bits >> 16)) * 0x7feb352du;
    bits = (bits ^ (bits >> 15)) * 0x846ca68bu;
    return bits ^ (bits >> 16);
}

std::uint32_t lattice_bits(std::int64_t column, std::int64_t row, std::uint32_t seed) {
    const auto high_of = [](std::int64_t n) { return static_cast<std::uint32_t>(static_cast<std::uint64_t>(n) >> 32); };
    const std::uint32_t first = stirred(static_cast<std::uint32_t>(column) + stirred(seed ^ (high_of(column) + 0x9e3779b9u)));
    return stirred(static_cast<std::uint32_t>(row) + stirred(first ^ (high_of(row) + 0x85ebca6bu)));
}

struct Fade {
    double weight, slope;  ///< of the farther lattice point
};

/// Smooth to the second derivative; 0..1 bit for bit.
Fade quintic_fade(double t) {
    return {std::clamp(t * t * t * (t * (t * 6 - 15) + 10), 0.0, 1.0), 30 * t * t * (t - 1) * (t - 1)};
}

/// What one lattice point alone would give.
SurfacePoint corner_of(NoiseKind kind, std::uint32_t bits, double dx, double dy) {
    if (kind == NoiseKind::value) return {static_cast<double>(static_cast<std::int32_t>(bits)) * 0x1p-31, 0, 0};
    static constexpr double kAcross[8] = {1, kHalfDiagonal, 0, -kHalfDiagonal, -1, -kHalfDiagonal, 0, kHalfDiagonal};
    const double x = kAcross[bits >> 29] / kHalfDiagonal, y = kAcross[((bits >> 29) + 6) % 8] / kHalfDiagonal;
    return {x * dx + y * dy, x, y};
}

SurfacePoint mixed(const SurfacePoint& a, const SurfacePoint& b, double weight) {
    return {(1 - weight) * a.height + weight * b.height, (1 - weight) * a.slope_x + weight * b.slope_x,
            (1 - weight) * a.slope_y + weight * b.slope_y};
}

/// Of one octave; x and y count lattice points.
SurfacePoint octave_at(NoiseKind kind, std::uint32_t seed, double x, double y) {
    const double left = std::floor(x), top = std::floor(y);
    const auto column = static_cast<std::int64_t>(left), row = static_cast<std::int64_t>(top);
    const double u = x - left, v = y - top;
    const SurfacePoint a = corner_of(kind, lattice_bits(column, row, seed), u, v);
    const SurfacePoint b = corner_of(kind, lattice_bits(column + 1, row, seed), u - 1, v);
    const SurfacePoint c = corner_of(kind, lattice_bits(column, row + 1, seed), u, v - 1);
    const SurfacePoint d = corner_of(kind, lattice_bits(column + 1, row + 1, seed), u - 1, v - 1);
    const Fade across = quintic_fade(u), down = quintic_fade(v);
    const SurfacePoint upper = mixed(a, b, across.weight), lower = mixed(c, d, across.weight);
    SurfacePoint point = mixed(upper, lower, down.weight);
    point.slope_x += across.slope * ((1 - down.weight) * (b.height - a.height) + down.weight * (d.height - c.height));
    point.slope_y += down.slope * (lower.height - upper.height);
    point.height = std::clamp(point.height, -1.0, 1.0);
    return point;
}

/// Of the first octave, so that all together have the amplitude.
double first_share(const MicroNoise& noise) {
    double shares = 0, share = 1;
    for (std::uint32_t n = 0; n < noise.octaves; ++n, share *= noise.gain) shares += share;
    return noise.amplitude / shares;
}

}  // namespace

double lattice_value(std::int64_t column, std::int64_t row, std::uint32_t seed) {
    return corner_of(NoiseKind::value, lattice_bits(column, row, seed), 0, 0).height;
}

SurfacePoint noise_at(const MicroNoise& noise, double x, double y) {
    SurfacePoint sum;
    double share = first_share(noise), frequency = noise.frequency;
    const double place_x = static_cast<double>(noise.first_column) + x, place_y = static_cast<double>(noise.first_row) + y;
    for (std::uint32_t n = 0; n < noise.octaves; ++n) {
        const SurfacePoint octave = octave_at(noise.kind, noise.seed + n, place_x * frequency, place_y * frequency);
        sum.height += share * octave.height;
        sum.slope_x += share * frequency * octave.slope_x;
        sum.slope_y += share * frequency * octave.slope_y;
        share *= noise.gain;
        frequency *= 2;
    }
    sum.height = std::clamp(sum.height, -noise.amplitude, noise.amplitude);
    return sum;
}

double steepest_slope(const MicroNoise& noise) {
    // The fade is nowhere steeper than 15/8, between corners that differ by at most 2 (value), or by what slopes of length sqrt 2
    // reach from opposite corners of a cell, 2 x sqrt 2 x sqrt 2, to which those slopes themselves come.
    const double of_lattice = noise.kind == NoiseKind::value ? 3.75 : 1.875 * 4 + 1 / kHalfDiagonal;
    double sum = 0, share = first_share(noise), frequency = noise.frequency;
    for (std::uint32_t n = 0; n < noise.octaves; ++n, share *= noise.gain, frequency *= 2) sum += share * frequency * of_lattice;
    return sum;
}

}  // namespace tedavis::raytrace
