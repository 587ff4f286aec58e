/// The colours of a billboard for its value and uncertainty. Pure functions; any thread.
#pragma once

#include "render_core/draw/data/element_input.hpp"

namespace tedavis::draw {

struct BillboardLook {
    design::Color color;     ///< of the icon
    design::Color text;      ///< of names and numbers
    float dashes = 0;        ///< share of a dashed rim round the icon that is drawn; 0: no rim
    bool is_unsure = false;  ///< the element shows uncertainty, and that of this value is unknown

    /// Share of the rim that is drawn: unknown uncertainty has a rim with every technique.
    [[nodiscard]] float rim() const { return dashes > 0 || !is_unsure ? dashes : kUnknownDashes; }
    static constexpr float kUnknownDashes = 0.55f;
};

/// Least opacity of a billboard: it may be a hazard, especially where it is uncertain.
inline constexpr double kMinShown = 0.6;
/// Share of a rim's dashes for the least certain values.
inline constexpr double kMinDashes = 0.35;

/// Returns the look for a colour and an uncertainty: the element's opacity and its uncertainty technique (transparency and
/// saturation fade less certain values, a dashed rim has longer gaps, by strength and levels). Texts never fade.
[[nodiscard]] BillboardLook faded_look(const design::DataElement& element, design::Color color, scene::Uncertainty uncertainty);

/// Returns the look for value n of the coloured attribute (placement.hpp), with its age.
[[nodiscard]] BillboardLook billboard_look(const ElementInput& input, std::size_t n);

/// A name, with a question mark where its uncertainty is unknown.
using BillboardText = base::FixedString<31>;
[[nodiscard]] BillboardText billboard_name(const ElementInput& input, std::uint32_t feature, const BillboardLook& look);

}  // namespace tedavis::draw
