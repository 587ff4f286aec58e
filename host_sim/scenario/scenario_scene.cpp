#include "host_sim/scenario/scenario_scene.hpp"

#include <algorithm>
#include <filesystem>

#include "host_sim/input_file.hpp"
#include "host_sim/scenario/generated_attribute.hpp"
#include "host_sim/scenario/gust_ensemble.hpp"
#include "host_sim/scenario/planned_flight.hpp"
#include "host_sim/scenario/radar_frames.hpp"
#include "host_sim/scenario/storm_cells.hpp"
#include "host_sim/scenario/wind_forecast.hpp"
#include "host_sim/scene_builder/derived_attribute.hpp"

namespace tedavis::host_sim {
namespace {

/// One generator each, far apart whatever the seed.
enum class RandomStream : std::uint64_t { wind = 1, storm = 2, gust = 3 };
SeededRandom random_of(std::uint64_t seed, RandomStream stream) {
    constexpr std::uint64_t kApart = 0x9E3779B97F4A7C15u;  // an odd number without a pattern
    return SeededRandom(seed + static_cast<std::uint64_t>(stream) * kApart);
}

std::vector<LayerDraft> generated_layers(const Scenario& scenario, const ScenarioFlight& flight, std::uint64_t seed) {
    std::vector<LayerDraft> layers = {make_flight_layer(flight, scenario.strip)};
    if (!scenario.weather) return layers;
    SeededRandom for_wind = random_of(seed, RandomStream::wind), for_storm = random_of(seed, RandomStream::storm);
    const std::vector<StormCell> cells = draw_storm_cells(scenario.weather->storm, for_storm);
    const LocalPlane plane(scenario.strip.latitude_rad, scenario.strip.longitude_rad);
    layers.push_back(make_wind_layer(scenario, flight.air(), for_wind));
    layers.push_back(make_storm_layer(cells, plane, scenario.start));
    layers.push_back(make_radar_layer(scenario, cells, flight.end()));
    if (scenario.weather->gust.members == 0) return layers;
    SeededRandom for_gust = random_of(seed, RandomStream::gust);
    layers.push_back(make_gust_layer(scenario, flight.air(), for_gust));
    return layers;
}

LayerDraft* find(std::vector<LayerDraft>& layers, const char* name) {
    const auto found = std::find_if(layers.begin(), layers.end(), [&](const LayerDraft& layer) { return layer.name == name; });
    return found == layers.end() ? nullptr : &*found;
}

bool has(const LayerDraft& layer, const char* name) {
    return std::any_of(layer.attributes.begin(), layer.attributes.end(),
                       [&](const AttributeDraft& attribute) { return attribute.name == name; });
}

bool gives_wind_to(const LayerDraft& flight, const LayerDraft& wind) {
    return wind.shape == scene::LayerShape::grid && has(wind, "east") && has(wind, "north") &&
           (wind.levels_m.empty() || wind.height_datum == flight.height_datum);
}

/// What the flight meets, at its places, heights and times.
std::vector<std::string> add_wind_along(LayerDraft& flight, const std::vector<LayerDraft>& layers) {
    LayerRecipe recipe;
    recipe.name = flight.name;
    recipe.wind_layer = "wind";
    const auto ask = [&](const char* name, const char* title, const char* variable) {
        AttributeRecipe attribute;
        attribute.name = name;
        attribute.title = title;
        attribute.variable = variable;
        recipe.attributes.push_back(std::move(attribute));
    };
    ask("wind_speed", "WIND SPEED", "derived:wind_speed");
    ask("head_wind", "HEAD WIND", "derived:head_wind");
    ask("cross_wind", "CROSS WIND", "derived:cross_wind");
    return add_derived(recipe, flight, layers);
}

std::string joined_origin(const std::string& of_file) {
    if (of_file.empty() || of_file == kGeneratedOrigin) return kGeneratedOrigin;
    return of_file + "; the rest " + kGeneratedOrigin;
}

}  // namespace

MadeScene make_scenario_scene(const Scenario& scenario, const ScenarioFlight& flight, std::uint64_t seed,
                              const SceneProgress& progress) {
    SceneRecipe recipe;
    if (!scenario.scene.empty()) recipe = parse_scene(read_file(scenario.scene), scenario.scene);
    const std::string folder = std::filesystem::path(scenario.scene).parent_path().string();
    MadeScene made = make_scene(recipe, folder, progress, generated_layers(scenario, flight, seed));
    made.draft.name = scenario.name;
    made.draft.origin = joined_origin(recipe.origin);
    std::vector<LayerDraft>& layers = made.draft.layers;
    LayerDraft &planned = *find(layers, "flight"), *const wind = find(layers, "wind");
    if (wind != nullptr && gives_wind_to(planned, *wind)) {
        const std::vector<std::string> notes = add_wind_along(planned, layers);
        // The generated wind is missing where the aircraft stands, and nowhere else.
        if (!scenario.weather) made.notes.insert(made.notes.end(), notes.begin(), notes.end());
    }
    return made;
}

}  // namespace tedavis::host_sim
