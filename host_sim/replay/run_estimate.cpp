#include "host_sim/replay/run_estimate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host_sim/interrupt.hpp"
#include "host_sim/reports/frame_record_json.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/user_error.hpp"
#include "platform/clock/monotonic_clock.hpp"
#include "render_core/display/preroll.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kTrials = 3;

struct FrameCost {
    double plan_s = 0, draw_s = 0, bytes = 0;
};

double seconds_since(base::Time start) { return (platform::monotonic_now() - start).to_seconds(); }

/// The picture and the line of records as a run would keep them.
FrameCost cost_of_frame(const ReplayOptions& options, const flight::FrameInput& input, DisplaySession& session) {
    display::Display& display = session.display();
    display::settle(display, input);
    FrameCost cost;
    base::Time start = platform::monotonic_now();
    display::preroll(display, input);
    cost.plan_s = seconds_since(start);
    start = platform::monotonic_now();
    session.draw();
    if (options.frame_output() != FrameOutput::none) (void)session.frame_hash();
    if (options.frame_output() == FrameOutput::png) cost.bytes += static_cast<double>(encode_png(session.pixels()).size());
    FrameResult result;
    result.record = display.record();
    cost.bytes += static_cast<double>(frame_record_json(result, input.time).size());
    cost.draw_s = seconds_since(start);
    return cost;
}

/// Before a frame that does not follow the one before on the device's grid, a window of frames is planned.
double plans_of_frame(const FrameInstants& times, double rate_hz) {
    const bool follows = std::abs(times.step().to_seconds() * rate_hz - 1) < 1e-3;
    return follows ? 1 : 1 + terrain::StoreSettings().window_frames;
}

std::string bytes_words(double bytes) {
    if (bytes >= 1e9) return decimal(bytes / 1e9, bytes >= 1e10 ? 0 : 1) + " GB";
    return decimal(std::ceil(bytes / 1e6), 0) + " MB";
}

std::string duration_words(double seconds) { return seconds < 90 ? decimal(std::ceil(seconds), 0) + " s" : age_words(seconds); }

/// What other programs take now and then counts less than in a mean.
double middle_of(std::array<double, kTrials> values) {
    std::sort(values.begin(), values.end());
    return values[kTrials / 2];
}

}  // namespace

RunEstimate estimate_run(const ReplayOptions& options, const FrameInstants& times, FlightPlayer& player,
                         DisplaySession& session) {
    std::array<double, kTrials> plan_s{}, draw_s{};
    double bytes = 0;
    for (std::size_t n = 0; n < kTrials; ++n) {
        const flight::FrameInput input = player.at(times.in_order_of_time(times.count() * (2 * n + 1) / (2 * kTrials)));
        if (n == 0) (void)cost_of_frame(options, input, session);  // the first picture of all also compiles its programs
        const FrameCost cost = cost_of_frame(options, input, session);
        plan_s[n] = cost.plan_s;
        draw_s[n] = cost.draw_s;
        bytes += cost.bytes / kTrials;
    }
    const auto frames = static_cast<double>(times.count());
    const double plans = plans_of_frame(times, session.device().frame_rate_hz);
    return {times.count(), frames * (plans * middle_of(plan_s) + middle_of(draw_s)), frames * bytes};
}

std::string words_of(const RunEstimate& estimate) {
    return counted(estimate.frames, "frame") + ", about " + duration_words(estimate.seconds) + " and " +
           bytes_words(estimate.bytes);
}

void require_consent(const RunEstimate& estimate, const ReplayOptions& options, Console& console) {
    if (estimate.frames <= kFramesWithoutAWord) return;
    const std::string words = options.output + ": " + words_of(estimate);
    const bool is_long = estimate.frames > kFramesWithoutAsking || estimate.bytes > kBytesWithoutAsking;
    if (!is_long || options.yes) return console.note("note: " + words);
    const std::optional<bool> answer = console.confirm(words + "; go on?");
    require_uninterrupted(options.output);
    if (!answer)
        throw UserError(words +
                        (options.spread ? "; ask for fewer with --frames" : "; draw fewer, such as with --step 1, --from, --to") +
                        ", or confirm with --yes");
    if (!*answer) throw UserError(words + ": not confirmed; nothing was written to " + options.output);
}

}  // namespace tedavis::host_sim
