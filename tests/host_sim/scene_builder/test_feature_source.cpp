#include "host_sim/scene_builder/feature_source.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_feature_source {
namespace {

TEST(FeatureSource, IsReadByItsKind) {
    const test_support::TemporaryFolder folder;
    LayerRecipe recipe;
    recipe.name = "things";
    recipe.source = "x.csv";
    const std::string table = folder.write("x.csv", "lon,lat,kind\n9.8,46.8,mast\n");
    const FeatureSource masts = read_feature_source(SourceKind::vector, recipe, table);
    EXPECT_EQ(masts.features.features.size(), 1u);
    EXPECT_EQ(masts.features.file, table);
    EXPECT_TRUE(masts.usual_attributes.empty());
    const std::string zones = folder.write("z.txt",
                                           "AC R\nAN A\nAL GND\nAH 3000ft MSL\nDP 46:00:00N 009:00:00E\nDP 46:10:00N 009:00:00E\n"
                                           "DP 46:10:00N 009:10:00E\n");
    EXPECT_FALSE(read_feature_source(SourceKind::openair, recipe, zones).usual_attributes.empty());
    recipe.aircraft = "HB1";
    test_support::expect_user_error([&] { (void)read_feature_source(SourceKind::vector, recipe, table); },
                                    "'aircraft' chooses one of a file of flights, and x.csv is none");
}

}  // namespace
}  // namespace tedavis::host_sim::test_feature_source
