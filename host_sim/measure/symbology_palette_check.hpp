/// Whether a palette of the symbology can be read by everybody, by day and by night.
///
///   apart   the colors of two roles of signs differ by kMinRoleDifference (CIEDE2000) in normal vision and without each of the
///           three kinds of cones (color_vision.hpp), unless the palette states what else tells them apart
///   rim     each role of signs has WCAG's ratio kMinRimContrast against the rim, which stands between signs and the ground
///   night   each role of signs is darker by night than by day, and so is each ground over white
///
/// Failure  a list of sentences, one for each requirement and light that does not hold; empty when all hold.
#pragma once

#include <string>
#include <vector>

#include "render_core/design/symbology_palette.hpp"

namespace tedavis::host_sim {

inline constexpr double kMinRoleDifference = 6, kMinRimContrast = 4.5;

/// The pair of roles that is hardest to tell apart, of those that color alone tells apart.
struct RoleGap {
    double difference = 0;  ///< CIEDE2000, the least of all visions
    std::string words;      ///< "caution and reference in deuteranopia"
};
[[nodiscard]] RoleGap least_role_gap(const design::SymbologyPalettes& palettes, design::SymbologyLight light);

/// `name` stands at the head of every sentence: the palette's file.
[[nodiscard]] std::vector<std::string> symbology_palette_faults(const design::SymbologyPalettes& palettes,
                                                                const std::string& name);

}  // namespace tedavis::host_sim
