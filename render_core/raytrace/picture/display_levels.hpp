/// Converts linear light to the 8 bits of an sRGB display (IEC 61966-2-1) with a table.
#pragma once

#include <cstdint>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::raytrace {

/// The error is at most one level, in the darkest tenth only; results are equal on every machine.
class DisplayLevels {
public:
    static constexpr std::uint32_t kEntries = 4096;

    [[nodiscard]] bool start(base::Arena& arena);
    /// Converts any number; negative numbers and NaN give black.
    [[nodiscard]] std::uint8_t level(float light) const {
        if (!(light > 0)) return 0;
        return light >= 1 ? 255 : levels_.data()[static_cast<std::uint32_t>(light * (kEntries - 1) + kHalf)];
    }

    /// Converts many numbers.
    void set(const float* light, std::uint32_t count, std::uint8_t* levels) const;

private:
    static constexpr float kHalf = 0.5f;
    base::Span<std::uint8_t> levels_;
};

}  // namespace tedavis::raytrace
