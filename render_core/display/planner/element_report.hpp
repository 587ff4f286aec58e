/// Which data elements a frame shows, and why it does not show the others. Plain data; pure functions; any thread.
#pragma once

#include <array>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/display/planner/glyph_elements.hpp"
#include "render_core/draw/data/trajectory_cues.hpp"

namespace tedavis::display {

enum class ElementState : std::uint8_t {
    shown,
    no_such_layer,
    not_measured,  ///< the aircraft's signals give nothing to show, not yet or no longer
    wrong_layer,   ///< the technique does not show layers of this kind
    no_room,       ///< the device has no room for another element
    out_of_date,   ///< the layer is not valid at this time
    no_terrain,    ///< data are shown only over terrain
};
/// For records: "the scene has no such layer".
[[nodiscard]] const char* reason_of(ElementState state) noexcept;

/// How a frame shows one of the layers that an element names.
struct ElementReport {
    ElementState state = ElementState::no_such_layer;
    const design::DataElement* element = nullptr;
    const scene::Layer* layer = nullptr;  ///< null where the scene has none
    draw::ElementCount count;
    std::size_t slot = GlyphElements::kSlots;  ///< of glyphs; kSlots: none
    /// Prisms, tubes, ribbons and solids that are wholly out of the frame's view; they are part of `count`.
    std::uint32_t out_of_view = 0;
    std::uint32_t suppressed_labels = 0;  ///< names of features in view that are not shown
    double detail_factor = 1;             ///< of the element's detail, as shown
    std::array<draw::CueCount, draw::kCues> cues{};
};
/// Whether the frame shows features of a layer by this element.
[[nodiscard]] bool is_drawn(const ElementReport& report) noexcept;
/// Whether it also shows their uncertainty: the element has a technique for it, and the layer states an uncertainty.
[[nodiscard]] bool shows_uncertainty(const ElementReport& report) noexcept;
/// Whether a technique draws signs that face the eye and have sizes in pixels; they are built in every frame.
[[nodiscard]] bool is_billboard_technique(design::DataTechnique technique) noexcept;
/// Whether a technique draws signs over the picture, in the room that the symbology leaves.
[[nodiscard]] bool is_sign_technique(design::DataTechnique technique) noexcept;

inline constexpr std::size_t kMaxElementGroups = 32;
using ElementReports = base::FixedVector<ElementReport, kMaxElementGroups>;  ///< in the design's order, then the scene's

/// Whether a layer is left out because it is not valid at this time.
[[nodiscard]] bool any_is_out_of_date(const ElementReports& reports) noexcept;

}  // namespace tedavis::display
