#include "host_sim/options/asked_parameters.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_asked_parameters {
namespace {

TEST(AskedParameters, AreThoseOfTheOptions) {
    PictureOptions options;
    options.tau_px = 2.5;
    options.weights = {{"terrain", 0.5}};
    options.foci = {"radius_m = 700"};
    const platform::DesignParameters asked = asked_parameters(options);
    EXPECT_EQ(asked.tau_px, 2.5);
    EXPECT_EQ(asked.weights[0].aspect.view(), "terrain");
    EXPECT_EQ(asked.weights[0].weight, 0.5);
    EXPECT_EQ(asked.foci[0].view(), "radius_m = 700");
}

TEST(AskedParameters, MoreThanADisplayHasRoomForIsRefused) {
    const auto refused = [](const PictureOptions& options, const char* words) {
        test_support::expect_user_error([&] { static_cast<void>(asked_parameters(options)); }, words);
    };
    PictureOptions options;
    options.foci = std::vector<std::string>(5, "radius_m = 700");
    refused(options, "has room for 4");
    options.foci = {std::string(1001, 'x')};
    refused(options, "a thousand bytes");
    options.foci.clear();
    for (const char* name : {"a", "b", "c", "d", "e", "f", "g", "h", "i"}) options.weights[name] = 1;
    refused(options, "no aspect");
}

}  // namespace
}  // namespace tedavis::host_sim::test_asked_parameters
