#include "host_sim/terrain_builder/build_stages.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/files/image_file.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"
#include "tests/support/terrain/terrain_image.hpp"

namespace tedavis::host_sim::test_build_stages {
namespace {

std::vector<std::string> names_of(const std::vector<BuildStage>& stages) {
    std::vector<std::string> names;
    for (const BuildStage& stage : stages)
        if (names.empty() || names.back() != stage.name) names.emplace_back(stage.name);
    return names;
}

TEST(BuildStages, ComeInTheirOrder) {
    const test_support::TemporaryFolder folder;
    const Raster small = test_support::make_rough_raster(80, 70), wide = test_support::make_rough_raster(1100, 40);
    const TerrainSources one(test_support::posts_of(small)), units(test_support::posts_of(wide));
    BuildParts parts(one, folder.file("a"), {});
    const std::vector<std::string> expected = {"posts",  "pyramid",    "voids",     "slopes",      "borders",
                                               "chunks", "attributes", "directory", "verification"};
    EXPECT_EQ(names_of(build_stages(parts)), expected);
    BuildParts more(units, folder.file("b"), {});
    std::vector<std::string> with_proof = expected;
    with_proof.insert(with_proof.begin() + 6, "proof");
    EXPECT_EQ(names_of(build_stages(more)), with_proof) << "chunks above the units have a proof of their own";
}

TEST(BuildStages, AnImageAddsAStageForEveryLevelOfItsPages) {
    const test_support::TemporaryFolder folder;
    const Raster raster = test_support::make_rough_raster(150, 110);
    TerrainSources sources(test_support::posts_of(raster));
    test_support::ImageFile image;
    image.transform = {9.6, 0.5 / 1200, 0, 47.1, 0, -0.5 / 1200};
    sources.drape = DrapeOptions{image.write(folder.file("i.tif")), {}, {}};
    BuildParts parts(sources, folder.file("a"), {});
    const std::vector<BuildStage> stages = build_stages(parts);
    const std::vector<std::string> names = names_of(stages);
    const auto attributes = std::find(names.begin(), names.end(), "attributes");
    ASSERT_NE(attributes, names.end());
    EXPECT_EQ(*(attributes + 1), "drape");
    std::vector<std::uint32_t> tasks;
    for (const BuildStage& stage : stages)
        if (stage.name == "drape") tasks.push_back(stage.count());
    EXPECT_EQ(tasks, (std::vector<std::uint32_t>{3 * 2, 2 * 1, 1})) << "levels 1 to 3";
}

TEST(BuildStages, InsetsAddTheirs) {
    const test_support::TemporaryFolder folder;
    const Raster ground = test_support::make_rough_raster(150, 110);
    const Raster inset = test_support::make_raster(
        40, 40, [](auto, auto) { return 5.0f; }, 9.62, 47.07, 1.0 / 4800);
    const TerrainSources sources(test_support::posts_of(ground), {test_support::posts_of(inset)});
    BuildParts parts(sources, folder.file("a"), {});
    const std::vector<std::string> names = names_of(build_stages(parts));
    EXPECT_EQ(names, (std::vector<std::string>{"posts", "insets", "pyramid", "voids", "slopes", "borders", "chunks", "insets",
                                               "attributes", "insets", "directory", "verification"}));
}

TEST(BuildStages, VoidsAreFilledOnlyWhereThereAreAny) {
    const test_support::TemporaryFolder folder;
    const Raster raster = test_support::make_rough_raster(80, 70);
    const TerrainSources sources(test_support::posts_of(raster));
    BuildParts parts(sources, folder.file("a"), {});
    for (const bool has_voids : {false, true}) {
        parts.record.statistics.void_posts = has_voids ? 3 : 0;
        for (const BuildStage& stage : build_stages(parts))
            EXPECT_TRUE(stage.name != "voids" || (stage.count() > 0) == has_voids);
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_build_stages
