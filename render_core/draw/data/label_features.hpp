/// The features of a layer that may be labelled: the candidates of the label planner. These are features within
/// kFarthestBillboard_m (scaled to a field of view of 60 degrees) that lie ahead, or so close to the picture that they may
/// enter it before the next interval. Of layers without roles that warn, `detail` is the share of the features that have their
/// names, those of the highest interest; places without one are left out, and so are more than kMaxPlaces * detail of them.
/// Obstacles, no-go areas, airspaces and storms always have their icons, and names by `detail`; the nearest come first.
///
/// Pure, apart from one query to the ground per shape. Bounded by the features.
#pragma once

#include "render_core/draw/data/degree_of_interest.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/label_planner.hpp"
#include "render_core/draw/data/sign_view.hpp"
#include "render_core/scene/detail_regions.hpp"

namespace tedavis::draw {

inline constexpr double kMaxPlaces = 24;  ///< in a picture with less than full detail

/// True for layers that warn: their features are never left out for low interest and never delayed.
[[nodiscard]] bool is_protected(const scene::Layer& layer);
[[nodiscard]] LabelGroup label_group(const ElementInput& input);
/// Offers all features of a group that may be in the picture; to be called after its add_group().
void offer_features(const ElementInput& input, std::uint32_t group, const SignView& view, const design::LabelSettings& settings,
                    LabelPlanner& planner);
/// Returns the largest level of a label in a region with reduced detail: names and markers of features with too little interest
/// are decluttered, with hysteresis. Features that warn or are in a focus keep their labels.
[[nodiscard]] LabelLevel level_left(const ElementInput& input, std::uint32_t feature, const SignView& view,
                                    const design::LabelSettings& settings, const scene::DetailRegions& regions);
[[nodiscard]] LabelShape label_shape(const ElementInput& input, std::uint32_t feature, const SignView& view);

}  // namespace tedavis::draw
