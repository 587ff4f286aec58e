#include "render_core/base/stamped.hpp"

namespace tedavis::base {

const char* to_string(SignalState state) noexcept {
    switch (state) {
        case SignalState::missing: return "missing";
        case SignalState::valid: return "valid";
        case SignalState::stale: return "stale";
        case SignalState::lost: return "lost";
        case SignalState::invalid: return "invalid";
    }
    return "invalid";
}

}  // namespace tedavis::base
