// `terrain check` passes on each of three whole terrains and finds one height that is a metre off. Run by command, see
// CONTRIBUTING.md.
#include <gtest/gtest.h>

#include "tests/poses/grounds.hpp"
#include "tests/support/terrain/terrain_forgery.hpp"

namespace tedavis::test_terrain_forgery {
namespace {

class TerrainForgeryOf : public ::testing::TestWithParam<Ground> {};

TEST_P(TerrainForgeryOf, AMetreIsFound) { test_support::expect_check_finds_a_metre(GetParam().file); }

INSTANTIATE_TEST_SUITE_P(Terrains, TerrainForgeryOf, ::testing::ValuesIn(grounds()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tedavis::test_terrain_forgery
