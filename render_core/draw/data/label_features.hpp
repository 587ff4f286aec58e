/// What of a layer may be labelled, and where: the candidates of the label planner. Features within kFarthestBillboard_m, as far
/// away as 60 degrees of view would show them, that lie ahead, or so little beside the picture that they may be in it before the
/// next interval. Of layers without roles that warn, `detail` is the share of the features that have their names, those of the
/// highest interest; places without one are left out, and so are more than kMaxPlaces * detail of them. Obstacles, no-go areas,
/// airspaces and storms have their icons whatever their interest, and their names likewise by `detail`; of them the nearest come
/// first.
///
/// Pure but for the ground that is asked, once a shape. Bounded by the features.
#pragma once

#include "render_core/draw/data/degree_of_interest.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/label_planner.hpp"
#include "render_core/draw/data/sign_view.hpp"
#include "render_core/scene/detail_regions.hpp"

namespace tedavis::draw {

inline constexpr double kMaxPlaces = 24;  ///< of a picture with less than all detail

/// Warns: never left out for want of interest, and never late.
[[nodiscard]] bool is_protected(const scene::Layer& layer);
[[nodiscard]] LabelGroup label_group(const ElementInput& input);
/// All features of a group that may be in the picture, after its add_group().
void offer_features(const ElementInput& input, std::uint32_t group, const SignView& view, const design::LabelSettings& settings,
                    LabelPlanner& planner);
/// The most that is left of a label where the view's regions keep less of their detail: names and markers of what keeps too
/// little interest give way, a little later than they came. What warns, and what is in a focus, keeps all.
[[nodiscard]] LabelLevel level_left(const ElementInput& input, std::uint32_t feature, const SignView& view,
                                    const design::LabelSettings& settings, const scene::DetailRegions& regions);
[[nodiscard]] LabelShape label_shape(const ElementInput& input, std::uint32_t feature, const SignView& view);

}  // namespace tedavis::draw
