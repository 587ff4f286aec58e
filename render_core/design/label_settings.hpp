/// Which features get a marker and a name, and how fast that may change: the table [labels] of a design, after the thesis's
/// function of interest (5.2.3). Features in the focus have a marker and a name, those in the intermediate context a marker,
/// others nothing. Designs belong to phases, so weights and relevance depend on the phase.
///
///     [labels]
///     distance = 1              weights of the criteria (draw/data/degree_of_interest.hpp); 0: it does not count
///     population = 0.5
///     height = 0.5
///     runway_length = 0.5
///     relevance = 1
///     name_above = 0.35         degree of interest, 0..1, from which on there is a name
///     marker_above = 0.27       and a marker; no more than name_above
///     dwell_s = 2               what has changed stays so long, where there is room
///     most_changes = 2          of the picture a second
///     show_suppressed = true    the legend says how many labels in view are left out
///     [labels.role_relevance]
///     runway = 1                of a role, 0..1, in this phase
#pragma once

#include <array>

#include "render_core/base/config_reader.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::design {

/// Weights of the criteria, not negative.
struct LabelWeights {
    double distance = 1, population = 0.5, height = 0.5, runway_length = 0.5, relevance = 1;
};

/// Roles that have signs; role_relevance has this order.
inline constexpr std::array kLabelRoles = {scene::LayerRole::sample,   scene::LayerRole::obstacle,   scene::LayerRole::no_go,
                                           scene::LayerRole::airspace, scene::LayerRole::storm_cell, scene::LayerRole::runway,
                                           scene::LayerRole::place,    scene::LayerRole::road,       scene::LayerRole::river,
                                           scene::LayerRole::building, scene::LayerRole::model};

struct LabelSettings {
    LabelWeights weights;
    std::array<double, kLabelRoles.size()> relevance{0.5, 1, 1, 0.8, 1, 0.8, 0.5, 0.3, 0.3, 0.3, 0.4};
    double name_above = 0.35, marker_above = 0.27;
    double dwell_s = 2;
    double most_changes = 2;  ///< a second
    bool show_suppressed = false;

    /// Returns the relevance of a role; 0.5 for roles that are not listed.
    [[nodiscard]] double relevance_of(scene::LayerRole role) const;
};

void read_label_settings(base::ConfigSection section, LabelSettings& labels);

}  // namespace tedavis::design
