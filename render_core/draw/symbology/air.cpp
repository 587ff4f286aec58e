#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/symbology.hpp"

namespace tedavis::draw {
namespace {

using policy::Element;
using policy::ElementShow;

// In texts.
constexpr float kText = 0.85f;

constexpr double kCalm_mps = 0.5 * base::kMpsPerKnot, kMax_mps = 399 * base::kMpsPerKnot;

void append_age(ElementShow show, base::Duration age, ShortText& text) {
    if (show != ElementShow::flagged) return;
    text.append(" ");
    text.append(whole_number(limited(age.to_seconds(), 0, 999)).view());
    text.append("S");
}

bool is_calm(const SymbologyInput& input) { return !(input.wind_speed_mps >= kCalm_mps); }

/// "265/12KT", "CALM"; from where it blows, true.
ShortText wind_text(const SymbologyInput& input) {
    const base::DisplayUnit unit = base::speed_unit(input.shown.units);
    if (is_calm(input)) return "CALM";
    const double degrees = std::round(base::degrees(limited(input.wind_from_rad, 0, 2 * base::kPi)));
    ShortText text = whole_number(degrees < 0.5 ? 360 : degrees, 3);
    text.append("/");
    text.append(whole_number(unit.of(limited(input.wind_speed_mps, 0, kMax_mps))).view());
    text.append(unit.text);
    return text;
}

/// "OAT -5°C".
ShortText temperature_text(const SymbologyInput& input) {
    constexpr double kZeroCelsius_k = 273.15;
    ShortText text("OAT ");
    text.append(whole_number(limited(input.outside_temperature_k - kZeroCelsius_k, -99, 99)).view());
    text.append(
        "\xC2\xB0"
        "C");
    return text;
}

/// The way that the wind blows, on a picture whose upper side is `up_rad`.
void build_arrow(const Painter& painter, Point center, double toward_rad, double up_rad, design::Color color) {
    const float t = painter.text_px();
    const auto sine = static_cast<float>(std::sin(toward_rad - up_rad)),
               cosine = static_cast<float>(std::cos(toward_rad - up_rad));
    const auto at = [&](float along, float across) {
        return Point{center.x + t * (along * sine + across * cosine), center.y - t * (along * cosine - across * sine)};
    };
    painter.line(at(-0.4f, 0), at(0.15f, 0), color);
    painter.batch().triangle(at(0.58f, 0), at(0, 0.28f), at(0, -0.28f), color);
}

/// On small screens an old wind has its age in the arrow's place.
bool has_room_for_arrow(const Painter& painter, const Rect& row, std::string_view text) {
    return text_width_px(text, kMinText_px) <= row.width - row.height - painter.stroke_px();
}

Rect beside_arrow(const Painter& painter, const Rect& row, std::string_view text) {
    const float side = has_room_for_arrow(painter, row, text) ? row.height : 0;
    return {row.x + side, row.y, row.width - side, row.height};
}

void build_wind(const Painter& painter, const Rect& row, const SymbologyInput& input) {
    const ElementShow show = input.decisions[Element::wind].show;
    if (show == ElementShow::absent) return;
    if (show == ElementShow::failed) return painter.crossed_out(row, "WIND");
    ShortText text = wind_text(input);
    append_age(show, input.wind_age, text);
    painter.batch().box(row, painter.color(SymbolRole::readout_ground));
    const bool has_up = input.over != SymbolGround::moving && input.decisions.view_heading != flight::Signal::count_;
    const double up_rad = input.over == SymbolGround::map ? input.map.up_rad : input.view_heading_rad;
    if (!is_calm(input) && has_up && has_room_for_arrow(painter, row, text.view()))
        build_arrow(painter, {row.x + 0.5f * row.height, row.center().y},
                    limited(input.wind_from_rad, 0, 2 * base::kPi) + base::kPi, up_rad, painter.label_color(show));
    const std::string_view unit = base::speed_unit(input.shown.units).text;
    const std::size_t at = text.view().find(unit);
    ShortText short_text(text.view().substr(0, at));
    if (at != std::string_view::npos) short_text.append(text.view().substr(at + unit.size()));
    const Rect place = beside_arrow(painter, row, text.view());
    const Words words{text.view(), short_text.view(), show == ElementShow::flagged ? "WIND STALE" : ""};
    painter.fitted_text(words, place, TextAnchor::left, kText, painter.label_color(show), TextRim::none);
}

void build_temperature(const Painter& painter, const Rect& row, const SymbologyInput& input) {
    const ElementShow show = input.decisions[Element::outside_temperature].show;
    if (show == ElementShow::absent) return;
    if (show == ElementShow::failed) return painter.crossed_out(row, "OAT");
    ShortText text = temperature_text(input);
    append_age(show, input.temperature_age, text);
    painter.batch().box(row, painter.color(SymbolRole::readout_ground));
    painter.fitted_text({text.view(), text.view().substr(4)}, row, TextAnchor::center, kText, painter.label_color(show),
                        TextRim::none);
}

}  // namespace

void build_air(const Painter& painter, const SymbologyInput& input) {
    const Rect& box = painter.layout().air;
    build_wind(painter, {box.x, box.y, box.width, 0.5f * box.height}, input);
    build_temperature(painter, {box.x, box.center().y, box.width, 0.5f * box.height}, input);
}

}  // namespace tedavis::draw
