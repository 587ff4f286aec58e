/// Every red or amber text of the symbology: where it stands, why it is shown, and what is removed. A plain table; pure.
///
/// Texts of notices are in notice_table.hpp. The symbology writes these texts itself; a test builds every element in every state
/// and compares them with the table. README.md shows the table; a test compares both.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/span.hpp"
#include "render_core/policy/display_decisions.hpp"

namespace tedavis::policy {

/// "selected_altitude"; `element` must not be count_.
[[nodiscard]] std::string_view name_of(Element element) noexcept;
/// "flagged".
[[nodiscard]] std::string_view name_of(ElementShow show) noexcept;

enum class TextColor : std::uint8_t { red, amber };

/// One sentence a cell.
struct ElementText {
    std::string_view place;  ///< an element's name, or "phase", "distortion", "legend" or "notices"
    ElementShow show;        ///< in which the texts are shown; normal for what is no element
    TextColor color;
    std::string_view texts;  ///< separated by ", ". "#" stands for a number, "(phase)" and "(title)" for names; in feet and knots
    std::string_view cause, removed;
};
[[nodiscard]] base::Span<const ElementText> element_texts() noexcept;

}  // namespace tedavis::policy
