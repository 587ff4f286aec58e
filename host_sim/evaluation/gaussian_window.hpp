/// Means and covariances under a Gaussian window around each pixel. Near the picture's border, the weights of the pixels inside
/// are normalised.
#pragma once

#include <vector>

#include "render_core/perception/picture_view.hpp"

namespace tedavis::host_sim {

/// One number per pixel, rows from the top.
struct ValueMap {
    int width = 0, height = 0;
    std::vector<double> values;

    ValueMap() = default;
    ValueMap(int columns, int rows) : width(columns), height(rows), values(perception::pixels_of(columns, rows)) {}
    [[nodiscard]] double* row(int y) { return values.data() + perception::pixels_of(width, y); }
    [[nodiscard]] const double* row(int y) const { return values.data() + perception::pixels_of(width, y); }
};

class GaussianWindow {
public:
    /// The window is truncated `radius` pixels from its centre, across and down.
    GaussianWindow(double sigma_px, int radius);

    [[nodiscard]] ValueMap mean(const ValueMap& map) const;
    /// mean(a b) - mean(a) mean(b); the means are passed since they serve several covariances. All of one size.
    [[nodiscard]] ValueMap covariance(const ValueMap& a, const ValueMap& b, const ValueMap& mean_a, const ValueMap& mean_b) const;

private:
    [[nodiscard]] std::vector<double> shares_inside(int length) const;
    void blur_across(ValueMap& map) const;

    std::vector<double> weights_;  // of the centre, and of both pixels together at each distance; their sum is 1
};

}  // namespace tedavis::host_sim
