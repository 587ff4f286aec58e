#include "target/frame_pacer.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/check.hpp"

namespace tedavis::target {
namespace {

constexpr double kFasterThanRate = 1.05;   // a screen of 60 Hz serves a rate of 59
constexpr double kForget = 0.99;           // a long frame counts less with each later one
constexpr double kMoreThanLongest = 1.15;  // for a frame that takes longer
constexpr base::Duration kReserve = base::Duration::milliseconds(1);

base::Duration times(base::Duration duration, double factor) {
    return base::Duration::from_seconds(duration.to_seconds() * factor);
}

}  // namespace

FramePacer::FramePacer(double rate_hz, base::Time start) : period_s_(1 / rate_hz), start_(start) {
    TEDAVIS_CHECK(rate_hz >= 1 && rate_hz <= 1000);
}

base::Time FramePacer::at(std::int64_t turn) const {
    return start_ + base::Duration::from_seconds(static_cast<double>(turn) * period_s_);
}

base::Time FramePacer::next(base::Time now) {
    follows_blankings_ = false;
    earliest_flip_ = {};
    ++turn_;
    if (at(turn_) > now) return at(turn_);
    // A rounded quotient is off by one at most.
    auto ahead = static_cast<std::int64_t>((now - start_).to_seconds() / period_s_);
    if (ahead < turn_) ahead = turn_;
    if (at(ahead) <= now) ++ahead;
    if (at(ahead) <= now) ++ahead;
    missed_ += static_cast<std::uint64_t>(ahead - turn_);
    turn_ = ahead;
    return at(turn_);
}

base::Time FramePacer::next_after(const ScreenBlanking& blanking, base::Duration work) {
    const std::int64_t apart = blankings_apart(blanking.refresh);
    count_missed(blanking, apart);
    longest_work_ = std::max(work, times(longest_work_, kForget));
    const base::Duration room = times(longest_work_, kMoreThanLongest) + kReserve;
    const base::Duration whole{apart * blanking.refresh.ns};
    // A quarter behind the blanking before the one at which it is to be shown.
    earliest_flip_ = blanking.shown_at + (whole - blanking.refresh) + base::Duration{apart > 1 ? blanking.refresh.ns / 4 : 0};
    start_ = blanking.shown_at + std::max(base::Duration{}, whole - room);
    turn_ = 0;
    return start_;
}

std::int64_t FramePacer::blankings_apart(base::Duration refresh) const {
    const double apart = std::ceil(period_s_ / kFasterThanRate / refresh.to_seconds());
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(apart));
}

void FramePacer::count_missed(const ScreenBlanking& blanking, std::int64_t apart) {
    const double passed = (blanking.shown_at - shown_at_).to_seconds() / blanking.refresh.to_seconds();
    if (follows_blankings_ && std::lround(passed) > apart)
        missed_ += static_cast<std::uint64_t>((std::lround(passed) - 1) / apart);
    follows_blankings_ = true;
    shown_at_ = blanking.shown_at;
}

}  // namespace tedavis::target
