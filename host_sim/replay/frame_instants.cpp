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

FrameInstants::FrameInstants(const ReplayOptions& options, base::Time first, base::Time last, double rate_hz,
                             const TimeRanges& parts)
    : origin_(first), rate_hz_(rate_hz) {
    const double end_s = (last - first).to_seconds();
    const double from_s = options.from_s.value_or(0), to_s = options.to_s.value_or(end_s),
                 step_s = options.step_s.value_or(1 / rate_hz);
    check_range(from_s, to_s, step_s, end_s);
    backwards_ = step_s < 0;
    step_s_ = std::abs(step_s);
    std::vector<Part> drawn;
    for (const TimeRange& part : parts) drawn.push_back({(part.from - first).to_seconds(), (part.to - first).to_seconds()});
    if (parts.empty()) drawn.push_back({from_s, std::min(to_s, end_s)});
    if (options.spread) spread(*options.spread, drawn);
    list_steps(drawn);
}

/// Frames of the device, equal to those of a whole run. A part has one more than it has whole steps, so that all of them have as
/// many as asked for at most; or one each.
void FrameInstants::spread(std::uint64_t frames, std::vector<Part>& parts) {
    double whole_s = 0;
    for (Part& part : parts) {
        const base::Time begin = frame_at_or_after(origin_ + base::Duration::from_seconds(part.from_s));
        part.from_s = std::min((begin - origin_).to_seconds(), part.to_s);
        whole_s += part.to_s - part.from_s;
    }
    const double gaps = std::max(1.0, static_cast<double>(frames) - static_cast<double>(parts.size()));
    step_s_ = std::max(1.0, std::ceil(whole_s * rate_hz_ / gaps - kPartOfAFrame)) / rate_hz_;
}

void FrameInstants::list_steps(const std::vector<Part>& parts) {
    for (const Part& part : parts) {
        steps_ = steps_of(part);
        parts_.push_back({step_at(steps_, 0), origin_ + base::Duration::from_seconds(part.to_s)});
        if (parts.size() == 1) return;  // a whole flight at a device's rate is not listed
        for (std::uint64_t n = 0; n < steps_.count; ++n) listed_.push_back(step_at(steps_, n));
    }
}

FrameInstants::Steps FrameInstants::steps_of(const Part& part) const {
    const double steps = std::round(part.from_s / step_s_);
    const bool whole = std::abs(part.from_s - steps * step_s_) <= kOneNanosecond_s;
    return {whole ? 0 : part.from_s, whole ? static_cast<std::uint64_t>(steps) : 0,
            static_cast<std::uint64_t>((part.to_s - part.from_s + kOneNanosecond_s) / step_s_) + 1};
}

void FrameInstants::add(const std::vector<base::Time>& events) {
    std::vector<base::Time> all;
    for (const base::Time event : events)
        if (const base::Time frame = frame_at_or_after(event); contains(parts_, frame)) all.push_back(frame);
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

base::Time FrameInstants::step_at(const Steps& steps, std::uint64_t n) const {
    return origin_ + base::Duration::from_seconds(steps.offset_s + static_cast<double>(steps.before + n) * step_s_);
}

}  // namespace tedavis::host_sim
