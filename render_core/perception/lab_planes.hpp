/// Converts a picture to CIE 1976 L*a*b* at full, half or quarter size, in hundredths of the formula's units: lightness 0..1,
/// red-green and yellow-blue about -1..1.
///
/// A pixel of a smaller size is the mean sRGB level of its block; blocks beyond the picture repeat its border. Pictures are
/// sRGB, white is D65 (IEC 61966-2-1, CIE 15). The error is below 0.01 units of the exact formula.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"
#include "render_core/perception/plane.hpp"

namespace tedavis::perception {

inline constexpr int kMaxStartLevel = 2;

struct LabPlanes {
    Plane lightness, a, b;  ///< of the level's size
};

class LabConversion {
public:
    [[nodiscard]] static std::size_t bytes(int most_width);
    /// Allocates memory; returns false where the arena is too small.
    [[nodiscard]] bool start(base::Arena& arena, int most_width);
    /// `level` 0..kMaxStartLevel; the planes have the level's size, the picture is no wider than at start().
    void convert(const PictureView& picture, int level, const LabPlanes& out);

private:
    void add_rows(const PictureView& picture, int first, int level);
    void read_light(int channels, int level, int width);

    base::Span<float> light_of_;      ///< linear light by sixteenths of an sRGB level
    base::Span<std::uint16_t> sums_;  ///< sums of a block's rows, with the picture's last column repeated
    base::Span<float> light_;         ///< one row each of red, green and blue
    std::size_t stride_ = 0;          ///< of light_
};

}  // namespace tedavis::perception
