#include "host_sim/commands/option_texts.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_option_texts {
namespace {

using test_support::expect_user_error;

TEST(OptionTexts, SizesAreTwoEdges) {
    const PictureSize size = size_from("1024x768");
    EXPECT_EQ(size.width, 1024u);
    EXPECT_EQ(size.height, 768u);
    for (const char* text : {"1024", "15x100", "100x16385", "10.5x100", "axb", "", "1x2x3"})
        expect_user_error([&] { static_cast<void>(size_from(text)); }, "WIDTHxHEIGHT");
}

TEST(OptionTexts, PosesAreSixNumbers) {
    const AircraftPose pose = pose_from("46.98,-10.02,3500,90,-5,0.5");
    EXPECT_EQ(pose.latitude_deg, 46.98);
    EXPECT_EQ(pose.longitude_deg, -10.02);
    EXPECT_EQ(pose.altitude_msl_m, 3500);
    EXPECT_EQ(pose.heading_deg, 90);
    EXPECT_EQ(pose.pitch_deg, -5);
    EXPECT_EQ(pose.roll_deg, 0.5);
    for (const char* text : {"46,10,3500,90,0", "91,0,0,0,0,0", "0,0,0,0,0,nan", "north"})
        expect_user_error([&] { static_cast<void>(pose_from(text)); }, "degrees");
}

TEST(OptionTexts, PlacesMayHaveAnAltitude) {
    const SweptPlace ground = place_from("36.6,-84.25"), high = place_from("36.6,-84.25,450");
    EXPECT_EQ(ground.latitude_deg, 36.6);
    EXPECT_EQ(ground.longitude_deg, -84.25);
    EXPECT_FALSE(ground.altitude_msl_m.has_value());
    EXPECT_EQ(high.altitude_msl_m, 450);
    for (const char* text : {"36.6", "91,0", "1,2,3,4", "0,0,200000", "Davos"})
        expect_user_error([&] { static_cast<void>(place_from(text)); }, "--around");
}

TEST(OptionTexts, MetresAreAList) {
    EXPECT_EQ(metres_from("--heights", "-50,1500.5", -100, 2000), (std::vector<double>{-50, 1500.5}));
    for (const char* text : {"", "-101", "5,2001", "5,,6", "far", "1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1"})
        expect_user_error([&] { static_cast<void>(metres_from("--heights", text, -100, 2000)); }, "--heights");
}

TEST(OptionTexts, EdgesAreABlurAndTwoThresholds) {
    const perception::CannySettings canny = canny_from("0.5,6,15");
    EXPECT_EQ(canny.sigma, 0.5);
    EXPECT_EQ(canny.low, 6);
    EXPECT_EQ(canny.high, 15);
    for (const char* text : {"1,6", "4,6,15", "1,16,15", "1,-1,15", "1,6,15,2", "edges"})
        expect_user_error([&] { static_cast<void>(canny_from(text)); }, text);
}

TEST(OptionTexts, PhasesHaveNames) {
    EXPECT_EQ(phase_from("takeoff.first_climb"), "takeoff.first_climb");
    expect_user_error([] { static_cast<void>(phase_from("lunch")); }, "lunch");
}

TEST(OptionTexts, InstantsAreUtc) {
    EXPECT_EQ(time_from("1970-01-01T00:01:00Z").ns, 60'000'000'000);
    for (const char* text : {"2026-06-01", "2026-06-01T14:00:00", "noon"})
        expect_user_error([&] { static_cast<void>(time_from(text)); }, text);
}

TEST(OptionTexts, ReadSearchesWithTheirNumbers) {
    using raytrace::SearchKind;
    EXPECT_EQ(search_from("exact"), raytrace::SearchSettings());
    EXPECT_EQ(search_from("cells"), raytrace::usual_search(SearchKind::cells));
    EXPECT_EQ(search_from("ray:64"), (raytrace::SearchSettings{SearchKind::ray, 64, 12}));
    EXPECT_EQ(search_from("cones:300:0"), (raytrace::SearchSettings{SearchKind::cones, 300, 0}));
    for (const char* const text : {"", "Ray", "rays:4", "ray:", "ray:0", "ray:1.5", "ray:-4", "ray:65537", "ray:64:25",
                                   "ray:64:12:1", "exact:4", "cells:many", ":64"})
        expect_user_error([&] { static_cast<void>(search_from(text)); },
                          std::string("--search ") + text + ": not exact, cells, ray or cones");
}

}  // namespace
}  // namespace tedavis::host_sim::test_option_texts
