/// What the operators and the approximate modes of the tracer cost and how far they are off, one ray after the other on one core:
/// surfaces, searches, maps made at start. Ratios are of the same run. `--json` prints the lines as a list.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "render_core/raytrace/search/cone_map.hpp"
#include "render_core/raytrace/search/search_surface.hpp"
#include "render_core/raytrace/shading/sky_map.hpp"
#include "render_core/raytrace/surface/average_mipmap.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/raytrace/surface_scene.hpp"

namespace {

using namespace tedavis;
using namespace tedavis::raytrace;
using bench::BenchResult;
using test_support::Dice;
using test_support::SurfaceScene;

constexpr std::uint32_t kSide = 513;
constexpr int kRays = 20000, kRuns = 7;

template <class Work>
double best_seconds(Work work) {
    double best = 1e300;
    for (int n = 0; n < kRuns; ++n) {
        const std::clock_t start = std::clock();
        work();
        best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

/// `target` is the most that the value may be; 0 asks for nothing.
BenchResult line(const std::string& name, double value, const char* unit, double target = 0) {
    return {name, value, unit, target, target == 0 || value <= target, 0};
}

/// From above the ground at the border towards the horizon.
std::vector<Ray> horizon_rays(const test_support::HeldHeights<std::int16_t>& heights) {
    std::vector<Ray> rays;
    Dice dice(3);
    while (rays.size() < kRays) {
        Ray ray;
        ray.origin = {0, dice.between(0, kSide - 1.0), dice.between(190, 230)};
        ray.direction = glm::vec3(1, dice.between(-0.4, 0.4), dice.between(-0.25, -0.02));
        SurfacePoint ground;
        if (find_surface(heights.grid(), {}, 0, ray.origin.y, ground) && ground.height < ray.origin.z) rays.push_back(ray);
    }
    return rays;
}

struct Measured {
    std::vector<SurfaceHit> hits;
    double ns_a_ray = 0;
};

template <class Trace>
Measured measured(const std::vector<Ray>& rays, Trace trace) {
    Measured result;
    result.hits.resize(rays.size());
    const double seconds = best_seconds([&] {
        for (std::size_t n = 0; n < rays.size(); ++n) result.hits[n] = trace(rays[n]);
    });
    result.ns_a_ray = seconds * 1e9 / static_cast<double>(rays.size());
    return result;
}

/// Off by more than a cell, or missed.
double wrong_percent(const Measured& exact, const Measured& other) {
    int wrong = 0;
    for (std::size_t n = 0; n < exact.hits.size(); ++n) {
        const SurfaceHit &a = exact.hits[n], &b = other.hits[n];
        const bool is_hit = a.side != HitSide::none;
        wrong += is_hit != (b.side != HitSide::none) || (is_hit && std::abs(a.t - b.t) > 1) ? 1 : 0;
    }
    return 100.0 * wrong / static_cast<double>(exact.hits.size());
}

using Heights = test_support::HeldHeights<std::int16_t>;

void measure_surfaces(const Heights& heights, const std::vector<Ray>& rays, std::vector<BenchResult>& results) {
    const char* const names[] = {"two triangles", "bilinear", "bicubic", "approximate bicubic (4)"};
    for (std::size_t n = 0; n < 4; ++n) {
        SurfaceScene<std::int16_t> scene(heights, test_support::kSurfaceKinds[n]);
        base::SerialWorkers alone;
        const double build = best_seconds([&] { scene.maxima.build(alone); });
        const std::string name = names[n];
        results.push_back(line(name + ": bounds", build * 1e9 / (double{kSide} * kSide), "ns a sample"));
        results.push_back(
            line(name + ": exact", measured(rays, [&](const Ray& ray) { return scene.trace(ray); }).ns_a_ray, "ns a ray"));
    }
}

void measure_bounds(const Heights& heights, std::vector<BenchResult>& results) {
    SurfaceSettings settings;
    settings.kind = SurfaceKind::bicubic;
    double slack = 0, most_above = 0;
    int cells = 0, above = 0;
    for (std::uint32_t row = 0; row + 1 < kSide; row += 3)
        for (std::uint32_t column = 0; column + 1 < kSide; column += 3, ++cells) {
            const CellPatch patch = cell_patch(heights.grid(), settings, column, row);
            double top = -1e9, posts = -1e9;
            for (int v = 0; v <= 16; ++v)
                for (int u = 0; u <= 16; ++u) top = std::max(top, patch.at(u / 16.0, v / 16.0).height);
            for (std::uint32_t k = 0; k < 4; ++k)
                posts = std::max(posts, static_cast<double>(heights.grid().at(column + k % 2, row + k / 2)));
            slack += patch.range().highest - top;
            above += top > posts ? 1 : 0;
            most_above = std::max(most_above, top - posts);
        }
    results.push_back(line("bicubic: bound above the patch", slack / cells, "height steps"));
    results.push_back(line("bicubic: cells above their four posts", 100.0 * above / cells, "%"));
    results.push_back(line("bicubic: most above its four posts", most_above, "height steps"));
    for (const std::uint32_t parts : {1u, 2u, 4u, 8u, 16u}) {
        SurfaceSettings near;
        near.kind = SurfaceKind::approximate_bicubic;
        near.subdivisions = parts;
        Dice dice(1);
        double sum = 0;
        constexpr int kPlaces = 50000;
        for (int n = 0; n < kPlaces; ++n) {
            const std::uint32_t column = dice.below(kSide - 1), row = dice.below(kSide - 1);
            const double u = dice.unit(), v = dice.unit();
            const double off = cell_patch(heights.grid(), near, column, row).at(u, v).height -
                               cell_patch(heights.grid(), settings, column, row).at(u, v).height;
            sum += off * off;
        }
        results.push_back(
            line("approximate bicubic (" + std::to_string(parts) + "): rms", std::sqrt(sum / kPlaces), "height steps"));
    }
}

void measure_searches(const Heights& heights, const std::vector<Ray>& rays, std::vector<BenchResult>& results) {
    const SurfaceScene<std::int16_t> scene(heights, SurfaceKind::bilinear);
    const Measured exact = measured(rays, [&](const Ray& ray) { return scene.trace(ray); });
    const auto add = [&](const std::string& name, const Measured& found, double target = 0) {
        results.push_back(line(name + ": wrong rays", wrong_percent(exact, found), "%", target));
        results.push_back(line(name + ": time", found.ns_a_ray / exact.ns_a_ray, "x exact"));
    };
    for (const std::uint32_t steps : {64u, 256u, 1024u, 4096u})
        add("whole ray, " + std::to_string(steps) + " steps", measured(rays, [&](const Ray& ray) {
                return search_ray(heights.grid(), scene.settings, ray, {steps, 12});
            }));
    for (const std::uint32_t steps : {1u, 2u, 4u})
        add("in cells, " + std::to_string(steps) + " steps",
            measured(rays,
                     [&](const Ray& ray) {
                         return search_cells(scene.maxima, scene.settings, ray, {steps, 12});
                     }),
            steps >= 4 ? 0.02 : 0);
    for (const bool is_relaxed : {true, false}) {
        std::vector<unsigned char> memory(ConeMap<std::int16_t>::bytes_needed(kSide, kSide));
        base::Arena arena(memory.data(), memory.size());
        ConeMap<std::int16_t> cones;
        if (!cones.start(heights.grid(), {16, 16, is_relaxed}, arena)) return;
        base::SerialWorkers alone;
        const std::clock_t start = std::clock();
        cones.build(alone);
        const double us = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC * 1e6;
        const std::string name = is_relaxed ? "relaxed cones" : "narrow cones";
        results.push_back(line(name + ": map", us / (kSide * kSide), "us a post"));
        for (const std::uint32_t steps : {32u, 96u, 400u})
            add(name + ", " + std::to_string(steps) + " steps", measured(rays, [&](const Ray& ray) {
                    return cones.search(ray, {steps, 16});
                }));
    }
}

void measure_maps(const Heights& heights, std::vector<BenchResult>& results) {
    base::SerialWorkers alone;
    std::vector<unsigned char> memory(SkyMap<std::int16_t>::bytes_needed(kSide, kSide, true));
    base::Arena arena(memory.data(), memory.size());
    SkyMapSettings settings;
    settings.scale = {30, 30, 1};
    settings.has_apertures = true;
    SkyMap<std::int16_t> sky;
    if (!sky.start(heights.grid(), settings, arena)) return;
    const std::clock_t start = std::clock();
    sky.build(alone);
    results.push_back(line("sky view and apertures, 16 x 64",
                           static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC * 1e6 / (kSide * kSide), "us a post"));
    std::vector<unsigned char> more(AverageMipmap<std::int16_t>::bytes_needed(kSide, kSide));
    base::Arena room(more.data(), more.size());
    AverageMipmap<std::int16_t> averages;
    if (!averages.start(heights.grid(), room)) return;
    results.push_back(
        line("average mipmap", best_seconds([&] { averages.build(alone); }) * 1e9 / (kSide * kSide), "ns a sample"));
    results.push_back(line("average mipmap: memory", static_cast<double>(more.size()) / (kSide * kSide), "bytes a sample"));
}

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "bench_trace_operators: unknown argument '%s'; only --json is known\n", argv[1]);
        return 2;
    }
    const Heights heights = test_support::hilly_heights<std::int16_t>(kSide, kSide, 4, 300);
    const std::vector<Ray> rays = horizon_rays(heights);
    std::vector<BenchResult> results;
    measure_surfaces(heights, rays, results);
    measure_bounds(heights, results);
    measure_searches(heights, rays, results);
    measure_maps(heights, results);
    return bench::report(results, json);
}
