/// The perceptual contract of a display: conditions that the pictures of a run must meet.
///
///     title = "Approach under the default design"
///     [canny]                            edge detector for clutter; absent: 1, 70, 170
///     sigma = 1
///     low = 70
///     high = 170
///
///     [[condition]]
///     name = "instruments stay readable" name in reports; absent: a description of the measure
///     phases = ["approach"]              "approach" has its sub-phases; absent: all
///     for_s = 2                          time beyond the limit that breaks it; absent: a single picture does
///     optional = true                    a flight without its phases, or its obstacles, may pass; absent: it may not
///     measure = "clutter"                and the keys of the measure; the limit is `most` or `least`
///
/// Measures, their limits and keys:
///
///   clutter             most: the share of edge pixels. region = "picture" (where absent), "every" of grid = [8, 6], of which
///                       the busiest counts, or a third such as "upper left" or "middle centre"; or cell = [column, row] of the
///                       grid, from [1, 1] at the upper left
///   saliency_share      least: a layer's share of the saliency. layer = "prioritized" (where absent) or a layer;
///                       without = [layers that do not count]
///   saliency_over_area  least: that share over the layer's share of the pixels. The same keys
///   obstacle_rank       most: the worst rank among the most salient places of an obstacle that is on the way and in the picture.
///                       focus = 1/6 of the smaller side, the radius in which the eye sees; without
///   luminance_contrast  least: WCAG's ratio of the faintest sign (measure/sign_contrast.hpp) of a layer. layer; least_px = 24,
///                       pixels that a sign has at least
///   color_difference    least: CIEDE2000 between colours of different groups (contract/color_groups.hpp), in normal vision and
///                       the three deficiencies. between = [groups]; light = 1, of the full light
///   symbology_contrast  least: WCAG's ratio of the faintest sign of any role of the symbology's palette, against its rim or
///                       the ground (measure/role_contrast.hpp). least_px = 12, pixels of the role's own color
///   symbology_difference least: CIEDE2000 between roles of that palette, in normal vision and the three deficiencies
///                       (measure/symbology_palette_check.hpp)
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render_core/perception/condition_watch.hpp"
#include "render_core/perception/edge_density.hpp"
#include "render_core/perception/edge_detector.hpp"
#include "render_core/perception/salient_places.hpp"

namespace tedavis::host_sim {

enum class ContractMeasure : std::uint8_t {
    clutter,
    saliency_share,
    saliency_over_area,
    obstacle_rank,
    luminance_contrast,
    color_difference,
    symbology_contrast,
    symbology_difference
};
inline constexpr std::string_view kContractMeasureNames[] = {
    "clutter",          "saliency_share",     "saliency_over_area",  "obstacle_rank", "luminance_contrast",
    "color_difference", "symbology_contrast", "symbology_difference"};

enum class ClutterRegion : std::uint8_t { picture, every, cell };

struct ContractCondition {
    std::string name;
    ContractMeasure measure = ContractMeasure::clutter;
    perception::ConditionLimit limit;
    std::vector<std::string> phases;  ///< empty: all
    bool is_optional = false;

    ClutterRegion region = ClutterRegion::picture;
    perception::RegionGrid grid;
    int column = 0, row = 0;           ///< of `cell`
    std::string layer;                 ///< empty: that of the prioritized aspect
    std::vector<std::string> without;  ///< layers
    double focus_share = perception::kFocusShare;
    int least_px = 24;
    std::vector<std::string> between;  ///< groups of colours
    double light = 1;
};

struct Contract {
    std::string path, title;
    std::optional<perception::CannySettings> canny;
    std::vector<ContractCondition> conditions;  ///< at least one
};

/// True where the condition applies in a phase such as "approach.final".
[[nodiscard]] bool applies_in(const ContractCondition& condition, std::string_view phase);

/// True where its measure needs layer masks.
[[nodiscard]] bool needs_layers(const ContractCondition& condition);

/// Throws UserError with file and line.
[[nodiscard]] Contract read_contract(const std::string& path);

}  // namespace tedavis::host_sim
