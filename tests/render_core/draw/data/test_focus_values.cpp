#include "render_core/draw/data/focus_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/foci_of_test.hpp"

namespace tedavis::draw::test_focus_values {
namespace {

using test_support::FociOfTest;
using test_support::LoadedScene;

constexpr int kColumns = 40, kRows = 30, kLevels = 2, kTimes = 2;
constexpr std::int64_t kMinute_ns = 60'000'000'000;

/// Values from 0 to 100 at random; some missing.
host_sim::LayerDraft air() {
    host_sim::LayerDraft layer;
    layer.name = "air";
    layer.shape = scene::LayerShape::grid;
    layer.grid = {
        base::radians(9.4), base::radians(47.1), base::radians(0.02), base::radians(0.02), kColumns, kRows, kLevels, kTimes};
    layer.levels_m = {1000, 3000};
    layer.times_ns = {0, 10 * kMinute_ns};
    host_sim::AttributeDraft attribute;
    attribute.name = "gust";
    std::mt19937 random(4);
    std::uniform_real_distribution<float> value(0, 100);
    for (int n = 0; n < kColumns * kRows * kLevels * kTimes; ++n)
        attribute.values.push_back(n % 17 == 0 ? std::nanf("") : value(random));
    layer.attributes.push_back(attribute);
    return layer;
}

struct Found {
    explicit Found(const std::string& line, std::int64_t minute = 0, bool has_date = true)
        : scene(air()), foci({line}, &scene.scene(), {base::Time{minute * kMinute_ns + 5'000'000'000}, has_date, true}) {}

    /// At the minute, by the values themselves.
    double value(std::size_t n, double part) const {
        const auto& values = scene.attribute().values;
        const std::size_t all = kColumns * kRows * kLevels;
        return static_cast<double>(values[n]) * (1 - part) + static_cast<double>(values[n + all]) * part;
    }
    LoadedScene scene;
    FociOfTest foci;
};

TEST(FocusValues, AnExtremeIsThatOfAllThatHoldNow) {
    for (const std::int64_t minute : {0, 3, 7}) {
        const Found found(R"(shape = "data", layer = "air", attribute = "gust", extreme = "highest", within = 2)", minute);
        double highest = -1;
        for (std::size_t n = 0; n < kColumns * kRows * kLevels; ++n)
            if (const double value = found.value(n, static_cast<double>(minute) / 10); value > highest) highest = value;
        EXPECT_NEAR(found.foci.frame().ranges[0].high, highest, 1e-4) << minute;
        EXPECT_NEAR(found.foci.frame().ranges[0].low, highest - 2, 1e-4);
    }
    const Found lowest(R"(shape = "data", layer = "air", attribute = "gust", extreme = "lowest")");
    EXPECT_LT(lowest.foci.frame().ranges[0].low, 1);
    EXPECT_EQ(lowest.foci.frame().ranges[0].low, lowest.foci.frame().ranges[0].high);
}

/// Every place with such a value lies in the region, and few of the places that have none where they are few.
TEST(FocusValues, TheRegionHoldsEveryPlaceOfTheData) {
    for (const char* interval : {"[99.5, 100]", "[97, 100]", "[0, 100]"}) {
        const Found found(std::string(R"(shape = "data", layer = "air", attribute = "gust", radius_m = 100, interval = )") +
                          interval);
        const scene::FocusRegion& region = found.foci.region();
        ASSERT_TRUE(region.is_valid);
        EXPECT_LE(region.point_count, scene::kMaxFocusPoints);
        const LayerValues values(found.scene.layer(), "gust", 0);
        int in = 0, beside = 0;
        for (std::size_t n = 0; n < values.size(); ++n) {
            const LayerValues::Place at = values.post(n);
            const glm::dvec2 ground = scene::in_focus_plane(region, earth::to_ecef({at.latitude_rad, at.longitude_rad, {0}}));
            const bool is_within = scene::focus_distance_m(region, ground) <= 0;
            const bool is_meant = values[n] >= found.foci.foci[0].data.low && values[n] <= 100;
            EXPECT_TRUE(is_within || !is_meant) << interval << " " << n;
            in += is_meant ? 1 : 0;
            beside += is_within && !is_meant ? 1 : 0;
        }
        EXPECT_GT(in, 0) << interval;
        const bool is_few = interval[1] == '9' && interval[3] == '.';
        EXPECT_TRUE(!is_few || beside < 500) << beside << ", a control: it does not hold everything";
    }
}

TEST(FocusValues, WhatIsNotThereIsSaid) {
    EXPECT_EQ(Found(R"(shape = "data", layer = "air", attribute = "hail", value = 1)").foci.plan.states[0],
              FocusState::no_such_data);
    const Found none(R"(shape = "data", layer = "air", attribute = "gust", interval = [200, 300])");
    EXPECT_EQ(none.foci.plan.states[0], FocusState::no_such_value);
    EXPECT_FALSE(none.foci.region().is_valid);
    FociOfTest no_scene({R"(shape = "data", role = "field", attribute = "gust", value = 1)"});
    EXPECT_EQ(no_scene.plan.states[0], FocusState::no_such_data);
    host_sim::LayerDraft old = air();
    old.valid_until_ns = 0;
    const LoadedScene scene(old);
    const flight::FlightTime later{base::Time{kMinute_ns}, true, true};
    FociOfTest too_old({R"(shape = "data", layer = "air", attribute = "gust", extreme = "highest")"}, &scene.scene(), later);
    EXPECT_EQ(too_old.plan.states[0], FocusState::no_such_data);
}

TEST(FocusValues, AFocusOfSpaceHasTheIntervalOfItsValues) {
    const Found found(R"(at = "position", position_deg = [46.8, 9.8], radius_m = 9000)");
    const LayerValues values(found.scene.layer(), "gust", 0);
    const DerivedInterval interval = values_in(found.foci.region(), values, found.scene.layer());
    double low = 1e9, high = -1e9;
    std::uint32_t count = 0;
    for (std::size_t n = 0; n < values.size(); ++n) {
        const LayerValues::Place at = values.post(n);
        const double away =
            earth::surface_distance_m({at.latitude_rad, at.longitude_rad, {0}}, {base::radians(46.8), base::radians(9.8), {0}});
        if (away > 9000 || std::isnan(values[n])) continue;
        low = std::min(low, values[n]), high = std::max(high, values[n]);
        ++count;
    }
    EXPECT_EQ(interval.count, count);
    EXPECT_EQ(interval.low, low);
    EXPECT_EQ(interval.high, high);
    EXPECT_GT(count, 50u);
}

}  // namespace
}  // namespace tedavis::draw::test_focus_values
