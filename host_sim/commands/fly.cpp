#include "host_sim/commands/fly.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/kept_terrains.hpp"
#include "host_sim/commands/replay.hpp"
#include "host_sim/commands/scene.hpp"
#include "host_sim/commands/terrain_cache.hpp"
#include "host_sim/commands/weather_scene.hpp"
#include "host_sim/importers/fix_cleaner.hpp"
#include "host_sim/importers/flight_importer.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/terrain_span.hpp"
#include "host_sim/reports/geo_extent.hpp"
#include "host_sim/reports/run_findings.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/written_files.hpp"
#include "render_core/scene/sdb_format.hpp"
#include "render_core/terrain/tdb_format.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kWithoutTerrain =
    "no terrain was given (--terrain), so that no ground is shown and no terrain alert can be given";

bool begins_with(const std::string& path, std::string_view magic) {
    std::string beginning(magic.size(), '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    return file && beginning == magic;
}

/// Of a flight that is no bus log.
struct Recording {
    std::string format;
    std::vector<OutlinePlace> fixes;
};

std::optional<Recording> recording_of(const ConvertOptions& flight) {
    if (is_bus_log_file(flight.flight)) {
        if (!flight.aircraft.empty() || flight.qnh_hpa || flight.assume_geometric)
            throw UserError(flight.flight +
                            ": a bus log, which is replayed as it is; leave out --aircraft, --qnh and "
                            "--assume-geometric");
        return std::nullopt;
    }
    ImportedFile file = import_flight_file(flight.flight);
    Recording recording{file.format, {}};
    RecordedFlight flown = choose_aircraft(std::move(file), flight.aircraft, flight.flight);
    (void)clean_fixes(flown);
    for (const RecordedFix& fix : flown.fixes) recording.fixes.push_back({fix.time, fix.latitude_rad, fix.longitude_rad});
    return recording;
}

/// Of a recording, the log beside the report; its notes go to the report.
std::string log_of_flight(const FlyOptions& options, WrittenFiles& made, Console& console, std::vector<std::string>& notes) {
    ConvertOptions convert = options.flight;
    convert.output = options.replay.output + "/flight.log";
    made.add_new(convert.output);
    made.add_new(convert.output + ".json");
    if (run_convert(convert, console, notes) != 0)
        throw Interrupted("interrupted; nothing was written to " + options.replay.output);
    return convert.output;
}

/// `use` keeps a database of the cache from being removed.
std::string terrain_of_flight(const TerrainBuildOptions& terrain, TerrainUse& use, Console& console) {
    if (terrain.rasters.empty()) return {};
    const auto is_database = [](const std::string& file) {
        return begins_with(file, {terrain::kTdbMagic, sizeof terrain::kTdbMagic});
    };
    if (std::none_of(terrain.rasters.begin(), terrain.rasters.end(), is_database)) {
        std::string path = cached_terrain(terrain, console);
        use = TerrainUse(path);
        return path;
    }
    if (terrain.rasters.size() > 1)
        throw UserError("--terrain: one database, or rasters to build one from; not " + std::to_string(terrain.rasters.size()) +
                        " files with a database among them");
    return terrain.rasters.front();
}

/// The hours of a converted flight and the region of the terrain, as far as they are known.
WeatherWindow window_of(const FlyOptions& options, const ReplayOptions& replay) {
    constexpr double kAround_deg = 0.25;
    WeatherWindow window;
    const bool is_converted = replay.log != options.flight.flight;  // else the file beside the log may be anything
    if (is_converted) {
        const Json flight = Json::parse(read_file(replay.log + ".json"));
        const auto time_of = [&](const char* key) {
            return base::Time{} + base::Duration::from_seconds(flight.at(key).get<double>());
        };
        window.begin = time_of("begin_s");
        window.end = time_of("end_s");
    }
    if (replay.picture.terrain.empty()) return window;
    window.region = extent_of(OpenDatabase(replay.picture.terrain).database());
    window.region.include(window.region.south_deg - kAround_deg, window.region.west_deg - kAround_deg);
    window.region.include(window.region.north_deg + kAround_deg, window.region.east_deg + kAround_deg);
    return window;
}

std::string weather_file(const FlyOptions& options, ReplayOptions& replay, WrittenFiles& made, Console& console) {
    const WeatherScene scene = weather_scene(options.weather, window_of(options, replay));
    for (const std::string& note : scene.notes) {
        console.note("note: " + note);
        replay.notes.push_back(note);
    }
    std::string path = replay.output + "/scene.toml";
    require_replaceable(path, "name = \"weather\"\n", "scene file of weather");
    made.add_new(path);
    write_file_atomically(path, scene.toml);
    return path;
}

/// The database of the scene; empty where there is none.
std::string scene_of_flight(const FlyOptions& options, ReplayOptions& replay, WrittenFiles& made, Console& console) {
    if (!options.weather.empty() && !options.scene.empty())
        throw UserError("--weather and --scene: name the grids of the weather in the scene file, and leave out --weather");
    if (options.weather.empty() && options.scene.empty()) return {};
    if (begins_with(options.scene, {scene::kSdbMagic, sizeof scene::kSdbMagic})) return options.scene;
    SceneBuildOptions build;
    build.scene = options.scene.empty() ? weather_file(options, replay, made, console) : options.scene;
    build.output = replay.output + "/scene.sdb";
    made.add_new(build.output);
    (void)run_scene_build(build, console);
    return build.output;
}

/// An IGC file is the record of a glider, unless somebody says otherwise.
void take_class(const Recording& recording, ReplayOptions& replay, Console& console) {
    const bool is_stated = replay.aircraft_class.has_value() ||
                           load_aircraft(replay.picture.aircraft).aircraft_class != flight::AircraftClass::unstated;
    if (is_stated || recording.format != "IGC") return;
    replay.aircraft_class = flight::AircraftClass::glider;
    replay.notes.emplace_back("phases by motion are those of a glider, because the flight is an IGC file (--class)");
    console.note("note: " + replay.notes.back());
}

/// What is wrong with the flight and with the pair of flight and terrain is found before the long steps.
ReplayOptions replay_of(const FlyOptions& options, WrittenFiles& made, TerrainUse& use, Console& console) {
    ReplayOptions replay = options.replay;
    const std::optional<Recording> recording = recording_of(options.flight);
    replay.picture.terrain = terrain_of_flight(options.terrain, use, console);
    if (recording && !replay.picture.terrain.empty())
        require_near_terrain(recording->fixes, replay.picture.terrain, OpenDatabase(replay.picture.terrain).database());
    replay.log = recording ? log_of_flight(options, made, console, replay.notes) : options.flight.flight;
    if (recording) take_class(*recording, replay, console);
    replay.keeps_index = replay.log == options.flight.flight;  // a log of this moment would not be trusted
    replay.over_terrain = !replay.picture.terrain.empty();
    if (!replay.over_terrain) {
        console.note(std::string("note: ") + kWithoutTerrain);
        replay.notes.emplace_back(kWithoutTerrain);
    }
    replay.picture.scene = scene_of_flight(options, replay, made, console);
    return replay;
}

void say_where_it_is(const std::string& output, Console& console) {
    const std::string report = output + "/" + kReportName;
    const Json summary = Json::parse(read_file(output + "/" + kSummaryName));
    const Json& warnings = summary.at("warnings");
    const std::string frames = counted(summary.at("frames").get<std::uint64_t>(), "frame");
    const bool is_interrupted = summary.at("interrupted").get<bool>();
    console.result(report + ": " + frames + (is_interrupted ? " (interrupted), " : ", ") +
                       (warnings.empty() ? "no warnings" : counted(warnings.size(), "warning")),
                   json_text(Json{{"report", report}, {"summary", summary}}));
}

}  // namespace

int run_fly(const FlyOptions& options, Console& console) {
    NewFolder folder(options.replay.output);
    WrittenFiles made;
    Console steps = console.without_result();
    TerrainUse use;
    const ReplayOptions replay = replay_of(options, made, use, steps);
    require_uninterrupted(options.replay.output);
    const int code = run_replay(replay, steps);
    made.keep();
    folder.keep();
    say_where_it_is(options.replay.output, console);
    return code;
}

}  // namespace tedavis::host_sim
