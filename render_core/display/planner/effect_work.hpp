/// The GL work of each effect in a frame: draws, passes over a picture, bytes uploaded to the GPU. Work that an effect shares
/// with others, such as a variant of the terrain's program, is not counted.
///
/// Plain data; one frame.
#pragma once

#include <array>
#include <cstdint>

#include "render_core/effects/effect_table.hpp"

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

}  // namespace tedavis::display
