#include "host_sim/evaluation/subband_entropy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/evaluation/fourier_transform.hpp"
#include "host_sim/evaluation/steerable_bands.hpp"
#include "render_core/perception/entropy.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kLightnessWeight = 0.84, kColorWeight = 0.08;
constexpr double kFlatRange = 0.001;  // a tenth of a unit of CIELab, invisible

/// Mirrored on at its end up to sides that can be taken apart.
ValueMap with_whole_sides(const perception::Plane& plane) {
    constexpr int kStep = 1 << kBandSizes;
    ValueMap map(smooth_length(plane.width, kStep), smooth_length(plane.height, kStep));
    const auto mirrored = [](int at, int length) {
        const int place = at % (2 * length);
        return place < length ? place : 2 * length - 1 - place;
    };
    for (int y = 0; y < map.height; ++y) {
        const float* row = plane.row(mirrored(y, plane.height));
        for (int x = 0; x < map.width; ++x) map.row(y)[x] = static_cast<double>(row[mirrored(x, plane.width)]);
    }
    return map;
}

/// Those whose middles lie in the picture; where it is narrower than a pixel, the first ones.
std::vector<double> values_inside(const ValueMap& band, double columns, double rows) {
    const auto whole = [](double count) { return std::max(static_cast<int>(std::ceil(count - 0.5)), 1); };
    std::vector<double> values;
    for (int y = 0; y < std::min(whole(rows), band.height); ++y)
        values.insert(values.end(), band.row(y), band.row(y) + std::min(whole(columns), band.width));
    return values;
}

double entropy_of(const std::vector<double>& values) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const double range = *most - *least;
    if (range < kFlatRange) return 0;
    const auto steps = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(values.size()))));
    std::vector<std::uint32_t> counts(steps, 0);
    for (const double value : values) {
        const auto step = static_cast<std::size_t>((value - *least) / range * static_cast<double>(steps));
        ++counts[std::min(step, steps - 1)];
    }
    return perception::shannon_entropy({counts.data(), counts.size()});
}

bool is_flat(const perception::Plane& plane) {
    const auto [least, most] = std::minmax_element(plane.values, plane.values + plane.size());
    return static_cast<double>(*most - *least) < kFlatRange;
}

double mean_entropy(const perception::Plane& plane) {
    if (is_flat(plane)) return 0;
    const std::vector<ValueMap> bands = steerable_bands(with_whole_sides(plane));
    double sum = 0;
    for (std::size_t n = 0; n < bands.size(); ++n) {
        const std::size_t size = n / kBandDirections;
        const double pixels = std::exp2(static_cast<double>(size));
        sum += entropy_of(values_inside(bands[n], plane.width / pixels, plane.height / pixels));
    }
    return sum / static_cast<double>(bands.size());
}

}  // namespace

double subband_entropy(const LabLevels& picture) {
    const perception::LabPlanes& lab = picture.level(0);
    return kLightnessWeight * mean_entropy(lab.lightness) + kColorWeight * (mean_entropy(lab.a) + mean_entropy(lab.b));
}

}  // namespace tedavis::host_sim
