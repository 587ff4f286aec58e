#include "host_sim/scenario/wind_forecast.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/input_file.hpp"
#include "host_sim/scene_builder/draft_grid.hpp"
#include "render_core/earth/geodetic.hpp"
#include "render_core/scene/grid_field.hpp"
#include "render_core/scene/wind.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::host_sim::test_wind_forecast {
namespace {

Scenario shipped() {
    return parse_scenario(read_file(test_support::source_dir() + "/configs/scenarios/default.toml"), "default.toml");
}

const FlownAir kAir{101'900, 0, 6, base::radians(260)};

LayerDraft forecast(std::uint64_t seed, const Scenario& scenario = shipped()) {
    SeededRandom random(seed);
    return make_wind_layer(scenario, kAir, random);
}

double from_deg(const MeanWind& wind) { return base::degrees(scene::wind_of(wind.east_mps, wind.north_mps).from_rad); }
double speed_mps(const MeanWind& wind) { return std::hypot(wind.east_mps, wind.north_mps); }

TEST(WindForecast, GrowsAndTurnsWithHeight) {
    EXPECT_NEAR(speed_mps(mean_wind(kAir, 0.6, kWindReference_m)), 6, 1e-12);
    EXPECT_NEAR(from_deg(mean_wind(kAir, 0.6, kWindReference_m)), 260, 1e-9);
    EXPECT_NEAR(speed_mps(mean_wind(kAir, 0.6, 128 * kWindReference_m)), 12, 1e-12) << "128 is the seventh power of 2";
    double before_deg = 0;
    for (const double height_m : kWindHeights_m) {
        const double here_deg = from_deg(mean_wind(kAir, 0.6, height_m));
        EXPECT_GT(here_deg, before_deg) << "it veers in the north";
        EXPECT_NEAR(here_deg + from_deg(mean_wind(kAir, -0.6, height_m)), 520, 1e-9) << "and backs in the south";
        EXPECT_NEAR(here_deg, 260, 25);
        before_deg = here_deg;
    }
}

TEST(WindForecast, IsTheFlightsWindAtTheStrip) {
    const Scenario scenario = shipped();
    const LayerDraft layer = forecast(1);
    const DraftGrid grid(layer);
    const auto at_strip = [&](const char* name) {
        return scene::GridField(grid.layer(), *grid.find(name))
            .at(scenario.strip.latitude_rad, scenario.strip.longitude_rad, scenario.strip.elevation_msl_m + kWindReference_m,
                scenario.start.ns);
    };
    EXPECT_NEAR(at_strip("east").value, -6 * std::sin(kAir.wind_from_rad), 0.15);
    EXPECT_NEAR(at_strip("north").value, -6 * std::cos(kAir.wind_from_rad), 0.15);
    EXPECT_NEAR(at_strip("speed").value, 6, 0.15);
    EXPECT_NEAR(kFullWindSigma_mps * at_strip("east").uncertainty.level(), scenario.weather->wind.sigma_mps, 0.1)
        << "posts do not stand at the strip itself";
}

TEST(WindForecast, VariesAwayFromTheStripByWhatIsAsked) {
    Scenario scenario = shipped();
    double squares = 0, count = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const LayerDraft layer = forecast(seed);
        for (std::size_t n = 0; n < kWindPosts; ++n) {  // the northern edge, in the lowest level
            const double off = static_cast<double>(layer.attributes[0].values[n]) - mean_wind(kAir, 0.6, 2).east_mps;
            squares += off * off;
            ++count;
        }
    }
    EXPECT_NEAR(std::sqrt(squares / count), scenario.weather->wind.variation_mps, 0.4);
    scenario.weather->wind.variation_mps = 0;
    const LayerDraft even = forecast(1, scenario);
    for (std::size_t n = 0; n < kWindPosts * kWindPosts; ++n)
        EXPECT_EQ(even.attributes[0].values[n], even.attributes[0].values[0]);
}

TEST(WindForecast, IsTheLessSureTheFartherAndTheLater) {
    const LayerDraft layer = forecast(1);
    const AttributeDraft& east = layer.attributes[0];
    constexpr std::size_t kLevel = kWindPosts * kWindPosts, kHour = kLevel * kWindHeights_m.size();
    ASSERT_EQ(east.values.size(), kHour * kWindTimes);
    const std::size_t middle = kWindPosts / 2 * kWindPosts + kWindPosts / 2;
    for (std::size_t n = 0; n < east.values.size(); ++n) {
        ASSERT_TRUE(std::isfinite(east.values[n]));
        ASSERT_TRUE(east.uncertainties[n].is_known());
    }
    const auto sigma_mps = [&](std::size_t n) { return kFullWindSigma_mps * east.uncertainties[n].level(); };
    EXPECT_LT(sigma_mps(middle), sigma_mps(middle + 5));
    EXPECT_LT(sigma_mps(middle + 5), sigma_mps(0));
    const double corner_m = 18'000 * std::sqrt(2.0);
    const double least_mps = shipped().weather->wind.sigma_mps;
    EXPECT_NEAR(sigma_mps(0), least_mps * (1 + corner_m / 15'000), 0.02);
    EXPECT_NEAR(sigma_mps(2 * kHour), least_mps * (1 + corner_m / 15'000 + 2), 0.02);
}

TEST(WindForecast, HasTheTimesAndHeightsOfItsFlight) {
    const Scenario scenario = shipped();
    const LayerDraft layer = forecast(1);
    EXPECT_EQ(layer.times_ns.front(), scenario.start.ns);
    EXPECT_EQ(layer.times_ns.back() - layer.times_ns.front(), 2 * std::int64_t{3'600'000'000'000});
    EXPECT_EQ(layer.levels_m.front(), 347);
    EXPECT_EQ(layer.levels_m.back(), 3345);
    EXPECT_EQ(layer.attributes[0].values, forecast(1).attributes[0].values);
    EXPECT_NE(layer.attributes[0].values, forecast(2).attributes[0].values);
}

}  // namespace
}  // namespace tedavis::host_sim::test_wind_forecast
