/// Marks the calls into drivers (GL, EGL, window systems), whose allocations are not ours: the heap trap of the tests
/// counts them apart.
///
/// Thread    each thread has its own depth. Memory  none.
#pragma once

namespace tedavis::base {

/// How many driver calls this thread is inside of.
inline thread_local int driver_depth = 0;

class DriverScope {
public:
    DriverScope() { ++driver_depth; }
    ~DriverScope() { --driver_depth; }
    DriverScope(const DriverScope&) = delete;
    DriverScope& operator=(const DriverScope&) = delete;
};

}  // namespace tedavis::base
