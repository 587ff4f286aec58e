/// Shorter wordings of the texts of the display, for screens without room for the whole. Pure; any thread.
#pragma once

#include <string_view>

#include "render_core/base/span.hpp"
#include "render_core/draw/symbology/fitted_words.hpp"

namespace tedavis::draw {

struct ShortWording {
    std::string_view whole, shorter;
};

/// Every one says the same in fewer letters, and is the wording of one text only.
[[nodiscard]] base::Span<const ShortWording> short_wordings() noexcept;

/// The shorter wording, or the text itself where there is none.
[[nodiscard]] std::string_view short_wording(std::string_view whole) noexcept;

/// The text, and its shorter wording if there is one. `whole` must outlive them.
[[nodiscard]] Words short_words(std::string_view whole) noexcept;
/// The same for a place that stays empty where neither fits.
[[nodiscard]] Words short_words_or_none(std::string_view whole) noexcept;

}  // namespace tedavis::draw
