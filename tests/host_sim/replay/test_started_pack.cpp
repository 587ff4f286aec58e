#include "host_sim/replay/started_pack.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_started_pack {
namespace {

TEST(StartedPack, NothingIsSaidWithoutOne) { EXPECT_EQ(words_of_started({}, {1'800'000'000'000'000'000}), ""); }

TEST(StartedPack, OneThatIsGoneIsRefused) {
    platform::CheckedPack pack;
    pack.folder = "/nowhere/pack/";
    test_support::expect_user_error([&] { static_cast<void>(words_of_started(pack, {0})); }, "/nowhere/pack/");
}

}  // namespace
}  // namespace tedavis::host_sim::test_started_pack
