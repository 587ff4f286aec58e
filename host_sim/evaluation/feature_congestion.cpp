#include "host_sim/evaluation/feature_congestion.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host_sim/evaluation/gaussian_window.hpp"
#include "render_core/perception/oriented_energy.hpp"

namespace tedavis::host_sim {
namespace {

// The authors' program has L, a, b of light that is a hundredth of the white: a straight line of it. At a fifth of the white one
// of its units is 12.5 of CIELab's.
constexpr double kTheirUnit = 0.125;

// What the eye does not tell apart.
constexpr double kMinLightness = 0.0007 * kTheirUnit, kMinA = 0.1 * kTheirUnit, kMinB = 0.05 * kTheirUnit;
constexpr double kMinDirection2 = 0.001;
/// Energy of stripes of which half counts: that of their filter's noise, 1, for the stripes that it answers to best.
constexpr double kStripeNoise = 0.32;

constexpr double kUsualColor = 0.2088 * kTheirUnit, kUsualContrast = 0.0660 * kTheirUnit, kUsualDirection = 0.0269;

/// Measured from the first pixel: a covariance does not change by it, and is exactly 0 in a flat picture.
ValueMap from_first(const perception::Plane& plane) {
    ValueMap map(plane.width, plane.height);
    const double first = static_cast<double>(plane.values[0]);
    for (std::size_t n = 0; n < map.values.size(); ++n) map.values[n] = static_cast<double>(plane.values[n]) - first;
    return map;
}

ValueMap color_clutter(const perception::LabPlanes& lab) {
    const GaussianWindow window(3, 6);
    const ValueMap l = from_first(lab.lightness), a = from_first(lab.a), b = from_first(lab.b);
    const ValueMap mean_l = window.mean(l), mean_a = window.mean(a), mean_b = window.mean(b);
    const ValueMap ll = window.covariance(l, l, mean_l, mean_l), la = window.covariance(l, a, mean_l, mean_a),
                   lb = window.covariance(l, b, mean_l, mean_b), aa = window.covariance(a, a, mean_a, mean_a),
                   ab = window.covariance(a, b, mean_a, mean_b), bb = window.covariance(b, b, mean_b, mean_b);
    const double flat = std::cbrt(kMinLightness * kMinA * kMinB);
    ValueMap clutter(l.width, l.height);
    for (std::size_t n = 0; n < clutter.values.size(); ++n) {
        const double x = ll.values[n] + kMinLightness * kMinLightness, y = aa.values[n] + kMinA * kMinA,
                     z = bb.values[n] + kMinB * kMinB;
        const double xy = la.values[n], xz = lb.values[n], yz = ab.values[n];
        const double determinant = x * (y * z - yz * yz) - xy * (xy * z - yz * xz) + xz * (xy * yz - y * xz);
        clutter.values[n] = std::max(std::cbrt(std::sqrt(std::max(determinant, 0.0))) - flat, 0.0) / kUsualColor;
    }
    return clutter;
}

/// Differences of two Gaussians answer to spots and edges; how much their strengths vary is the clutter.
ValueMap contrast_clutter(const perception::LabPlanes& lab) {
    const ValueMap l = from_first(lab.lightness);
    ValueMap contrast = GaussianWindow(0.71, 3).mean(l);
    const ValueMap outer = GaussianWindow(1.14, 3).mean(l);
    for (std::size_t n = 0; n < contrast.values.size(); ++n) contrast.values[n] = std::fabs(contrast.values[n] - outer.values[n]);
    const GaussianWindow window(3, 6);
    const ValueMap mean = window.mean(contrast);
    ValueMap clutter = window.covariance(contrast, contrast, mean, mean);
    for (double& value : clutter.values) value = std::sqrt(std::max(value, 0.0)) / kUsualContrast;
    return clutter;
}

/// Energies of stripes in four directions, each the mean of its nearest pixels.
std::array<ValueMap, perception::kDirections> stripe_energies(const perception::Plane& lightness) {
    std::array<std::vector<float>, perception::kDirections> lengths;
    std::array<perception::Plane, perception::kDirections> planes;
    for (std::size_t n = 0; n < lengths.size(); ++n) {
        lengths[n].resize(lightness.size());
        planes[n] = {lengths[n].data(), lightness.width, lightness.height};
    }
    std::vector<float> scratch(perception::kOrientedEnergyScratch);
    perception::oriented_energy(lightness, perception::gabor_taps(), planes, {scratch.data(), scratch.size()});
    const GaussianWindow window(1.75, 4);
    std::array<ValueMap, perception::kDirections> energies;
    for (std::size_t n = 0; n < energies.size(); ++n) {
        ValueMap energy(lightness.width, lightness.height);
        for (std::size_t at = 0; at < energy.values.size(); ++at)
            energy.values[at] = static_cast<double>(lengths[n][at]) * static_cast<double>(lengths[n][at]);
        energies[n] = window.mean(energy);
    }
    return energies;
}

/// The cosine and sine of twice the direction, weighted by how clear it is.
ValueMap direction_clutter(const perception::LabPlanes& lab) {
    const std::array<ValueMap, perception::kDirections> energies = stripe_energies(lab.lightness);
    ValueMap cosine(lab.lightness.width, lab.lightness.height), sine = cosine, clutter = cosine;
    for (std::size_t n = 0; n < cosine.values.size(); ++n) {
        double sum = kStripeNoise;
        for (const ValueMap& energy : energies) sum += energy.values[n];
        cosine.values[n] = (energies[0].values[n] - energies[2].values[n]) / sum;
        sine.values[n] = (energies[1].values[n] - energies[3].values[n]) / sum;
    }
    const GaussianWindow window(14, 28);
    const ValueMap mean_cosine = window.mean(cosine), mean_sine = window.mean(sine);
    const ValueMap cc = window.covariance(cosine, cosine, mean_cosine, mean_cosine),
                   cs = window.covariance(cosine, sine, mean_cosine, mean_sine),
                   ss = window.covariance(sine, sine, mean_sine, mean_sine);
    for (std::size_t n = 0; n < clutter.values.size(); ++n) {
        const double x = cc.values[n] + kMinDirection2, y = ss.values[n] + kMinDirection2;
        const double area = std::sqrt(std::max(x * y - cs.values[n] * cs.values[n], 0.0));
        clutter.values[n] = std::max(std::sqrt(area) - std::sqrt(kMinDirection2), 0.0) / kUsualDirection;
    }
    return clutter;
}

FloatMap seen_at_full_size(const ValueMap& clutter, int level, const perception::Plane& full) {
    const auto cell = static_cast<float>(1 << level);
    FloatMap map{static_cast<std::uint32_t>(clutter.width), static_cast<std::uint32_t>(clutter.height), cell, cell, {}};
    for (const double value : clutter.values) map.values.push_back(static_cast<float>(value));
    return enlarged(map, static_cast<std::uint32_t>(full.width), static_cast<std::uint32_t>(full.height));
}

/// Adds, of each pixel, the greatest of the levels.
template <class Clutter>
void add_feature(const LabLevels& picture, const Clutter& clutter_of_level, FloatMap& sum) {
    const perception::Plane& full = picture.level(0).lightness;
    FloatMap most = seen_at_full_size(clutter_of_level(picture.level(0)), 0, full);
    for (int n = 1; n < LabLevels::kLevels; ++n) {
        const FloatMap coarser = seen_at_full_size(clutter_of_level(picture.level(n)), n, full);
        for (std::size_t at = 0; at < most.values.size(); ++at) most.values[at] = std::max(most.values[at], coarser.values[at]);
    }
    for (std::size_t at = 0; at < most.values.size(); ++at) sum.values[at] += most.values[at];
}

}  // namespace

FeatureCongestion feature_congestion(const LabLevels& picture) {
    const perception::Plane& full = picture.level(0).lightness;
    FeatureCongestion congestion;
    congestion.map = {static_cast<std::uint32_t>(full.width), static_cast<std::uint32_t>(full.height), 1, 1,
                      std::vector<float>(full.size(), 0.0f)};
    add_feature(picture, color_clutter, congestion.map);
    add_feature(picture, contrast_clutter, congestion.map);
    add_feature(picture, direction_clutter, congestion.map);
    for (const float value : congestion.map.values) congestion.mean += static_cast<double>(value);
    congestion.mean /= static_cast<double>(full.size());
    return congestion;
}

}  // namespace tedavis::host_sim
