/// Icons of what stands in the terrain: a few strokes each, of which the kind is told at a dozen pixels. They follow the signs of
/// aeronautical charts (ICAO Annex 4, appendix 2) where these have one.
///
/// Thread  any. Memory  none. Failure  false when the batch has no room.
#pragma once

#include "render_core/draw/quad_batch.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::draw {

enum class Icon : std::uint8_t {
    generic,
    obstacle,
    mast,
    turbine,
    chimney,
    crane,
    pole,
    cable,
    place,
    village,
    town,
    runway,
    traffic,
    sample,
    storm,
    no_go,
    model,
    count
};

/// By the class of the attribute "kind" where that is the name of an icon, else by the layer's role.
[[nodiscard]] Icon icon_of(const scene::Layer& layer, std::uint32_t feature);

/// `half_px`: from the middle to the edge. Drawn over a dark rim of the same opacity.
bool draw_icon(QuadBatch& batch, Icon icon, Point middle, float half_px, design::Color color);
/// A circle of dashes, which are `share` of it: how sure that is, or that nobody knows.
bool draw_dashed_rim(QuadBatch& batch, Point middle, float radius_px, design::Color color, float share);

}  // namespace tedavis::draw
