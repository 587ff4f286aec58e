#include "host_sim/scenario/storm_cells.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "host_sim/scenario/generated_attribute.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kRadiusShare = 0.3;
constexpr double kSecondHarmonic = 0.18, kThirdHarmonic = 0.08;
constexpr double kShortestTexture_m = 800, kLongestTexture_m = 3'000, kTextureHeight_m = 10'000;
constexpr double kSigma_db = 5, kSigmaSpread_db = 2, kFullSigma_db = 12, kStormGrowth_per_hour = 0.6;
constexpr double kSpeedSigma_mps = 1.5, kFullSpeedSigma_mps = 10;
constexpr double kPositionAccuracy_m = 400, kHeightAccuracy_m = 500;
constexpr int kCorners = 24;
constexpr std::uint8_t kStormImportance = 240;

double full_circle(SeededRandom& random) { return 2 * base::kPi * random.unit(); }

LayerDraft empty_storm_layer(base::Time start) {
    LayerDraft layer;
    layer.name = "storm";
    layer.title = "STORM";
    layer.source = kGeneratedOrigin;
    layer.shape = scene::LayerShape::areas;
    layer.role = scene::LayerRole::storm_cell;
    layer.importance = kStormImportance;
    layer.data_time_ns = start.ns;
    layer.valid_until_ns = start.ns + base::kNanosecondsPerHour;
    layer.position_accuracy_m = kPositionAccuracy_m;
    layer.height_accuracy_m = kHeightAccuracy_m;
    layer.starts.push_back(0);
    return layer;
}

void add_outline(const StormCell& cell, const LocalPlane& plane, LayerDraft& layer) {
    for (int n = 0; n < kCorners; ++n) {
        const double bearing_rad = 2 * base::kPi * n / kCorners, away_m = cell.outline_m(bearing_rad);
        const PlanePlace at =
            plane.at(cell.east_m + away_m * std::sin(bearing_rad), cell.north_m + away_m * std::cos(bearing_rad));
        layer.points.push_back({at.latitude_rad, at.longitude_rad, static_cast<float>(cell.base_msl_m), 0, scene::kNoTime});
    }
    layer.starts.push_back(static_cast<std::uint32_t>(layer.points.size()));
    layer.names.push_back("Cell " + std::to_string(layer.names.size() + 1));
}

}  // namespace

StormCell::StormCell(const StormSettings& settings, SeededRandom& random)
    : east_m(settings.distance_m * std::sin(settings.bearing_rad)),
      north_m(settings.distance_m * std::cos(settings.bearing_rad)),
      intensity_dbz(random.within(settings.intensity_dbz, settings.intensity_spread_dbz)),
      sigma_dbz(random.within(kSigma_db, kSigmaSpread_db)),
      speed_mps(std::max(0.0, random.within(settings.speed_mps, settings.speed_spread_mps))),
      toward_rad(random.within(settings.toward_rad, settings.toward_spread_rad)),
      base_msl_m(random.within(settings.base_msl_m, kStormBaseSpread_m)),
      top_msl_m(random.within(settings.top_msl_m, kStormTopSpread_m)),
      radius_m_(settings.radius_m * random.within(1, kRadiusShare)),
      second_rad_(full_circle(random)),
      third_rad_(full_circle(random)),
      texture_(random, kShortestTexture_m, kLongestTexture_m, kTextureHeight_m) {
    // Evenly over a disk.
    const double away_m = settings.spread_m * std::sqrt(random.unit()), bearing_rad = full_circle(random);
    east_m += away_m * std::sin(bearing_rad);
    north_m += away_m * std::cos(bearing_rad);
}

double StormCell::outline_m(double bearing_rad) const {
    return radius_m_ * (1 + kSecondHarmonic * std::cos(2 * (bearing_rad - second_rad_)) +
                        kThirdHarmonic * std::cos(3 * (bearing_rad - third_rad_)));
}

double StormCell::echo_dbz(double at_east_m, double at_north_m, double time_s) const {
    const double gone_m = speed_mps * time_s;
    const double east = at_east_m - east_m - gone_m * std::sin(toward_rad);
    const double north = at_north_m - north_m - gone_m * std::cos(toward_rad);
    const double share = std::hypot(east, north) / outline_m(std::atan2(east, north));
    const double ragged_db = kTexture_db * std::min(1.0, share * share) * texture_.at(east, north, 0);
    return std::max(kNoEcho_dbz, intensity_dbz - kOutlineDrop_db * share * share + ragged_db);
}

std::vector<StormCell> draw_storm_cells(const StormSettings& settings, SeededRandom& random) {
    std::vector<StormCell> cells;
    for (int n = 0; n < settings.cells; ++n) cells.emplace_back(settings, random);
    return cells;
}

LayerDraft make_storm_layer(const std::vector<StormCell>& cells, const LocalPlane& plane, base::Time start) {
    LayerDraft layer = empty_storm_layer(start);
    AttributeDraft intensity = generated_attribute("intensity", "INTENSITY", "dBZ", kFullSigma_db);
    intensity.uncertainty_growth_per_hour = kStormGrowth_per_hour;
    AttributeDraft speed = generated_attribute("speed", "CELL SPEED", "m/s", kFullSpeedSigma_mps);
    AttributeDraft toward = generated_attribute("toward", "TOWARD", "rad", 0);
    AttributeDraft floor = generated_attribute("floor", "FLOOR", "m", 0);
    AttributeDraft ceiling = generated_attribute("ceiling", "CEILING", "m", 0);
    for (const StormCell& cell : cells) {
        add_outline(cell, plane, layer);
        add_value(intensity, cell.intensity_dbz, cell.sigma_dbz);
        add_value(speed, cell.speed_mps, kSpeedSigma_mps);
        toward.values.push_back(static_cast<float>(cell.toward_rad));
        floor.values.push_back(static_cast<float>(cell.base_msl_m));
        ceiling.values.push_back(static_cast<float>(cell.top_msl_m));
    }
    for (AttributeDraft* attribute : {&intensity, &speed, &toward, &floor, &ceiling}) {
        attribute->of = scene::AttributeOf::feature;
        layer.attributes.push_back(std::move(*attribute));
    }
    return layer;
}

}  // namespace tedavis::host_sim
