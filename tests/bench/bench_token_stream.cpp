/// What it costs to draw a picture through a token stream rather than by calling its batch functions: synthetic rays, 16 lanes at
/// once, over 1920 x 1080 pixels. Then time and speed-up against workers and block size, as figure 6.10 of the thesis. Pictures
/// must be equal, bit for bit; lines without a limit hold where they are. `--json` prints the lines as a list.
#include <chrono>
#include <cstring>
#include <ctime>
#include <memory>

#include "platform/threads/thread_workers.hpp"
#include "render_core/raytrace/stream/stream_rewriter.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/raytrace/synthetic_rays.hpp"

namespace {

using namespace tedavis;
using bench::BenchResult;
using test_support::SyntheticRays;

constexpr int kRuns = 9;
constexpr std::uint32_t kPixels = 1920 * 1080, kTiles = kPixels / SyntheticRays::kTilePixels;
constexpr int kLightSteps = 64, kHeavySteps = 128;
constexpr double kMaxOverhead = 1.05;
constexpr std::uint32_t kManyRounds = 1'000'000, kMaxWorkers = 4;

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double wall_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
}

class Stream {
public:
    Stream(std::uint32_t block_words, int steps, std::uint32_t mirrors) : rays_(kPixels, steps), tasks_(rays_) {
        rays_.mirrors = mirrors;
        raytrace::StreamSettings settings;
        settings.block_words = block_words;
        memory_.resize(raytrace::TokenStream::bytes_needed(settings) + raytrace::StreamRewriter::bytes_needed(settings));
        base::Arena arena(memory_.data(), memory_.size());
        is_started_ = stream_.start(settings, arena).ok() && rewriter_.start(stream_, arena).ok();
    }

    bool draw(base::Workers& workers) {
        if (!is_started_ || !raytrace::begin_picture(stream_, tasks_.tasks, kTiles)) return false;
        const raytrace::StreamRewriter::Answer answer = rewriter_.rewrite(tasks_.network, workers, kManyRounds);
        if (!answer.ok()) std::fprintf(stderr, "bench_token_stream: %s\n", answer.error().c_str());
        if (answer.ok()) report_ = answer.value();
        return answer.ok() && answer.value().is_finished;
    }
    [[nodiscard]] const std::vector<float>& picture() const { return rays_.picture; }
    [[nodiscard]] const raytrace::RewriteReport& report() const { return report_; }

private:
    SyntheticRays rays_;
    test_support::SyntheticRayTasks tasks_;
    std::vector<unsigned char> memory_;
    raytrace::TokenStream stream_;
    raytrace::StreamRewriter rewriter_;
    raytrace::RewriteReport report_;
    bool is_started_ = false;
};

constexpr std::uint32_t kTilesOfPart = 100, kParts = kTiles / kTilesOfPart;

/// The same functions without a stream, parts of the picture shared out.
void draw_directly(SyntheticRays& rays, base::Workers& workers) {
    workers.parallel_for(
        kParts,
        [](void* of, std::uint32_t part) {
            for (std::uint32_t n = 0; n < kTilesOfPart; ++n) static_cast<SyntheticRays*>(of)->draw_tile(part * kTilesOfPart + n);
        },
        &rays);
}

/// Runs alternate, so that both meet the same machine; processor time, one worker.
std::vector<BenchResult> overhead(const std::string& what, std::uint32_t block_words, int steps, std::uint32_t mirrors) {
    SyntheticRays direct(kPixels, steps);
    direct.mirrors = mirrors;
    Stream stream(block_words, steps, mirrors);
    base::SerialWorkers workers;
    std::vector<double> direct_ms, stream_ms;
    bool is_right = true;
    for (int run = 0; run <= kRuns; ++run) {
        const double start = processor_ms();
        draw_directly(direct, workers);
        const double middle = processor_ms();
        is_right = stream.draw(workers) && is_right;
        if (run == 0) continue;  // the memory's first touch
        direct_ms.push_back(middle - start);
        stream_ms.push_back(processor_ms() - middle);
    }
    is_right = is_right && direct.picture == stream.picture();
    const double ratio = median(stream_ms) / median(direct_ms);
    const raytrace::RewriteReport& report = stream.report();
    const double full = static_cast<double>(report.counts.calls) / static_cast<double>(report.counts.lanes);
    const double ns_of_pixel = 1e6 / kPixels;
    return {{what + ": a pixel", median(stream_ms) * ns_of_pixel, "ns", median(direct_ms) * ns_of_pixel * kMaxOverhead, is_right,
             median(direct_ms) * ns_of_pixel},
            {what + ": overhead", ratio, "x", kMaxOverhead, is_right && ratio <= kMaxOverhead, 1},
            {what + ": lanes in use", full, "share", 0.8, full >= 0.8, 1}};
}

/// Wall time; the baseline is that of direct calls by as many workers, which says what the machine has to give.
std::vector<BenchResult> speed_up(std::uint32_t block_words) {
    SyntheticRays direct(kPixels, kHeavySteps);
    Stream stream(block_words, kHeavySteps, 0);
    std::vector<BenchResult> results;
    double direct_alone_ms = 0, alone_ms = 0;
    for (std::uint32_t count = 1; count <= kMaxWorkers; ++count) {
        auto workers = platform::make_thread_workers({count, nullptr});
        if (!workers) return {};
        std::vector<double> direct_ms, stream_ms;
        bool is_right = true;
        for (int run = 0; run < kRuns; ++run) {
            const double start = wall_ms();
            draw_directly(direct, *workers.value());
            const double middle = wall_ms();
            is_right = stream.draw(*workers.value()) && is_right;
            direct_ms.push_back(middle - start);
            stream_ms.push_back(wall_ms() - middle);
        }
        is_right = is_right && stream.picture() == direct.picture;
        const double ms = median(stream_ms), by_calls_ms = median(direct_ms);
        if (count == 1) {
            alone_ms = ms;
            direct_alone_ms = by_calls_ms;
        }
        const std::string name = "blocks of " + std::to_string(block_words) + ", workers " + std::to_string(count);
        results.push_back({name, ms, "ms", by_calls_ms, is_right, by_calls_ms});
        results.push_back(
            {name + ": speed-up", alone_ms / ms, "x", direct_alone_ms / by_calls_ms, is_right, direct_alone_ms / by_calls_ms});
    }
    return results;
}

}  // namespace

int main(int argc, char** argv) {
    const bool json = argc == 2 && std::strcmp(argv[1], "--json") == 0;
    if (argc > 1 && !json) {
        std::fprintf(stderr, "bench_token_stream: unknown argument '%s'; only --json is known\n", argv[1]);
        return 2;
    }
    std::vector<BenchResult> results;
    const auto take = [&](const std::vector<BenchResult>& some) { results.insert(results.end(), some.begin(), some.end()); };
    for (const std::uint32_t size : {64u, 512u, 4096u}) {
        take(overhead("light rays, blocks of " + std::to_string(size), size, kLightSteps, 0));
        take(overhead("heavy rays, blocks of " + std::to_string(size), size, kHeavySteps, 0));
    }
    take(overhead("heavy rays, a fourth reflected, blocks of 512", 512, kHeavySteps, 4));
    for (const std::uint32_t size : {64u, 512u, 4096u}) take(speed_up(size));
    return bench::report(results, json);
}
