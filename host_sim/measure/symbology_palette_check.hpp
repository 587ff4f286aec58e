/// Checks whether a palette of the symbology is readable, also with colour vision deficiencies, by day and by night.
///
///   apart   the colors of two roles of signs differ by kMinRoleDifference (CIEDE2000) in normal vision and without each of the
///           three kinds of cones (color_vision.hpp), unless the palette states another distinction
///   rim     each role of signs has WCAG's ratio kMinRimContrast against the rim, which separates signs from the ground
///   night   each role of signs is darker by night than by day, and so is each ground over white
///
/// Failure  a list of sentences, one for each requirement and light that does not hold; empty when all hold.
#pragma once

#include <string>
#include <vector>

#include "render_core/design/symbology_palette.hpp"

namespace tedavis::host_sim {

inline constexpr double kMinRoleDifference = 6, kMinRimContrast = 4.5;

/// The least difference of two roles that are distinguished by color alone.
struct RoleGap {
    double difference = 0;  ///< CIEDE2000, the least of all visions
    std::string words;      ///< "caution and reference in deuteranopia"
};
[[nodiscard]] RoleGap least_role_gap(const design::SymbologyPalettes& palettes, design::SymbologyLight light);

/// Every sentence begins with `name`, the palette's file.
[[nodiscard]] std::vector<std::string> symbology_palette_faults(const design::SymbologyPalettes& palettes,
                                                                const std::string& name);

}  // namespace tedavis::host_sim
