/// Text that fits into its room without becoming too small to be read. Pure; any thread.
#pragma once

#include <initializer_list>
#include <string_view>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"

namespace tedavis::draw {

using FittedText = base::FixedString<127>;

/// A text with shorter wordings for small screens, from the longest to the shortest; with an empty one at the end, nothing is
/// drawn where no other fits. The texts must outlive the object.
class Words {
public:
    Words(std::string_view text) { add(text); }
    Words(const char* text) : Words(std::string_view(text)) {}
    Words(std::initializer_list<std::string_view> texts) {
        for (const std::string_view text : texts) add(text);
    }

    /// Returns the longest wording that is at most `room_px` wide, else the shortest.
    [[nodiscard]] std::string_view within(float room_px, float size_px) const noexcept;
    [[nodiscard]] std::string_view longest() const noexcept { return texts_[0]; }

private:
    void add(std::string_view text) { static_cast<void>(texts_.try_push_back(text)); }
    base::FixedVector<std::string_view, 4> texts_;
};
/// Returns a label whose last word is a unit, with the label alone as shorter wording: "BARO FT", "BARO".
[[nodiscard]] Words label_words(std::string_view label) noexcept;

/// Returns the text, or as many of its first letters as fit, followed by two dots. A word with a digit is neither cut nor
/// separated from its unit, because the rest would be another value: "WIND 850 HPA" becomes "WIND..". A value at the beginning of
/// the text is kept even where it does not fit.
[[nodiscard]] FittedText cut_words(std::string_view text, float room_px, float size_px) noexcept;

}  // namespace tedavis::draw
