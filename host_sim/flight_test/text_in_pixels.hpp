/// Looks for a text in the pixels of a picture, where its characters were written.
///
/// Every character is compared by itself. The template is the coverage of each pixel of its quad
/// (render_core/draw/quad_batch.hpp), computed again from the font atlas; it is compared with the nearness of each pixel of the
/// picture to the color of the text, by Pearson's correlation. This is 1 where the character is fully visible, and 0 or less
/// where it is covered or has the color of its background. For a character with a dark halo only the pixels that the halo covers
/// count, so that the background does not matter.
#pragma once

#include <cstddef>
#include <optional>

#include "host_sim/flight_test/placed_words.hpp"
#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

/// The least correlation of a visible character. Measured with GL in 66 pictures of the shipped flight and of the designs of its
/// phases, devices es2-small and es3-mid: of 3,986 texts, 95 % had 0.99 or more in each character; below this limit were only
/// numbers and letters of scales that other marks cross or a box clips. The same places in the same pictures without symbology
/// had at most 0.45, and other texts of equal length at these places at most 0.70. A single character may be taken for another
/// one that contains its strokes: F for E had 0.99.
inline constexpr double kSeenCorrelation = 0.85;

/// Correlation does not depend on contrast. A character whose color differs from its background by less than this (8-bit levels,
/// Euclidean in red, green and blue) has correlation 0. Whether a text is legible is judged by a contract.
inline constexpr double kSeenDifference = 16;

struct CharacterLook {
    std::size_t at = 0;      ///< index of its first byte in the text
    double correlation = 0;  ///< -1..1; 0 where none of its pixels lie in the picture, or its color is nearly the background's
    float x = 0, y = 0;      ///< its centre, pixels from the picture's upper left
};

/// Returns the character with the lowest correlation among the text's bytes from `at` to before `end`; nothing if these are
/// blanks.
[[nodiscard]] std::optional<CharacterLook> faintest_character(const RgbaPicture& picture, const PlacedWords& words,
                                                              std::size_t at, std::size_t end);

}  // namespace tedavis::host_sim
