#include "render_core/perception/gaussian_weights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace tedavis::perception::test_gaussian_weights {
namespace {

int sum(const GaussianWeights& weights) {
    int all = weights.at[0];
    for (int k = 1; k <= weights.radius; ++k) all += 2 * weights.at[static_cast<std::size_t>(k)];
    return all;
}

TEST(GaussianWeights, AddUpToOneWhateverTheSigma) {
    for (double sigma = 0; sigma <= 4; sigma += 0.05) EXPECT_EQ(sum(gaussian_weights(sigma)), 256) << sigma;
}

TEST(GaussianWeights, WithoutSigmaNothingIsBlurred) {
    EXPECT_EQ(gaussian_weights(0).radius, 0);
    EXPECT_EQ(gaussian_weights(-1).radius, 0);
    EXPECT_EQ(gaussian_weights(std::nan("")).radius, 0);
    EXPECT_EQ(gaussian_weights(1e9).radius, kMaxRadius);
}

// From the outside to any weight, the sum is rounded; the middle takes what is left of both sides.
TEST(GaussianWeights, AreOpenCvsWithinRounding) {
    for (const double sigma : {0.5, 0.8, 1.0, 1.4, 2.0, 3.0}) {
        const GaussianWeights weights = gaussian_weights(sigma);
        const cv::Mat kernel = cv::getGaussianKernel(2 * weights.radius + 1, sigma, CV_64F);
        double outside = 0;
        for (int k = weights.radius; k > 0; --k) {
            outside += weights.at[static_cast<std::size_t>(k)] - 256 * kernel.at<double>(weights.radius + k);
            EXPECT_LE(std::fabs(outside), 0.5) << sigma << ' ' << k;
        }
        EXPECT_NEAR(weights.at[0], 256 * kernel.at<double>(weights.radius), 1) << sigma;
    }
}

}  // namespace
}  // namespace tedavis::perception::test_gaussian_weights
