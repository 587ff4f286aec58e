#include "host_sim/evaluation/gaussian_window.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {
namespace {

void add_weighted_row(double* __restrict sum, const double* __restrict row, double weight, int width) {
    for (int x = 0; x < width; ++x) sum[x] += weight * row[x];
}

}  // namespace

GaussianWindow::GaussianWindow(double sigma_px, int radius) {
    double sum = 0;
    for (int k = 0; k <= radius; ++k) {
        weights_.push_back(std::exp(-k * k / (2 * sigma_px * sigma_px)));
        sum += (k == 0 ? 1 : 2) * weights_.back();
    }
    for (double& weight : weights_) weight /= sum;
}

std::vector<double> GaussianWindow::shares_inside(int length) const {
    const int radius = static_cast<int>(weights_.size()) - 1;
    std::vector<double> shares(static_cast<std::size_t>(length), 0.0);
    for (int x = 0; x < length; ++x)
        for (int k = std::max(-radius, -x); k <= std::min(radius, length - 1 - x); ++k)
            shares[static_cast<std::size_t>(x)] += weights_[static_cast<std::size_t>(std::abs(k))];
    return shares;
}

void GaussianWindow::blur_across(ValueMap& map) const {
    const std::size_t radius = weights_.size() - 1, width = static_cast<std::size_t>(map.width);
    const std::vector<double> shares = shares_inside(map.width);
    std::vector<double> line(width + 2 * radius, 0.0), sum(width);
    for (int y = 0; y < map.height; ++y) {
        double* row = map.row(y);
        std::copy_n(row, width, line.begin() + static_cast<std::ptrdiff_t>(radius));
        std::fill(sum.begin(), sum.end(), 0.0);
        add_weighted_row(sum.data(), line.data() + radius, weights_[0], map.width);
        for (std::size_t k = 1; k <= radius; ++k) {
            add_weighted_row(sum.data(), line.data() + radius - k, weights_[k], map.width);
            add_weighted_row(sum.data(), line.data() + radius + k, weights_[k], map.width);
        }
        for (std::size_t x = 0; x < width; ++x) row[x] = sum[x] / shares[x];
    }
}

ValueMap GaussianWindow::mean(const ValueMap& map) const {
    const int radius = static_cast<int>(weights_.size()) - 1;
    ValueMap across = map;
    blur_across(across);
    const std::vector<double> shares = shares_inside(map.height);
    ValueMap out(map.width, map.height);
    for (int y = 0; y < map.height; ++y) {
        double* row = out.row(y);
        const double share = shares[static_cast<std::size_t>(y)];
        for (int other = std::max(y - radius, 0); other <= std::min(y + radius, map.height - 1); ++other)
            add_weighted_row(row, across.row(other), weights_[static_cast<std::size_t>(std::abs(other - y))] / share, map.width);
    }
    return out;
}

ValueMap GaussianWindow::covariance(const ValueMap& a, const ValueMap& b, const ValueMap& mean_a, const ValueMap& mean_b) const {
    ValueMap products(a.width, a.height);
    for (std::size_t n = 0; n < products.values.size(); ++n) products.values[n] = a.values[n] * b.values[n];
    ValueMap covariances = mean(products);
    for (std::size_t n = 0; n < products.values.size(); ++n) covariances.values[n] -= mean_a.values[n] * mean_b.values[n];
    return covariances;
}

}  // namespace tedavis::host_sim
