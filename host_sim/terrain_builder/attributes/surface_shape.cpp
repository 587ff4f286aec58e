#include "host_sim/terrain_builder/attributes/surface_shape.hpp"

#include <cmath>

namespace tedavis::host_sim {
namespace {

using Stride = std::ptrdiff_t;

struct Difference {
    Lanes per_post, weight;
};

/// Along three posts, the middle one at `height_m`.
Difference difference(const float* height_m, const float* valid, Stride step) {
    const Lanes before = load(height_m - step), here = load(height_m), after = load(height_m + step);
    const Lanes vb = load(valid - step), vh = load(valid), va = load(valid + step);
    const Lanes both = vb * va, usable = larger(both, vh * larger(vb, va));
    const Lanes rise = (va > 0.0f ? after : here) - (vb > 0.0f ? before : here);
    return {usable > 0.0f ? rise * (both > 0.0f ? all(0.5f) : all(1.0f)) : all(0.0f), usable};
}

/// Of three parallel lines of posts, the middle one counting twice; along `step`, the lines `across` apart.
Lanes horn(const float* height_m, const float* valid, Stride step, Stride across) {
    const Difference a = difference(height_m - across, valid - across, step), b = difference(height_m, valid, step),
                     c = difference(height_m + across, valid + across, step);
    const Lanes sum = (a.per_post + c.per_post) + 2.0f * b.per_post;
    const Lanes weight = (a.weight + c.weight) + 2.0f * b.weight;
    return weight > 0.0f ? sum / larger(weight, all(1.0f)) : all(0.0f);
}

Lanes second_difference(const float* height_m, const float* valid, Stride step) {
    const Lanes known = load(valid - step) * load(valid) * load(valid + step);
    const Lanes bend = (load(height_m - step) + load(height_m + step)) - 2.0f * load(height_m);
    return known > 0.0f ? bend : all(0.0f);
}

/// Of heights to the east and the north.
Lanes mixed_difference(const float* height_m, const float* valid, Stride stride) {
    const Lanes known = load(valid - stride - 1) * load(valid - stride + 1) * load(valid + stride - 1) * load(valid + stride + 1);
    const Lanes rising = load(height_m - stride + 1) + load(height_m + stride - 1);
    const Lanes falling = load(height_m - stride - 1) + load(height_m + stride + 1);
    return known > 0.0f ? 0.25f * (rising - falling) : all(0.0f);
}

}  // namespace

Gradients::Gradients(const HeightPlanes& planes) : east(planes.validity.size(), 0.0f), north(planes.validity.size(), 0.0f) {
    const Stride stride = static_cast<Stride>(planes.stride);
    const float per_north_m = static_cast<float>(1 / planes.tile.north_m);
    for (int row = -kHorizonReach; row < planes.tile.rows + kHorizonReach; ++row) {
        const float per_east_m = static_cast<float>(1 / planes.east_m(row));
        for (int column = -kHorizonReach; column < planes.tile.columns + kHorizonReach; column += kLanes) {
            const std::size_t at = planes.at(column, row);
            const float *height_m = &planes.high[at_post][at], *valid = &planes.validity[at];
            store(&east[at], horn(height_m, valid, 1, stride) * per_east_m);
            store(&north[at], -horn(height_m, valid, stride, 1) * per_north_m);
        }
    }
}

Lanes curvature(const HeightPlanes& planes, const Gradients& gradients, std::size_t at, double east_m) {
    const Stride stride = static_cast<Stride>(planes.stride);
    const double north_m = planes.tile.north_m;
    const float *height_m = &planes.high[at_post][at], *valid = &planes.validity[at];
    const Lanes ee = second_difference(height_m, valid, 1) * static_cast<float>(1 / (east_m * east_m));
    const Lanes nn = second_difference(height_m, valid, stride) * static_cast<float>(1 / (north_m * north_m));
    const Lanes en = mixed_difference(height_m, valid, stride) * static_cast<float>(1 / (east_m * north_m));
    const Lanes e = load(&gradients.east[at]), n = load(&gradients.north[at]);
    const Lanes bend = ((1.0f + n * n) * ee + (1.0f + e * e) * nn) - 2.0f * ((e * n) * en);
    const Lanes area = 1.0f + (e * e + n * n);
    return bend / (area * root(area)) * static_cast<float>(-0.5 * std::sqrt(east_m * north_m));
}

}  // namespace tedavis::host_sim
