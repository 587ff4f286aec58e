// The pixel error that a frame states is never exceeded, measured on drawn triangles against the raster, over random poses and
// ones that are made to hurt. tests/poses flies many more, and over other terrains.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/support/files/paths.hpp"
#include "tests/support/terrain/pose_proof.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::test_pixel_guarantee {
namespace {

using test_support::GdalTerrain;
using test_support::MemoryTerrain;
using test_support::PoseProof;
using test_support::PoseProver;

constexpr std::uint32_t kPoses = 3000, kControlPoses = 32;
constexpr unsigned kThreads = 2;

struct DefaultGround {
    std::string file = test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif";
    GdalTerrain truth{file};
    MemoryTerrain drawn{test_support::build_image_of_file(file)};
};

TEST(PixelGuarantee, HoldsOverTheDefaultTerrainForEveryTau) {
    DefaultGround ground;
    const PoseProof proof = PoseProver(ground.drawn, ground.truth).prove(kPoses, 1, kThreads);
    EXPECT_EQ(proof.excesses, 0u) << proof.first_excess.text();
    EXPECT_EQ(proof.contradictions, 0u) << "what a frame says of tau and what it states must agree";
    EXPECT_LE(proof.worst_mesh_excess_m, 1e-4) << "a mesh is farther from the true surface than its chunk states";
    EXPECT_LE(proof.deepest_lifted_m, 1e-3) << "a lifted surface is below the true one";
    EXPECT_EQ(proof.frames, kPoses * PoseProver::kTaus_px.size());
    EXPECT_GE(proof.met, proof.frames / 4);
    for (const char* reason : {"met", "chunks", "milliseconds", "at_data_limit"})
        EXPECT_TRUE(proof.reasons.count(reason) == 1) << "no frame stopped at " << reason;
    EXPECT_GT(PoseProof::ratio_to_tau(proof.closest_to_tau), 0.3) << "the worst places were not found";
    std::printf("worst found: %s\n", proof.closest_to_tau.text().c_str());
    RecordProperty("closest_to_tau", proof.closest_to_tau.text());
    RecordProperty("closest_to_stated", proof.closest_to_stated.text());
}

TEST(PixelGuarantee, ALieAboutTheErrorIsFound) {
    DefaultGround ground;
    EXPECT_GT(PoseProver(ground.drawn, ground.truth).prove(kControlPoses, 5, kThreads, 0.2).excesses, 0u);
}

}  // namespace
}  // namespace tedavis::test_pixel_guarantee
