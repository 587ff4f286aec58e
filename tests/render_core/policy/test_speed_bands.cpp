// Oracle: every position that the flaps may have is looked at by itself, between its two neighbours among the settings.
#include "render_core/policy/speed_bands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/files/device_files.hpp"

namespace tedavis::policy::test_speed_bands {
namespace {

using design::AircraftSettings;
using design::FlapSetting;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kKnot = 1852.0 / 3600.0;
constexpr int kAircraft = 400;

AircraftSettings shipped(const std::string& name) {
    const std::string path = "configs/aircraft/" + name + ".toml";
    return design::load_aircraft(test_support::source_file(path), path).value();
}

/// Random aircraft as the reader accepts them.
class RandomAircraft {
public:
    explicit RandomAircraft(unsigned seed) : random_(seed) {}

    double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    AircraftSettings aircraft() {
        AircraftSettings made;
        made.name = "random";
        made.caution_factor = in(1.01, 1.3);
        const double stall_mps = in(15, 60);
        made.limit_mps = stall_mps * in(2.5, 5);
        made.has_vmo = in(0, 1) < 0.5;
        if (!made.has_vmo && in(0, 1) < 0.8) made.normal_limit_mps = in(1.4 * stall_mps, made.limit_mps);
        const int count = static_cast<int>(in(1, 8.99));
        FlapSetting setting{"0", 0, made.limit_mps, stall_mps};
        for (int n = 0; n < count; ++n) {
            EXPECT_TRUE(made.flaps.try_push_back(setting));
            setting.position = n + 2 == count ? 1 : (n + 1) / 8.0;
            setting.limit_mps = in(std::max(1.31 * stall_mps, 0.6 * setting.limit_mps), setting.limit_mps);
            setting.stall_mps = in(0.8, 1) * setting.stall_mps;
        }
        return made;
    }
    FlapsRange range() {
        const double a = in(0, 1), b = in(0, 1) < 0.3 ? a : in(0, 1);
        return {std::min(a, b), std::max(a, b)};
    }

private:
    std::mt19937 random_;
};

/// The limit and the stall speed, in level flight, by the rule's own words.
struct Limits {
    double limit_mps = 1e9, stall_mps = 0;
};
Limits limits_at(const AircraftSettings& aircraft, double position) {
    constexpr double kTolerance = 0.02;
    Limits found{0, 0};
    for (const FlapSetting& setting : aircraft.flaps)
        if (std::fabs(setting.position - position) <= kTolerance) return {setting.limit_mps, setting.stall_mps};
    const FlapSetting *below = nullptr, *above = nullptr;
    for (const FlapSetting& setting : aircraft.flaps) {
        if (setting.position < position) below = &setting;
        if (setting.position > position && above == nullptr) above = &setting;
    }
    if (below == nullptr || above == nullptr) below = above = below != nullptr ? below : above;
    found.limit_mps = std::min(below->limit_mps, above->limit_mps);
    found.stall_mps = std::max(below->stall_mps, above->stall_mps);
    return found;
}
Limits limits_of(const AircraftSettings& aircraft, const FlapsRange& flaps) {
    constexpr int kSteps = 1000;
    Limits strictest;
    for (int n = 0; n <= kSteps; ++n) {
        const double position = n == kSteps ? flaps.most : flaps.least + (flaps.most - flaps.least) * n / kSteps;
        const Limits here = limits_at(aircraft, position);
        strictest.limit_mps = std::min(strictest.limit_mps, here.limit_mps);
        strictest.stall_mps = std::max(strictest.stall_mps, here.stall_mps);
    }
    return strictest;
}

SpeedConditions with_flaps(const FlapsRange& flaps, double load_factor = 1) {
    SpeedConditions conditions;
    conditions.flaps = flaps;
    conditions.load_factor = load_factor;
    return conditions;
}

std::vector<SpeedBand> first_column(const SpeedBands& shown) {
    std::vector<SpeedBand> column;
    for (const SpeedBand& band : shown.bands)
        if (band.role != SpeedBandRole::flaps_range) column.push_back(band);
    return column;
}

/// The role at a speed; flaps_range where there is none.
SpeedBandRole role_at(const SpeedBands& shown, double speed_mps) {
    for (const SpeedBand& band : first_column(shown))
        if (speed_mps >= band.low_mps && speed_mps < band.high_mps) return band.role;
    return SpeedBandRole::flaps_range;
}

/// Empty where the column reaches from 0 to its end without gaps, overlaps and bands without extent, in the order of the roles.
std::string faults_of_column(const std::vector<SpeedBand>& column) {
    std::ostringstream faults;
    if (column.empty()) return "there is none";
    if (column.front().low_mps != 0) faults << "begins at " << column.front().low_mps << "; ";
    if (column.back().high_mps != kEndOfBands_mps) faults << "ends at " << column.back().high_mps << "; ";
    for (std::size_t n = 0; n < column.size(); ++n) {
        if (!(column[n].low_mps < column[n].high_mps)) faults << "band " << n << " is empty; ";
        if (n > 0 && column[n].low_mps != column[n - 1].high_mps) faults << "band " << n << " does not adjoin; ";
        if (n > 0 && column[n].role <= column[n - 1].role) faults << "band " << n << " is out of order; ";
    }
    return faults.str();
}

/// By the oracle's limits, in the order in which the rule states the roles.
SpeedBandRole expected_role(const AircraftSettings& aircraft, const Limits& limits, double load_factor, double speed_mps) {
    const double stall_mps = limits.stall_mps * std::sqrt(load_factor);
    if (speed_mps >= limits.limit_mps) return SpeedBandRole::above_limit;
    if (speed_mps < stall_mps) return SpeedBandRole::low_warning;
    if (speed_mps < stall_mps * aircraft.caution_factor) return SpeedBandRole::low_caution;
    const bool is_rough = aircraft.normal_limit_mps > 0 && speed_mps >= aircraft.normal_limit_mps;
    return is_rough ? SpeedBandRole::caution : SpeedBandRole::normal;
}

TEST(SpeedBands, OfTheLightPistonStandWhereItsFileSays) {
    const AircraftSettings piston = shipped("light_piston");
    const SpeedBands up = speed_bands(piston, with_flaps({0, 0}));
    const auto expect = [](const SpeedBand& band, double low_kt, double high_mps, SpeedBandRole role) {
        EXPECT_NEAR(band.low_mps, low_kt * kKnot, 1e-9);
        EXPECT_NEAR(band.high_mps, high_mps, 1e-9);
        EXPECT_EQ(band.role, role);
    };
    ASSERT_EQ(up.bands.size(), 6u);
    expect(up.bands[0], 0, 50 * kKnot, SpeedBandRole::low_warning);
    expect(up.bands[1], 50, 55 * kKnot, SpeedBandRole::low_caution);
    expect(up.bands[2], 55, 126 * kKnot, SpeedBandRole::normal);
    expect(up.bands[3], 126, 160 * kKnot, SpeedBandRole::caution);
    expect(up.bands[4], 160, kEndOfBands_mps, SpeedBandRole::above_limit);
    expect(up.bands[5], 44, 85 * kKnot, SpeedBandRole::flaps_range);
    EXPECT_FALSE(up.has_pole);
    EXPECT_EQ(up.flags.size(), piston.flags.size());

    const SpeedBands full = speed_bands(piston, with_flaps({1, 1}));
    ASSERT_EQ(full.bands.size(), 5u) << "Vno is above the flaps' limit";
    expect(full.bands[0], 0, 44 * kKnot, SpeedBandRole::low_warning);
    expect(full.bands[2], 48.4, 85 * kKnot, SpeedBandRole::normal);
    expect(full.bands[3], 85, kEndOfBands_mps, SpeedBandRole::above_limit);
    EXPECT_TRUE(speed_bands(shipped("turboprop"), with_flaps({0, 0})).has_pole);
}

TEST(SpeedBands, WithoutAnAircraftFileThereAreNone) {
    const SpeedBands shown = speed_bands({}, with_flaps({0, 0}));
    EXPECT_TRUE(shown.bands.empty());
    EXPECT_TRUE(shown.flags.empty());
}

TEST(SpeedBands, FlapsThatNobodyKnowsMayBeAnywhere) {
    const AircraftSettings piston = shipped("light_piston");
    const SpeedBands unknown = speed_bands(piston, {});
    EXPECT_EQ(role_at(unknown, 49.9 * kKnot), SpeedBandRole::low_warning) << "they may be up";
    EXPECT_EQ(role_at(unknown, 84.9 * kKnot), SpeedBandRole::normal);
    EXPECT_EQ(role_at(unknown, 85.1 * kKnot), SpeedBandRole::above_limit) << "they may be out";
    for (const FlapsRange no_range :
         {FlapsRange{kNaN, kNaN}, FlapsRange{0, kNaN}, FlapsRange{0.6, 0.4}, FlapsRange{-0.1, 0}, FlapsRange{0, 1.1}}) {
        const SpeedBands same = speed_bands(piston, with_flaps(no_range));
        ASSERT_EQ(same.bands.size(), unknown.bands.size());
        for (std::size_t n = 0; n < same.bands.size(); ++n) EXPECT_EQ(same.bands[n].high_mps, unknown.bands[n].high_mps);
    }
}

TEST(SpeedBands, BetweenTwoSettingsTheStricterOneHolds) {
    const AircraftSettings piston = shipped("light_piston");
    const SpeedBands moving = speed_bands(piston, with_flaps({0.15, 0.15}));
    EXPECT_EQ(role_at(moving, 49.9 * kKnot), SpeedBandRole::low_warning) << "the stall speed of the flaps at 0";
    EXPECT_EQ(role_at(moving, 110.1 * kKnot), SpeedBandRole::above_limit) << "the limit of 10";
    EXPECT_EQ(role_at(moving, 109.9 * kKnot), SpeedBandRole::normal);
    const SpeedBands noisy = speed_bands(piston, with_flaps({0.01, 0.01}));
    EXPECT_EQ(role_at(noisy, 159.9 * kKnot), SpeedBandRole::caution) << "a measured position is not exactly that of a setting";
}

TEST(SpeedBands, TheStallSpeedGrowsWithTheRootOfTheLoadFactor) {
    const AircraftSettings piston = shipped("light_piston");
    const auto stall_kt = [&piston](double load_factor) {
        return speed_bands(piston, with_flaps({0, 0}, load_factor)).bands[0].high_mps / kKnot;
    };
    EXPECT_NEAR(stall_kt(1), 50, 1e-9);
    EXPECT_NEAR(stall_kt(2), 70.710678, 1e-6) << "a level turn with a bank of 60 degrees";
    EXPECT_NEAR(stall_kt(4), 100, 1e-9);
    EXPECT_NEAR(stall_kt(9), 100, 1e-9) << "more counts as 4";
    for (const double less : {0.5, 0.0, -1.0, kNaN}) EXPECT_NEAR(stall_kt(less), 50, 1e-9) << less;
    const SpeedBands steep = speed_bands(piston, with_flaps({1, 1}, 4));
    EXPECT_EQ(role_at(steep, 84 * kKnot), SpeedBandRole::low_warning) << "the stall speed has reached the limit";
    EXPECT_EQ(role_at(steep, 86 * kKnot), SpeedBandRole::above_limit);
    EXPECT_EQ(faults_of_column(first_column(steep)), "");
}

TEST(SpeedBands, WhereAMachNumberIsTheLimitThereAreThoseOfLowSpeedsAlone) {
    const AircraftSettings jet = shipped("jet");
    SpeedConditions conditions = with_flaps({0, 0});
    conditions.pressure_altitude_m = 27'000 * 0.3048;
    EXPECT_EQ(speed_bands(jet, conditions).bands.size(), 5u);
    for (const double altitude_m : {27'001 * 0.3048, kNaN}) {
        conditions.pressure_altitude_m = altitude_m;
        const SpeedBands low = speed_bands(jet, conditions);
        ASSERT_EQ(low.bands.size(), 2u) << altitude_m;
        conditions.pressure_altitude_m = 0;
        const SpeedBands known = speed_bands(jet, conditions);
        for (std::size_t n = 0; n < low.bands.size(); ++n) {
            EXPECT_EQ(low.bands[n].role, n == 0 ? SpeedBandRole::low_warning : SpeedBandRole::low_caution);
            EXPECT_EQ(low.bands[n].high_mps, known.bands[n].high_mps) << "the stall speed is that of every altitude";
        }
        conditions.pressure_altitude_m = altitude_m;
        conditions.is_on_ground = true;
        EXPECT_TRUE(speed_bands(jet, conditions).bands.empty()) << altitude_m;
        conditions.is_on_ground = false;
        EXPECT_EQ(speed_bands(jet, conditions).flags.size(), jet.flags.size());
        EXPECT_FALSE(speed_bands(shipped("turboprop"), conditions).bands.empty()) << "a file without such an altitude";
    }
}

TEST(SpeedBands, OnTheGroundNoneTellsOfAStallAndTheOthersStay) {
    RandomAircraft random(36);
    for (int n = 0; n < 200; ++n) {
        const AircraftSettings aircraft = random.aircraft();
        SpeedConditions conditions = with_flaps(random.range());
        const SpeedBands in_air = speed_bands(aircraft, conditions);
        conditions.is_on_ground = true;
        const SpeedBands on_ground = speed_bands(aircraft, conditions);
        const auto is_of_stall = [](SpeedBandRole role) {
            return role == SpeedBandRole::low_warning || role == SpeedBandRole::low_caution;
        };
        std::size_t same = 0;
        for (const SpeedBand& band : in_air.bands) {
            if (is_of_stall(band.role)) continue;
            ASSERT_LT(same, on_ground.bands.size());
            EXPECT_EQ(on_ground.bands[same].low_mps, band.low_mps);
            EXPECT_EQ(on_ground.bands[same].high_mps, band.high_mps);
            EXPECT_EQ(on_ground.bands[same++].role, band.role);
        }
        EXPECT_EQ(on_ground.bands.size(), same);
    }
}

TEST(SpeedBands, OfAnyAircraftAdjoinAndHaveTheRoleOfTheirSpeeds) {
    RandomAircraft random(34);
    std::size_t looked_at = 0;
    for (int n = 0; n < kAircraft; ++n) {
        const AircraftSettings aircraft = random.aircraft();
        const FlapsRange flaps = random.range();
        const double load_factor = random.in(1, kMaxLoadFactor);
        const SpeedBands shown = speed_bands(aircraft, with_flaps(flaps, load_factor));
        EXPECT_EQ(faults_of_column(first_column(shown)), "") << n;
        EXPECT_EQ(shown.bands.refused(), 0u);
        const Limits limits = limits_of(aircraft, flaps);
        for (double speed_mps = 0.5; speed_mps < kEndOfBands_mps; speed_mps += 1.7, ++looked_at)
            EXPECT_EQ(role_at(shown, speed_mps), expected_role(aircraft, limits, load_factor, speed_mps))
                << n << ": " << speed_mps << " m/s, flaps " << flaps.least << " to " << flaps.most;
    }
    EXPECT_GT(looked_at, 90'000u);
}

/// Metamorphic: knowing less is never less strict.
TEST(SpeedBands, AWiderRangeNeverRaisesALimitNorLowersAStallSpeed) {
    RandomAircraft random(35);
    int stricter = 0;
    for (int n = 0; n < kAircraft; ++n) {
        const AircraftSettings aircraft = random.aircraft();
        const FlapsRange narrow = random.range();
        const FlapsRange wide{random.in(0, narrow.least), random.in(narrow.most, 1)};
        const std::vector<SpeedBand> known = first_column(speed_bands(aircraft, with_flaps(narrow))),
                                     unsure = first_column(speed_bands(aircraft, with_flaps(wide)));
        EXPECT_LE(unsure.back().low_mps, known.back().low_mps) << n;
        EXPECT_GE(unsure.front().high_mps, known.front().high_mps) << n;
        stricter += unsure.back().low_mps < known.back().low_mps || unsure.front().high_mps > known.front().high_mps ? 1 : 0;
    }
    EXPECT_GT(stricter, kAircraft / 4) << "a control: ranges make a difference";
}

TEST(SpeedBands, AFaultyColumnIsFound) {
    std::vector<SpeedBand> column = first_column(speed_bands(shipped("light_piston"), with_flaps({0, 0})));
    ASSERT_EQ(faults_of_column(column), "");
    std::vector<SpeedBand> gap = column, overlap = column, missing = column, turned = column;
    gap[2].low_mps += 1e-9;
    overlap[2].high_mps += 1;
    missing.pop_back();
    std::swap(turned[1].role, turned[2].role);
    for (const auto& faulty : {gap, overlap, missing, turned}) EXPECT_NE(faults_of_column(faulty), "");
}

}  // namespace
}  // namespace tedavis::policy::test_speed_bands
