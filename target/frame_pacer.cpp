#include "target/frame_pacer.hpp"

#include "render_core/base/check.hpp"

namespace tedavis::target {

FramePacer::FramePacer(double rate_hz, base::Time start) : period_s_(1 / rate_hz), start_(start) {
    TEDAVIS_CHECK(rate_hz >= 1 && rate_hz <= 1000);
}

base::Time FramePacer::at(std::int64_t turn) const {
    return start_ + base::Duration::from_seconds(static_cast<double>(turn) * period_s_);
}

base::Time FramePacer::next(base::Time now) {
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

}  // namespace tedavis::target
