#include "host_sim/evaluation/fourier_transform.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kMaxParts = 5;
constexpr std::array<int, 4> kParts = {4, 2, 3, 5};

/// Without the standard's detour for infinities.
Complex product(const Complex& a, const Complex& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

bool is_smooth(int length) {
    for (const int part : {2, 3, 5})
        while (length % part == 0) length /= part;
    return length == 1;
}

int parts_of(int length) {
    const auto* found = std::find_if(kParts.begin(), kParts.end(), [&](int parts) { return length % parts == 0; });
    return found == kParts.end() ? 1 : *found;
}

}  // namespace

int smooth_length(int length, int step) {
    int smooth = (length + step - 1) / step * step;
    while (!is_smooth(smooth)) smooth += step;
    return smooth;
}

FourierTransform::FourierTransform(int length) : length_(length) {
    for (int n = 0; n < length; ++n) turns_.push_back(std::polar(1.0, -2 * base::kPi * n / length));
}

/// Every `parts`th value is transformed apart, one after the other into `out`.
void FourierTransform::transform(const Complex* in, int stride, int length, Complex* out) const {
    const int parts = parts_of(length);
    if (parts == 1) {
        out[0] = in[0];
        return;
    }
    const int part_length = length / parts;
    for (int n = 0; n < parts; ++n)
        transform(in + std::ptrdiff_t{n} * stride, stride * parts, part_length, out + std::ptrdiff_t{n} * part_length);
    combine(out, stride, parts, part_length);
}

void FourierTransform::combine(Complex* out, int stride, int parts, int part_length) const {
    std::array<Complex, kMaxParts> turned{}, corner{};
    const auto turn = [&](int n) { return turns_[static_cast<std::size_t>(n)]; };
    for (int n = 0; n < parts; ++n) corner[static_cast<std::size_t>(n)] = turn(length_ / parts * n);
    for (int k = 0; k < part_length; ++k) {
        for (int n = 0; n < parts; ++n)
            turned[static_cast<std::size_t>(n)] = product(out[n * part_length + k], turn(n * k * stride));
        for (int m = 0; m < parts; ++m) {
            Complex sum = turned[0];
            for (int n = 1; n < parts; ++n)
                sum += product(turned[static_cast<std::size_t>(n)], corner[static_cast<std::size_t>(n * m % parts)]);
            out[m * part_length + k] = sum;
        }
    }
}

void Spectrum::transform_forward() {
    const FourierTransform across(width), down(height);
    std::vector<Complex> line(static_cast<std::size_t>(std::max(width, height)));
    for (int y = 0; y < height; ++y) {
        std::copy_n(row(y), width, line.begin());
        across.forward(line.data(), row(y));
    }
    std::vector<Complex> column(static_cast<std::size_t>(height));
    for (int x = 0; x < width; ++x) {
        for (int y = 0; y < height; ++y) line[static_cast<std::size_t>(y)] = row(y)[x];
        down.forward(line.data(), column.data());
        for (int y = 0; y < height; ++y) row(y)[x] = column[static_cast<std::size_t>(y)];
    }
}

void Spectrum::transform_backward() {
    for (Complex& value : values) value = std::conj(value);
    transform_forward();
    const double share = 1 / static_cast<double>(values.size());
    for (Complex& value : values) value = std::conj(value) * share;
}

}  // namespace tedavis::host_sim
