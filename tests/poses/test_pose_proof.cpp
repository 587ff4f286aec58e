// Ten thousand poses with tau 0.5, 1, 2 and 4 over each of three terrains: no drawn point is farther from its true place on the
// screen than the frame states. Run by command, see CONTRIBUTING.md.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "tests/poses/grounds.hpp"
#include "tests/support/terrain/pose_proof.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::test_pose_proof {
namespace {

using test_support::GdalTerrain;
using test_support::MemoryTerrain;
using test_support::PoseProof;
using test_support::PoseProver;

constexpr std::uint32_t kPoses = 10'000, kSpeakEvery = 500;

class PoseProofOf : public ::testing::TestWithParam<Ground> {};

TEST_P(PoseProofOf, NoDrawnPointIsFartherOffThanStated) {
    const auto begin = std::chrono::steady_clock::now();
    const auto minutes = [begin] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / 60; };
    const GdalTerrain truth(GetParam().file);
    MemoryTerrain drawn(test_support::build_image_of_file(GetParam().file));
    PoseProver prover(drawn, truth);
    const PoseProof proof =
        prover.prove(kPoses, 2026, std::max(2u, std::thread::hardware_concurrency()), 1, [&](std::uint32_t done) {
            if (done % kSpeakEvery == 0)
                std::fprintf(stderr, "%s: %u of %u poses, %.1f min\n", GetParam().name, done, kPoses, minutes());
        });
    EXPECT_EQ(proof.excesses, 0u) << proof.first_excess.text();
    EXPECT_EQ(proof.contradictions, 0u);
    EXPECT_LE(proof.worst_mesh_excess_m, 1e-4);
    EXPECT_LE(proof.deepest_lifted_m, 1e-3);
    EXPECT_EQ(proof.frames, kPoses * PoseProver::kTaus_px.size());
    std::printf("%s: %llu frames, %llu points, %.1f min\n", GetParam().name, static_cast<unsigned long long>(proof.frames),
                static_cast<unsigned long long>(proof.points), minutes());
    for (const auto& [reason, count] : proof.reasons)
        std::printf("  %s: %llu\n", reason.c_str(), static_cast<unsigned long long>(count));
    std::printf("  nearest to tau:    %s\n  nearest to stated: %s\n  mesh over stated: %.3g m, lifted below: %.3g m\n",
                proof.closest_to_tau.text().c_str(), proof.closest_to_stated.text().c_str(), proof.worst_mesh_excess_m,
                proof.deepest_lifted_m);
    RecordProperty("closest_to_tau", proof.closest_to_tau.text());
}

INSTANTIATE_TEST_SUITE_P(Terrains, PoseProofOf, ::testing::ValuesIn(grounds()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tedavis::test_pose_proof
