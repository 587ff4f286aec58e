/// Looks for a text in the pixels of a picture, where its characters were written.
///
/// Every character is compared by itself: the template is the coverage that the drawing gives to each pixel of its quad
/// (render_core/draw/quad_batch.hpp), evaluated anew from the font atlas; the picture's side is how near each pixel is to the
/// color of the text. Both are compared by Pearson's correlation: 1 where the character stands there alone, 0 and less where
/// another thing covers it or its color is that of its ground. Where it has a dark rim, only the pixels count that the rim
/// covers, so that what lies behind it does not matter.
#pragma once

#include <cstddef>
#include <optional>

#include "host_sim/flight_test/placed_words.hpp"
#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

/// A character whose correlation is at least so high can be seen. Measured with GL over 66 pictures of the shipped flight and of
/// the designs of its phases, devices es2-small and es3-mid: of 3,986 texts 95 in 100 had 0.99 or more in each of their
/// characters, and less than this limit had only numbers and letters of scales that other marks cross or a box cuts. The same
/// places in the same pictures without symbology had 0.45 at most, and other texts of as many characters at these places 0.70.
/// A single character may pass for another one with its strokes: F for E had 0.99.
inline constexpr double kSeenCorrelation = 0.85;

/// Correlation does not see how faint a text is. A character that differs from its ground by less than this (levels of 8 bits,
/// Euclidean in red, green and blue) has none. It bounds what is a text at all; a contract judges whether it can be read.
inline constexpr double kSeenDifference = 16;

struct CharacterLook {
    std::size_t at = 0;      ///< its first byte in the text
    double correlation = 0;  ///< -1..1; 0 where none of its pixels lie in the picture, and where it has nearly its ground's color
    float x = 0, y = 0;      ///< pixels from the upper left: its middle
};

/// The character with the lowest correlation, of the text's bytes from `at` to before `end`; nothing where these are blanks.
[[nodiscard]] std::optional<CharacterLook> faintest_character(const RgbaPicture& picture, const PlacedWords& words,
                                                              std::size_t at, std::size_t end);

}  // namespace tedavis::host_sim
