#include "render_core/draw/symbology/fitted_words.hpp"

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::draw {
namespace {

constexpr std::string_view kLeftOut = "..";
constexpr float kWidthSlack_px = 0.02f;  // of rounding: a text that was made to fit does

bool is_number(std::string_view text) { return text.find_first_not_of("0123456789+-. ") == std::string_view::npos; }

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
    if (text_width_px(text, size_px) <= room_px + kWidthSlack_px || is_number(text)) return FittedText(text);
    const float room = room_px - text_width_px(kLeftOut, size_px);
    while (!text.empty() && (text.back() == ' ' || text_width_px(text, size_px) > room)) text = text.substr(0, last_start(text));
    FittedText cut(text);
    cut.append(kLeftOut);
    return cut;
}

}  // namespace tedavis::draw
