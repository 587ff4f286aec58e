#include "host_sim/replay/frame_instants.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kSmallestStep_s = 1e-3, kLargestStep_s = 1e6;
constexpr double kOneNanosecond_s = 1e-9;
constexpr double kPartOfAFrame = 1e-4;  // by which a time may miss its frame, as numbers are rounded
constexpr std::int64_t kSameInstant_ns = 1000;

std::string with_number(const char* format, double number) {
    char text[160];
    std::snprintf(text, sizeof text, format, number);
    return text;
}

void check_range(double from_s, double to_s, double step_s, double end_s) {
    // Written so that NaN is refused as well.
    if (!(from_s >= 0 && from_s <= end_s))
        throw UserError(with_number("--from %g: not inside the log, ", from_s) +
                        with_number("which lasts %g s; choose a time inside it", end_s));
    if (!(to_s >= from_s)) throw UserError(with_number("--to %g: lies before --from; give a later time", to_s));
    if (!(std::abs(step_s) >= kSmallestStep_s && std::abs(step_s) <= kLargestStep_s))
        throw UserError(with_number("--step %g: must be 0.001 to 1000000 s, negative to go backwards", step_s));
}

}  // namespace

FrameInstants::FrameInstants(const ReplayOptions& options, base::Time first, base::Time last, double rate_hz)
    : origin_(first), rate_hz_(rate_hz) {
    const double end_s = (last - first).to_seconds();
    const double from_s = options.from_s.value_or(0), to_s = options.to_s.value_or(end_s),
                 step_s = options.step_s.value_or(1 / rate_hz);
    check_range(from_s, to_s, step_s, end_s);
    backwards_ = step_s < 0;
    step_s_ = std::abs(step_s);
    const double until_s = std::min(to_s, end_s);
    end_ = first + base::Duration::from_seconds(until_s);
    if (options.spread)
        spread(*options.spread, from_s, until_s);
    else
        set_steps(from_s, until_s);
}

void FrameInstants::set_steps(double from_s, double to_s) {
    const double steps = std::round(from_s / step_s_);
    const bool whole = std::abs(from_s - steps * step_s_) <= kOneNanosecond_s;
    offset_s_ = whole ? 0 : from_s;
    steps_before_ = whole ? static_cast<std::uint64_t>(steps) : 0;
    count_ = static_cast<std::uint64_t>((to_s - from_s + kOneNanosecond_s) / step_s_) + 1;
}

/// Frames of the device, as many as asked for at most: equal to those of a whole run.
void FrameInstants::spread(std::uint64_t frames, double from_s, double to_s) {
    const double begin_s =
        std::min((frame_at_or_after(origin_ + base::Duration::from_seconds(from_s)) - origin_).to_seconds(), to_s);
    const double gaps = static_cast<double>(std::max<std::uint64_t>(frames, 2) - 1);
    const double frames_apart = std::ceil((to_s - begin_s) * rate_hz_ / gaps - kPartOfAFrame);
    step_s_ = std::max(1.0, frames_apart) / rate_hz_;
    set_steps(begin_s, to_s);
}

void FrameInstants::add(const std::vector<base::Time>& events) {
    std::vector<base::Time> all;
    const base::Time begin = earliest();
    for (const base::Time event : events)
        if (const base::Time frame = frame_at_or_after(event); frame > begin && frame <= end_) all.push_back(frame);
    for (std::uint64_t n = 0; n < count(); ++n) all.push_back(in_order_of_time(n));
    std::sort(all.begin(), all.end());
    const auto is_same = [](base::Time a, base::Time b) { return (b - a).ns <= kSameInstant_ns; };
    all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
    listed_ = std::move(all);
}

base::Time FrameInstants::frame_at_or_after(base::Time time) const {
    const double frames = std::ceil((time - origin_).to_seconds() * rate_hz_ - kPartOfAFrame);
    return origin_ + base::Duration::from_seconds(frames / rate_hz_);
}

base::Time FrameInstants::step_at(std::uint64_t n) const {
    return origin_ + base::Duration::from_seconds(offset_s_ + static_cast<double>(steps_before_ + n) * step_s_);
}

}  // namespace tedavis::host_sim
