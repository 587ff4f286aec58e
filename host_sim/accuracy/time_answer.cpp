#include "host_sim/accuracy/time_answer.hpp"

#include <algorithm>

#include "host_sim/accuracy/knobs/frame_settings_knob.hpp"
#include "host_sim/printed_text.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kUsualShare = 0.95, kHighShare = 0.99;

double expected_share(const MeasuredKnob& knob, const MeasuredLevel& level, const TimeNeed& need, double budget_ms) {
    const bool do_more_fit = is_of_frames(knob) && level.kept_99_ms * (1 + need.margin) <= budget_ms;
    return do_more_fit ? kHighShare : kUsualShare;
}

}  // namespace

bool is_of_frames(const MeasuredKnob& knob) { return knob.name == kFrameSettings; }

TimeNeed time_need(const MeasuredKnob& knob, const MeasuredLevel& level) {
    return {is_of_frames(knob) ? level.kept_ms : level.ms.p95, (1 + knob.noise) * knob.dearest - 1};
}

std::optional<TimeAnswer> answer_within(const MeasuredKnob& knob, double budget_ms) {
    std::optional<TimeAnswer> answer;
    for (const MeasuredLevel& level : knob.levels) {
        const TimeNeed need = time_need(knob, level);
        if (!level.is_offered || need.needed_ms() > budget_ms) continue;
        if (answer && level.trusted_error() >= answer->level->trusted_error()) continue;
        answer = {&level, need, expected_share(knob, level, need, budget_ms)};
    }
    return answer;
}

const MeasuredLevel& least_needing(const MeasuredKnob& knob) {
    return *std::min_element(knob.levels.begin(), knob.levels.end(), [&](const MeasuredLevel& a, const MeasuredLevel& b) {
        if (a.is_offered != b.is_offered) return a.is_offered;
        return time_need(knob, a).needed_ms() < time_need(knob, b).needed_ms();
    });
}

std::string need_words(const MeasuredKnob& knob, const TimeNeed& need) {
    const bool is_frame = is_of_frames(knob);
    std::string text = is_frame ? "95 of 100 frames of the slowest measured place" : "95 of 100 rounds";
    text += printed(" took at most %.3g ms; with a margin of %.0f %% (%.0f %% for the noise of the machine", need.spread_ms,
                    100 * need.margin, 100 * knob.noise);
    if (knob.moments > 0)
        text += printed(", %.0f %% by which the dearest of %zu further moments of the flight takes longer than that place",
                        100 * (knob.dearest - 1), knob.moments);
    return text + printed(") that is %.3g ms", need.needed_ms());
}

std::string share_words(const TimeAnswer& answer) {
    return printed(", so at least %.0f of 100 are expected to keep to it", 100 * answer.expected_share);
}

}  // namespace tedavis::host_sim
