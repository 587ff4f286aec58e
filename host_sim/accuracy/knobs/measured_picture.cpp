#include "host_sim/accuracy/knobs/measured_picture.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {
namespace {

constexpr int kGroundWaves = 6, kSigns = 14, kLines = 10;
constexpr double kWholeTurn_rad = 6.283185307179586;

struct GroundWave {
    double across, down, phase, strength[perception::kColors];

    explicit GroundWave(SeededRandom& numbers)
        : across(numbers.between(-0.08, 0.08)),
          down(numbers.between(-0.08, 0.08)),
          phase(numbers.between(0, kWholeTurn_rad)),
          strength{numbers.between(2, 14), numbers.between(2, 14), numbers.between(2, 14)} {}
};

std::uint8_t as_level(double value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)); }

}  // namespace

MeasuredPicture::MeasuredPicture(int width, int height)
    : width_(width), height_(height), pixels_(perception::kColors * perception::pixels_of(width, height)) {}

MeasuredPicture::MeasuredPicture(SeededRandom& numbers) : MeasuredPicture(kWidth, kHeight) {
    add_ground(numbers);
    for (int n = 0; n < kLines; ++n) add_line(numbers);
    for (int n = 0; n < kSigns; ++n) add_sign(numbers);
}

void MeasuredPicture::add_ground(SeededRandom& numbers) {
    std::vector<GroundWave> waves;
    for (int n = 0; n < kGroundWaves; ++n) waves.emplace_back(numbers);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x)
            for (int color = 0; color < perception::kColors; ++color) {
                double level = 110;
                for (const GroundWave& wave : waves)
                    level += wave.strength[color] * std::sin(wave.across * x + wave.down * y + wave.phase);
                at(x, y)[color] = as_level(level);
            }
}

/// A round or square sign of 6 to 40 pixels.
void MeasuredPicture::add_sign(SeededRandom& numbers) {
    const double half = numbers.between(3, 20), middle_x = numbers.between(0, width_), middle_y = numbers.between(0, height_);
    const bool is_round = numbers.between(0, 1) < 0.5;
    const double color[] = {numbers.between(0, 255), numbers.between(0, 255), numbers.between(0, 255)};
    for (int y = std::max(0, static_cast<int>(middle_y - half)); y < std::min<double>(height_, middle_y + half); ++y)
        for (int x = std::max(0, static_cast<int>(middle_x - half)); x < std::min<double>(width_, middle_x + half); ++x)
            if (!is_round || std::hypot(x - middle_x, y - middle_y) < half)
                for (int n = 0; n < perception::kColors; ++n) at(x, y)[n] = as_level(color[n]);
}

/// A line of 1 to 3 pixels across the picture.
void MeasuredPicture::add_line(SeededRandom& numbers) {
    const double from = numbers.between(0, height_), slope = numbers.between(-0.7, 0.7), level = numbers.between(0, 255);
    const int thick = static_cast<int>(numbers.between(1, 4));
    for (int x = 0; x < width_; ++x)
        for (int part = 0; part < thick; ++part) {
            const int y = static_cast<int>(std::floor(from + slope * x)) + part;
            if (y < 0 || y >= height_) continue;
            for (int n = 0; n < perception::kColors; ++n) at(x, y)[n] = as_level(level);
        }
}

MeasuredPicture MeasuredPicture::shrunk(int n) const {
    MeasuredPicture smaller(width_ / n, height_ / n);
    for (int y = 0; y < smaller.height_; ++y)
        for (int x = 0; x < smaller.width_; ++x)
            for (int color = 0; color < perception::kColors; ++color) {
                int sum = 0;
                for (int v = 0; v < n; ++v)
                    for (int u = 0; u < n; ++u) sum += at(n * x + u, n * y + v)[color];
                smaller.at(x, y)[color] = static_cast<std::uint8_t>((sum + n * n / 2) / (n * n));
            }
    return smaller;
}

}  // namespace tedavis::host_sim
