#include "host_sim/replay/generated_flight.hpp"

#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::host_sim::test_generated_flight {
namespace {

TEST(GeneratedFlight, HasAManifestBesideIt) {
    const test_support::TemporaryFolder folder;
    const std::string log = folder.write("flight.log", "");
    EXPECT_FALSE(is_generated_flight(log));
    EXPECT_FALSE(is_generated_flight("flight.log"));
    folder.write("scenario.json", "{}");
    EXPECT_TRUE(is_generated_flight(log));
}

}  // namespace
}  // namespace tedavis::host_sim::test_generated_flight
