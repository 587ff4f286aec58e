/// Chooses the settings of each region of the next picture (an open question in the thesis, 6.2.4): the best within a deadline,
/// or the cheapest with a given quality; near and lit regions have precedence over far and dark ones.
///
/// Settings are levels from the cheapest to the best. A region's step to the next level gains its weight times the reduction of
/// error, and costs what the cost table states. Steps are taken in the order of gain per cost, until the deadline or the
/// quality is reached. Levels of the last picture are favoured (`hysteresis`), and new steps are taken only while that share of
/// the deadline stays free, so that noise in costs and weights does not make levels flicker. The choice is deterministic: ties
/// go to the region with the lower number.
///
/// Memory  an arena's, at start: 20 bytes per step.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/raytrace/picture/trace_costs.hpp"

namespace tedavis::raytrace {

struct ChoiceLimits {
    std::uint32_t levels = 1;                  ///< 1..TraceCosts::kMaxLevels
    float error[TraceCosts::kMaxLevels] = {};  ///< error of each level against the best one, descending (picture_error.hpp)
    float deadline_ms = 0;                     ///< limit of the sum of all regions' costs; 0: none
    float most_error = 0;                      ///< sufficient weighted mean error of all regions; 0: the best possible
    float hysteresis = 0.1f;                   ///< 0..1
};

struct Choice {
    double cost_ms = 0;          ///< expected
    double error = 0;            ///< expected weighted mean
    bool keeps_deadline = true;  ///< false where even the cheapest levels exceed the deadline
};

class SettingsChooser {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t regions);
    /// Allocates memory; returns false where the arena is too small.
    [[nodiscard]] bool start(std::uint32_t regions, base::Arena& arena);
    /// `levels` contains the regions' levels in the last picture (0 where there was none) and receives the new ones.
    Choice choose(base::Span<const RegionView> regions, const TraceCosts& costs, const ChoiceLimits& limits,
                  base::Span<std::uint8_t> levels);

private:
    struct Step {
        float worth;  ///< gain per cost
        float cost, gain;
        std::uint32_t region;
        std::uint8_t level;  ///< the level reached by the step
        bool is_new;
    };
    std::uint32_t list_steps(base::Span<const RegionView> regions, const TraceCosts& costs, const ChoiceLimits& limits,
                             base::Span<const std::uint8_t> last);

    base::Span<Step> steps_;
};

}  // namespace tedavis::raytrace
