/// The table of scenarios of the thesis (6.1): small and large terrain, then on the large one numerical data, ways, air, shafts
/// of shade, and a saliency map, each with all before it; least and greatest rate, mean frame and most triangles of a whole
/// frame. Device desktop at 1920 x 1080, without instruments. A flight of a circle over the middle of the terrain; before each
/// frame all that it asks for is there, then it is planned, drawn and finished. Triangles are those handed to GL, by all passes.
/// `bench_scenarios [SMALL.tdb LARGE.tdb] [--frames N] [--gl egl|osmesa] [--json]`: without databases the shipped terrain, and
/// generated terrain of 1300 x 1300 posts. The baseline of a line is the thesis's, of another machine.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "host_sim/commands/own_ground.hpp"
#include "host_sim/scenario/generated_attribute.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"
#include "host_sim/scenario/square_grid.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/terrain_builder/terrain_build.hpp"
#include "host_sim/user_error.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "platform/files/file_byte_source.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/bench/counted_triangles.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/default_flight.hpp"
#include "tests/support/terrain/fractal_posts.hpp"

namespace {

using namespace tedavis;

constexpr std::uint32_t kWidth = 1920, kHeight = 1080;
constexpr const char* kDevice = "desktop";
constexpr std::uint32_t kFractalPosts = 1300;                // a side
constexpr double kMaxReach_m = 30'000;                       // of data round the middle of the terrain
constexpr std::uint32_t kWindPosts = 112, kWindHeights = 8;  // 100,352 glyphs
constexpr std::uint32_t kWays = 10, kWayPoints = 600;
constexpr int kWarmUp = 2;

constexpr const char* kTerrain = R"(
name = "scenario"
[terrain.texture]
technique = "hypsometric"
[terrain.shade]
technique = "lambert"
[warning]
enabled = false
[symbology]
attitude = false
map = false
heading = false
airspeed = false
altitude = false
vertical_speed = false
flight_path = false
baro_setting = false
ground_height = false
air = false
phase = false
)";
constexpr const char* kWind = R"(
[[data.element]]
layer = "wind"
technique = "arrows"
attribute = "speed"
palette = "data_wind"
heights_m = [150, 300, 600, 900, 1200, 1800, 2400, 3000]
heights_over_ground = true
)";
constexpr const char* kTubes = R"(
[[data.element]]
role = "trajectory"
technique = "tube"
attribute = "ground_speed"
palette = "data_wind_speed_tube"
size_m = 60
)";
constexpr const char* kClear = "[sky]\nhaze_distance_m = 0\n";
constexpr const char* kAir = "[sky]\naerial_perspective = true\nvisibility_m = 60000\n";
constexpr const char* kShafts = "[effects.shadows]\nin_air = 1\n";
constexpr const char* kSaliency = "[effects.saliency]\nview = \"heat\"\n";  // measured in every frame, and shown

struct Figures {
    double triangles = 0, least_rate = 0, greatest_rate = 0, mean_ms = 0;
};
struct Scenario {
    const char* name;
    std::string design;
    const char* must_run;  ///< an effect without which the row is not what it says
    bool is_large;
    Figures theirs;
};

std::vector<Scenario> scenarios() {
    const std::string terrain = kTerrain, wind = terrain + kWind, ways = wind + kTubes, air = ways + kAir;
    return {{"small terrain", terrain + kClear, "terrain", false, {3.2e6, 342, 563, 2.2}},
            {"large terrain", terrain + kClear, "terrain", true, {6.0e6, 267, 488, 2.6}},
            {"+ numerical data", wind + kClear, "terrain", true, {7.5e6, 168, 254, 4.7}},
            {"+ geometrical data", ways + kClear, "terrain", true, {7.6e6, 128, 199, 6.1}},
            {"+ atmospheric effects", air, "aerial_perspective", true, {7.6e6, 64, 78, 14.1}},
            {"+ volumetric lighting", air + kShafts, "volumetric_light", true, {7.6e6, 58, 72, 15.4}},
            {"+ saliency map", air + kShafts + kSaliency, "saliency", true, {7.6e6, 42, 61, 19.4}}};
}

design::DesignSettings design_of(const Scenario& scenario) {
    test_support::ShippedFiles files;
    const auto design = design::read_design_settings(scenario.design, scenario.name, files);
    if (!design) throw std::runtime_error(design.error().message.c_str());
    return design.value();
}

/// The middle of a terrain, and how far data and flight may go from there.
struct Place {
    double latitude_deg, longitude_deg, highest_m, reach_m;

    explicit Place(const terrain::FileHeader& header)
        : latitude_deg(header.north_deg - 0.5 * header.step_lat_deg * header.rows),
          longitude_deg(header.west_deg + 0.5 * header.step_lon_deg * header.columns),
          highest_m(header.max_height_m) {
        const host_sim::LocalPlane plane = around();
        const double north_m = base::radians(0.5 * header.step_lat_deg * header.rows) / plane.latitude_per_m(),
                     east_m = base::radians(0.5 * header.step_lon_deg * header.columns) / plane.longitude_per_m();
        reach_m = std::min({0.95 * north_m, 0.95 * east_m, kMaxReach_m});
    }
    [[nodiscard]] host_sim::LocalPlane around() const { return {base::radians(latitude_deg), base::radians(longitude_deg)}; }
    /// Of a circle to the right round the middle, seen ahead.
    [[nodiscard]] host_sim::AircraftPose pose(int n, int frames) const {
        const double turn = 2 * base::kPi * n / frames, radius_m = 0.5 * reach_m;
        const host_sim::PlanePlace at = around().at(radius_m * std::sin(turn), radius_m * std::cos(turn));
        return {base::degrees(at.latitude_rad),
                base::degrees(at.longitude_rad),
                highest_m + 300,
                base::degrees(std::fmod(turn + base::kPi / 2, 2 * base::kPi)),
                -5,
                0};
    }
};

/// One level at any height; the wind turns and grows from the west to the east.
host_sim::LayerDraft wind_layer(const Place& place) {
    const host_sim::SquareGrid square(place.reach_m, kWindPosts);
    host_sim::LayerDraft layer;
    layer.name = "wind";
    layer.title = "WIND";
    layer.source = host_sim::kGeneratedOrigin;
    layer.shape = scene::LayerShape::grid;
    layer.role = scene::LayerRole::wind;
    layer.grid = square.shape(place.around(), 1, 1);
    host_sim::AttributeDraft east = host_sim::generated_attribute("east", "WIND EAST", "m/s", 0);
    host_sim::AttributeDraft north = host_sim::generated_attribute("north", "WIND NORTH", "m/s", 0);
    host_sim::AttributeDraft speed = host_sim::generated_attribute("speed", "WIND SPEED", "m/s", 0);
    for (std::uint32_t row = 0; row < kWindPosts; ++row)
        for (std::uint32_t column = 0; column < kWindPosts; ++column) {
            const double turn = 5.0 * column / kWindPosts + 2.0 * row / kWindPosts, blows = 5 + 20.0 * column / kWindPosts;
            east.values.push_back(static_cast<float>(blows * std::cos(turn)));
            north.values.push_back(static_cast<float>(blows * std::sin(turn)));
            speed.values.push_back(static_cast<float>(blows));
        }
    layer.attributes = {east, north, speed};
    return layer;
}

/// Rings that wind up and down round the middle.
host_sim::LayerDraft way_layer(const Place& place) {
    host_sim::LayerDraft layer;
    layer.name = "ways";
    layer.title = "WAYS";
    layer.source = host_sim::kGeneratedOrigin;
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::trajectory;
    host_sim::AttributeDraft speed = host_sim::generated_attribute("ground_speed", "GROUND SPEED", "m/s", 0);
    for (std::uint32_t way = 0; way < kWays; ++way) {
        layer.starts.push_back(static_cast<std::uint32_t>(layer.points.size()));
        const double radius_m = place.reach_m * (way + 1) / (kWays + 1);
        for (std::uint32_t n = 0; n < kWayPoints; ++n) {
            const double turn = 1.9 * base::kPi * n / kWayPoints + way;
            const host_sim::PlanePlace at = place.around().at(radius_m * std::sin(turn), radius_m * std::cos(turn));
            const double height_m = place.highest_m + 100 + 300 * (1 + std::sin(5 * turn));
            layer.points.push_back({at.latitude_rad, at.longitude_rad, static_cast<float>(height_m), 0, scene::kNoTime});
            speed.values.push_back(static_cast<float>(15 + 10 * std::sin(3 * turn)));
        }
    }
    layer.starts.push_back(static_cast<std::uint32_t>(layer.points.size()));
    layer.attributes = {speed};
    return layer;
}

std::vector<std::uint8_t> scene_over(const Place& place) {
    return host_sim::sdb_bytes({"scenarios", host_sim::kGeneratedOrigin, 1, {wind_layer(place), way_layer(place)}});
}

struct Options {
    std::string small, large, gl = "egl", fault;
    int frames = 36;
    bool json = false;
};

struct Measured {
    bool holds = true;
    Figures ours;
    double terrain_triangles = 0;
};

/// What the row says is in the frame.
bool shows(const Scenario& scenario, const display::FrameRecord& record) {
    const auto has_run = [&](const display::EffectRecord& effect) {
        return effect.name.view() == scenario.must_run && effect.state == display::EffectState::run;
    };
    bool holds = record.terrain.triangles > 0 && std::any_of(record.effects.begin(), record.effects.end(), has_run);
    const auto has = [&](const char* part) { return scenario.design.find(part) != std::string::npos; };
    std::uint32_t wind = 0, ways = 0;
    for (const display::DataRecord& data : record.data) {
        const std::uint32_t all = data.drawn + data.aggregated + data.hidden + data.out_of_view;
        if (data.type.view() == "wind") wind += all;
        if (data.type.view() == "trajectory") ways += all;
    }
    holds = holds && (!has(kWind) || wind == kWindPosts * kWindPosts * kWindHeights);
    return holds && (!has(kTubes) || ways == kWays * kWayPoints);
}

class Flight {
public:
    Flight(const Scenario& scenario, const std::string& database, const Options& options)
        : scenario_(scenario), frames_(options.frames), terrain_(opened(database)), place_(header_of(terrain_)) {
        scene_ = scene_over(place_);
        test_support::MemoryBytes scene(scene_);
        const bool has_data = scenario.design.find("[[data.element]]") != std::string::npos;
        headless_ =
            std::make_unique<test_support::HeadlessDisplay>(options.gl, kDevice, kWidth, kHeight, &terrain_, design_of(scenario),
                                                            test_support::CountedTriangles::wrap, has_data ? &scene : nullptr);
    }
    [[nodiscard]] std::string gl() { return std::string(headless_->display().gl().driver_text().view()); }

    Measured fly() {
        Measured measured;
        double total_ms = 0, longest_ms = 0, shortest_ms = 1e9;
        for (int n = -kWarmUp; n < frames_; ++n) {
            const double ms = frame(place_.pose(n, frames_), measured);
            if (n < 0) continue;
            total_ms += ms;
            longest_ms = std::max(longest_ms, ms);
            shortest_ms = std::min(shortest_ms, ms);
        }
        measured.ours.mean_ms = total_ms / frames_;
        measured.ours.least_rate = 1000 / longest_ms;
        measured.ours.greatest_rate = 1000 / shortest_ms;
        measured.holds = measured.holds && headless_->display().gl().denied().total == 0;
        return measured;
    }

private:
    static platform::FileByteSource opened(const std::string& database) {
        auto file = platform::open_file(database.c_str());
        if (!file.ok()) throw std::runtime_error(file.error().message.c_str());
        return std::move(file.value());
    }
    static terrain::FileHeader header_of(base::ByteSource& bytes) {
        terrain::FileHeader header{};
        if (!bytes.read(0, &header, sizeof header)) throw std::runtime_error("a terrain database is too short");
        return header;
    }
    double frame(const host_sim::AircraftPose& pose, Measured& measured) {
        display::Display& display = headless_->display();
        const flight::AircraftState state = host_sim::posed_aircraft(pose, display);
        display::settle(display, {state, {}, pose.time});
        test_support::CountedTriangles::count() = 0;
        const base::Time start = platform::monotonic_now();
        display.plan({state, {}, pose.time});
        display.draw(headless_->surface());
        display.gl()->Finish();
        const double ms = (platform::monotonic_now() - start).to_seconds() * 1000;
        measured.holds = measured.holds && shows(scenario_, display.record());
        measured.ours.triangles = std::max(measured.ours.triangles, double(test_support::CountedTriangles::count()));
        measured.terrain_triangles = std::max(measured.terrain_triangles, double(display.record().terrain.triangles));
        return ms;
    }

    Scenario scenario_;
    int frames_;
    platform::FileByteSource terrain_;
    Place place_;
    std::vector<std::uint8_t> scene_;
    std::unique_ptr<test_support::HeadlessDisplay> headless_;
};

std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

void add_lines(const Scenario& scenario, const Measured& measured, double before_ms, std::vector<bench::BenchResult>& lines) {
    const std::string name = scenario.name;
    const Figures &ours = measured.ours, &theirs = scenario.theirs;
    lines.push_back({name + ": least rate", ours.least_rate, "frames/s", 0, measured.holds, theirs.least_rate});
    lines.push_back({name + ": greatest rate", ours.greatest_rate, "frames/s", 0, measured.holds, theirs.greatest_rate});
    lines.push_back({name + ": mean frame", ours.mean_ms, "ms", 0, measured.holds, theirs.mean_ms});
    lines.push_back({name + ": most triangles", ours.triangles, "triangles", 0, measured.holds, theirs.triangles});
    lines.push_back({name + ": of it terrain", measured.terrain_triangles, "triangles", 0, measured.holds, 0});
    if (before_ms > 0)
        lines.push_back({name + ": mean frame / the row before", ours.mean_ms / before_ms, "ratio", 0, measured.holds, 0});
}

void print_row(const Scenario& scenario, const Measured& measured) {
    const Figures &ours = measured.ours, &theirs = scenario.theirs;
    char mine[96];
    std::snprintf(mine, sizeof mine, "%10.0f %10.0f %7.1f - %6.1f %8.1f%s", ours.triangles, measured.terrain_triangles,
                  ours.least_rate, ours.greatest_rate, ours.mean_ms, measured.holds ? "" : " (not all is shown)");
    std::printf("%-24s %-48s | %4.1f Mio %5.0f - %3.0f %6.1f\n", scenario.name, mine, theirs.triangles / 1e6, theirs.least_rate,
                theirs.greatest_rate, theirs.mean_ms);
}

std::string own_terrain(const test_support::TemporaryFolder& folder, const Scenario& scenario) {
    std::ostringstream results, notes;
    host_sim::Console console(results, notes, false, false);
    if (!scenario.is_large)
        return host_sim::build_own_terrain({host_sim::shipped_root() + host_sim::kOwnRaster}, folder.path(), console);
    std::string database = folder.file("fractal.tdb");
    if (!std::filesystem::exists(database)) host_sim::build_terrain(test_support::fractal_posts(kFractalPosts), database, {});
    return database;
}

int measure(const Options& options) {
    const test_support::TemporaryFolder folder;
    std::vector<bench::BenchResult> lines;
    double before_ms = 0;
    for (const Scenario& scenario : scenarios()) {
        const std::string named = scenario.is_large ? options.large : options.small;
        const std::string database = named.empty() ? own_terrain(folder, scenario) : named;
        Flight flight(scenario, database, options);
        if (before_ms == 0 && !options.json)
            std::printf("%s\n%-24s %10s %10s %16s %8s | the thesis, GeForce GTX 780\n", flight.gl().c_str(), "scenario",
                        "triangles", "of terrain", "frames/s", "mean ms");
        const Measured measured = flight.fly();
        std::fprintf(stderr, "%s: %s, %.0f MB\n", scenario.name, stem_of(database).c_str(),
                     1e-6 * static_cast<double>(std::filesystem::file_size(database)));
        add_lines(scenario, measured, before_ms, lines);
        before_ms = measured.ours.mean_ms;
        if (!options.json) print_row(scenario, measured);
    }
    if (options.json) bench::print_json(lines);
    return std::all_of(lines.begin(), lines.end(), [](const bench::BenchResult& line) { return line.holds; }) ? 0 : 1;
}

Options options_of(int count, char** given) {
    Options options;
    std::vector<std::string> databases;
    for (int n = 1; n < count; ++n) {
        const std::string argument = given[n];
        if (argument == "--json")
            options.json = true;
        else if (argument == "--gl" && n + 1 < count)
            options.gl = given[++n];
        else if (argument == "--frames" && n + 1 < count)
            options.frames = static_cast<int>(std::strtol(given[++n], nullptr, 10));
        else if (argument[0] != '-')
            databases.push_back(argument);
        else
            options.fault = "'" + argument + "' is not understood";
    }
    if (options.frames < 1 || options.frames > 10'000) options.fault = "--frames wants a number from 1 to 10000";
    if (databases.size() != 0 && databases.size() != 2) options.fault = "give a small and a large database, or none";
    if (databases.size() == 2) {
        options.small = databases[0];
        options.large = databases[1];
    }
    return options;
}

}  // namespace

int main(int count, char** given) {
    const Options options = options_of(count, given);
    if (options.fault.empty()) try {
            return measure(options);
        } catch (const std::exception& fault) {
            std::fprintf(stderr, "bench_scenarios: %s\n", fault.what());
            return 2;
        }
    std::fprintf(stderr,
                 "bench_scenarios: %s; usage: bench_scenarios [SMALL.tdb LARGE.tdb] [--frames N] [--gl egl|osmesa] [--json]\n",
                 options.fault.c_str());
    return 2;
}
