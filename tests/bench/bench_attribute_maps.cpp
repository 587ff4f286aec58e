/// How long the attribute maps of a post take on one core, all channels, horizons and codes. `--json` prints the lines as a
/// list.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/attributes/attribute_maps.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/terrain/attribute_terrain.hpp"
#include "tests/support/terrain/fractal_square.hpp"

namespace {

using namespace tedavis;
using namespace tedavis::host_sim;
using bench::BenchResult;

constexpr int kRuns = 7;
constexpr double kTarget_ns = 1500;

/// Processor time, so that other programs on the machine do not count; nothing here waits or uses a second thread.
template <class Work>
double best_seconds(Work work) {
    double best = 1e300;
    for (int run = 0; run < kRuns; ++run) {
        const std::clock_t start = std::clock();
        work();
        best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

AttributeTile tile_of(const test_support::FractalSquare& terrain, int side, double cell_m) {
    return test_support::make_tile(side, side, 0.7 * cell_m, cell_m, [&](int i, int j) {
        return terrain.at(static_cast<std::uint32_t>(i + kAttributeApron), static_cast<std::uint32_t>(j + kAttributeApron));
    });
}

BenchResult measure(const test_support::FractalSquare& terrain, int side, bool level_below_follows) {
    const AttributeTile above = tile_of(terrain, side / 2, 60), tile = tile_of(terrain, side, 30);
    const FarHorizons far = make_far_horizons(HeightPlanes(above), {});
    bool whole = false;
    const double seconds = best_seconds([&] {
        const TileAttributes made = make_attributes(tile, {}, test_support::view_of(far), level_below_follows);
        whole = made.maps.rgba[0].size() == std::size_t{4} * static_cast<std::size_t>(side * side);
    });
    const double ns = seconds * 1e9 / (static_cast<double>(side) * side);
    const std::string name =
        "attribute maps, tile of " + std::to_string(side) + (level_below_follows ? ", with far horizons" : "");
    return {name, ns, "ns/post", kTarget_ns, whole && ns <= kTarget_ns, kTarget_ns};
}

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "bench_attribute_maps: unknown argument '%s'; only --json is known\n", argv[1]);
        return 2;
    }
    const test_support::FractalSquare terrain = test_support::fractal_square(512 + 2 * kAttributeApron, 1);
    std::vector<BenchResult> lines;
    for (const int side : {128, 256, 512})
        for (const bool level_below_follows : {false, true}) lines.push_back(measure(terrain, side, level_below_follows));
    return bench::report(lines, json);
}
