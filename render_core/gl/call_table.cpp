#include "render_core/gl/call_table.hpp"

namespace tedavis::gl {
namespace {

bool class_has(effects::CallClass calls, CallDevices devices) {
    switch (devices) {
        case CallDevices::all: return true;
        case CallDevices::es: return calls != effects::CallClass::sc2;
        case CallDevices::es3: return calls == effects::CallClass::es3;
        case CallDevices::sc2: return calls == effects::CallClass::sc2;
        case CallDevices::es3_sc2: return calls != effects::CallClass::es2;
    }
    return false;
}

template <class Names>
bool listed(const Names& names, const char* name) {
    for (const effects::CallName& one : names)
        if (one.view() == name) return true;
    return false;
}

}  // namespace

CallId find_call(std::string_view name) {
    for (std::size_t i = 0; i < kCallCount; ++i)
        if (name == kCalls[i].name) return static_cast<CallId>(i);
    return CallId::count;
}

bool device_has(const effects::GlRules& rules, CallId id) {
    const CallDescription& call = describe(id);
    if (listed(rules.never, call.name)) return false;
    return class_has(rules.calls, call.devices) || listed(rules.also, call.name);
}

}  // namespace tedavis::gl
