// Pictures of many poses over each of three terrains: skylines within the stated error and half a pixel of the full raster's, no
// background where the raster has ground, lifted surfaces nowhere below it. Run by command, see CONTRIBUTING.md.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/poses/grounds.hpp"
#include "tests/support/terrain/picture_proof.hpp"

namespace tedavis::test_picture_proof {
namespace {

using test_support::GdalTerrain;
using test_support::HardPose;
using test_support::HeadlessDisplay;
using test_support::PictureProof;

constexpr std::uint32_t kWidth = 1024, kHeight = 768, kSeed = 4711;

class PictureProofOf : public ::testing::TestWithParam<Ground> {
protected:
    PictureProof prove(double tau_px, bool lifted) {
        HeadlessDisplay headless("egl", "desktop", kWidth, kHeight, &bytes_, test_support::garish_design(tau_px, lifted));
        PictureProof proof;
        for (std::uint32_t n = 0; n < GetParam().pictures; ++n)
            if (const HardPose pose(truth_, kSeed, n); test_support::has_skyline(pose.kind))
                proof.include(headless, truth_, pose, n);
        std::printf("%s, tau %g%s: %s\n", GetParam().name, tau_px, lifted ? ", lifted" : "", proof.text().c_str());
        return proof;
    }

private:
    GdalTerrain truth_{GetParam().file};
    std::vector<std::uint8_t> image_ = test_support::build_image_of_file(GetParam().file);
    test_support::MemoryBytes bytes_{image_};
};

TEST_P(PictureProofOf, SkylinesAreTheTrueOnesAndNothingShowsThrough) {
    for (const double tau_px : {0.5, 1.0, 2.0, 4.0}) {
        const PictureProof proof = prove(tau_px, false);
        EXPECT_EQ(proof.too_high, 0);
        EXPECT_EQ(proof.too_low, 0);
        EXPECT_EQ(proof.cracks, 0);
        EXPECT_EQ(proof.unsettled, 0);
        EXPECT_GE(proof.pictures, 10);
    }
}

TEST_P(PictureProofOf, LiftedSkylinesAreNeverBelowTheTrueOnes) {
    const PictureProof proof = prove(2, true);
    EXPECT_EQ(proof.below_true, 0);
    EXPECT_EQ(proof.too_high, 0);
    EXPECT_EQ(proof.cracks, 0);
}

INSTANTIATE_TEST_SUITE_P(Terrains, PictureProofOf, ::testing::ValuesIn(grounds()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tedavis::test_picture_proof
