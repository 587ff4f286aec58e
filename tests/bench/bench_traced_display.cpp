/// Whole frames of the display with terrain by rays beside the same with triangles: the shipped design on device es3-mid at
/// 1024 x 768, on the processor's own OpenGL and two threads. In turns, each of another heading; planned, drawn and finished.
/// `bench_traced_display [X.tdb...] [--json]`: databases beside the shipped terrain, seen from three heights in four directions.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "host_sim/scenario/posed_aircraft.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "platform/files/file_byte_source.hpp"
#include "platform/threads/thread_workers.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/flights/default_flight.hpp"

namespace {

using namespace tedavis;

constexpr std::uint32_t kWidth = 1024, kHeight = 768, kThreads = 2;
constexpr int kIterations = 15;
constexpr double kTurn_deg = 0.2;
constexpr double kMinRate = 40;  // frames/s, by rays

double median(std::vector<double> ms) {
    std::nth_element(ms.begin(), ms.begin() + static_cast<std::ptrdiff_t>(ms.size() / 2), ms.end());
    return ms[ms.size() / 2];
}

double spent_ms(const std::function<void()>& work) {
    const base::Time start = platform::monotonic_now();
    work();
    return (platform::monotonic_now() - start).to_seconds() * 1000;
}

struct Measured {
    double raster_ms = 0, trace_ms = 0;
    std::uint64_t posts_bytes = 0;
};

/// One database on two displays.
class Bench {
public:
    explicit Bench(base::ByteSource& terrain) : workers_(std::move(platform::make_thread_workers({kThreads, nullptr}).value())) {
        for (const design::TerrainRenderer renderer : {design::TerrainRenderer::raster, design::TerrainRenderer::trace}) {
            design::DesignSettings design = test_support::shipped_design("default");
            design.terrain.renderer = renderer;
            std::unique_ptr<test_support::HeadlessDisplay>& display = displays_[static_cast<std::size_t>(renderer)];
            start_ms_[static_cast<std::size_t>(renderer)] = spent_ms([&] {
                display = std::make_unique<test_support::HeadlessDisplay>("egl", test_support::shipped_device("es3-mid"), kWidth,
                                                                          kHeight, &terrain, design, test_support::as_it_is,
                                                                          nullptr, nullptr, workers_.get());
            });
            display->surface().release_current();
        }
    }
    ~Bench() {
        for (auto& display : displays_) {
            make_current(*display);
            display.reset();
        }
    }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    [[nodiscard]] double start_ms(design::TerrainRenderer of) const { return start_ms_[static_cast<std::size_t>(of)]; }
    [[nodiscard]] terrain::FileHeader header() {
        const terrain::TerrainDatabase* const database = displays_[0]->display().planner().terrain_database();
        if (database == nullptr) throw std::runtime_error("the display has no terrain");
        return database->header();
    }

    Measured measure(host_sim::AircraftPose pose) {
        std::vector<double> ms[2];
        for (int iteration = 0; iteration < kIterations; ++iteration, pose.heading_deg += kTurn_deg)
            for (std::size_t n = 0; n < 2; ++n) ms[n].push_back(frame_ms(*displays_[n], pose));
        display::Display& traced = displays_[1]->display();
        if (traced.record().terrain.renderer.view() != "trace")
            throw std::runtime_error("the terrain was not traced: " +
                                     std::string(traced.record().terrain.renderer_reason.view()));
        return {median(ms[0]), median(ms[1]), traced.planner().budget().find(effects::kTracedTerrain)->use.in_use};
    }

private:
    static void make_current(test_support::HeadlessDisplay& headless) {
        if (!headless.make_current()) throw std::runtime_error("the surface cannot be made current");
    }
    static double frame_ms(test_support::HeadlessDisplay& headless, const host_sim::AircraftPose& pose) {
        make_current(headless);
        display::Display& display = headless.display();
        const flight::AircraftState aircraft = host_sim::posed_aircraft(pose, display);
        display::settle(display, {aircraft, {}, host_sim::kPosedTime});
        const double ms = spent_ms([&] {
            display.plan({aircraft, {}, host_sim::kPosedTime});
            display.draw(headless.surface());
            display.gl()->Finish();
        });
        headless.surface().release_current();
        return ms;
    }

    std::unique_ptr<base::Workers> workers_;
    std::unique_ptr<test_support::HeadlessDisplay> displays_[2];
    double start_ms_[2] = {};
};

void measure_terrain(const std::string& name, base::ByteSource& terrain, std::vector<bench::BenchResult>& lines) {
    Bench bench(terrain);
    const terrain::FileHeader header = bench.header();
    const double latitude = header.north_deg - 0.5 * header.step_lat_deg * header.rows,
                 longitude = header.west_deg + 0.5 * header.step_lon_deg * header.columns;
    double slowest = 0;
    Measured measured;
    for (const double above_m : {150.0, 600.0, 2400.0})
        for (const double heading_deg : {30.0, 120.0, 210.0, 300.0}) {
            const host_sim::AircraftPose pose{latitude,    longitude, double(header.max_height_m) + above_m,
                                              heading_deg, -5,        heading_deg == 120 ? 15.0 : 0};
            measured = bench.measure(pose);
            slowest = std::max(slowest, measured.trace_ms);
            char text[120];
            std::snprintf(text, sizeof text, "%s %.0f m %03.0f: frame by rays", name.c_str(), pose.altitude_msl_m, heading_deg);
            lines.push_back({text, measured.trace_ms, "ms", 1000 / kMinRate, true, measured.raster_ms});
        }
    lines.push_back({name + ": slowest by rays", 1000 / slowest, "frames/s", kMinRate, 1000 / slowest >= kMinRate, 0});
    lines.push_back(
        {name + ": memory of the processor", static_cast<double>(measured.posts_bytes) / 1048576, "MiB", 96, true, 0});
    const double started = bench.start_ms(design::TerrainRenderer::trace);
    lines.push_back({name + ": start", started, "ms", started, true, bench.start_ms(design::TerrainRenderer::raster)});
}

}  // namespace

int main(int count, char** given) {
    bool json = false;
    std::vector<bench::BenchResult> lines;
    std::vector<std::string> files;
    for (int n = 1; n < count; ++n)
        if (std::strcmp(given[n], "--json") == 0)
            json = true;
        else if (given[n][0] != '-')
            files.emplace_back(given[n]);
        else {
            std::fprintf(stderr, "bench_traced_display: unknown argument '%s'; databases and --json are known\n", given[n]);
            return 2;
        }
    try {
        test_support::DefaultTerrain shipped;
        measure_terrain("default", shipped.bytes, lines);
        for (const std::string& file : files) {
            auto opened = platform::open_file(file.c_str());
            if (!opened.ok()) throw std::runtime_error(opened.error().message.c_str());
            measure_terrain(std::filesystem::path(file).stem(), opened.value(), lines);
        }
    } catch (const std::exception& fault) {
        std::fprintf(stderr, "bench_traced_display: %s\n", fault.what());
        return 2;
    }
    return bench::report(lines, json);
}
