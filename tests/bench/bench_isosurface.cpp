/// How long the isosurface of a volume of 128 posts a side takes on one core, at once, and the longest step of 32,768 cells when
/// it is spread over frames. `--json` prints the lines as a list.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

#include "tests/bench/bench_result.hpp"
#include "tests/support/scene/surface_topology.hpp"
#include "tests/support/scene/volume_surface.hpp"

namespace {

using namespace tedavis;
using bench::BenchResult;
using scene::IsosurfaceProgress;
using test_support::Volume;

constexpr std::uint32_t kSide = 128;
constexpr int kRuns = 5;
constexpr double kTarget_ms = 150, kStepTarget_ms = 2;
constexpr std::uint64_t kCellsAStep = 32768;
constexpr std::size_t kRoomVertices = 6u << 20, kRoomIndices = 36u << 20;

/// Processor time, so that other programs on the machine do not count; nothing here waits or uses a second thread.
double now_ms() { return static_cast<double>(std::clock()) * 1e3 / CLOCKS_PER_SEC; }

Volume ball() {
    return test_support::sampled_volume(kSide, kSide, kSide,
                                        [](const glm::dvec3& p) { return 50 - glm::length(p - glm::dvec3(63.2, 63.9, 63.4)); });
}

/// Towers with ragged flanks, as of a storm: waves of falling size on a few heaps.
Volume storm() {
    return test_support::sampled_volume(kSide, kSide, kSide, [](const glm::dvec3& p) {
        double value = 0;
        for (int n = 0; n < 6; ++n)
            value += 40 * std::exp(-(std::pow(p.x - 20 - 17 * n, 2) + std::pow(p.y - 30 - 13 * (n * 3 % 6), 2)) / 200.0);
        double size = 9, turn = 0.07;
        for (int n = 0; n < 5; ++n, size *= 0.55, turn *= 2.1)
            value += size * std::sin(turn * (p.x + 1.3 * p.y)) * std::cos(turn * (p.y - 0.7 * p.z)) * std::sin(turn * p.z + n);
        return value - 0.1 * std::abs(p.z - 50);
    });
}

struct Case {
    const char* name;
    Volume volume;
    float level;
};

class Bench {
public:
    Bench() : maker_(kSide, kSide), vertices_(kRoomVertices), indices_(kRoomIndices) {}

    void measure(const Case& measured, std::vector<BenchResult>& lines) {
        double whole_ms = 1e300, longest_ms = 1e300;
        for (int run = 0; run < kRuns; ++run) {
            whole_ms = std::min(whole_ms, build(measured, ~std::uint64_t{0}).total_ms);
            longest_ms = std::min(longest_ms, build(measured, kCellsAStep).longest_step_ms);
        }
        const std::string name = measured.name + (", " + std::to_string(maker_.builder.counts().indices / 3)) + " triangles";
        const bool right = is_right();
        lines.push_back({name + ": surface", whole_ms, "ms", kTarget_ms, right && whole_ms <= kTarget_ms, kTarget_ms});
        lines.push_back(
            {name + ": longest step", longest_ms, "ms", kStepTarget_ms, right && longest_ms <= kStepTarget_ms, whole_ms});
    }

private:
    struct Times {
        double total_ms = 0, longest_step_ms = 0;
    };

    Times build(const Case& measured, std::uint64_t cells) {
        Times times;
        const double begin = now_ms();
        is_complete_ =
            maker_.builder.begin(measured.volume.view(), measured.level, {vertices_, indices_}) == scene::IsosurfaceError::none;
        IsosurfaceProgress progress = IsosurfaceProgress::more;
        while (progress == IsosurfaceProgress::more) {
            const double step_begin = now_ms();
            progress = maker_.builder.step(cells);
            times.longest_step_ms = std::max(times.longest_step_ms, now_ms() - step_begin);
        }
        times.total_ms = now_ms() - begin;
        is_complete_ = is_complete_ && progress == IsosurfaceProgress::done;
        return times;
    }

    [[nodiscard]] bool is_right() const {
        const scene::IsosurfaceCounts& counts = maker_.builder.counts();
        const std::vector<std::uint32_t> made(indices_.begin(), indices_.begin() + counts.indices);
        return is_complete_ && test_support::topology_of(made, counts.vertices).is_oriented_manifold();
    }

    test_support::SurfaceMaker maker_;
    std::vector<scene::IsosurfaceVertex> vertices_;
    std::vector<std::uint32_t> indices_;
    bool is_complete_ = false;
};

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "bench_isosurface: unknown argument '%s'; only --json is known\n", argv[1]);
        return 2;
    }
    Bench bench;
    std::vector<BenchResult> lines;
    bench.measure({"ball", ball(), 0}, lines);
    bench.measure({"storm", storm(), 15}, lines);
    return bench::report(lines, json);
}
