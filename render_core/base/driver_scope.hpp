/// Marks calls into drivers (GL, EGL, window systems). The tests' heap trap counts allocations inside drivers separately.
///
/// Thread    each thread has its own depth. Memory  none.
#pragma once

namespace tedavis::base {

/// Nesting depth of driver calls on this thread.
inline thread_local int driver_depth = 0;

class DriverScope {
public:
    DriverScope() { ++driver_depth; }
    ~DriverScope() { --driver_depth; }
    DriverScope(const DriverScope&) = delete;
    DriverScope& operator=(const DriverScope&) = delete;
};

}  // namespace tedavis::base
