#include "render_core/perception/spectral_residual.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::perception {
namespace {

using Complex = std::complex<double>;

constexpr int kSide = kResidualSide, kBits = 6, kResidualRadius = 7;
constexpr std::size_t kCells = std::size_t{kSide} * kSide;

std::size_t cell(int x, int y) {
    return std::size_t{kSide} * static_cast<unsigned>(y & (kSide - 1)) + static_cast<unsigned>(x & (kSide - 1));
}

/// Product without the library's care for infinities.
Complex times(const Complex& a, const Complex& b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

struct PixelRange {
    int first, end;
};
PixelRange pixels_of_cell(int n, int side) {
    const int first = n * side / kSide;
    return {first, std::max(first + 1, (n + 1) * side / kSide)};
}

/// Rec. 601, as most reference code has it.
double mean_luma(const PictureView& picture, const PixelRange& across, const PixelRange& down) {
    std::uint64_t sum = 0;
    for (int y = down.first; y < down.end; ++y) {
        const std::uint8_t* pixel = picture.row(y) + across.first * picture.channels;
        for (int x = across.first; x < across.end; ++x, pixel += picture.channels)
            sum += 299u * pixel[0] + 587u * pixel[1] + 114u * pixel[2];
    }
    return static_cast<double>(sum) / (1000.0 * (across.end - across.first) * (down.end - down.first));
}

/// Frequencies that are not there (0, but for rounding) take part as the faintest that counts.
double strength(const Complex& number) {
    constexpr double kFaintest = 1e-6;
    return std::max(std::hypot(number.real(), number.imag()), kFaintest);
}

}  // namespace

void fourier_transform(base::Span<Complex> numbers, TransformDirection way) noexcept {
    for (int n = 0; n < kSide; ++n) {
        int reversed = 0;
        for (int bit = 0; bit < kBits; ++bit) reversed |= (n >> bit & 1) << (kBits - 1 - bit);
        if (reversed > n) std::swap(numbers[static_cast<std::size_t>(n)], numbers[static_cast<std::size_t>(reversed)]);
    }
    const double sign = way == TransformDirection::forwards ? -1 : 1;
    for (int half = 1; half < kSide; half *= 2)
        for (int k = 0; k < half; ++k) {
            const double angle = sign * base::kPi * k / half;
            const Complex turn(std::cos(angle), std::sin(angle));
            for (int n = k; n < kSide; n += 2 * half) {
                Complex &low = numbers[n], &high = numbers[n + half];
                const Complex turned = times(turn, high);
                high = low - turned;
                low += turned;
            }
        }
    if (way == TransformDirection::backwards)
        for (Complex& number : numbers) number *= 1.0 / kSide;
}

std::size_t SpectralResidual::bytes() { return kCells * (sizeof(Complex) + sizeof(double) + sizeof(float)) + 3 * 16; }

bool SpectralResidual::start(base::Arena& arena) {
    spectrum_ = arena.allocate_array<Complex>(kCells);
    numbers_ = arena.allocate_array<double>(kCells);
    values_ = arena.allocate_array<float>(kCells);
    return !spectrum_.empty() && !numbers_.empty() && !values_.empty();
}

bool SpectralResidual::look(const PictureView& picture) {
    if (!picture.is_valid() || values_.empty()) return false;
    double least = 255, most = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double luma = mean_luma(picture, pixels_of_cell(x, picture.width), pixels_of_cell(y, picture.height));
            spectrum_[cell(x, y)] = luma;
            least = std::min(least, luma);
            most = std::max(most, luma);
        }
    has_salient_ = most > least;
    if (!has_salient_) {
        std::fill_n(values_.data(), kCells, 0.0f);
        return true;
    }
    transform(TransformDirection::forwards);
    take_residual();
    transform(TransformDirection::backwards);
    blur_power();
    return true;
}

void SpectralResidual::transform(TransformDirection way) {
    Complex column[kSide];
    for (int y = 0; y < kSide; ++y) fourier_transform(spectrum_.subspan(cell(0, y), kSide), way);
    for (int x = 0; x < kSide; ++x) {
        for (int y = 0; y < kSide; ++y) column[y] = spectrum_[cell(x, y)];
        fourier_transform(column, way);
        for (int y = 0; y < kSide; ++y) spectrum_[cell(x, y)] = column[y];
    }
}

void SpectralResidual::take_residual() {
    for (std::size_t n = 0; n < kCells; ++n) numbers_[n] = std::log(strength(spectrum_[n]));
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            double mean = 0;
            for (int v = -1; v <= 1; ++v)
                for (int u = -1; u <= 1; ++u) mean += numbers_[cell(x + u, y + v)] / 9;
            Complex& number = spectrum_[cell(x, y)];
            number *= std::exp(numbers_[cell(x, y)] - mean) / strength(number);
        }
}

void SpectralResidual::blur_power() {
    double weights[kResidualRadius + 1];
    for (int k = 0; k <= kResidualRadius; ++k) weights[k] = std::exp(-k * k / (2 * kResidualSigma_px * kResidualSigma_px));
    const auto inside = [](int n) { return std::clamp(n, 0, kSide - 1); };
    for (std::size_t n = 0; n < kCells; ++n) spectrum_[n] = std::norm(spectrum_[n]);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            double sum = 0;
            for (int k = -kResidualRadius; k <= kResidualRadius; ++k)
                sum += weights[std::abs(k)] * spectrum_[cell(inside(x + k), y)].real();
            numbers_[cell(x, y)] = sum;
        }
    double most = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            double sum = 0;
            for (int k = -kResidualRadius; k <= kResidualRadius; ++k)
                sum += weights[std::abs(k)] * numbers_[cell(x, inside(y + k))];
            spectrum_[cell(x, y)] = sum;
            most = std::max(most, sum);
        }
    for (std::size_t n = 0; n < kCells; ++n) values_[n] = static_cast<float>(spectrum_[n].real() / most);
}

}  // namespace tedavis::perception
