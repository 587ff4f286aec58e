/// Which settings each region of the next picture gets (thesis 6.2.4, left open there): the best that a deadline allows, or the
/// cheapest that a quality allows; near and lit regions before far and dark ones.
///
/// Settings are levels from the cheapest to the best. A step of a region to the next level gains its weight times the error that
/// the level takes away, and costs what the table says. Steps are taken by gain for cost, until the deadline or the quality is
/// reached. What a region had in the last picture counts for more (`hysteresis`), and steps that are new only while that part of
/// the deadline stays free: so neither noise of costs nor of weights makes levels flicker. Equal input, equal choice: ties go to
/// the region with the lower number.
///
/// Memory  an arena's, at start: 20 bytes a step.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/raytrace/picture/trace_costs.hpp"

namespace tedavis::raytrace {

struct ChoiceLimits {
    std::uint32_t levels = 1;                  ///< 1..TraceCosts::kMaxLevels
    float error[TraceCosts::kMaxLevels] = {};  ///< of each level against the best, falling (picture_error.hpp)
    float deadline_ms = 0;                     ///< of the sum of all regions' costs; 0: none
    float most_error = 0;                      ///< weighted mean of all regions that is good enough; 0: as good as can be
    float hysteresis = 0.1f;                   ///< 0..1
};

struct Choice {
    double cost_ms = 0;          ///< expected
    double error = 0;            ///< weighted mean, expected
    bool keeps_deadline = true;  ///< false where even the cheapest level of all does not
};

class SettingsChooser {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t regions);
    /// False where the arena has no room.
    [[nodiscard]] bool start(std::uint32_t regions, base::Arena& arena);
    /// `levels` holds what regions had in the last picture (0 where there was none), and then what they get.
    Choice choose(base::Span<const RegionView> regions, const TraceCosts& costs, const ChoiceLimits& limits,
                  base::Span<std::uint8_t> levels);

private:
    struct Step {
        float worth;  ///< gain for cost
        float cost, gain;
        std::uint32_t region;
        std::uint8_t level;  ///< to this
        bool is_new;
    };
    std::uint32_t list_steps(base::Span<const RegionView> regions, const TraceCosts& costs, const ChoiceLimits& limits,
                             base::Span<const std::uint8_t> last);

    base::Span<Step> steps_;
};

}  // namespace tedavis::raytrace
