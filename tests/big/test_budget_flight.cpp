// The smallest device flies over 12 GB of generated terrain. Run by command, see CONTRIBUTING.md: the database is built in
// build/host/big, or in the folder that TEDAVIS_BIG_FOLDER names; a run that was stopped goes on there. It is removed in the end.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "host_sim/terrain_builder/terrain_build.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/flights/budget_flight.hpp"
#include "tests/support/terrain/fractal_posts.hpp"

namespace tedavis::test_budget_flight {
namespace {

constexpr int kLegs = 24;
constexpr std::uint32_t kSide = 14'100;
constexpr std::uint64_t kMinBytes = 12'000'000'000, kBytesNeeded = 15'000'000'000;  // with what a build writes besides

std::filesystem::path big_folder() {
    const char* named = std::getenv("TEDAVIS_BIG_FOLDER");
    return named != nullptr ? named : test_support::binary_dir() + "/big";
}

std::uint64_t bytes_in(const std::filesystem::path& folder) {
    std::uint64_t bytes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) bytes += entry.file_size();
    return bytes;
}

void build(const std::filesystem::path& database) {
    host_sim::BuildOptions options;
    std::uint64_t spoken = 0;
    options.progress = [&](std::string_view stage, std::uint64_t done, std::uint64_t total) {
        const std::uint64_t percent = total == 0 ? 0 : 100 * done / total;
        if (percent < spoken + 5) return;
        spoken = percent;
        std::fprintf(stderr, "%.*s: %u %%\n", static_cast<int>(stage.size()), stage.data(), static_cast<unsigned>(percent));
    };
    host_sim::build_terrain(test_support::fractal_posts(kSide), database.string(), options);
}

TEST(BudgetFlight, OverTwelveGigabytesStaysWithinTheSmallestDevice) {
    const std::filesystem::path folder = big_folder(), database = folder / "fractal.tdb";
    std::filesystem::create_directories(folder);
    const std::uint64_t room = std::filesystem::space(folder).available + bytes_in(folder);
    ASSERT_GE(room, kBytesNeeded) << folder << " has room for " << room / 1'000'000'000 << " GB, and "
                                  << kBytesNeeded / 1'000'000'000 << " are needed; name another folder in TEDAVIS_BIG_FOLDER";
    if (!std::filesystem::exists(database)) build(database);
    ASSERT_GE(std::filesystem::file_size(database), kMinBytes);
    const test_support::FlownBudget flown =
        test_support::BudgetFlight(database.string(), "es2-small", test_support::fractal_ground(kSide), kLegs).fly();
    test_support::expect_within_device(flown, kLegs);
    std::printf("%.1f GB: %d frames, %.0f triangles, %.1f ms (p99 %.1f ms) of processor time, %.1f MB, taken away in %d\n",
                static_cast<double>(std::filesystem::file_size(database)) / 1e9, flown.frames, flown.mean_triangles,
                flown.quantile_ms(0.5), flown.quantile_ms(0.99), static_cast<double>(flown.cpu_bytes + flown.gpu_bytes) / 1e6,
                flown.taken_away);
    if (!HasFailure()) std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace tedavis::test_budget_flight
