/// Allocations seeded into library code: one source of each library folder is compiled once more for this program so that
/// each of its functions calls a hook at its entry. Armed for a namespace, the hook allocates in the next exported function
/// of that namespace that runs, as a careless line in that function would.
#pragma once

#include <string>

namespace tedavis::heap_control {

/// `library` is the namespace: "base", "earth", ..., "platform". One allocation a call of arm().
void arm(const char* library);
void disarm();
/// The mangled name of the function that made the allocation; empty if none has.
[[nodiscard]] std::string seeded_function();

}  // namespace tedavis::heap_control
