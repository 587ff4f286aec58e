#include "host_sim/evaluation/steerable_bands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "tests/support/perception/synthetic_picture.hpp"

namespace tedavis::host_sim::test_steerable_bands {
namespace {

const double kHalfTurn = std::acos(-1.0);

ValueMap noise_map_of(int width, int height, std::uint32_t seed) {
    ValueMap map(width, height);
    for (std::size_t n = 0; n < map.values.size(); ++n)
        map.values[n] = test_support::scrambled(static_cast<std::uint32_t>(n), 9, seed) % 1000 / 1000.0;
    return map;
}

ValueMap wave(int width, int height, int across, int down) {
    ValueMap map(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            map.row(y)[x] =
                std::cos(2 * kHalfTurn * (static_cast<double>(across * x) / width + static_cast<double>(down * y) / height));
    return map;
}

double mean_square(const ValueMap& map) {
    double sum = 0;
    for (const double value : map.values) sum += value * value;
    return sum / static_cast<double>(map.values.size());
}

/// Of the radial frequency, in units of pi: what is left for a size, or for all coarser ones.
double radial(int size, double frequency, bool is_rest) {
    const auto low = [&](double end) {
        if (frequency <= end / 2) return 1.0;
        return frequency >= end ? 0.0 : std::cos(kHalfTurn / 2 * std::log2(2 * frequency / end));
    };
    const double here = low(std::exp2(-size)), below = low(std::exp2(-size - 1));
    return is_rest ? here : here * std::sqrt(1 - below * below);
}

/// One value of a band by the sum over all frequencies, of the sum over all pixels.
double directly(const ValueMap& picture, int size, int direction, int x, int y) {
    const int w = picture.width, h = picture.height;
    const double place_x = std::exp2(size) * (x + 0.5) - 0.5, place_y = std::exp2(size) * (y + 0.5) - 0.5;
    std::complex<double> sum = 0;
    for (int v = -h / 2; v < h / 2; ++v)
        for (int u = -w / 2; u < w / 2; ++u) {
            const double across = 2.0 * u / w, down = 2.0 * v / h;
            double share = radial(size, std::hypot(across, down), direction < 0);
            if (direction >= 0)
                share *= std::sqrt(0.8) * std::pow(std::cos(std::atan2(down, across) - kHalfTurn / 4 * direction), 3);
            std::complex<double> value = 0;
            for (int j = 0; j < h; ++j)
                for (int i = 0; i < w; ++i) value += picture.row(j)[i] * std::polar(1.0, -kHalfTurn * (across * i + down * j));
            sum += share * value * std::polar(1.0, kHalfTurn * (across * place_x + down * place_y));
        }
    return (direction >= 0 ? -sum.imag() : sum.real()) / (w * h);  // of i times the sum
}

TEST(SteerableBands, AgreeWithTheSums) {
    const ValueMap picture = noise_map_of(24, 16, 1);
    const std::vector<ValueMap> bands = steerable_bands(picture);
    ASSERT_EQ(bands.size(), 13u);
    for (int size = 0; size < 3; ++size)
        for (int direction = 0; direction < 4; ++direction) {
            const ValueMap& band = bands[static_cast<std::size_t>(4 * size + direction)];
            ASSERT_EQ(band.width, 24 >> size);
            ASSERT_EQ(band.height, 16 >> size);
            for (const auto& [x, y] : {std::pair{0, 0}, std::pair{2, 1}, std::pair{5, 3}})
                EXPECT_NEAR(band.row(y)[x], directly(picture, size, direction, x, y), 1e-12) << size << " " << direction;
        }
    EXPECT_EQ(bands[12].width, 3);
    EXPECT_NEAR(bands[12].row(1)[2], directly(picture, 3, -1, 2, 1), 1e-12);
}

// Waves of 6 and 5.7 pixels lie 0.585 and 0.5 octaves below the first band's end; 0.8 is what the cosine leaves of their energy.
TEST(SteerableBands, StripesLieInTheirDirection) {
    const auto energy = [](double octaves) { return 0.5 * 0.8 * std::pow(std::cos(kHalfTurn / 2 * octaves), 2); };
    const std::vector<ValueMap> upright = steerable_bands(wave(48, 48, 8, 0)), level = steerable_bands(wave(48, 48, 0, 8)),
                                slanted = steerable_bands(wave(48, 48, 6, 6));
    EXPECT_NEAR(mean_square(upright[0]), energy(std::log2(1.5)), 1e-12);
    EXPECT_LT(mean_square(upright[2]), 1e-20);
    EXPECT_NEAR(mean_square(level[2]), energy(std::log2(1.5)), 1e-12);
    EXPECT_LT(mean_square(level[0]), 1e-20);
    EXPECT_NEAR(mean_square(slanted[1]), energy(0.5), 1e-12);
    EXPECT_LT(mean_square(slanted[3]), 1e-20);
}

// What is not too fine for the first band is neither lost nor counted twice.
TEST(SteerableBands, KeepTheEnergy) {
    for (const auto& [across, down] : {std::pair{0, 0}, std::pair{1, 0}, std::pair{3, 2}, std::pair{7, 5}, std::pair{0, 12}}) {
        const ValueMap picture = wave(48, 48, across, down);
        double sum = 0;
        for (const ValueMap& band : steerable_bands(picture)) sum += mean_square(band);
        EXPECT_NEAR(sum, mean_square(picture), 1e-12) << across << " " << down;
    }
    const ValueMap too_fine = wave(48, 48, 24, 0);
    for (const ValueMap& band : steerable_bands(too_fine)) EXPECT_LT(mean_square(band), 1e-20);
}

TEST(SteerableBands, MirrorWithThePicture) {
    const ValueMap picture = noise_map_of(40, 24, 2);
    ValueMap mirrored(40, 24);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 40; ++x) mirrored.row(y)[x] = picture.row(y)[39 - x];
    const std::vector<ValueMap> bands = steerable_bands(picture), others = steerable_bands(mirrored);
    for (std::size_t n = 0; n < 13; ++n) {
        // Directions 1 and 3 change places; the signs of odd filters may change.
        const std::size_t direction = n % 4, other = n == 12 ? n : n - direction + (4 - direction) % 4;
        for (int y = 0; y < bands[n].height; ++y)
            for (int x = 0; x < bands[n].width; ++x)
                ASSERT_NEAR(std::fabs(others[other].row(y)[bands[n].width - 1 - x]), std::fabs(bands[n].row(y)[x]), 1e-12);
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_steerable_bands
