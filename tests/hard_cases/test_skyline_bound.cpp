// In every picture the skyline is that of the full raster within the stated error and half a pixel, lifted surfaces never fall
// short of it, and no background shows through the ground. tests/poses looks at more pictures, and of other terrains.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/support/files/paths.hpp"
#include "tests/support/programs/headless_backends.hpp"
#include "tests/support/terrain/damaged_terrain.hpp"
#include "tests/support/terrain/picture_proof.hpp"

namespace tedavis::test_skyline_bound {
namespace {

using test_support::GdalTerrain;
using test_support::HardPose;
using test_support::HeadlessDisplay;
using test_support::PictureProof;
using test_support::PoseKind;
using test_support::TerrainPicture;

constexpr std::uint32_t kWidth = 512, kHeight = 384, kSeed = 77, kPoses = 32;

const GdalTerrain& truth() {
    static const GdalTerrain terrain(test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif");
    return terrain;
}
test_support::DefaultTerrain& database() {
    static test_support::DefaultTerrain terrain;
    return terrain;
}

PictureProof prove(double tau_px, bool conservative_up, std::uint32_t poses, int turned_px = 0) {
    HeadlessDisplay headless("egl", "desktop", kWidth, kHeight, &database().bytes,
                             test_support::garish_design(tau_px, conservative_up));
    PictureProof proof;
    for (std::uint32_t n = 0; n < poses; ++n)
        if (const HardPose pose(truth(), kSeed, n); test_support::has_skyline(pose.kind))
            proof.include(headless, truth(), pose, n, turned_px);
    return proof;
}

TEST(SkylineBound, HoldsInEveryPicture) {
    for (const double tau_px : {1.0, 4.0}) {
        const PictureProof proof = prove(tau_px, false, kPoses);
        EXPECT_EQ(proof.too_high, 0) << proof.text();
        EXPECT_EQ(proof.too_low, 0) << proof.text();
        EXPECT_EQ(proof.cracks, 0) << proof.text();
        EXPECT_EQ(proof.unsettled, 0) << proof.text();
        EXPECT_GE(proof.met, proof.pictures / 3) << proof.text();
        EXPECT_GT(proof.columns, 8000);
        std::printf("tau %g: %s\n", tau_px, proof.text().c_str());
    }
}

TEST(SkylineBound, OfALiftedSurfaceIsNeverBelowTheTrueOne) {
    const PictureProof lifted = prove(4, true, kPoses);
    EXPECT_EQ(lifted.below_true, 0) << lifted.text();
    EXPECT_EQ(lifted.too_high, 0) << lifted.text();
    EXPECT_EQ(lifted.cracks, 0) << lifted.text();
    EXPECT_GT(prove(4, false, 16).below_true, 20) << "control: without the lift it is";
}

TEST(SkylineBound, ASkylineMovedSidewaysIsFound) { EXPECT_GT(prove(1, false, 8, 6).too_low, 20); }

/// Straight down onto the middle, low and high, round about: nothing but ground can be in the picture.
int background_from_above(const std::string& backend, const std::string& device, base::ByteSource& bytes, double tau_px = 1) {
    HeadlessDisplay headless(backend, device, kWidth, kHeight, &bytes, test_support::garish_design(tau_px));
    int count = 0;
    for (int n = 0; n < 12; ++n) {
        const terrain::View view =
            test_support::view_from_above(truth(), 150 + 9 * n, 130 + 7 * n, 300 + 500 * n, 31 * n, -90 + 2 * n);
        const TerrainPicture picture(headless, test_support::resized(view, kWidth, kHeight), truth().middle());
        EXPECT_GT(picture.record().terrain.triangles, 100u);
        count += picture.background();
    }
    return count;
}

TEST(SkylineBound, NoBackgroundShowsThroughTheGround) {
    for (const char* device : {"desktop", "es2-small"})
        EXPECT_EQ(background_from_above("egl", device, database().bytes), 0) << device;
    EXPECT_EQ(background_from_above(test_support::headless_backends().back(), "es2-small", database().bytes), 0);
}

TEST(SkylineBound, AMissingTriangleIsSeen) {
    std::vector<std::uint8_t> image = database().image;
    test_support::remove_a_triangle_of_each_chunk(image);
    test_support::MemoryBytes bytes(image);
    EXPECT_GT(background_from_above("egl", "desktop", bytes, 4), 20);
    HeadlessDisplay headless("egl", "desktop", kWidth, kHeight, &bytes, test_support::garish_design());
    PictureProof proof;
    int enclosed = 0;
    for (std::uint32_t n = 0; n < 2 * kPoses; ++n)
        if (const HardPose pose(truth(), kSeed, n); pose.kind == PoseKind::random || pose.kind == PoseKind::along_the_horizon)
            enclosed += proof.include(headless, truth(), pose, n);
    EXPECT_GT(proof.cracks, 20);
    EXPECT_GT(enclosed, 20);
}

}  // namespace
}  // namespace tedavis::test_skyline_bound
