/// The saliency model of thesis 5.3.3 pixel by pixel in double, written from its formulas and from Itti, Koch, Niebur 1998: an
/// oracle that shares no code with render_core/perception, and is some thousand times slower.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "render_core/perception/picture_view.hpp"

namespace tedavis::test_support {

/// One number a pixel; beyond its borders the nearest.
struct Field {
    int width = 0, height = 0;
    std::vector<double> values;

    Field(int columns, int rows) : width(columns), height(rows), values(perception::pixels_of(columns, rows)) {}
    double& at(int x, int y) { return values[perception::pixels_of(width, y) + static_cast<std::size_t>(x)]; }
    [[nodiscard]] double operator()(int x, int y) const;
    /// Interpolated between the pixels' middles; the picture has the corners (0, 0) and (width, height).
    [[nodiscard]] double between(double x, double y) const;
    [[nodiscard]] double most() const;
};

struct ReferenceOptions {
    bool fixed_scale = false;
    /// Controls: what a wrong model would do.
    bool without_entropy = false, without_colors = false;
    /// Divides by the largest value, whatever it is.
    bool without_guard = false;
    double wave_px = 4;
};

[[nodiscard]] std::array<Field, 3> reference_lab(const perception::PictureView& picture);
[[nodiscard]] Field reference_halved(const Field& field);
/// By direct summation of 9 x 9 products.
[[nodiscard]] Field reference_gabor(const Field& field, double angle_rad, double wave_px = 4);
/// The saliency map.
[[nodiscard]] Field itti_reference(const perception::PictureView& picture, const ReferenceOptions& options = {});

}  // namespace tedavis::test_support
