#include "host_sim/scenario/planned_flight.hpp"

#include <algorithm>

#include "host_sim/scenario/generated_attribute.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

using flight::Signal;

constexpr double kSigmasOf95 = 1.96;
constexpr double kFullHeightSigma_m = 100, kFullSpeedSigma_mps = 10, kFullClimbSigma_mps = 5;
constexpr std::uint8_t kRouteImportance = 225;

LayerDraft empty_flight_layer(base::Time start) {
    LayerDraft layer;
    layer.name = "flight";
    layer.title = "FLIGHT";
    layer.source = kGeneratedOrigin;
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    layer.importance = kRouteImportance;
    layer.data_time_ns = start.ns;
    layer.position_accuracy_m = kPlanPosition_m;
    layer.height_accuracy_m = kPlanHeight_m;
    return layer;
}

/// Every kPlanStep_s, and the last one.
std::vector<base::Time> plan_times(const ScenarioFlight& flight) {
    std::vector<base::Time> times;
    for (base::Time time = flight.begin(); time < flight.end(); time = time + base::Duration::from_seconds(kPlanStep_s))
        times.push_back(time);
    times.push_back(flight.end());
    return times;
}

}  // namespace

LayerDraft make_flight_layer(const ScenarioFlight& flight, const LandingStrip& strip) {
    LayerDraft layer = empty_flight_layer(flight.begin());
    AttributeDraft height = generated_attribute("height", "HEIGHT", "m", kFullHeightSigma_m);
    AttributeDraft speed = generated_attribute("ground_speed", "GROUND SPEED", "m/s", kFullSpeedSigma_mps);
    AttributeDraft climb = generated_attribute("vertical_speed", "VERTICAL SPEED", "m/s", kFullClimbSigma_mps);
    AttributeDraft position = generated_attribute("position_accuracy", "ACCURACY", "m", 0);
    AttributeDraft vertical = generated_attribute("height_accuracy", "HEIGHT ACCURACY", "m", 0);
    earth::Geodetic before;
    double flown_m = 0;
    for (const base::Time time : plan_times(flight)) {
        const SignalSample sample = flight.at(time).value();
        const earth::Geodetic here{sample[Signal::latitude], sample[Signal::longitude], {}};
        if (!layer.points.empty()) flown_m += earth::surface_distance_m(before, here);
        before = here;
        const double height_m = sample[Signal::true_altitude];
        const double from_strip_m = earth::surface_distance_m({strip.latitude_rad, strip.longitude_rad, {}}, here);
        const double position_m = kPlanPosition_m + std::min(kPlanPositionShare * flown_m, kStripPositionShare * from_strip_m);
        const double vertical_m = kPlanHeight_m + std::min(kPlanHeightShare * flown_m, kStripHeightShare * from_strip_m);
        layer.points.push_back({here.latitude_rad, here.longitude_rad, static_cast<float>(height_m), 0, time.ns});
        add_value(height, height_m, vertical_m / kSigmasOf95);
        add_value(speed, sample[Signal::ground_speed], kPlanSpeedSigma_mps);
        add_value(climb, sample[Signal::vertical_speed], kPlanClimbSigma_mps);
        position.values.push_back(static_cast<float>(position_m));
        vertical.values.push_back(static_cast<float>(vertical_m));
    }
    layer.starts = {0, static_cast<std::uint32_t>(layer.points.size())};
    for (AttributeDraft* attribute : {&height, &speed, &climb, &position, &vertical})
        layer.attributes.push_back(std::move(*attribute));
    return layer;
}

}  // namespace tedavis::host_sim
