/// What a log of 1 GiB costs the program `tedavis`: the default flight over and over, replayed as a user does it. Peak
/// resident memory of each process as the kernel counted it, and how long a replay that starts somewhere in the log takes,
/// beside the same replay of the one flight. `--json` prints the lines as a list; `--mib N` takes another size.
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/bench/bench_result.hpp"
#include "tests/support/files/paths.hpp"

extern char** environ;

namespace {

namespace fs = std::filesystem;
using tedavis::bench::BenchResult;

constexpr int kSpacing_s = 420;  ///< between the starts of two flights; one lasts 417 s
constexpr int kRunsEach = 3;

struct Cost {
    double wall_s = 0, cpu_s = 0, peak_mib = 0;
};

/// Runs the program beside this one to its end; throws where it does not exit with 0.
Cost run_tedavis(const std::vector<std::string>& arguments) {
    std::string program = fs::read_symlink("/proc/self/exe").parent_path() / "tedavis";
    std::vector<char*> argv{program.data()};
    std::vector<std::string> copies = arguments;
    for (std::string& argument : copies) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    const auto start = std::chrono::steady_clock::now();
    pid_t child = 0;
    const int failed = posix_spawn(&child, program.c_str(), &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) throw std::runtime_error(program + " cannot be started; build the target tedavis");
    int status = 0;
    rusage use{};
    wait4(child, &status, 0, &use);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error("tedavis " + arguments[0] + " failed");
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
    return {wall.count(), seconds(use.ru_utime) + seconds(use.ru_stime), static_cast<double>(use.ru_maxrss) / 1024};
}

std::string text_of(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// The flight again and again, each time later, until the file has `bytes`; returns how often.
int write_repeated(const std::string& flight, const fs::path& path, std::uint64_t bytes) {
    std::ofstream file(path, std::ios::binary);
    std::string later = flight;
    int repeats = 0;
    for (std::uint64_t written = 0; written < bytes; written += later.size(), ++repeats) {
        for (std::size_t at = 0; repeats > 0 && at < later.size(); at = later.find('\n', at) + 1)
            later.replace(at + 1, 10, std::to_string(std::stoll(later.substr(at + 1, 10)) + kSpacing_s));
        file << later;
    }
    if (!file.flush()) throw std::runtime_error(path.string() + ": cannot be written; free some space or set TMPDIR");
    return repeats;
}

class BigLogBench {
public:
    BigLogBench(fs::path folder, std::uint64_t bytes) : folder_(std::move(folder)) {
        const std::string root = tedavis::test_support::source_dir();
        run_tedavis({"scenario", "build", root + "/configs/scenarios/default.toml", "-o", folder_});
        run_tedavis({"terrain", "build", root + "/configs/data/jacksboro_srtm3.tif", "-o", terrain(), "--accuracy", "16"});
        repeats_ = write_repeated(text_of(folder_ / "flight.log"), big(), bytes);
        std::this_thread::sleep_for(std::chrono::seconds(3));  // an index is kept of logs at rest only
    }

    std::vector<BenchResult> measure() {
        const Cost small = replay(folder_ / "flight.log", 200, 200);
        const Cost indexing = run_tedavis(arguments(big(), 0, 0, "1"));
        if (!fs::exists(index())) throw std::runtime_error("no index was kept beside the log");
        std::vector<BenchResult> lines;
        measure_starts(small, indexing, lines);
        measure_memory(small, indexing, lines);
        return lines;
    }

private:
    void measure_starts(const Cost& small, const Cost& indexing, std::vector<BenchResult>& lines) const {
        Cost slowest;
        for (int n = 1; n <= 8; ++n) {
            const Cost cost = replay(big(), length_s() * n / 8.5, length_s() * n / 8.5);
            slowest.wall_s = std::max(slowest.wall_s, cost.wall_s);
            slowest.cpu_s = std::max(slowest.cpu_s, cost.cpu_s);
        }
        const double wall = slowest.wall_s - small.wall_s, cpu = slowest.cpu_s - small.cpu_s;
        const double ratio = indexing.cpu_s / slowest.cpu_s;
        lines.push_back({"seek by --from T, slowest of 8: added wall time", wall, "s", 1, wall <= 1, small.wall_s});
        lines.push_back({"the same, added processor time", cpu, "s", 1, cpu <= 1, small.cpu_s});
        lines.push_back({"first start, without an index / start with one", ratio, "ratio", 1, ratio > 1, 1});
    }

    void measure_memory(const Cost& small, const Cost& indexing, std::vector<BenchResult>& lines) const {
        const Cost whole = run_tedavis(arguments(big(), 0, length_s(), "60"));
        const double peak = std::max(indexing.peak_mib, whole.peak_mib), added = indexing.peak_mib - small.peak_mib;
        // Kept indices belong to the log, so the other device needs no pass of its own; it is asked for one here.
        fs::remove(index());
        const double floor = run_tedavis(arguments(big(), 0, length_s(), "60", "es2-small")).peak_mib;
        const double share = static_cast<double>(fs::file_size(index())) / static_cast<double>(fs::file_size(big()));
        lines.push_back({"peak resident memory, index and replay, es3-mid", peak, "MiB", 256, peak <= 256, small.peak_mib});
        lines.push_back({"peak resident memory, index and replay, es2-small", floor, "MiB", 256, floor <= 256, small.peak_mib});
        lines.push_back({"memory that the long log adds to one frame", added, "MiB", 16, added <= 16, small.peak_mib});
        lines.push_back({"size of the index / size of the log", share, "ratio", 0.01, share <= 0.01, 0});
    }

    [[nodiscard]] fs::path big() const { return folder_ / "big.log"; }
    [[nodiscard]] fs::path index() const { return big().string() + ".tdx"; }
    [[nodiscard]] std::string terrain() const { return folder_ / "terrain.tdb"; }
    [[nodiscard]] double length_s() const { return static_cast<double>(repeats_) * kSpacing_s - 2; }

    [[nodiscard]] std::vector<std::string> arguments(const fs::path& log, double from_s, double to_s, const std::string& step,
                                                     const std::string& device = "es3-mid") const {
        return {"replay",    log,
                "--terrain", terrain(),
                "--from",    std::to_string(from_s),
                "--to",      std::to_string(to_s),
                "--device",  device,
                "--frames",  "none",
                "--step",    step,
                "-o",        folder_ / "run"};
    }
    /// The fastest of some runs: other programs only ever add time.
    [[nodiscard]] Cost replay(const fs::path& log, double from_s, double to_s) const {
        Cost best = run_tedavis(arguments(log, from_s, to_s, "1"));
        for (int n = 1; n < kRunsEach; ++n) {
            const Cost cost = run_tedavis(arguments(log, from_s, to_s, "1"));
            best = {std::min(best.wall_s, cost.wall_s), std::min(best.cpu_s, cost.cpu_s), std::max(best.peak_mib, cost.peak_mib)};
        }
        return best;
    }

    fs::path folder_;
    int repeats_ = 0;
};

/// Removed with the log in it, whatever happens.
struct TemporaryFolder {
    fs::path path = fs::temp_directory_path() / ("tedavis_big_log_" + std::to_string(getpid()));
    TemporaryFolder() { fs::create_directories(path); }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

struct Arguments {
    bool json = false, right = true;
    std::uint64_t mib = 1024;
};

Arguments arguments_of(int argc, char** argv) {
    Arguments arguments;
    for (int n = 1; n < argc; ++n) {
        if (std::strcmp(argv[n], "--json") == 0)
            arguments.json = true;
        else if (std::strcmp(argv[n], "--mib") == 0 && n + 1 < argc)
            arguments.mib = std::strtoull(argv[++n], nullptr, 10);
        else
            arguments.right = false;
    }
    arguments.right = arguments.right && arguments.mib >= 64 && arguments.mib <= 65536;
    return arguments;
}

}  // namespace

int main(int argc, char** argv) {
    const Arguments arguments = arguments_of(argc, argv);
    if (!arguments.right) {
        std::fprintf(stderr, "bench_big_log: usage: bench_big_log [--json] [--mib 64..65536]\n");
        return 2;
    }
    try {
        const TemporaryFolder folder;
        const std::vector<BenchResult> lines = BigLogBench(folder.path, arguments.mib << 20).measure();
        return tedavis::bench::report(lines, arguments.json);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_big_log: %s\n", error.what());
        return 2;
    }
}
