/// The steps of Canny's edge detector on one row, all three colours at once: elements of a row are the interleaved red, green
/// and blue of its pixels, so that a pixel's neighbour is kColors elements away.
///
/// Rows have kRowLead elements before the first one and end with a whole block and kRowLead more, which may be read and
/// written. Sums are exact integers, except that the blurred row is rounded. A picture that is rotated by a right angle or
/// mirrored gives the same numbers.
///
/// Source: J. Canny, "A Computational Approach to Edge Detection", IEEE PAMI 8 (1986).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "render_core/perception/gaussian_weights.hpp"
#include "render_core/perception/picture_view.hpp"

namespace tedavis::perception {

inline constexpr int kRowLead = 48, kRowBlock = 24;
static_assert(kRowLead >= kColors * kMaxRadius && kRowBlock % kColors == 0);

/// Returns the number of elements in memory of a row of `width` pixels.
[[nodiscard]] constexpr std::size_t row_elements(int width) {
    const int blocks = (kColors * width + kRowBlock - 1) / kRowBlock;
    return std::size_t{kRowBlock} * static_cast<std::size_t>(blocks) + 2 * kRowLead;
}

/// The edge state of a pixel in each colour: bit n for a weak edge of colour n, bit n + 4 for a strong one.
inline constexpr std::uint8_t kWeakEdges = 0x07, kStrongEdges = 0x70;

/// Repeats the first and the last pixel `times` times beyond the row's ends.
void repeat_ends(std::uint8_t* row, int width, int times) noexcept;

/// Blurs horizontally; sums are in 256ths of a level. The source's ends must be repeated.
void blur_across(const std::uint8_t* source, std::uint16_t* out, int width, const GaussianWeights& weights) noexcept;

using BlurRows = std::array<const std::uint16_t*, 2 * kMaxRadius + 1>;
/// Blurs vertically over the rows from `radius` above to `radius` below; results are rounded levels.
void blur_down(const BlurRows& rows, std::uint8_t* out, int width, const GaussianWeights& weights) noexcept;

struct GradientRow {
    std::int16_t* across = nullptr;   ///< Sobel's difference, positive to the right: 8 x gradient in levels per pixel
    std::int16_t* down = nullptr;     ///< likewise, downwards
    std::int32_t* squared = nullptr;  ///< across^2 + down^2; 0 beyond the row's ends
};
struct LevelRows {
    const std::uint8_t *above = nullptr, *here = nullptr, *below = nullptr;  ///< ends repeated
};
/// `sums` has room for two rows.
void gradient(const LevelRows& levels, std::int16_t* sums, int width, const GradientRow& out) noexcept;

/// Squared thresholds: a value above `low` may be an edge, one above `high` is one.
struct EdgeThresholds {
    std::int32_t low = 0, high = 0;
};
struct GradientRows {
    const std::int32_t *above = nullptr, *below = nullptr;  ///< squared, of the rows above and below
    GradientRow here;
};
/// Non-maximum suppression in four directions; of two equal pixels the left or upper one is kept. Writes one byte per pixel.
void thin(const GradientRows& rows, const EdgeThresholds& thresholds, int width, std::uint8_t* edges) noexcept;

}  // namespace tedavis::perception
