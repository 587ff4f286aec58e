#include "render_core/perception/spectral_residual.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/saliency.hpp>
#include <vector>

#include "tests/support/files/paths.hpp"
#include "tests/support/perception/golden_pictures.hpp"
#include "tests/support/perception/rank_correlation.hpp"

namespace tedavis::perception::test_spectral_residual {
namespace {

using test_support::flat_picture;
using test_support::landscape;
using test_support::noise_picture;
using test_support::rank_correlation;
using test_support::Rgb;
using test_support::SyntheticPicture;

using Complex = std::complex<double>;

std::vector<Complex> numbers_by_chance() {
    std::vector<Complex> numbers;
    for (std::uint32_t n = 0; n < 64; ++n)
        numbers.emplace_back(test_support::scrambled(n, 1, 2) % 1000 / 500.0 - 1,
                             test_support::scrambled(n, 2, 2) % 1000 / 500.0 - 1);
    return numbers;
}

TEST(FourierTransform, IsTheSumOfItsDefinition) {
    const std::vector<Complex> numbers = numbers_by_chance();
    std::vector<Complex> transformed = numbers;
    fourier_transform(transformed, TransformDirection::forwards);
    for (int k = 0; k < 64; ++k) {
        Complex sum = 0;
        for (int n = 0; n < 64; ++n)
            sum += numbers[static_cast<std::size_t>(n)] * std::polar(1.0, -2 * std::acos(-1.0) * n * k / 64);
        EXPECT_LT(std::abs(transformed[static_cast<std::size_t>(k)] - sum), 1e-12) << k;
    }
    fourier_transform(transformed, TransformDirection::backwards);
    for (std::size_t n = 0; n < 64; ++n) EXPECT_LT(std::abs(transformed[n] - numbers[n]), 1e-13);
}

struct HeldResidual {
    HeldResidual() : block(SpectralResidual::bytes()) {
        base::Arena arena(block.data(), block.size());
        EXPECT_TRUE(model.start(arena));
    }
    std::vector<float> of(const SyntheticPicture& picture) {
        EXPECT_TRUE(model.look(picture.view()));
        return {model.values().begin(), model.values().end()};
    }
    std::vector<unsigned char> block;
    SpectralResidual model;
};

/// The paper's formulas with OpenCV's transform, in double.
std::vector<double> reference_residual(const SyntheticPicture& picture) {
    cv::Mat luma(64, 64, CV_64F), planes[2], spectrum, logarithm, wrapped, mean;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            double sum = 0;
            int count = 0;
            for (int v = y * picture.height / 64; v < (y + 1) * picture.height / 64; ++v)
                for (int u = x * picture.width / 64; u < (x + 1) * picture.width / 64; ++u, ++count) {
                    const Rgb color = picture.at(u, v);
                    sum += 0.299 * color[0] + 0.587 * color[1] + 0.114 * color[2];
                }
            luma.at<double>(y, x) = sum / count;
        }
    cv::dft(luma, spectrum, cv::DFT_COMPLEX_OUTPUT);
    cv::split(spectrum, planes);
    cv::Mat strength;
    cv::magnitude(planes[0], planes[1], strength);
    strength = cv::max(strength, 1e-6);
    cv::log(strength, logarithm);
    cv::copyMakeBorder(logarithm, wrapped, 1, 1, 1, 1, cv::BORDER_WRAP);
    cv::blur(wrapped, mean, cv::Size(3, 3));
    cv::Mat factor;
    cv::exp(logarithm - mean(cv::Rect(1, 1, 64, 64)), factor);
    for (cv::Mat& plane : planes) plane = plane.mul(factor) / strength;
    cv::merge(planes, 2, spectrum);
    cv::dft(spectrum, spectrum, cv::DFT_INVERSE | cv::DFT_SCALE);
    cv::split(spectrum, planes);
    cv::Mat power = planes[0].mul(planes[0]) + planes[1].mul(planes[1]);
    cv::GaussianBlur(power, power, cv::Size(15, 15), kResidualSigma_px, kResidualSigma_px, cv::BORDER_REPLICATE);
    double most = 0;
    cv::minMaxLoc(power, nullptr, &most);
    power /= most;
    return {power.begin<double>(), power.end<double>()};
}

TEST(SpectralResidual, IsThePapersFormula) {
    HeldResidual held;
    for (const test_support::NamedPicture& of : test_support::golden_pictures(test_support::source_dir())) {
        const std::vector<float> map = held.of(of.picture);
        const std::vector<double> reference = reference_residual(of.picture);
        for (std::size_t n = 0; n < map.size(); ++n) ASSERT_NEAR(map[n], reference[n], 1e-5) << of.name;
    }
}

/// OpenCV's own model: of levels that are rounded at 64 x 64, its mean of the spectrum does not go round, and it squares after
/// blurring.
std::vector<float> opencv_residual(const SyntheticPicture& picture) {
    cv::Mat rgb(picture.height, picture.width, CV_8UC3), bgr, map;
    std::copy(picture.pixels.begin(), picture.pixels.end(), rgb.data);
    cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
    cv::resize(bgr, bgr, cv::Size(64, 64), 0, 0, cv::INTER_AREA);
    EXPECT_TRUE(cv::saliency::StaticSaliencySpectralResidual::create()->computeSaliency(bgr, map));
    return {map.begin<float>(), map.end<float>()};
}

TEST(SpectralResidual, RanksPlacesAsOpenCvDoes) {
    HeldResidual held;
    double mean = 0, of_others = 0;
    const std::vector<test_support::NamedPicture> pictures = test_support::golden_pictures(test_support::source_dir());
    for (const test_support::NamedPicture& of : pictures) {
        const std::vector<float> map = held.of(of.picture);
        const double rank = rank_correlation(map, opencv_residual(of.picture));
        RecordProperty(of.name, std::to_string(rank));
        EXPECT_GE(rank, 0.3) << of.name;
        mean += rank / static_cast<double>(pictures.size());
        of_others += rank_correlation(map, opencv_residual(of.picture.turned().turned())) / static_cast<double>(pictures.size());
    }
    EXPECT_GE(mean, 0.8);
    EXPECT_LT(of_others, 0.4) << "negative control: the picture upside down";
}

TEST(SpectralResidual, FlatPicturesHaveNothingSalient) {
    HeldResidual held;
    for (const SyntheticPicture& flat :
         {flat_picture(100, 70, {30, 90, 200}), flat_picture(1, 1, {255, 255, 255}), flat_picture(2, 3, {0, 0, 0})}) {
        EXPECT_EQ(held.of(flat), std::vector<float>(4096, 0));
        EXPECT_FALSE(held.model.has_salient());
    }
}

TEST(SpectralResidual, OneOddPatchIsTheMaximum) {
    HeldResidual held;
    const SyntheticPicture picture(640, 480, [](int x, int y) {
        const bool is_odd = std::abs(x - 450) < 12 && std::abs(y - 130) < 12;
        return is_odd ? Rgb{240, 240, 240} : x / 20 % 2 == 0 ? Rgb{90, 90, 90} : Rgb{110, 110, 110};
    });
    const std::vector<float> map = held.of(picture);
    const auto place = static_cast<int>(std::max_element(map.begin(), map.end()) - map.begin());
    EXPECT_NEAR(place % 64, 45, 2);
    EXPECT_NEAR(place >> 6, 17, 2);
    EXPECT_EQ(*std::max_element(map.begin(), map.end()), 1);
    EXPECT_TRUE(held.model.has_salient());
}

TEST(SpectralResidual, MirrorsWithThePicture) {
    HeldResidual held;
    const SyntheticPicture picture = landscape(256, 128, 4);
    const std::vector<float> map = held.of(picture), mirrored = held.of(picture.mirrored()), turned = held.of(picture.turned());
    for (std::size_t y = 0; y < 64; ++y)
        for (std::size_t x = 0; x < 64; ++x) {
            ASSERT_NEAR(map[64 * y + x], mirrored[64 * y + 63 - x], 1e-6);
            ASSERT_NEAR(map[64 * y + x], turned[64 * x + 63 - y], 1e-6);
        }
}

TEST(SpectralResidual, AnySizeIsFiniteAndTheSameTwice) {
    HeldResidual held;
    for (const auto& [width, height] : {std::pair{2, 1}, {2, 3}, {63, 65}, {1919, 1079}}) {
        const SyntheticPicture picture = noise_picture(width, height, 6);
        const std::vector<float> map = held.of(picture);
        for (const float value : map) ASSERT_TRUE(value >= 0 && value <= 1);
        EXPECT_EQ(map, held.of(picture));
    }
    EXPECT_FALSE(held.model.look({}));
}

}  // namespace
}  // namespace tedavis::perception::test_spectral_residual
