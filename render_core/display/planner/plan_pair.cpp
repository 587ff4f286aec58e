#include "render_core/display/planner/plan_pair.hpp"

#include <new>

#include "render_core/effects/device.hpp"

namespace tedavis::display {
namespace {

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
    return base::make_error("the budget line '", frame == nullptr ? effects::kPlannedFrames : effects::kPlannerMemory,
                            "' is too small; it holds two; raise it in the device file");
}

}  // namespace tedavis::display
