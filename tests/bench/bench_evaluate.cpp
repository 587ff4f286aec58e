/// How long the evaluation of a flight takes: pictures of the default flight as `replay` writes them (1024 x 768, device es3-mid,
/// design default, every ten seconds), measured again and again as those of a longer flight, on two threads. Beside it what one
/// picture costs on one thread: read, and measured (edges, regions, both scales of saliency); and what a peak costs more for the
/// other opinions on clutter. Of several turns the quickest counts.
/// `--json` prints the lines as a list; `--frames N` measures that many (600); `--run DIR` takes the pictures of a run.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "host_sim/commands/replay.hpp"
#include "host_sim/evaluation/clutter_opinions.hpp"
#include "host_sim/evaluation/evaluate_flight.hpp"
#include "host_sim/evaluation/picture_file.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "platform/threads/thread_workers.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/default_flight.hpp"

namespace {

using namespace tedavis;
using bench::BenchResult;

constexpr double kFlightFrames = 20 * 60 * 10, kTarget_s = 180;
constexpr double kNoTarget = std::numeric_limits<double>::max();
constexpr std::uint32_t kThreads = 2;
constexpr std::size_t kStretch = 40;

double seconds_since(base::Time start) { return (platform::monotonic_now() - start).to_seconds(); }

std::string replayed(const test_support::TemporaryFolder& folder) {
    const test_support::RecordedFlight flight = test_support::default_flight();
    const test_support::DefaultTerrain terrain;
    host_sim::ReplayOptions options;
    options.log = folder.write("flight.log", flight.log);
    options.switches = folder.write("flight.switches", flight.switch_log);
    options.picture.terrain = folder.write("terrain.tdb", {terrain.image.begin(), terrain.image.end()});
    options.picture.size = host_sim::PictureSize{1024, 768};
    options.step_s = 10;
    options.output = folder.file("run");
    std::ostringstream results, notes;
    host_sim::Console console(results, notes, false, false);
    if (host_sim::run_replay(options, console) != 0) throw std::runtime_error("the flight could not be drawn: " + notes.str());
    return options.output;
}

/// The run's frames over and over, as if one flight.
host_sim::FlightRun repeated(const host_sim::FlightRun& run, std::size_t count) {
    host_sim::FlightRun longer = run;
    longer.frames.clear();
    for (std::size_t n = 0; n < count; ++n) {
        longer.frames.push_back(run.frames[n % run.frames.size()]);
        longer.frames.back().time_s = 0.1 * static_cast<double>(n);
    }
    return longer;
}

/// Of one picture on one thread, the least of some turns, in the mean of the pictures: other work on the machine only adds.
struct Costs {
    double read_ms = 0, measured_ms = 0;
};

Costs costs_of(const host_sim::FlightRun& run) {
    constexpr std::size_t kPictures = 20;
    constexpr int kIterations = 5;
    host_sim::EvaluationSettings settings;
    settings.saliency_start_level = host_sim::kFlightStartLevel;
    host_sim::PictureMeter meter(settings);
    Costs costs;
    const std::size_t stride = std::max<std::size_t>(1, run.frames.size() / kPictures);
    std::size_t count = 0;
    for (std::size_t n = 0; n < run.frames.size(); n += stride, ++count) {
        double read_s = 1e9, measured_s = 1e9;
        for (int iteration = 0; iteration < kIterations; ++iteration) {
            const base::Time start = platform::monotonic_now();
            const host_sim::RgbaPicture picture = host_sim::read_picture(run.frames[n].picture);
            read_s = std::min(read_s, seconds_since(start));
            const base::Time ready = platform::monotonic_now();
            (void)meter.measure(picture, run.frames[n].picture, nullptr, {});
            measured_s = std::min(measured_s, seconds_since(ready));
        }
        costs.read_ms += 1000 * read_s;
        costs.measured_ms += 1000 * measured_s;
    }
    return {costs.read_ms / static_cast<double>(count), costs.measured_ms / static_cast<double>(count)};
}

/// Of twelve thousand frames, at the pace of the quickest of some stretches.
double flight_s(const host_sim::FlightRun& run, std::size_t frames) {
    auto workers = std::move(platform::make_thread_workers({kThreads, nullptr}).value());
    std::ostringstream results, notes;
    host_sim::Console console(results, notes, false, false);
    const host_sim::EvaluationWork work{*workers, console, [] { return false; }, {}};
    double least_s = 1e9;
    for (std::size_t done = 0; done < frames; done += kStretch) {
        const base::Time start = platform::monotonic_now();
        const host_sim::EvaluatedFlight flight = host_sim::measure_flight(repeated(run, kStretch), nullptr, work);
        least_s = std::min(least_s, seconds_since(start) / static_cast<double>(flight.measures.size()));
    }
    return least_s * kFlightFrames;
}

/// Of the run's last picture.
double opinions_ms(const host_sim::FlightRun& run) {
    const host_sim::RgbaPicture picture = host_sim::read_picture(run.frames.back().picture);
    double least_s = 1e9;
    for (int turn = 0; turn < 5; ++turn) {
        const base::Time start = platform::monotonic_now();
        (void)host_sim::clutter_opinions(picture);
        least_s = std::min(least_s, seconds_since(start));
    }
    return 1000 * least_s;
}

std::vector<BenchResult> results_of(const host_sim::FlightRun& run, std::size_t frames) {
    const Costs costs = costs_of(run);
    const double all_s = flight_s(run, frames), alone_s = (costs.read_ms + costs.measured_ms) * kFlightFrames / 1000;
    const double most_ms = kThreads * 1000 * kTarget_s / kFlightFrames - costs.read_ms;
    return {{"12,000 frames on two threads; baseline: on one", all_s, "s", kTarget_s, all_s <= kTarget_s, alone_s},
            {"a picture measured; baseline: read", costs.measured_ms, "ms", most_ms, costs.measured_ms <= most_ms, costs.read_ms},
            {"other opinions on the clutter of one", opinions_ms(run), "ms", kNoTarget, true, costs.measured_ms}};
}

}  // namespace

int main(int count, char** given) {
    bool json = false;
    long frames = 600;
    std::string run;
    for (int n = 1; n < count; ++n) {
        if (std::strcmp(given[n], "--json") == 0)
            json = true;
        else if (std::strcmp(given[n], "--frames") == 0 && n + 1 < count)
            frames = std::strtol(given[++n], nullptr, 10);
        else if (std::strcmp(given[n], "--run") == 0 && n + 1 < count)
            run = given[++n];
        else
            frames = 0;
    }
    if (frames < 1 || frames > 1'000'000) {
        std::fprintf(stderr, "bench_evaluate: not understood; use --json, --frames 1..1000000 and --run DIR\n");
        return 2;
    }
    const test_support::TemporaryFolder folder;
    const host_sim::FlightRun flown = host_sim::read_flight_run(run.empty() ? replayed(folder) : run);
    return bench::report(results_of(flown, static_cast<std::size_t>(frames)), json);
}
