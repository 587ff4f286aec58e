/// Traced pictures through the token stream, as chapter 6.2 of the thesis measured its own: table 6.2 in form (three terrains of
/// 512 x 512 posts, geometry basic or in detail, light static or dynamic; two workers here, a GTX 780 there, net of its 65 ms for
/// the stream), what the stream costs beyond direct calls of the same functions, and figure 6.10 in form (time and speed-up
/// against workers and block size). 1920 x 1080 pixels. Lines without a limit hold where pictures are right. `--json` prints the
/// lines as a list.
#include <chrono>
#include <cstring>
#include <ctime>
#include <memory>

#include "platform/threads/thread_workers.hpp"
#include "render_core/raytrace/picture/trace_presets.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/raytrace/drawn_trace.hpp"

namespace {

using namespace tedavis;
using bench::BenchResult;
using test_support::DrawnTrace;
using Posts = test_support::HeightField<std::int16_t>;

constexpr int kRuns = 9;
constexpr std::uint32_t kSide = 512, kWidth = 1920, kHeight = 1080;
constexpr double kMaxOverhead = 1.05;

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double wall_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

std::unique_ptr<base::Workers> threads(std::uint32_t count) {
    auto made = platform::make_thread_workers({count, nullptr});
    return made ? std::move(made.value()) : nullptr;
}

/// A single mountain with gullies, as a volcano.
Posts cone_heights() {
    Posts posts = test_support::fractal_heights(kSide, 2);
    const double most = 0.15 * kSide * test_support::steps_a_cell(kSide);
    for (std::uint32_t row = 0; row < kSide; ++row)
        for (std::uint32_t column = 0; column < kSide; ++column) {
            const double far = std::hypot(column - 300.0, row - 300.0) / kSide;
            const double height = most * std::exp(-6 * far) + 0.2 * posts.at(column, row);
            posts.at(column, row) = static_cast<std::int16_t>(std::lround(height));
        }
    return posts;
}

/// Sharp ridges: noise folded at its middle.
Posts ridged_heights() {
    Posts posts = test_support::fractal_heights(kSide, 3);
    const double middle = 0.075 * kSide * test_support::steps_a_cell(kSide);
    for (std::int16_t& post : posts.posts) post = static_cast<std::int16_t>(2 * (middle - std::abs(post - middle)) * 0.9);
    return posts;
}

/// Bilinear posts and Phong's light; in detail, four small cells to a post's side with bicubic places and noise; dynamic light
/// moves with the sun, through apertures.
std::vector<raytrace::TraceSettings> table_settings() {
    std::vector<raytrace::TraceSettings> all(4);
    for (std::uint32_t n = 0; n < 4; ++n) {
        all[n].surface.kind = raytrace::SurfaceKind::bilinear;
        all[n].shading = raytrace::Shading::phong;
        if (n % 2 == 1) all[n].ambient = raytrace::Ambient::apertures;
        if (n < 2) continue;
        all[n].is_surface_stored = true;
        all[n].surface.kind = raytrace::SurfaceKind::approximate_bicubic;
        all[n].surface.micro.kind = raytrace::MicroKind::noise;
        all[n].surface.micro.noise.amplitude = 0.1 * test_support::steps_a_cell(kSide);
    }
    return all;
}

struct TableTerrain {
    const char* name;
    Posts posts;
    double net_ms[4];  ///< of the thesis, for a terrain of its own
};

/// The sun goes on from picture to picture where light is dynamic.
void move_sun(DrawnTrace& drawn, int run) {
    const double turn = 0.1 * run;
    drawn.look.sun.towards = glm::normalize(glm::dvec3(std::cos(turn), std::sin(turn), 0.6));
}

std::vector<BenchResult> table_rows(const TableTerrain& terrain) {
    DrawnTrace drawn(terrain.posts, table_settings(), kWidth, kHeight);
    const auto workers = threads(2);
    const char* const rows[] = {"basic, static", "basic, dynamic", "detail, static", "detail, dynamic"};
    std::vector<BenchResult> results;
    for (std::uint32_t n = 0; n < 4 && workers != nullptr; ++n) {
        std::vector<double> ms;
        bool is_drawn = true;
        for (int run = 0; run <= kRuns; ++run) {
            if (n % 2 == 1) move_sun(drawn, run);
            const double start = wall_ms();
            is_drawn = drawn.draw(*workers, n) && is_drawn;
            if (run > 0) ms.push_back(wall_ms() - start);
        }
        const double middle = median(ms), theirs = terrain.net_ms[n];
        results.push_back(
            {std::string(terrain.name) + ", " + rows[n], middle, "ms", theirs, is_drawn && middle < theirs, theirs});
    }
    return results;
}

/// Runs alternate, so that both meet the same machine; processor time, one worker.
std::vector<BenchResult> overhead_rows(const Posts& posts) {
    DrawnTrace direct(posts, table_settings(), kWidth, kHeight), stream(posts, table_settings(), kWidth, kHeight);
    base::SerialWorkers alone;
    std::vector<BenchResult> results;
    for (const std::uint32_t n : {0u, 3u}) {
        std::vector<double> ratios;
        bool is_right = true;
        for (int run = 0; run <= kRuns; ++run) {
            const double start = processor_ms();
            direct.draw_directly(alone, n);
            const double middle = processor_ms();
            is_right = stream.draw(alone, n) && is_right;
            if (run > 0) ratios.push_back((processor_ms() - middle) / (middle - start));
        }
        is_right = is_right && DrawnTrace::is_same(direct.light(), stream.light()) && direct.rgb == stream.rgb;
        const double ratio = median(ratios);
        results.push_back({n == 0 ? "stream, of direct calls: basic, static" : "stream, of direct calls: detail, dynamic", ratio,
                           "x", kMaxOverhead, is_right && ratio <= kMaxOverhead, 1});
    }
    return results;
}

/// Wall time; the baseline is that of direct calls by as many workers, which says what the machine has to give.
std::vector<BenchResult> figure_rows(const Posts& posts, std::uint32_t block_words) {
    raytrace::StreamSettings settings;
    settings.block_words = block_words;
    const std::vector<raytrace::TraceSettings> detail = {table_settings()[3]};
    DrawnTrace direct(posts, detail, kWidth, kHeight), stream(posts, detail, kWidth, kHeight, settings);
    std::vector<BenchResult> results;
    double alone_ms = 0, direct_alone_ms = 0;
    for (const std::uint32_t count : {1u, 2u, 3u, 4u, 7u}) {
        const auto workers = threads(count);
        if (workers == nullptr) return {};
        std::vector<double> direct_ms, stream_ms;
        bool is_right = true;
        for (int run = 0; run < kRuns; ++run) {
            const double start = wall_ms();
            direct.draw_directly(*workers);
            const double middle = wall_ms();
            is_right = stream.draw(*workers) && is_right;
            direct_ms.push_back(middle - start);
            stream_ms.push_back(wall_ms() - middle);
        }
        is_right = is_right && direct.rgb == stream.rgb;
        const double ms = median(stream_ms), by_calls = median(direct_ms);
        if (count == 1) {
            alone_ms = ms;
            direct_alone_ms = by_calls;
        }
        const std::string name = "blocks of " + std::to_string(block_words) + ", workers " + std::to_string(count);
        const double own = alone_ms / ms, possible = direct_alone_ms / by_calls;
        results.push_back({name, ms, "ms", by_calls, is_right, by_calls});
        results.push_back({name + ": speed-up", own, "x", possible, is_right, possible});
    }
    return results;
}

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "bench_trace_picture: unknown argument '%s'; only --json is known\n", argv[1]);
        return 2;
    }
    std::vector<BenchResult> results;
    const auto take = [&](const std::vector<BenchResult>& some) { results.insert(results.end(), some.begin(), some.end()); };
    const TableTerrain terrains[] = {{"noise", test_support::fractal_heights(kSide), {34.5, 36.1, 71.5, 71.9}},
                                     {"cone", cone_heights(), {34.6, 34.7, 71.6, 72.0}},
                                     {"ridges", ridged_heights(), {34.1, 35.0, 71.4, 71.6}}};
    for (const TableTerrain& terrain : terrains) take(table_rows(terrain));
    take(overhead_rows(terrains[2].posts));
    for (const std::uint32_t block : {64u, 512u, 4096u}) take(figure_rows(terrains[2].posts, block));
    return bench::report(results, json);
}
