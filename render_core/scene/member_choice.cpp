#include "render_core/scene/member_choice.hpp"

namespace tedavis::scene {
namespace {

std::int64_t steps_until(std::int64_t time_ns, std::int64_t step_ns) {
    return time_ns / step_ns - (time_ns % step_ns < 0 ? 1 : 0);
}

}  // namespace

std::uint32_t member_turn(std::int64_t time_ns, std::int64_t step_ns, std::uint32_t shown) noexcept {
    const std::int64_t turn = steps_until(time_ns, step_ns) % shown;
    return static_cast<std::uint32_t>(turn < 0 ? turn + shown : turn);
}

std::int64_t next_turn_ns(std::int64_t time_ns, std::int64_t step_ns) noexcept {
    return (steps_until(time_ns, step_ns) + 1) * step_ns;
}

}  // namespace tedavis::scene
