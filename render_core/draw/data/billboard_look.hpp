/// What a billboard's colours say of its value and of how sure it is. Pure functions; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

struct BillboardLook {
    design::Color color;     ///< of the icon
    design::Color text;      ///< of names and numbers
    float dashes = 0;        ///< of a rim about the icon, how much of it is drawn; 0: there is none
    bool is_unsure = false;  ///< how sure it is, nobody knows, and the element shows uncertainty

    /// Of the rim: what nobody knows has one with every technique.
    [[nodiscard]] float rim() const { return dashes > 0 || !is_unsure ? dashes : kUnknownDashes; }
    static constexpr float kUnknownDashes = 0.55f;
};

/// What a billboard at least keeps of its opacity: it may be dangerous, the more so where nobody is sure of it.
inline constexpr double kMinShown = 0.6;
/// Of a rim's dashes of what is wholly unsure.
inline constexpr double kMinDashes = 0.35;

/// Of a colour and how sure its value is by now: opacity, and the element's uncertainty technique (transparency and saturation
/// fade what is less sure, a dashed rim is the more broken, by strength and levels). Texts never fade.
[[nodiscard]] BillboardLook faded_look(const design::DataElement& element, design::Color color, scene::Uncertainty uncertainty);

/// Of value n of the coloured attribute (placement.hpp), with its age.
[[nodiscard]] BillboardLook billboard_look(const ElementInput& input, std::size_t n);

/// A name with a question mark where nobody knows how sure it is.
using BillboardText = base::FixedString<31>;
[[nodiscard]] BillboardText billboard_name(const ElementInput& input, std::uint32_t feature, const BillboardLook& look);

}  // namespace tedavis::draw
