/// How fast the default flight is drawn without pictures being written: device es3-mid at 1024 x 768 on the processor's own
/// OpenGL. Each instant is drawn with terrain and, in the same run, without (plain horizon and symbology), so that the cost
/// of the terrain is a ratio; of both the planning is timed alone. An instant is three frames, one after the other at the
/// device's rate, as a display draws them: what is decided twice a second is then a part of few. `--json` prints the lines as a
/// list; `--step S` takes an instant every S seconds.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "host_sim/replay/flight_player.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/default_flight.hpp"

namespace {

using namespace tedavis;

constexpr double kMinRate = 30;                       ///< frames/s
constexpr double kLongestFrame_ms = 2000 / kMinRate;  ///< the picture before stands once more, not longer
constexpr double kLongestPlan_ms = 0.5;               ///< median
constexpr int kFramesOfInstant = 3;
constexpr double kFrame_s = 1.0 / 30;  ///< of the device

struct Timing {
    std::vector<double> ms;
    [[nodiscard]] double quantile(double share) {
        std::sort(ms.begin(), ms.end());
        return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
    }
};

double ms_since(base::Time start) { return (platform::monotonic_now() - start).to_seconds() * 1000; }

struct Flown {
    Timing timing, planning;
    double triangles = 0;  ///< mean of all frames
};

/// Planned, drawn and finished; nothing is read back.
void time_frame(test_support::HeadlessDisplay& headless, const flight::FrameInput& instant, base::Time now, Flown& flown) {
    const base::Time start = platform::monotonic_now();
    headless.display().plan({instant.state, instant.phase, now});
    flown.planning.ms.push_back(ms_since(start));
    headless.display().draw(headless.surface());
    headless.display().gl()->Finish();
    flown.timing.ms.push_back(ms_since(start));
}

/// The whole flight on one display.
Flown fly(base::ByteSource* terrain, const host_sim::PlayerFiles& files, double step_s) {
    test_support::HeadlessDisplay headless("egl", "es3-mid", 1024, 768, terrain);
    host_sim::FlightPlayer player(files, headless.display());
    Flown flown;
    for (base::Time instant = player.first(); instant <= player.last(); instant = instant + base::Duration::from_seconds(step_s))
        for (int n = 0; n < kFramesOfInstant; ++n) {
            const base::Time now = instant + base::Duration::from_seconds(n * kFrame_s);
            if (now > player.last()) break;
            time_frame(headless, player.at(now), now, flown);
            flown.triangles += headless.display().record().terrain.triangles;
        }
    flown.triangles /= static_cast<double>(flown.timing.ms.size());
    return flown;
}

/// Terrain that was not drawn would be quick: no target holds without triangles.
std::vector<bench::BenchResult> results_of(Flown with, Flown without) {
    const double median = with.timing.quantile(0.5), slow = with.timing.quantile(0.99);
    const double plain = without.timing.quantile(0.5), plain_slow = without.timing.quantile(0.99);
    const double plan = with.planning.quantile(0.5), plain_plan = without.planning.quantile(0.5);
    const bool drawn = with.triangles > 0 && without.triangles == 0;
    const double rate = 1000 / median, plain_rate = 1000 / plain, ratio = median / plain, most = plain_rate / kMinRate;
    return {{"default flight: median frame rate", rate, "frames/s", kMinRate, drawn && rate >= kMinRate, plain_rate},
            {"99 of 100 frames take at most", slow, "ms", kLongestFrame_ms, drawn && slow <= kLongestFrame_ms, plain_slow},
            {"frame time with terrain / without", ratio, "ratio", most, drawn && ratio <= most, 1},
            {"planning of a frame, median", plan, "ms", kLongestPlan_ms, drawn && plan <= kLongestPlan_ms, plain_plan}};
}

constexpr double kMinStep_s = 0.1, kMaxStep_s = 60;

struct Arguments {
    bool json = false;
    double step_s = 1.5;
    std::string fault;  ///< a sentence; empty where all is right
};

void take_step(const char* given, Arguments& arguments) {
    char* end = nullptr;
    arguments.step_s = std::strtod(given, &end);
    if (end != given && *end == '\0' && arguments.step_s >= kMinStep_s && arguments.step_s <= kMaxStep_s) return;
    char message[160];
    std::snprintf(message, sizeof message, "--step '%.40s' is no number of seconds from %g to %g; give one, or leave it out",
                  given, kMinStep_s, kMaxStep_s);
    arguments.fault = message;
}

Arguments arguments_of(int count, char** given) {
    Arguments arguments;
    for (int n = 1; n < count; ++n) {
        if (std::strcmp(given[n], "--json") == 0)
            arguments.json = true;
        else if (std::strcmp(given[n], "--step") == 0 && n + 1 < count)
            take_step(given[++n], arguments);
        else
            arguments.fault = "'" + std::string(given[n]) + "' is not understood; use --json and --step SECONDS";
    }
    return arguments;
}

}  // namespace

int main(int count, char** given) {
    const Arguments arguments = arguments_of(count, given);
    if (!arguments.fault.empty()) {
        std::fprintf(stderr, "bench_flight: %s\n", arguments.fault.c_str());
        return 2;
    }
    const test_support::TemporaryFolder folder;
    const test_support::RecordedFlight flight = test_support::default_flight();
    const host_sim::PlayerFiles files{folder.write("flight.log", flight.log), "canaerospace",
                                      folder.write("flight.switches", flight.switch_log), "one_hot"};
    test_support::DefaultTerrain terrain;
    const Flown with = fly(&terrain.bytes, files, arguments.step_s), without = fly(nullptr, files, arguments.step_s);
    return bench::report(results_of(with, without), arguments.json);
}
