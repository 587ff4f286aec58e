/// Text that fits into its room without becoming too small to be read. Pure; any thread.
#pragma once

#include <initializer_list>
#include <string_view>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"

namespace tedavis::draw {

using FittedText = base::FixedString<127>;

/// A text with shorter wordings for small screens, from the longest to the shortest; an empty one at the end says that nothing
/// stands there where none of them fits. The texts must outlive it.
class Words {
public:
    Words(std::string_view text) { add(text); }
    Words(const char* text) : Words(std::string_view(text)) {}
    Words(std::initializer_list<std::string_view> texts) {
        for (const std::string_view text : texts) add(text);
    }

    /// The first one that is no wider, or the shortest.
    [[nodiscard]] std::string_view within(float room_px, float size_px) const noexcept;
    [[nodiscard]] std::string_view longest() const noexcept { return texts_[0]; }

private:
    void add(std::string_view text) { static_cast<void>(texts_.try_push_back(text)); }
    base::FixedVector<std::string_view, 4> texts_;
};
/// A label with a unit as its last word: "BARO FT", or "BARO" where that is too long.
[[nodiscard]] Words label_words(std::string_view label) noexcept;

/// The text, or as many of its first letters as there is room for, with two dots after them. A word with a digit is never cut,
/// nor is it parted from its unit, because what is left would be another value: "WIND 850 HPA" becomes "WIND..". Where the text
/// begins with a value, it keeps it, whatever the room is.
[[nodiscard]] FittedText cut_words(std::string_view text, float room_px, float size_px) noexcept;

}  // namespace tedavis::draw
