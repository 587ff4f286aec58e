#include "render_core/design/element_cues.hpp"

#include "render_core/base/units.hpp"
#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

using base::kMetresPerNauticalMile;

constexpr double kFarthestSpacing_m = 100 * kMetresPerNauticalMile;
constexpr double kMaxSpeed_mps = 1000;
constexpr std::string_view kLineMotions[] = {"still", "along", "away"};

void read_spacing(base::ConfigSection& section, ElementCues& cues) {
    const bool has_miles = section.has("line_spacing_nm");
    if (has_miles && section.has("line_spacing_m"))
        return fault_of(section, "line_spacing_nm", "and 'line_spacing_m' say the same; give one of them");
    if (has_miles)
        cues.line_spacing_m =
            kMetresPerNauticalMile * section.number("line_spacing_nm", kMinLineSpacing_m / kMetresPerNauticalMile,
                                                    kFarthestSpacing_m / kMetresPerNauticalMile, 1);
    else if (section.has("line_spacing_m"))
        cues.line_spacing_m = section.number("line_spacing_m", kMinLineSpacing_m, kFarthestSpacing_m, 1000);
}

}  // namespace

void read_element_cues(base::ConfigSection section, ElementCues& cues) {
    if (!section.present()) return;
    read_spacing(section, cues);
    for (const std::string_view key : {"lines_to_ground", "lines_move", "line_speed_mps"})
        if (section.has(key) && !(cues.line_spacing_m > 0))
            return fault_of(section, key, "is of vertical lines, and there are none; give 'line_spacing_m' or 'line_spacing_nm'");
    cues.lines_to_ground = section.boolean("lines_to_ground", false);
    section.choose("lines_move", kLineMotions, cues.lines_move);
    cues.line_speed_mps = section.number("line_speed_mps", 0.1, kMaxSpeed_mps, 0);
    const bool has_speed = section.has("line_speed_mps");
    if (cues.lines_move != LineMotion::still && !has_speed)
        fault_of(section, "lines_move", "needs 'line_speed_mps': how fast they go");
    if (cues.lines_move == LineMotion::still && has_speed)
        fault_of(section, "line_speed_mps", "is of lines that move; give 'lines_move'");
    cues.projection = section.number("projection", 0, 1, 0);
    cues.curtain = section.number("curtain", 0, 1, 0);
}

}  // namespace tedavis::design
