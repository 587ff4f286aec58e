#include "render_core/draw/symbology/fitted_words.hpp"

#include <algorithm>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::draw {
namespace {

constexpr std::string_view kLeftOut = "..";
constexpr float kWidthSlack_px = 0.02f;  // of rounding: a text that was made to fit does

constexpr std::size_t kMaxUnitLetters = 3;  // "KT", "HPA"

bool has_digit(std::string_view text) { return text.find_first_of("0123456789") != std::string_view::npos; }

/// The end of the word that begins at `from`.
std::size_t word_end(std::string_view text, std::size_t from) { return std::min(text.find(' ', from), text.size()); }

struct ValueSpan {
    std::size_t from = 0, to = 0;
};

/// "KT", "HPA", "KM/H", "FT/MIN": so many letters on either side of a slash.
bool is_unit(std::string_view word) {
    const std::size_t slash = word.find('/');
    if (slash == std::string_view::npos) return word.size() <= kMaxUnitLetters;
    return slash <= kMaxUnitLetters && word.size() - slash - 1 <= kMaxUnitLetters;
}

/// The word with a digit, with the unit after it, in which `text` would be cut at `at`; empty where it is cut elsewhere.
ValueSpan value_around(std::string_view text, std::size_t at) {
    for (std::size_t from = 0; from < at;) {
        std::size_t to = word_end(text, from);
        if (has_digit(text.substr(from, to - from)) && to < text.size()) {
            const std::size_t unit_end = word_end(text, to + 1);
            if (is_unit(text.substr(to + 1, unit_end - to - 1))) to = unit_end;
        }
        if (at < to && has_digit(text.substr(from, to - from))) return {from, to};
        from = to + 1;
    }
    return {};
}

/// The start of the last code point.
std::size_t last_start(std::string_view text) {
    std::size_t at = text.size() - 1;
    while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u) --at;
    return at;
}

}  // namespace

std::string_view Words::within(float room_px, float size_px) const noexcept {
    for (const std::string_view text : texts_)
        if (text_width_px(text, size_px) <= room_px + kWidthSlack_px) return text;
    return texts_.back();
}

Words label_words(std::string_view label) noexcept {
    const std::string_view name = label.substr(0, label.rfind(' '));
    return {label, name, name.substr(0, name.rfind(' '))};
}

FittedText cut_words(std::string_view text, float room_px, float size_px) noexcept {
    if (text_width_px(text, size_px) <= room_px + kWidthSlack_px) return FittedText(text);
    const float room = room_px - text_width_px(kLeftOut, size_px);
    std::string_view kept = text;
    while (!kept.empty() && (kept.back() == ' ' || text_width_px(kept, size_px) > room)) kept = kept.substr(0, last_start(kept));
    // At least one character, so that a value at the start is found too.
    const ValueSpan value = value_around(text, std::max<std::size_t>(kept.size(), 1));
    if (value.to > 0) kept = text.substr(0, value.from > 0 ? value.from - 1 : value.to);
    if (kept.size() == text.size()) return FittedText(text);
    FittedText cut(kept);
    cut.append(kLeftOut);
    return cut;
}

}  // namespace tedavis::draw
