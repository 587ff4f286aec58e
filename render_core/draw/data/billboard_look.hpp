/// What a billboard's colours say of its value and of how sure it is. Pure functions; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

struct BillboardLook {
    design::Color color;     ///< of the icon
    design::Color text;      ///< of names and numbers
    bool is_unsure = false;  ///< how sure it is, nobody knows, and the element shows uncertainty
};

/// Of a colour and how sure its value is by now: opacity, and the element's uncertainty technique (transparency and saturation
/// fade what is less sure, by strength and levels).
[[nodiscard]] BillboardLook faded_look(const design::DataElement& element, design::Color color, scene::Uncertainty uncertainty);

/// Of value n of the coloured attribute (placement.hpp), with its age.
[[nodiscard]] BillboardLook billboard_look(const ElementInput& input, std::size_t n);

/// A name with a question mark where nobody knows how sure it is.
using BillboardText = base::FixedString<31>;
[[nodiscard]] BillboardText billboard_name(const ElementInput& input, std::uint32_t feature, const BillboardLook& look);

}  // namespace tedavis::draw
