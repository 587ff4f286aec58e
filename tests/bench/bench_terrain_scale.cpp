/// Frame time and memory of the smallest device over the same ground in databases of 100 MB, 500 MB and, with `--gigabytes N`, N
/// GB of generated terrain: neither grows with the database. Milliseconds are of processor time, the better of two flights.
/// `--folder DIR` holds the databases, which are removed; a build that was stopped goes on there. `--json` prints a list.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>

#include "host_sim/terrain_builder/terrain_build.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/budget_flight.hpp"
#include "tests/support/terrain/fractal_posts.hpp"

namespace {

using namespace tedavis;
using bench::BenchResult;

constexpr std::uint32_t kSmallest = 1300, kMiddle = 3000;  // posts a side, of 100 MB and of 500 MB
constexpr double kBytesOfAPost = 64;                       // a little less than generated terrain takes
constexpr int kLegs = 8;
constexpr double kMaxOfTime = 1.1, kMaxOfSlowest = 1.25;
constexpr double kMaxOfBytes = 1.01;  // the page table has 8 bytes for 64 chunks

struct Arguments {
    bool json = false, right = true;
    double gigabytes = 0;
    std::string folder;
};

Arguments arguments_of(int count, char** given) {
    Arguments arguments;
    for (int n = 1; n < count; ++n) {
        const bool has_value = n + 1 < count;
        if (std::strcmp(given[n], "--json") == 0)
            arguments.json = true;
        else if (std::strcmp(given[n], "--gigabytes") == 0 && has_value) {
            char* end = nullptr;
            arguments.gigabytes = std::strtod(given[++n], &end);
            arguments.right = arguments.right && *end == '\0';
        } else if (std::strcmp(given[n], "--folder") == 0 && has_value)
            arguments.folder = given[++n];
        else
            arguments.right = false;
    }
    const bool sized = arguments.gigabytes == 0 || (arguments.gigabytes >= 1 && arguments.gigabytes <= 200);
    arguments.right = arguments.right && sized;
    return arguments;
}

struct Flown {
    double bytes, median_ms, slowest_ms;
    test_support::FlownBudget flight;

    [[nodiscard]] bool is_right() const {
        return flight.without_terrain + flight.taken_away_later + flight.holes + flight.changed_bytes + flight.over_budget +
                       flight.failing ==
                   0 &&
               flight.heap_calls == 0;
    }
    [[nodiscard]] double memory() const { return static_cast<double>(flight.cpu_bytes + flight.gpu_bytes); }
    [[nodiscard]] std::string name() const {
        char text[32];
        std::snprintf(text, sizeof text, "%.2f GB", bytes / 1e9);
        return text;
    }
};

Flown build_and_fly(const std::string& folder, std::uint32_t side) {
    const std::string database = folder + "/fractal_" + std::to_string(side) + ".tdb";
    if (!std::filesystem::exists(database)) host_sim::build_terrain(test_support::fractal_posts(side), database, {});
    Flown flown{static_cast<double>(std::filesystem::file_size(database)), 1e9, 1e9, {}};
    for (int n = 0; n < 2; ++n) {
        flown.flight = test_support::BudgetFlight(database, "es2-small", test_support::fractal_ground(kSmallest), kLegs).fly();
        flown.median_ms = std::min(flown.median_ms, flown.flight.quantile_ms(0.5));
        flown.slowest_ms = std::min(flown.slowest_ms, flown.flight.quantile_ms(0.99));
    }
    std::filesystem::remove(database);
    return flown;
}

void compare(const Flown& flown, const Flown& smallest, std::vector<BenchResult>& lines) {
    const std::string name = flown.name();
    const double time = flown.median_ms / smallest.median_ms, slowest = flown.slowest_ms / smallest.slowest_ms,
                 memory = flown.memory() / smallest.memory();
    lines.push_back({name + ": median frame", flown.median_ms, "ms", kMaxOfTime * smallest.median_ms,
                     flown.is_right() && time <= kMaxOfTime, smallest.median_ms});
    lines.push_back({name + ": 99 of 100 frames", flown.slowest_ms, "ms", kMaxOfSlowest * smallest.slowest_ms,
                     flown.is_right() && slowest <= kMaxOfSlowest, smallest.slowest_ms});
    lines.push_back({name + ": median frame / smallest", time, "ratio", kMaxOfTime, time <= kMaxOfTime, 1});
    lines.push_back({name + ": bytes / smallest", memory, "ratio", kMaxOfBytes, memory <= kMaxOfBytes, 1});
    lines.push_back({name + ": bytes", flown.memory(), "bytes", 64 << 20, flown.memory() <= 64 << 20, smallest.memory()});
}

}  // namespace

int main(int count, char** given) {
    const Arguments arguments = arguments_of(count, given);
    if (!arguments.right) {
        std::fprintf(stderr, "bench_terrain_scale: usage: bench_terrain_scale [--json] [--gigabytes 1..200] [--folder DIR]\n");
        return 2;
    }
    const test_support::TemporaryFolder temporary;
    const std::string folder = arguments.folder.empty() ? temporary.path() : arguments.folder;
    std::filesystem::create_directories(folder);
    std::vector<std::uint32_t> sides{kSmallest, kMiddle};
    if (arguments.gigabytes > 0)
        sides.push_back(static_cast<std::uint32_t>(std::sqrt(1e9 * arguments.gigabytes / kBytesOfAPost)));
    std::vector<BenchResult> lines;
    std::optional<Flown> smallest;
    for (const std::uint32_t side : sides) {
        const Flown flown = build_and_fly(folder, side);
        if (!smallest) smallest = flown;
        compare(flown, *smallest, lines);
    }
    return bench::report(lines, arguments.json);
}
