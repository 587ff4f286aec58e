/// How long it takes to say how much of a focus 100,000 elements are: points of a layer by their places, posts of a grid by their
/// values, and the choice of a data focus. `--json` prints the lines as a list.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <random>

#include "render_core/display/planner/foci_plan.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/display/foci_of_test.hpp"

namespace {

using namespace tedavis;
using bench::BenchResult;

constexpr int kRuns = 25;
constexpr std::uint32_t kElements = 100'000;
constexpr double kTarget_ms = 1;

/// Processor time of the best run.
template <class Work>
double best_ms(Work work) {
    double best = 1e300;
    for (int run = 0; run < kRuns; ++run) {
        const std::clock_t start = std::clock();
        work();
        best = std::min(best, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

/// Over a square of so many degrees round 46.8 N 9.8 E.
host_sim::LayerDraft scattered(double side_deg) {
    host_sim::LayerDraft layer;
    layer.name = "towns";
    layer.role = scene::LayerRole::place;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> off(-side_deg / 2, side_deg / 2);
    for (std::uint32_t n = 0; n < kElements; ++n) {
        const double latitude = 46.8 + off(random), longitude = 9.8 + off(random);
        layer.points.push_back({base::radians(latitude), base::radians(longitude), 0, 0, scene::kNoTime});
    }
    return layer;
}

host_sim::LayerDraft gusts() {
    host_sim::LayerDraft layer;
    layer.name = "gusts";
    layer.shape = scene::LayerShape::grid;
    layer.grid = {base::radians(9.3), base::radians(47.3), base::radians(0.0025), base::radians(0.004), 400, 250, 1, 1};
    host_sim::AttributeDraft gust;
    gust.name = "gust";
    std::mt19937 random(2);
    std::uniform_real_distribution<float> value(0, 40);
    for (std::uint32_t n = 0; n < kElements; ++n) gust.values.push_back(value(random));
    layer.attributes.push_back(gust);
    return layer;
}

/// The same by ECEF, place by place, as the region itself says.
std::uint32_t in_focus_by_region(const draw::FrameFoci& foci, const scene::Layer& layer) {
    std::uint32_t count = 0;
    for (const scene::ScenePoint& point : layer.points)
        count +=
            scene::ground_focus_degree(foci.regions, earth::to_ecef({point.latitude_rad, point.longitude_rad, {0}})) >= 1 ? 1 : 0;
    return count;
}

BenchResult by_place(const char* name, double side_deg, const char* focus) {
    test_support::ElementOfTest element(scattered(side_deg));
    const test_support::FociOfTest foci({focus});
    const draw::ElementInput input = element.input();
    const draw::LayerFoci layer(&foci.frame(), input.layer, 0, false);
    draw::FocusCounts counts;
    const double ms = best_ms([&] { counts = draw::count_in_focus(foci.frame(), 0, layer, input); });
    std::uint32_t expected = 0;
    const double baseline = best_ms([&] { expected = in_focus_by_region(foci.frame(), input.layer); });
    return {name, ms, "ms", kTarget_ms, counts.in_focus == expected && ms <= kTarget_ms, baseline};
}

BenchResult by_value() {
    test_support::ElementOfTest element(gusts());
    const test_support::LoadedScene scene(gusts());
    test_support::FociOfTest foci({R"(shape = "data", layer = "gusts", attribute = "gust", interval = [20, 25], similar = 5)"},
                                  &scene.scene());
    const draw::ElementInput input = element.input();
    const draw::LayerFoci layer(&foci.frame(), input.layer, 0, false);
    draw::FocusCounts counts;
    const double ms = best_ms([&] { counts = draw::count_in_focus(foci.frame(), 0, layer, input); });
    const bool is_whole = counts.in_focus + counts.intermediate + counts.context == kElements;
    return {"100,000 values, in an interval or similar", ms, "ms", kTarget_ms, is_whole && ms <= kTarget_ms, kTarget_ms};
}

BenchResult choice() {
    const test_support::LoadedScene scene(gusts());
    test_support::FociOfTest foci({R"(shape = "data", layer = "gusts", attribute = "gust", extreme = "highest", within = 0.01)"},
                                  &scene.scene());
    const double ms = best_ms([&] { foci.plan_again(&scene.scene()); });
    return {"the highest of 100,000 values and where they are", ms,        "ms", kTarget_ms,
            foci.region().is_valid && ms <= kTarget_ms,         kTarget_ms};
}

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "bench_focus: unknown argument '%s'; only --json is known\n", argv[1]);
        return 2;
    }
    const char* const kCircle = R"(at = "position", position_deg = [46.8, 9.8], radius_m = 5000, context.width_m = 10000)";
    const char* const kWide = R"(at = "position", position_deg = [46.8, 9.8], radius_m = 50000, context.width_m = 50000)";
    const char* const kPath = R"(shape = "path", ahead_s = 600, radius_m = 2000)";
    return bench::report(
        {by_place("100,000 places over 110 km, a circle", 1, kCircle), by_place("100,000 places over 110 km, a path", 1, kPath),
         by_place("100,000 places, all near a circle", 1, kWide), by_value(), choice()},
        json);
}
