/// What drawing terrain costs over drawing its bare triangles: device es3-mid at 1024 x 768 on the processor's own OpenGL.
/// The floor of a view are the triangles that the display selects for it, positions only, one colour, back faces culled, on a
/// cleared surface. In the same run, in turns: the floor, the terrain pass, the frame of the shipped design with its sketch,
/// tints and sky, and the same with its symbology.
/// `bench_terrain_frame [X.tdb...] [--json]`: databases beside the shipped terrain, seen from three heights in four directions.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host_sim/scenario/posed_aircraft.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "platform/files/file_byte_source.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/bench/bare_triangles.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/flights/default_flight.hpp"
#include "tests/support/terrain/drawn_terrain.hpp"
#include "tests/support/terrain/terrain_on_surface.hpp"

namespace {

using namespace tedavis;

constexpr std::uint32_t kWidth = 1024, kHeight = 768;
constexpr int kIterations = 21;
constexpr double kMaxPass = 1.15, kMaxFrame = 1.5;  // of the floor
constexpr double kMinRate = 60;                     // frames/s
constexpr std::uint32_t kMaxTriangles = 120'000;    // up to which the rate must hold

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
    std::uint32_t triangles = 0;
    double tau_px = 0;
    std::uint32_t submitted = 0;  ///< by the frame, which draws what lies on both sides of a depth range twice
    double floor_ms = 0, pass_ms = 0, plan_ms = 0, scene_ms = 0, frame_ms = 0;
};

/// One database on three surfaces.
class Bench {
public:
    explicit Bench(base::ByteSource& terrain)
        : design_(test_support::shipped_design("default")),
          bare_(kDevice, kWidth, kHeight),
          alone_(kDevice, kWidth, kHeight, terrain, design_),
          mesh_(terrain),
          display_("egl", kDevice, kWidth, kHeight, &terrain, design_) {
        release_current();
    }
    ~Bench() { make_current(); }
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;

    [[nodiscard]] const terrain::FileHeader& header() const { return mesh_.database().header(); }

    Measured measure(const host_sim::AircraftPose& pose) {
        display::Display& display = display_.display();
        make_current();
        const flight::AircraftState aircraft = host_sim::posed_aircraft(pose, display);
        display::settle(display, {aircraft, {}, host_sim::kPosedTime});
        display.plan({aircraft, {}, host_sim::kPosedTime});
        display.draw(display_.surface());
        release_current();
        look_alone(display.planned().picture.camera.view);
        take_bare(display.planned().picture.camera.view);
        Measured measured{bare_.triangles(), display.record().terrain.tau_reached_px, display.record().terrain.triangles};
        take_turns(aircraft, measured);
        return measured;
    }

private:
    static constexpr const char* kDevice = "es3-mid";

    void make_current() {
        if (!display_.surface().make_current()) throw std::runtime_error("the surface cannot be made current");
        display_.display().gl().activate();
    }
    void release_current() { display_.surface().release_current(); }

    void look_alone(const terrain::View& view) {
        draw::TerrainDrawInput input;
        input.view = view;
        input.haze_per_m = 1 / design_.sky.haze_distance_m;
        for (glm::dvec3& light : input.light_direction) light = glm::normalize(view.eye);
        input.warning_colors = true;
        input.aircraft_msl_m = 1e5;
        display::Camera camera;
        camera.view = view;
        camera.haze_per_m = input.haze_per_m;
        alone_.look(camera, input);
    }

    /// What the display has selected, selected once more.
    void take_bare(const terrain::View& view) {
        const effects::DeviceSettings device = test_support::shipped_device(kDevice);
        terrain::LodSettings lod;
        lod.tau_px = design_.terrain.tau_px;
        lod.max_triangles = device.triangle_budget;
        lod.max_chunks = device.max_chunk_slots * 2 / 3;
        lod.haze_per_m = 1 / design_.sky.haze_distance_m;
        mesh_.select(view, lod);
        if (mesh_.selected().size() != alone_.scene().selected().size())
            throw std::runtime_error("the floor has other triangles than the frame: the comparison would mean nothing");
        bare_.make_current();
        bare_.clear();
        for (const terrain::SelectedChunk& chunk : mesh_.selected()) {
            const terrain::ChunkEntry& entry = *chunk.entry;
            const glm::dvec3 offset = glm::dvec3(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]) - view.eye;
            std::vector<glm::vec3> places;
            for (const terrain::ChunkVertex& v : mesh_.vertices(chunk)) places.emplace_back(offset + glm::dvec3(v.x, v.y, v.z));
            const std::vector<std::uint16_t>& corners = mesh_.indices(chunk);
            bare_.add(places, {corners.data(), corners.size()});
        }
        bare_.release_current();
    }

    void draw_finished() {
        display_.display().draw(display_.surface());
        display_.display().gl()->Finish();
    }

    void take_turns(const flight::AircraftState& aircraft, Measured& measured) {
        display::Display& display = display_.display();
        const double far_m = std::fmax(alone_.scene().farthest_depth_m(display.planned().picture.camera.view),
                                       2 * display.planned().picture.camera.view.near_m);
        const terrain::View view = display.planned().picture.camera.view;
        std::vector<double> floor, pass, plan, scene, frame;
        for (int iteration = 0; iteration < kIterations; ++iteration) {
            bare_.make_current();
            floor.push_back(spent_ms([&] {
                bare_.draw(display.planned().picture.camera.view, {display.planned().picture.camera.view.near_m, far_m});
            }));
            bare_.release_current();
            alone_.make_current();
            pass.push_back(spent_ms([&] { alone_.draw(); }));
            alone_.release_current();
            make_current();
            plan.push_back(spent_ms([&] { display.plan({aircraft, {}, host_sim::kPosedTime}); }));
            frame.push_back(plan.back() + spent_ms([&] { draw_finished(); }));
            display.planner().set_free_view(view);
            scene.push_back(spent_ms([&] {
                                display.plan({aircraft, {}, host_sim::kPosedTime});
                            }) +
                            spent_ms([&] { draw_finished(); }));
            display.planner().clear_free_view();
            release_current();
        }
        measured.floor_ms = median(floor);
        measured.pass_ms = median(pass);
        measured.plan_ms = median(plan);
        measured.scene_ms = median(scene);
        measured.frame_ms = median(frame);
    }

    design::DesignSettings design_;
    test_support::BareTriangles bare_;
    test_support::TerrainOnSurface alone_;
    test_support::DrawnTerrain mesh_;
    test_support::HeadlessDisplay display_;  // last: goes first, while it is current
};

std::vector<host_sim::AircraftPose> poses_over(const terrain::FileHeader& header) {
    std::vector<host_sim::AircraftPose> poses;
    const double latitude = header.north_deg - 0.5 * header.step_lat_deg * header.rows,
                 longitude = header.west_deg + 0.5 * header.step_lon_deg * header.columns;
    for (const double above_m : {150.0, 600.0, 2400.0})
        for (const double heading_deg : {30.0, 210.0})
            poses.push_back({latitude, longitude, double(header.max_height_m) + above_m, heading_deg, -5, 0});
    return poses;
}

std::string name_of(const std::string& terrain, const host_sim::AircraftPose& pose) {
    char text[120];
    std::snprintf(text, sizeof text, "%s %.0f m %03.0f", terrain.c_str(), pose.altitude_msl_m, pose.heading_deg);
    return text;
}

void measure_terrain(const std::string& name, base::ByteSource& terrain, std::vector<bench::BenchResult>& lines) {
    Bench bench(terrain);
    for (const host_sim::AircraftPose& pose : poses_over(bench.header())) {
        const Measured m = bench.measure(pose);
        const std::string where = name_of(name, pose);
        const bool many = m.triangles > kMaxTriangles, whole = m.tau_px <= 1;
        const double pass = m.pass_ms / m.floor_ms, scene = m.scene_ms / m.floor_ms, rate = 1000 / m.frame_ms;
        lines.push_back({where + ": triangles", double(m.triangles), "triangles", kMaxTriangles, true, kMaxTriangles});
        lines.push_back({where + ": submitted", double(m.submitted), "triangles", kMaxTriangles, true, double(m.triangles)});
        lines.push_back({where + ": tau reached", m.tau_px, "px", 1, whole || many, 1});
        lines.push_back({where + ": floor", m.floor_ms, "ms", m.floor_ms, true, m.floor_ms});
        lines.push_back({where + ": plan", m.plan_ms, "ms", m.floor_ms, m.plan_ms < m.floor_ms, m.floor_ms});
        lines.push_back({where + ": terrain pass / floor", pass, "ratio", kMaxPass, pass <= kMaxPass, 1});
        lines.push_back({where + ": sketch and tints / floor", scene, "ratio", kMaxFrame, scene <= kMaxFrame, 1});
        const double whole_frame = m.frame_ms / m.floor_ms;
        lines.push_back({where + ": with symbology / floor", whole_frame, "ratio", whole_frame, true, 1});
        lines.push_back({where + ": rate", rate, "frames/s", kMinRate, many || rate >= kMinRate, 1000 / m.floor_ms});
    }
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
            std::fprintf(stderr, "bench_terrain_frame: unknown argument '%s'; databases and --json are known\n", given[n]);
            return 2;
        }
    test_support::DefaultTerrain shipped;
    measure_terrain("default", shipped.bytes, lines);
    for (const std::string& file : files) {
        auto opened = platform::open_file(file.c_str());
        if (!opened.ok()) {
            std::fprintf(stderr, "bench_terrain_frame: %s\n", opened.error().message.c_str());
            return 2;
        }
        measure_terrain(std::filesystem::path(file).stem(), opened.value(), lines);
    }
    return bench::report(lines, json);
}
