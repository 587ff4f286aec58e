// `terrain check` passes on the default terrain and finds one height that is a metre off. tests/poses does so for whole real
// ones.
#include <gtest/gtest.h>

#include "tests/support/files/paths.hpp"
#include "tests/support/terrain/terrain_forgery.hpp"

namespace tedavis::test_terrain_forgery {
namespace {

TEST(TerrainForgery, OfAMetreIsFoundInTheDefaultTerrain) {
    test_support::expect_check_finds_a_metre(test_support::source_dir() + "/configs/data/jacksboro_srtm3.tif");
}

}  // namespace
}  // namespace tedavis::test_terrain_forgery
