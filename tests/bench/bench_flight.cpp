/// How fast the default flight is drawn without pictures being written: device es3-mid at 1024 x 768 on the processor's own
/// OpenGL. Each instant is drawn with terrain and, in the same run, without (plain horizon and symbology), so that the cost
/// of the terrain is a ratio. `--json` prints the result as one object; `--step S` takes an instant every S seconds.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "host_sim/replay/flight_player.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "tests/support/default_flight.hpp"
#include "tests/support/temporary_folder.hpp"

namespace {

using namespace tedavis;

struct Timing {
    std::vector<double> ms;
    [[nodiscard]] double quantile(double share) {
        std::sort(ms.begin(), ms.end());
        return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
    }
};

/// Planned, drawn and finished; nothing is read back.
double frame_ms(test_support::HeadlessDisplay& headless, const host_sim::PlayedInstant& instant, base::Time now) {
    const base::Time start = platform::monotonic_now();
    headless.display().update(instant.aircraft, instant.phase, now);
    headless.display().draw(headless.surface());
    headless.display().gl()->Finish();
    return (platform::monotonic_now() - start).to_seconds() * 1000;
}

/// The whole flight on one display; `triangles` gets the mean of all frames.
Timing fly(base::ByteSource* terrain, const host_sim::PlayerFiles& files, double step_s, double& triangles) {
    test_support::HeadlessDisplay headless("egl", "es3-mid", 1024, 768, terrain);
    host_sim::FlightPlayer player(files, headless.display());
    Timing timing;
    triangles = 0;
    for (base::Time now = player.first(); now <= player.last(); now = now + base::Duration::from_seconds(step_s)) {
        const host_sim::PlayedInstant instant = player.at(now);
        timing.ms.push_back(frame_ms(headless, instant, now));
        triangles += headless.display().record().terrain.triangles;
    }
    triangles /= static_cast<double>(timing.ms.size());
    return timing;
}

}  // namespace

int main(int count, char** arguments) {
    bool json = false;
    double step_s = 0.5;
    for (int n = 1; n < count; ++n) {
        if (std::strcmp(arguments[n], "--json") == 0) {
            json = true;
        } else if (std::strcmp(arguments[n], "--step") == 0 && n + 1 < count) {
            step_s = std::atof(arguments[++n]);
        } else {
            std::fprintf(stderr, "usage: bench_flight [--json] [--step SECONDS]\n");
            return 2;
        }
    }
    if (!(step_s > 0)) {
        std::fprintf(stderr, "bench_flight: --step must be above 0\n");
        return 2;
    }
    const test_support::TemporaryFolder folder;
    const test_support::RecordedFlight flight = test_support::default_flight();
    const host_sim::PlayerFiles files{folder.write("flight.log", flight.log), "canaerospace",
                                      folder.write("flight.switches", flight.switch_log), "one_hot"};
    test_support::DefaultTerrain terrain;
    double triangles = 0, none = 0;
    Timing with = fly(&terrain.bytes, files, step_s, triangles), without = fly(nullptr, files, step_s, none);
    const double median = with.quantile(0.5), plain = without.quantile(0.5);
    const char* form = json ? "{\"frames\": %zu, \"median_ms\": %.3f, \"p99_ms\": %.3f, \"frames_per_second\": %.1f, "
                              "\"mean_triangles\": %.0f, \"without_terrain_ms\": %.3f, \"ratio\": %.3f}\n"
                            : "%zu frames: median %.1f ms, 99 %% within %.1f ms: %.1f frames/s; %.0f triangles on average\n"
                              "without terrain %.1f ms: with terrain a frame takes %.2f times as long\n";
    std::printf(form, with.ms.size(), median, with.quantile(0.99), 1000 / median, triangles, plain, median / plain);
    return 0;
}
