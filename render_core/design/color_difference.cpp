#include "render_core/design/color_difference.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::design {
namespace {

using base::degrees;
using base::radians;

/// CIE XYZ of the primaries' full light, a row for X, Y and Z.
constexpr double kPrimaries[3][3] = {
    {0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}};

/// Share of the white, compressed as the eye does.
double compressed(double share) {
    constexpr double kLinearBelow = 216.0 / 24389, kSlope = 24389.0 / 27;
    return share > kLinearBelow ? std::cbrt(share) : (kSlope * share + 16) / 116;
}

double seventh_power_root(double chroma) {
    const double power = std::pow(chroma, 7);
    return std::sqrt(power / (power + std::pow(25.0, 7)));
}

double square(double x) { return x * x; }

/// Degrees 0..360; 0 without chroma.
double hue_deg(double a, double b) {
    if (a == 0 && b == 0) return 0;
    const double hue = degrees(std::atan2(b, a));
    return hue < 0 ? hue + 360 : hue;
}

/// The formula's L', C', h'.
struct Polar {
    double lightness, chroma, hue_deg;
};

double hue_step_deg(const Polar& first, const Polar& second) {
    if (first.chroma * second.chroma == 0) return 0;
    const double step = second.hue_deg - first.hue_deg;
    return step > 180 ? step - 360 : step < -180 ? step + 360 : step;
}

double mean_hue_deg(const Polar& first, const Polar& second) {
    const double sum = first.hue_deg + second.hue_deg;
    if (first.chroma * second.chroma == 0) return sum;
    if (std::fabs(first.hue_deg - second.hue_deg) <= 180) return sum / 2;
    return sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2;
}

double weighted_difference(const Polar& first, const Polar& second) {
    const double mean_l = (first.lightness + second.lightness) / 2, mean_c = (first.chroma + second.chroma) / 2;
    const double mean_h = mean_hue_deg(first, second);
    const double t = 1 - 0.17 * std::cos(radians(mean_h - 30)) + 0.24 * std::cos(radians(2 * mean_h)) +
                     0.32 * std::cos(radians(3 * mean_h + 6)) - 0.20 * std::cos(radians(4 * mean_h - 63));
    const double s_l = 1 + 0.015 * square(mean_l - 50) / std::sqrt(20 + square(mean_l - 50));
    const double s_c = 1 + 0.045 * mean_c, s_h = 1 + 0.015 * mean_c * t;
    const double turn_deg = 30 * std::exp(-square((mean_h - 275) / 25));
    const double rotation = -std::sin(radians(2 * turn_deg)) * 2 * seventh_power_root(mean_c);
    const double l = (second.lightness - first.lightness) / s_l, c = (second.chroma - first.chroma) / s_c;
    const double h = 2 * std::sqrt(first.chroma * second.chroma) * std::sin(radians(hue_step_deg(first, second) / 2)) / s_h;
    return std::sqrt(std::max(0.0, l * l + c * c + h * h + rotation * c * h));
}

}  // namespace

LinearRgb linear_rgb(Color color) noexcept {
    return {design::linear_light(color.red), design::linear_light(color.green), design::linear_light(color.blue)};
}

Lab lab_of(const LinearRgb& light) noexcept {
    const double rgb[3] = {std::clamp(light.red, 0.0, 1.0), std::clamp(light.green, 0.0, 1.0), std::clamp(light.blue, 0.0, 1.0)};
    double f[3];
    for (int i = 0; i < 3; ++i) {
        const double* row = kPrimaries[i];
        f[i] = compressed((row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2]) / (row[0] + row[1] + row[2]));
    }
    return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double color_difference(const Lab& first, const Lab& second) noexcept {
    const double mean = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2;
    const double stretch = 1 + 0.5 * (1 - seventh_power_root(mean));
    const auto polar = [stretch](const Lab& lab) {
        return Polar{lab.lightness, std::hypot(stretch * lab.a, lab.b), hue_deg(stretch * lab.a, lab.b)};
    };
    return weighted_difference(polar(first), polar(second));
}

}  // namespace tedavis::design
