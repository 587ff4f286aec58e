#include "host_sim/terrain_builder/coarse_proof.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_coarse_proof {
namespace {

CoarseErrors errors_of(std::uint32_t i, double above, double below) {
    return {{6, i, 0}, {{above, below}, {2 * above, 0.5}, 3 * above}};
}

TEST(CoarseProof, GathersTheLargestInAnyOrder) {
    const test_support::TemporaryFolder folder;
    CoarseProof a(folder.file("a")), b(folder.file("b"));
    const std::vector<CoarseErrors> one = {errors_of(0, 1, 9), errors_of(1, 5, 5)}, two = {errors_of(0, 4, 2)};
    a.include(one);
    a.include(two);
    b.include(two);
    b.include(one);
    b.include(two);
    for (const CoarseProof* proof : {&a, &b}) {
        ASSERT_EQ(proof->all().size(), 2u);
        const ChunkErrors& errors = proof->all().at({6, 0, 0});
        EXPECT_EQ(errors.own.above_m, 4);
        EXPECT_EQ(errors.own.below_m, 9);
        EXPECT_EQ(errors.strips.above_m, 8);
        EXPECT_EQ(errors.shift_m, 12);
    }
}

TEST(CoarseProof, IsThereAgainFromItsFile) {
    const test_support::TemporaryFolder folder;
    {
        CoarseProof proof(folder.file("p"));
        EXPECT_TRUE(proof.all().empty());
        proof.include({errors_of(3, 1.25, 2.5)});
        proof.save();
    }
    const CoarseProof again(folder.file("p"));
    EXPECT_EQ(again.all().at({6, 3, 0}).own.below_m, 2.5);
    EXPECT_EQ(again.all().at({6, 3, 0}).shift_m, 3.75);
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(CoarseProof, ADamagedFileIsNotBelieved) {
    const test_support::TemporaryFolder folder;
    CoarseProof proof(folder.file("p"));
    proof.include({errors_of(3, 1, 2)});
    proof.save();
    std::string bytes = folder.read("p");
    bytes[20] = static_cast<char>(bytes[20] ^ 1);
    folder.write("p", bytes);
    EXPECT_TRUE(CoarseProof(folder.file("p")).all().empty());
    folder.write("p", "x");
    EXPECT_TRUE(CoarseProof(folder.file("p")).all().empty());
}

}  // namespace
}  // namespace tedavis::host_sim::test_coarse_proof
