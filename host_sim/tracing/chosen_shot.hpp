/// A picture of the ground whose settings are chosen for each region by their cost, for a deadline or a quality
/// (render_core/raytrace/picture/choose_settings.hpp).
///
/// Every level is drawn once, for its time and its error against the best one. Then frames follow as on a display: from the last
/// one it is known which regions are near and lit, its time corrects the costs, and the settings of the next one are chosen.
#pragma once

#include "host_sim/tracing/traced_shot.hpp"

namespace tedavis::host_sim {

struct ChoicePlan {
    double deadline_ms = 0;     ///< of a picture; 0: none
    double most_error = 0;      ///< tolerated error, root mean square of linear light; 0: the best quality
    std::uint32_t frames = 12;  ///< number of frames that follow, 1 or more; the last one is the picture
};

struct ChoiceLevel {
    std::string operators;
    double picture_ms = 0;
    double error = 0;  ///< of the whole picture, against the best level's
};

struct ChosenFrame {
    double picture_ms = 0, expected_ms = 0;
    double error = 0;                    ///< against the best level's picture
    std::vector<std::uint32_t> regions;  ///< number of regions with each level
    bool keeps_deadline = true;          ///< false: not even the cheapest level does
};

struct ChosenShot {
    TracedShot shot;  ///< of the last frame; its time is the median of the later half
    std::vector<ChoiceLevel> levels;
    std::vector<ChosenFrame> frames;
};

/// From the cheapest to the best: the time preset, one between, the quality preset.
[[nodiscard]] std::vector<raytrace::TraceSettings> choice_levels();

/// Throws UserError as draw_traced_shot().
[[nodiscard]] ChosenShot draw_chosen_shot(const TracedGround& ground, const TracedShotPlan& plan, const ChoicePlan& choice,
                                          base::Workers& workers);

}  // namespace tedavis::host_sim
