/// What became of the elements of the data aspect in a frame. Plain data; pure functions; any thread.
#pragma once

#include <array>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/display/planner/glyph_elements.hpp"
#include "render_core/draw/data/trajectory_cues.hpp"

namespace tedavis::display {

enum class ElementState : std::uint8_t {
    shown,
    no_such_layer,
    not_measured,  ///< of what the aircraft itself states: nothing to show yet, or not any more
    wrong_layer,   ///< the technique does not show layers of this kind
    no_room,       ///< the device has none for one more
    out_of_date,   ///< the layer is not valid at this time
    no_terrain,    ///< which is what data are shown over
};
/// For records: "the scene has no such layer".
[[nodiscard]] const char* reason_of(ElementState state) noexcept;

/// What became of an element and one of the layers that it names.
struct ElementReport {
    ElementState state = ElementState::no_such_layer;
    const design::DataElement* element = nullptr;
    const scene::Layer* layer = nullptr;  ///< null where the scene has none
    draw::ElementCount count;
    std::size_t slot = GlyphElements::kSlots;  ///< of glyphs; kSlots: none
    /// Of what stands or moves in space (prisms, tubes, ribbons, solids): wholly out of the frame's view, within `count`.
    std::uint32_t out_of_view = 0;
    std::uint32_t suppressed_labels = 0;  ///< names of features in view that are not shown
    double detail_factor = 1;             ///< of the element's detail, as shown
    std::array<draw::CueCount, draw::kCues> cues{};
};
/// Whether the frame shows features of a layer by this element.
[[nodiscard]] bool is_drawn(const ElementReport& report) noexcept;
/// Whether it shows how unsure they are, too: the element has a technique for it, and the layer states an uncertainty.
[[nodiscard]] bool shows_uncertainty(const ElementReport& report) noexcept;
/// Whether an element faces the eye, in pixels: signs that are built every frame.
[[nodiscard]] bool is_billboard_technique(design::DataTechnique technique) noexcept;
/// Whether an element stands over the picture as signs, which take what room the symbology leaves.
[[nodiscard]] bool is_sign_technique(design::DataTechnique technique) noexcept;

inline constexpr std::size_t kMaxElementGroups = 32;
using ElementReports = base::FixedVector<ElementReport, kMaxElementGroups>;  ///< in the design's order, then the scene's

/// Whether a layer is left out because it is not valid at this time.
[[nodiscard]] bool any_is_out_of_date(const ElementReports& reports) noexcept;

}  // namespace tedavis::display
