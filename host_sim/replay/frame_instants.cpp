#include "host_sim/replay/frame_instants.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kSmallestStep_s = 1e-3, kLargestStep_s = 1e6;
constexpr double kOneNanosecond_s = 1e-9;

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

FrameInstants::FrameInstants(const ReplayOptions& options, base::Time first, base::Time last, double rate_hz) : origin_(first) {
    const double end_s = (last - first).to_seconds();
    const double from_s = options.from_s.value_or(0), to_s = options.to_s.value_or(end_s),
                 step_s = options.step_s.value_or(1 / rate_hz);
    check_range(from_s, to_s, step_s, end_s);
    backwards_ = step_s < 0;
    step_s_ = std::abs(step_s);
    const double steps = std::round(from_s / step_s_);
    const bool whole = std::abs(from_s - steps * step_s_) <= kOneNanosecond_s;
    offset_s_ = whole ? 0 : from_s;
    steps_before_ = whole ? static_cast<std::uint64_t>(steps) : 0;
    count_ = static_cast<std::uint64_t>((std::min(to_s, end_s) - from_s + kOneNanosecond_s) / step_s_) + 1;
}

base::Time FrameInstants::in_order_of_time(std::uint64_t n) const {
    return origin_ + base::Duration::from_seconds(offset_s_ + static_cast<double>(steps_before_ + n) * step_s_);
}

}  // namespace tedavis::host_sim
