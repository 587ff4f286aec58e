/// Counts the work of an effect while it draws. Thread  the GL thread.
#pragma once

#include "render_core/display/planner/effect_work.hpp"
#include "render_core/gl/gl.hpp"

namespace tedavis::display {

/// Adds the GL work that is done during its lifetime.
class WorkScope {
public:
    WorkScope(const gl::Gl& gl, EffectWork& work, std::uint32_t passes = 1)
        : gl_(gl), work_(work), passes_(passes), before_(gl.frame()) {}
    ~WorkScope() {
        work_.passes += passes_;
        work_.draws += gl_.frame().draws - before_.draws;
        work_.bytes += gl_.frame().uploaded_bytes - before_.uploaded_bytes;
    }
    WorkScope(const WorkScope&) = delete;
    WorkScope& operator=(const WorkScope&) = delete;

private:
    const gl::Gl& gl_;
    EffectWork& work_;
    std::uint32_t passes_;
    gl::FrameCounts before_;
};

}  // namespace tedavis::display
