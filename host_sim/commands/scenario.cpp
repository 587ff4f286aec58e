#include "host_sim/commands/scenario.hpp"

#include <nlohmann/json.hpp>

#include "host_sim/atomic_file.hpp"
#include "host_sim/flight_log/flight_log_writer.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/scenario/scenario_flight.hpp"
#include "host_sim/scenario/scenario_scene.hpp"
#include "host_sim/scenario/scenario_switches.hpp"
#include "host_sim/scene_builder/open_scene.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/version.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kProgressSteps = 1000;
constexpr const char* kInterrupted = "interrupted; nothing was written";

bus::SwitchConfig panel_of(const Scenario& scenario) {
    const std::string path = resolve_config(scenario.switch_config, "switches");
    auto config = bus::load_switch_config(read_file(path), path);
    if (!config.ok()) throw UserError(std::string(config.error().message.view()));
    return config.value();
}

/// Logs are written as the shipped bus file has them read.
bus::BusSettings default_bus() {
    const std::string path = resolve_config("canaerospace", "buses");
    auto settings = bus::load_bus_settings(read_file(path), path);
    if (!settings.ok()) throw UserError(std::string(settings.error().message.view()));
    return settings.value();
}

Json legs_json(const Scenario& scenario, const ScenarioFlight& flight) {
    static constexpr const char* kStatedBy[] = {"motion", "can", "switch"};
    Json legs = Json::array();
    for (std::size_t i = 0; i < scenario.legs.size(); ++i) {
        const Leg& leg = scenario.legs[i];
        legs.push_back({{"phase", flight::scenario_name(leg.phase)},
                        {"sub_phase", flight::sub_phase_name(leg.phase)},
                        {"stated_by", kStatedBy[static_cast<std::size_t>(leg.stated_by)]},
                        {"begin_s", flight.legs()[i].begin_s},
                        {"end_s", flight.legs()[i].end_s}});
    }
    return legs;
}

Json layers_json(const SceneDraft& scene) {
    Json layers = Json::array();
    for (const LayerDraft& layer : scene.layers) layers.push_back(layer.name);
    return layers;
}

Json manifest(const std::string& path, const Scenario& scenario, std::uint64_t seed, const ScenarioFlight& flight,
              const FlightLogCounts& counts, const SceneDraft& scene) {
    const LandingStrip& strip = scenario.strip;
    const FlownAir& air = flight.air();
    return {{"synthetic", true},
            {"name", scenario.name},
            {"purpose", scenario.purpose},
            {"scenario", path},
            {"seed", seed},
            {"log", "flight.log"},
            {"switches", "flight.switches"},
            {"switch_config", scenario.switch_config},
            {"scene", "scene.sdb"},
            {"layers", layers_json(scene)},
            {"frames", counts.frames},
            {"phase_messages", counts.phase_messages},
            {"traffic", scenario.traffic.size()},
            {"duration_s", (flight.end() - flight.begin()).to_seconds()},
            {"begin_s", static_cast<double>(flight.begin().ns) * 1e-9},
            {"strip",
             {{"lat_deg", base::degrees(strip.latitude_rad)},
              {"lon_deg", base::degrees(strip.longitude_rad)},
              {"heading_deg", base::degrees(strip.heading_rad)},
              {"elevation_msl_m", strip.elevation_msl_m},
              {"length_m", strip.length_m},
              {"width_m", strip.width_m}}},
            {"air",
             {{"qnh_hpa", air.qnh_pa / base::kPascalsPerHectopascal},
              {"temperature_deviation_k", air.temperature_deviation_k},
              {"wind_speed_mps", air.wind_speed_mps},
              {"wind_from_deg", base::degrees(earth::wrap_heading(air.wind_from_rad))}}},
            {"legs", legs_json(scenario, flight)},
            {"version", version()}};
}

MadeScene make_scene_of(const Scenario& scenario, const ScenarioFlight& flight, std::uint64_t seed,
                        const InterruptGuard& interrupt, Console& console) {
    MadeScene scene =
        make_scenario_scene(scenario, flight, seed, [&](std::string_view layer, std::size_t done, std::size_t total) {
            console.progress(layer, done, total);
            if (interrupt.requested()) throw Interrupted(kInterrupted);
        });
    console.progress_done();
    for (const std::string& note : scene.notes) console.note("note: " + note);
    return scene;
}

/// Seals it; what the board would refuse is not put in its place.
void write_scene(const SceneDraft& scene, AtomicFile& file) {
    const std::vector<std::uint8_t> bytes = sdb_bytes(scene);
    file.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    file.seal();
    (void)OpenScene(file.part_path());
}

void require_replaceable_results(const std::string& folder) {
    require_replaceable_log(folder + "/flight.log");
    require_replaceable(folder + "/flight.switches", "# tedavis switch log ", "switch log");
    require_replaceable(folder + "/scene.sdb", {scene::kSdbMagic, sizeof scene::kSdbMagic}, "scene database");
    require_replaceable(folder + "/scenario.json", "{\n  \"synthetic\": ", "description of a generated flight");
}

}  // namespace

int run_scenario_build(const ScenarioBuildOptions& options, Console& console) {
    const std::string path = resolve_config(options.scenario, "scenarios");
    const Scenario scenario = parse_scenario(read_file(path), path);
    require_replaceable_results(options.output);
    const std::uint64_t seed = options.seed.value_or(scenario.seed);
    const bus::SwitchConfig panel = panel_of(scenario);
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    const ScenarioFlight flight(scenario, seed, geoid);
    const std::string switch_log = scenario_switch_log(scenario, flight, panel);
    const InterruptGuard interrupt;
    const MadeScene scene = make_scene_of(scenario, flight, seed, interrupt, console);

    NewFolder folder(options.output);
    FlightLogSettings log_settings;
    log_settings.name = options.output + "/flight.log";
    log_settings.bus = default_bus();
    AtomicFile log(log_settings.name), switches(options.output + "/flight.switches"), database(options.output + "/scene.sdb"),
        companion(options.output + "/scenario.json");
    const FlightLogCounts counts = write_flight_log(flight, log_settings, log.stream(), [&](double share) {
        console.progress("flying " + scenario.name, static_cast<std::uint64_t>(share * kProgressSteps), kProgressSteps);
        return !interrupt.requested();
    });
    console.progress_done();
    if (counts.interrupted) throw Interrupted(kInterrupted);
    const Json json = manifest(path, scenario, seed, flight, counts, scene.draft);
    switches.stream() << switch_log;
    write_scene(scene.draft, database);
    companion.stream() << json_text(json, 2) << '\n';
    for (AtomicFile* file : {&log, &switches, &companion}) file->seal();
    for (AtomicFile* file : {&log, &switches, &database, &companion}) file->commit();
    folder.keep();
    console.result(options.output + ": " + scenario.name + " with seed " + std::to_string(seed) + ", " +
                       std::to_string(counts.frames) + " frames over " +
                       std::to_string(static_cast<int>((flight.end() - flight.begin()).to_seconds())) + " s",
                   json_text(json));
    return 0;
}

}  // namespace tedavis::host_sim
