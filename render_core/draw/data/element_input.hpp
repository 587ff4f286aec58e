/// What builders of data elements are given, and what they answer. Plain data; the ground is asked on the display's thread.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/design/data_element.hpp"
#include "render_core/scene/ground.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::draw {

class LayerFoci;

struct ElementInput {
    const design::DataElement& element;
    std::uint8_t group = 0;  ///< of this element and this layer
    const scene::Layer& layer;
    scene::Ground& ground;
    design::Color missing;            ///< what stands for a value that is not known
    std::int64_t time_ns = 0;         ///< of the frame: what moves has come so far
    bool has_date = false;            ///< without, it stays where the data have it
    glm::dvec3 eye{0};                ///< ECEF; for what turns to it
    double metres_per_px_m = 0;       ///< of distance: a pixel is so wide there
    bool has_age = true;              ///< false: the time of the frame goes on, but nobody confirms it
    const LayerFoci* foci = nullptr;  ///< of this layer; null: everything is in the focus
};

inline constexpr double kFloating_m = 5;  ///< over the ground: less needs no link

/// Features (points of a field) of an element: every one is in exactly one of them.
struct ElementCount {
    std::uint32_t drawn = 0;
    std::uint32_t aggregated = 0;  ///< within what stands for several
    std::uint32_t hidden = 0;      ///< not drawn: no place, no room, out of view

    [[nodiscard]] std::uint32_t all() const { return drawn + aggregated + hidden; }
};

}  // namespace tedavis::draw
