/// The time of every frame of the default flight, as a display with its designs for phases, terrain and scene draws them at the
/// device's rate: device es3-mid at 1024 x 768 on the processor's own OpenGL. Behind the first picture every design is drawn
/// once, as the board program does (platform/runtime/design_warmer.hpp); `--cold` leaves that out, which is the control.
///
/// A frame over twice the median is explained by what the record states: the picture changes from one design or view to
/// another, or new terrain is uploaded. One that is over twice the median by the clock alone, and not by the processor's time,
/// waited for other programs. What the driver compiles after the designs were drawn is counted by the executable memory of the
/// process that no file holds.
///
/// `--json` prints the lines as a list; `--from S`, `--to S` fly a part, in seconds from the log's first frame; `--picture
/// F.svg` writes the times as a picture, the longest frame of each column.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/load_design.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "platform/runtime/design_warmer.hpp"
#include "render_core/display/preroll.hpp"
#include "tests/bench/bench_result.hpp"
#include "tests/bench/frame_times_picture.hpp"
#include "tests/support/files/compiled_memory.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/default_scene.hpp"

namespace {

using namespace tedavis;
using bench::BenchResult;
using bench::TimedFrame;

constexpr double kFrame_s = 1.0 / 30;  ///< of the device
constexpr double kLongFrame = 2;       ///< medians

struct Arguments {
    bool json = false, cold = false;
    double from_s = 0, to_s = 1e9;
    std::string picture;
    std::string fault;  ///< a sentence; empty where all is right
};

double processor_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

void warm(test_support::HeadlessDisplay& headless, const flight::FrameInput& first) {
    platform::DesignWarmer warmer;
    warmer.begin(headless.display().planner());
    while (warmer.draw_next(headless.display(), headless.surface(), first)) {
    }
}

std::string reason_of(const display::FrameRecord& record, std::uint64_t usual_upload) {
    if (record.earlier_share > 0) return "the picture fades from one design into another";
    if (record.view.transition < 1) return "the view changes";
    if (record.bytes.uploaded > usual_upload + usual_upload / 4) return "new terrain or data are uploaded";
    return "";
}

struct Flown {
    std::vector<TimedFrame> frames;
    std::uint64_t compiled_bytes = 0;  ///< after the first frame and the warming
};

TimedFrame timed_frame(test_support::HeadlessDisplay& headless, const flight::FrameInput& input, std::uint64_t& usual_upload) {
    TimedFrame frame;
    const base::Time start = platform::monotonic_now();
    const double processor = processor_ms();
    headless.display().plan(input);
    headless.display().draw(headless.surface());
    headless.display().gl()->Finish();
    frame.ms = 1e3 * (platform::monotonic_now() - start).to_seconds();
    frame.processor_ms = processor_ms() - processor;
    const display::FrameRecord& record = headless.display().record();
    frame.phase = record.design.c_str();
    frame.reason = reason_of(record, usual_upload);
    usual_upload = usual_upload == 0 ? record.bytes.uploaded : (7 * usual_upload + record.bytes.uploaded) / 8;
    return frame;
}

Flown fly(const host_sim::PlayerFiles& files, const Arguments& arguments) {
    test_support::DefaultTerrain terrain;
    const std::vector<std::uint8_t> scene = test_support::default_scene();
    test_support::MemoryBytes scene_source{scene};
    const auto designs = host_sim::load_designs({});
    test_support::HeadlessDisplay headless("egl", test_support::shipped_device("es3-mid"), 1024, 768, &terrain.bytes,
                                           designs->design, test_support::as_it_is, &scene_source, &designs->phases);
    host_sim::FlightPlayer player(files, headless.display());
    const base::Time first = player.first() + base::Duration::from_seconds(arguments.from_s);
    const base::Time last = std::min(player.last(), player.first() + base::Duration::from_seconds(arguments.to_s));
    display::settle(headless.display(), player.at(first));
    Flown flown;
    std::uint64_t usual_upload = 0, compiled = 0;
    for (int n = 0; first + base::Duration::from_seconds(n * kFrame_s) <= last; ++n) {
        const flight::FrameInput input = player.at(first + base::Duration::from_seconds(n * kFrame_s));
        flown.frames.push_back(timed_frame(headless, input, usual_upload));
        flown.frames.back().at_s = arguments.from_s + n * kFrame_s;
        if (n > 0) {
            const std::uint64_t now = test_support::compiled_bytes();
            flown.frames.back().compiled_bytes = now - std::min(now, compiled);
            compiled = now;
            continue;
        }
        if (!arguments.cold) warm(headless, input);
        flown.frames.clear();  // behind the first picture
        compiled = test_support::compiled_bytes();
    }
    for (const TimedFrame& frame : flown.frames) flown.compiled_bytes += frame.compiled_bytes;
    return flown;
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

struct LongFrames {
    std::size_t all = 0, waited = 0, unexplained = 0;
};

LongFrames long_frames(const std::vector<TimedFrame>& frames, double median_ms, double processor_median_ms) {
    LongFrames found;
    std::map<std::string, int> by_reason;
    for (const TimedFrame& frame : frames) {
        if (frame.compiled_bytes > 0)
            std::fprintf(stderr, "compiled: %.2f s, %s: %llu bytes\n", frame.at_s, frame.phase.c_str(),
                         static_cast<unsigned long long>(frame.compiled_bytes));
        if (frame.ms <= kLongFrame * median_ms) continue;
        ++found.all;
        const bool waited = frame.processor_ms <= kLongFrame * processor_median_ms;
        if (waited) ++found.waited;
        if (!waited && frame.reason.empty()) {
            ++found.unexplained;
            std::fprintf(stderr, "no reason: %.2f s, %s: %.0f ms, processor %.0f ms\n", frame.at_s, frame.phase.c_str(), frame.ms,
                         frame.processor_ms);
        }
        ++by_reason[waited ? "the processor was busy elsewhere" : frame.reason];
    }
    for (const auto& [reason, count] : by_reason)
        std::fprintf(stderr, "over twice the median: %d frames, %s\n", count, reason.empty() ? "no reason" : reason.c_str());
    return found;
}

void take_seconds(const char* given, double& seconds, Arguments& arguments) {
    char* end = nullptr;
    seconds = std::strtod(given, &end);
    if (end == given || *end != '\0' || !(seconds >= 0))
        arguments.fault = "'" + std::string(given) + "' is no number of seconds from 0 on";
}

Arguments arguments_of(int count, char** given) {
    Arguments arguments;
    for (int n = 1; n < count; ++n) {
        const std::string word = given[n];
        const bool has_value = n + 1 < count;
        if (word == "--json")
            arguments.json = true;
        else if (word == "--cold")
            arguments.cold = true;
        else if (word == "--from" && has_value)
            take_seconds(given[++n], arguments.from_s, arguments);
        else if (word == "--to" && has_value)
            take_seconds(given[++n], arguments.to_s, arguments);
        else if (word == "--picture" && has_value)
            arguments.picture = given[++n];
        else
            arguments.fault = "'" + word + "' is not understood; use --json, --cold, --from S, --to S and --picture F.svg";
    }
    if (arguments.fault.empty() && arguments.to_s <= arguments.from_s) arguments.fault = "--to must be later than --from";
    return arguments;
}

std::vector<BenchResult> results_of(const Flown& flown) {
    std::vector<double> ms, processor;
    for (const TimedFrame& frame : flown.frames) {
        ms.push_back(frame.ms);
        processor.push_back(frame.processor_ms);
    }
    const double median = quantile(ms, 0.5), processor_median = quantile(processor, 0.5);
    const LongFrames found = long_frames(flown.frames, median, processor_median);
    const auto counted = [](std::size_t count) { return static_cast<double>(count); };
    return {{"frames", counted(ms.size()), "frames", 0, !ms.empty(), 0},
            {"median", median, "ms", 1000.0 / 60, median <= 1000.0 / 60, processor_median},
            {"99 of 100 frames take at most", quantile(ms, 0.99), "ms", 25, quantile(ms, 0.99) <= 25, quantile(processor, 0.99)},
            {"longest", quantile(ms, 1), "ms", 0, true, quantile(processor, 1)},
            {"over twice the median", counted(found.all), "frames", 0, true, 0},
            {"of these, waited for other programs", counted(found.waited), "frames", 0, true, 0},
            {"of these, without a reason", counted(found.unexplained), "frames", 0, found.unexplained == 0, 0},
            {"compiled after the first picture", counted(flown.compiled_bytes), "bytes", 0, flown.compiled_bytes == 0, 0}};
}

}  // namespace

int main(int count, char** given) {
    const Arguments arguments = arguments_of(count, given);
    if (!arguments.fault.empty()) {
        std::fprintf(stderr, "bench_frame_times: %s\n", arguments.fault.c_str());
        return 2;
    }
    const test_support::TemporaryFolder folder;
    const test_support::RecordedFlight flight = test_support::default_flight();
    const Flown flown = fly(
        {folder.write("flight.log", flight.log), "canaerospace", folder.write("flight.switches", flight.switch_log), "one_hot"},
        arguments);
    if (flown.frames.empty()) {
        std::fprintf(stderr, "bench_frame_times: the flight has no frame there; choose an earlier --from\n");
        return 2;
    }
    if (!arguments.picture.empty() && !bench::write_frame_times(flown.frames, arguments.picture)) {
        std::fprintf(stderr, "bench_frame_times: %s cannot be written; choose another place\n", arguments.picture.c_str());
        return 2;
    }
    return bench::report(results_of(flown), arguments.json);
}
