/// Posts a minute of a whole terrain build with all attribute maps, and the memory it takes, over generated terrain.
/// `--side N` posts a side (4097), `--threads N` (2), `--json` prints the lines as a list.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>

#include "host_sim/terrain_builder/terrain_build.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/terrain/fractal_posts.hpp"

namespace {

using namespace tedavis;
using namespace tedavis::host_sim;
using bench::BenchResult;

constexpr double kTargetPostsAMinute = 20e6, kTargetMiB = 512;

double seconds_of(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

struct Spent {
    double wall_s, processor_s, peak_mib;

    static Spent now() {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        const auto wall = std::chrono::steady_clock::now().time_since_epoch();
        return {std::chrono::duration<double>(wall).count(), seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime),
                static_cast<double>(usage.ru_maxrss) / 1024};
    }
};

std::vector<BenchResult> measure(std::uint32_t side, std::uint32_t threads) {
    const test_support::TemporaryFolder folder;
    const double posts = static_cast<double>(side) * side;
    std::map<std::string, double> processor_s;
    Spent last = Spent::now();
    const Spent first = last;
    BuildOptions options;
    options.threads = threads;
    options.progress = [&](std::string_view stage, std::uint64_t, std::uint64_t) {
        const Spent now = Spent::now();
        processor_s[std::string(stage)] += now.processor_s - last.processor_s;
        last = now;
    };
    build_terrain(test_support::fractal_posts(side), folder.file("t.tdb"), options);
    const Spent end = Spent::now();
    const double rate = posts / (end.wall_s - first.wall_s) * 60,
                 microseconds = 1e6 * (end.processor_s - first.processor_s) / posts;
    const double bytes = static_cast<double>(std::filesystem::file_size(folder.file("t.tdb")));
    std::vector<BenchResult> lines;
    lines.push_back({"terrain build, " + std::to_string(threads) + " threads", rate, "posts/min", kTargetPostsAMinute,
                     rate >= kTargetPostsAMinute, kTargetPostsAMinute});
    lines.push_back({"memory at its peak", end.peak_mib, "MiB", kTargetMiB, end.peak_mib <= kTargetMiB, first.peak_mib});
    lines.push_back({"processor time", microseconds, "us/post", 6, microseconds <= 6, 6});
    for (const auto& [stage, s] : processor_s) lines.push_back({"  " + stage, 1e6 * s / posts, "us/post", 6, true, microseconds});
    lines.push_back({"database", bytes / posts, "bytes/post", 64, bytes / posts <= 64, 5});
    return lines;
}

}  // namespace

int main(int argc, char** argv) {
    bool json = false;
    std::uint32_t side = 4097, threads = 2;
    for (int n = 1; n < argc; ++n) {
        const bool has_value = n + 1 < argc;
        if (std::strcmp(argv[n], "--json") == 0) {
            json = true;
        } else if (std::strcmp(argv[n], "--side") == 0 && has_value) {
            side = static_cast<std::uint32_t>(std::strtoul(argv[++n], nullptr, 10));
        } else if (std::strcmp(argv[n], "--threads") == 0 && has_value) {
            threads = static_cast<std::uint32_t>(std::strtoul(argv[++n], nullptr, 10));
        } else {
            std::fprintf(stderr, "bench_terrain_build: unknown argument '%s'; --side N, --threads N and --json are known\n",
                         argv[n]);
            return 2;
        }
    }
    if (side < 2 || side > 65536 || threads < 1 || threads > 64) {
        std::fprintf(stderr, "bench_terrain_build: --side is from 2 to 65536, --threads from 1 to 64\n");
        return 2;
    }
    return bench::report(measure(side, threads), json);
}
