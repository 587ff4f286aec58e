#include "tests/support/perception/congestion_reference.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::test_support {
namespace {

using Features = std::vector<Field>;  // one each
using Covariance = std::vector<std::vector<double>>;

/// Calls with each pixel of the window that lies in the picture, and its weight; they add up to 1.
template <class Visit>
void visit_window(const Field& field, int x, int y, double sigma, int radius, const Visit& visit) {
    double sum = 0;
    for (int pass = 0; pass < 2; ++pass)
        for (int v = y - radius; v <= y + radius; ++v)
            for (int u = x - radius; u <= x + radius; ++u) {
                if (u < 0 || v < 0 || u >= field.width || v >= field.height) continue;
                const double weight = std::exp(-((u - x) * (u - x) + (v - y) * (v - y)) / (2 * sigma * sigma));
                if (pass == 0)
                    sum += weight;
                else
                    visit(u, v, weight / sum);
            }
}

Field smoothed(const Field& field, double sigma, int radius) {
    Field out(field.width, field.height);
    for (int y = 0; y < field.height; ++y)
        for (int x = 0; x < field.width; ++x)
            visit_window(field, x, y, sigma, radius, [&](int u, int v, double weight) { out.at(x, y) += weight * field(u, v); });
    return out;
}

/// From the differences to the mean, in a second pass.
Covariance covariance_at(const Features& features, int x, int y, double sigma, int radius) {
    const std::size_t count = features.size();
    std::vector<double> means(count, 0.0);
    visit_window(features[0], x, y, sigma, radius, [&](int u, int v, double weight) {
        for (std::size_t n = 0; n < count; ++n) means[n] += weight * features[n](u, v);
    });
    Covariance covariance(count, std::vector<double>(count, 0.0));
    visit_window(features[0], x, y, sigma, radius, [&](int u, int v, double weight) {
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < count; ++j)
                covariance[i][j] += weight * (features[i](u, v) - means[i]) * (features[j](u, v) - means[j]);
    });
    return covariance;
}

/// By elimination; of a matrix that is positive definite.
double determinant(Covariance m) {
    double product = 1;
    for (std::size_t k = 0; k < m.size(); ++k) {
        product *= m[k][k];
        for (std::size_t i = k + 1; i < m.size(); ++i) {
            const double factor = m[i][k] / m[k][k];
            for (std::size_t j = k; j < m.size(); ++j) m[i][j] -= factor * m[k][j];
        }
    }
    return product;
}

struct Window {
    double sigma = 3;
    int radius = 6;
};

/// Mean radius of the ellipsoid, without what a flat picture has, in `usual` ones. `floors` are the least deviations.
Field ellipsoids(const Features& features, const std::vector<double>& floors, double usual, const Window& window) {
    Field out(features[0].width, features[0].height);
    const double root = 1.0 / static_cast<double>(features.size());
    double flat = 1;
    for (const double floor : floors) flat *= floor;
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            Covariance covariance = covariance_at(features, x, y, window.sigma, window.radius);
            for (std::size_t n = 0; n < floors.size(); ++n) covariance[n][n] += floors[n] * floors[n];
            const double volume = std::sqrt(std::max(determinant(covariance), 0.0));
            out.at(x, y) = std::max(std::pow(volume, root) - std::pow(flat, root), 0.0) / usual;
        }
    return out;
}

Field contrasts(const Field& lightness) {
    const Field inner = smoothed(lightness, 0.71, 3), outer = smoothed(lightness, 1.14, 3);
    Field out(lightness.width, lightness.height);
    for (std::size_t n = 0; n < out.values.size(); ++n) out.values[n] = std::fabs(inner.values[n] - outer.values[n]);
    return out;
}

Features directions_of(const Field& lightness) {
    Features energies;
    for (int n = 0; n < 4; ++n) {
        Field answer = reference_gabor(lightness, n * std::acos(-1.0) / 4);
        for (double& value : answer.values) value *= value;
        energies.push_back(smoothed(answer, 1.75, 4));
    }
    Features two(2, Field(lightness.width, lightness.height));
    for (std::size_t n = 0; n < two[0].values.size(); ++n) {
        double sum = 0.32;
        for (const Field& energy : energies) sum += energy.values[n];
        two[0].values[n] = (energies[0].values[n] - energies[2].values[n]) / sum;
        two[1].values[n] = (energies[1].values[n] - energies[3].values[n]) / sum;
    }
    return two;
}

void take_most(Field& most, const Field& level, int scale) {
    for (int y = 0; y < most.height; ++y)
        for (int x = 0; x < most.width; ++x)
            most.at(x, y) = std::max(most.at(x, y), level.between((x + 0.5) / scale, (y + 0.5) / scale));
}

}  // namespace

Field congestion_reference(const perception::PictureView& picture, const CongestionControls& controls) {
    const auto lab = reference_lab(picture);
    Features levels(lab.begin(), lab.end());
    Field color(picture.width, picture.height), contrast = color, direction = color;
    for (int scale = 1; scale <= (controls.one_size ? 1 : 4); scale *= 2) {
        if (scale > 1)
            for (Field& plane : levels) plane = reference_halved(plane);
        take_most(color, ellipsoids(levels, {0.0007 / 8, 0.1 / 8, 0.05 / 8}, 0.2088 / 8, {}), scale);
        take_most(contrast, ellipsoids({contrasts(levels[0])}, {0.0}, 0.066 / 8, {}), scale);
        const double floor = std::sqrt(0.001);
        take_most(direction, ellipsoids(directions_of(levels[0]), {floor, floor}, 0.0269, {14, 28}), scale);
    }
    for (std::size_t n = 0; n < contrast.values.size(); ++n) {
        if (!controls.without_colors) contrast.values[n] += color.values[n];
        if (!controls.without_directions) contrast.values[n] += direction.values[n];
    }
    return contrast;
}

}  // namespace tedavis::test_support
