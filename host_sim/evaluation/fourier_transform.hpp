/// Discrete Fourier transforms of pictures whose sides have no prime factor above 5.
///
/// Source: J. W. Cooley, J. W. Tukey, "An algorithm for the machine calculation of complex Fourier series", Mathematics of
/// Computation 19 (1965).
#pragma once

#include <complex>
#include <vector>

namespace tedavis::host_sim {

using Complex = std::complex<double>;

/// Returns the smallest multiple of `step` that is no less than `length` and has no prime factors above 5; `step` has none
/// either.
[[nodiscard]] int smooth_length(int length, int step);

class FourierTransform {
public:
    /// `length` has no prime factor above 5.
    explicit FourierTransform(int length);

    /// out[k] = sum of in[n] e^(-2 pi i n k / length), of `length` values each, which do not overlap.
    void forward(const Complex* in, Complex* out) const { transform(in, 1, length_, out); }

private:
    void transform(const Complex* in, int stride, int length, Complex* out) const;
    void combine(Complex* out, int stride, int parts, int part_length) const;

    int length_;
    std::vector<Complex> turns_;  // e^(-2 pi i n / length)
};

/// A two-dimensional transform, rows from the top: forward as above along rows and columns; backward with the opposite sign and
/// divided by the number of values.
struct Spectrum {
    int width = 0, height = 0;
    std::vector<Complex> values;

    Spectrum(int columns, int rows)
        : width(columns), height(rows), values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}
    [[nodiscard]] Complex* row(int y) { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
    [[nodiscard]] const Complex* row(int y) const {
        return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    }
    void transform_forward();
    void transform_backward();
};

}  // namespace tedavis::host_sim
