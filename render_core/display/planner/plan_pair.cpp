#include "render_core/display/planner/plan_pair.hpp"

#include <new>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::display {
namespace {

constexpr std::string_view kOfTwo = "one of two plans";

/// Null where the arena is too small.
template <class T>
T* made_in(base::Arena& arena) {
    void* const place = arena.allocate(sizeof(T), alignof(T));
    return place == nullptr ? nullptr : new (place) T();
}

}  // namespace

base::Error PlanPair::start(base::Arena& frames, base::Arena& memories) {
    frame = made_in<PlannedFrame>(frames);
    memory = made_in<PlannerMemory>(memories);
    if (frame != nullptr && memory != nullptr) return {};
    return frame == nullptr ? base::shortage_error(effects::kPlannedFrames, frames, kOfTwo)
                            : base::shortage_error(effects::kPlannerMemory, memories, kOfTwo);
}

}  // namespace tedavis::display
