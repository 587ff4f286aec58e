#include "host_sim/replay/terrain_span.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/terrain/built_database.hpp"
#include "tests/support/terrain/synthetic_raster.hpp"

namespace tedavis::host_sim::test_terrain_span {
namespace {

using test_support::expect_user_error;

const base::Time kFirst{1'700'000'000'000'000'000};

/// Two degrees a side from 10 W to 8 W and 50 N to 48 N; `west_deg` moves it.
terrain::Lattice lattice(double west_deg = -10) {
    terrain::FileHeader header{};
    header.columns = header.rows = 201;
    header.west_deg = west_deg;
    header.north_deg = 50;
    header.step_lon_deg = header.step_lat_deg = 0.01;
    header.levels = 1;
    return terrain::Lattice(header);
}

/// A place each second along these longitudes, at 49 N.
std::vector<OutlinePlace> along(const std::vector<double>& longitudes_deg) {
    std::vector<OutlinePlace> places;
    for (std::size_t n = 0; n < longitudes_deg.size(); ++n)
        places.push_back({kFirst + base::Duration::seconds(static_cast<std::int64_t>(n)), base::radians(49),
                          base::radians(longitudes_deg[n])});
    return places;
}

std::vector<std::pair<double, double>> seconds_of(const TimeRanges& spans) {
    std::vector<std::pair<double, double>> seconds;
    for (const TimeRange& span : spans) seconds.emplace_back((span.from - kFirst).to_seconds(), (span.to - kFirst).to_seconds());
    return seconds;
}

using Spans = std::vector<std::pair<double, double>>;

TEST(TerrainSpan, AreThePlacesInARowThatLieInside) {
    EXPECT_EQ(seconds_of(spans_over(along({-11, -10.1, -9.9, -9, -8.1, -7.9, -7}), lattice())), (Spans{{2, 4}}));
    EXPECT_EQ(seconds_of(spans_over(along({-9, -11, -9, -9, -7}), lattice())), (Spans{{0, 0}, {2, 3}}));
    EXPECT_EQ(seconds_of(spans_over(along({-11, -7}), lattice())), Spans());
    EXPECT_EQ(seconds_of(spans_over({}, lattice())), Spans());
}

TEST(TerrainSpan, AcrossTheAntimeridianPlacesHaveTwoNames) {
    EXPECT_EQ(seconds_of(spans_over(along({178, 179.5, -179.5, -178}), lattice(179))), (Spans{{1, 2}}));
}

struct OverTerrain : ::testing::Test {
    static const test_support::FlownFiles& files() {
        static const test_support::FlownFiles kFiles;
        return kFiles;
    }
    ReplayOptions options = files().options("unused");
    DisplaySession session{options.picture, false};
    const terrain::TerrainDatabase* database = session.display().planner().terrain_database();

    /// A flight at 47 N, a place a second; the terrain covers 9.6 .. 9.76 E.
    static FlightOutline flown(const std::vector<double>& longitudes_deg) {
        std::vector<OutlinePlace> places = along(longitudes_deg);
        for (OutlinePlace& place : places) place.latitude_rad = base::radians(47);
        return {1, places, {}};
    }
};

TEST_F(OverTerrain, AreAllTimesThatTheFlightIsOverIt) {
    const FlightOutline flight = flown({9.5, 9.61, 9.7, 9.8, 9.7, 9.8, 9.75, 9.75, 9.8});
    EXPECT_EQ(seconds_of(terrain_spans(options, flight, kFirst, database)), (Spans{{1, 2}, {4, 4}, {6, 7}}));
}

TEST_F(OverTerrain, VoidsAtItsEndsAreNotOverIt) {
    // Known from column 60 to 140 of 193: 9.65 .. 9.7167 E.
    const test_support::BuiltDatabase partly(test_support::make_raster(
        193, 193, [](std::uint32_t i, std::uint32_t) { return i >= 60 && i <= 140 ? 500.0f : std::nanf(""); }));
    const FlightOutline across = flown({9.61, 9.64, 9.66, 9.7, 9.71, 9.73, 9.75});
    EXPECT_EQ(seconds_of(terrain_spans(options, across, kFirst, &partly.database)), (Spans{{2, 4}}));
    const FlightOutline beside = flown({9.61, 9.62, 9.74, 9.75});
    expect_user_error([&] { (void)terrain_spans(options, beside, kFirst, &partly.database); },
                      "the flight is over it only where it has no heights: it covers 46.940");
}

TEST_F(OverTerrain, StaysWithinWhatIsAskedFor) {
    options.from_s = 2;
    options.to_s = 4.5;
    const FlightOutline flight = flown({9.5, 9.61, 9.7, 9.8, 9.7, 9.75, 9.8});
    EXPECT_EQ(seconds_of(terrain_spans(options, flight, kFirst, database)), (Spans{{2, 2}, {4, 4}}));
}

TEST_F(OverTerrain, FixesThatComeNearItAreNotRefused) {
    const auto refused = [&](const std::vector<double>& longitudes_deg) {
        std::vector<OutlinePlace> fixes = along(longitudes_deg);
        for (OutlinePlace& fix : fixes) fix.latitude_rad = base::radians(47);
        try {
            require_near_terrain(fixes, "a.tdb", *database);
            return std::string();
        } catch (const UserError& error) {
            return std::string(error.what());
        }
    };
    EXPECT_EQ(refused({9.0, 9.7, 10.4}), "");
    EXPECT_EQ(refused({9.7}), "") << "a single fix";
    EXPECT_EQ(refused({9.0, 10.4}), "") << "it may lie between two fixes";
    EXPECT_EQ(refused({9.0, 9.4}), "") << "a curve may lead beyond its fixes";
    EXPECT_NE(refused({9.0, 9.1, 9.2, 9.1}).find("a.tdb: the flight is never over it: it covers 46.940"), std::string::npos);
    EXPECT_NE(refused({8.9}).find("the flight 47.000 .. 47.000 N, 8.900 .. 8.900 E"), std::string::npos);
}

TEST(TerrainSpan, IsSaidInWords) {
    const auto at = [](double s) { return kFirst + base::Duration::from_seconds(s); };
    const TimeRange span{at(1.25), at(3)}, later{at(70), at(80.5)};
    EXPECT_EQ(words_of_spans({span, later}, kFirst, "a.tdb"),
              "frames are drawn where the flight is over a.tdb: 1.2 - 3.0 s, 70.0 - 80.5 s");
    const std::string many = words_of_spans(TimeRanges(11, later), kFirst, "a.tdb");
    EXPECT_NE(many.find("80.5 s, and 3 further spans, the last until 80.5 s"), std::string::npos) << many;
    EXPECT_EQ(std::count(many.begin(), many.end(), ','), 8 + 1);
}

TEST_F(OverTerrain, NeverOverItIsRefusedWithNumbers) {
    const FlightOutline flight = flown({9.5, 9.55, 9.8});
    expect_user_error([&] { (void)terrain_spans(options, flight, kFirst, database); },
                      "it covers 46.940 .. 47.100 N, 9.600 .. 9.760 E");
    expect_user_error([&] { (void)terrain_spans(options, flight, kFirst, database); },
                      "the flight 47.000 .. 47.000 N, 9.500 .. 9.800 E");
    options.to_s = -1;
    expect_user_error([&] { (void)terrain_spans(options, flight, kFirst, database); },
                      "no position of the flight is known between --from and --to; choose other times");
    options.to_s.reset();
    expect_user_error([&] { (void)terrain_spans(options, flown({}), kFirst, database); },
                      "no position of the flight is known; leave out --over-terrain");
    expect_user_error([&] { (void)terrain_spans(options, flight, kFirst, nullptr); }, "--over-terrain: there is no terrain");
}

}  // namespace
}  // namespace tedavis::host_sim::test_terrain_span
