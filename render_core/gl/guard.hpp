/// The functions in the table that callers use: `Guard` checks the arguments and calls the driver, `Deny` counts. Only gl.cpp
/// includes this.
#pragma once

#include "render_core/base/driver_scope.hpp"
#include "render_core/gl/gl.hpp"

namespace tedavis::gl {

/// The Gl of this thread's current context; null before open().
inline thread_local Gl* active_gl = nullptr;

template <auto Member>
struct CallIdOf;
#define TEDAVIS_GL_CALL(result, name, arguments, devices, stage, origin) \
    template <>                                                          \
    struct CallIdOf<&CallTable::name> {                                  \
        static constexpr CallId value = CallId::name;                    \
    };
#include "render_core/gl/gl_calls.inc"
#undef TEDAVIS_GL_CALL

template <auto Member>
struct Guard;
template <class R, class... A, R (*CallTable::*Member)(A...)>
struct Guard<Member> {
    static R call(A... arguments) {
        Gl& gl = *active_gl;
        if (const char* reason = CallRule<Member>::refusal(gl.state_, arguments...)) {
            gl.refuse(CallIdOf<Member>::value, reason);
            return R();
        }
        const base::DriverScope driver;
        return (gl.loaded_.*Member)(arguments...);
    }
};

template <auto Member>
struct Deny;
template <class R, class... A, R (*CallTable::*Member)(A...)>
struct Deny<Member> {
    static R call(A...) {
        active_gl->refuse(CallIdOf<Member>::value, active_gl->absence(CallIdOf<Member>::value));
        return R();
    }
};

}  // namespace tedavis::gl
