/// What a frame's effects cost in GL, each by itself: draws, passes over a picture, bytes that went to the GPU. What an effect
/// shares with others, such as a variant of the terrain's program, is no work of its own.
///
/// Plain data; one frame. Thread  the GL thread.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/effects/effect_table.hpp"
#include "render_core/gl/gl.hpp"

namespace tedavis::display {

struct EffectWork {
    std::uint32_t draws = 0, passes = 0;
    std::uint64_t bytes = 0;

    EffectWork& operator+=(const EffectWork& more) {
        draws += more.draws;
        passes += more.passes;
        bytes += more.bytes;
        return *this;
    }
};

class EffectWorkTable {
public:
    [[nodiscard]] EffectWork& operator[](effects::Effect effect) { return work_[static_cast<std::size_t>(effect)]; }
    [[nodiscard]] const EffectWork& operator[](effects::Effect effect) const { return work_[static_cast<std::size_t>(effect)]; }

private:
    std::array<EffectWork, effects::kEffectCount> work_{};
};

/// Adds what GL is given while it lives.
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
