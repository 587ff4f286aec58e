#include "host_sim/evaluation/fourier_transform.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/perception/synthetic_picture.hpp"

namespace tedavis::host_sim::test_fourier_transform {
namespace {

double by_chance(std::size_t n, std::uint32_t seed) {
    return test_support::scrambled(static_cast<std::uint32_t>(n), 5, seed) % 2001 / 1000.0 - 1;
}

TEST(FourierTransform, AgreesWithTheSum) {
    for (const int length : {1, 2, 3, 4, 5, 6, 8, 15, 16, 24, 40, 90, 135}) {
        const auto size = static_cast<std::size_t>(length);
        std::vector<Complex> in(size), out(size);
        for (std::size_t n = 0; n < size; ++n) in[n] = {by_chance(n, 1), by_chance(n, 2)};
        FourierTransform(length).forward(in.data(), out.data());
        for (std::size_t k = 0; k < size; ++k) {
            Complex sum = 0;
            for (std::size_t n = 0; n < size; ++n)
                sum += in[n] * std::polar(1.0, -2 * std::acos(-1.0) * static_cast<double>(n * k % size) / length);
            ASSERT_NEAR(std::abs(out[k] - sum), 0, 1e-12 * length) << length << " " << k;
        }
    }
}

TEST(FourierTransform, ThereAndBack) {
    Spectrum spectrum(24, 10);
    for (std::size_t n = 0; n < spectrum.values.size(); ++n) spectrum.values[n] = {by_chance(n, 3), by_chance(n, 4)};
    const Spectrum before = spectrum;
    spectrum.transform_forward();
    Complex sum = 0;
    for (const Complex& value : before.values) sum += value;
    EXPECT_NEAR(std::abs(spectrum.values[0] - sum), 0, 1e-12);
    EXPECT_GT(std::abs(spectrum.values[1] - before.values[1]), 0.1) << "something happened";
    spectrum.transform_backward();
    for (std::size_t n = 0; n < spectrum.values.size(); ++n)
        EXPECT_NEAR(std::abs(spectrum.values[n] - before.values[n]), 0, 1e-13);
}

TEST(SmoothLength, IsTheNextWithoutLargeFactors) {
    EXPECT_EQ(smooth_length(1024, 8), 1024);
    EXPECT_EQ(smooth_length(1080, 8), 1080);
    EXPECT_EQ(smooth_length(1, 8), 8);
    EXPECT_EQ(smooth_length(49, 8), 64) << "56 has a 7";
    EXPECT_EQ(smooth_length(1367, 8), 1440);
}

}  // namespace
}  // namespace tedavis::host_sim::test_fourier_transform
