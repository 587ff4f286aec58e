#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/symbology.hpp"

namespace tedavis::draw {
namespace {

using policy::Element;
using policy::ElementShow;
using policy::NoticeLevel;

/// A label over a number in one box.
void labelled_number(const Painter& painter, const Rect& box, std::string_view label, std::string_view number, ElementShow show) {
    const Rect upper{box.x, box.y, box.width, 1.2f * painter.text_px()};
    const Rect lower{box.x, upper.bottom(), box.width, box.height - upper.height};
    painter.plate(upper, label, 0.8f, label_color(show));
    painter.readout(lower, number, show == ElementShow::flagged);
}

/// The right part of a box, which is made narrower by it; nothing for what is absent.
Rect take_right(Rect& box, float share, ElementShow show) {
    if (show == ElementShow::absent) return {};
    const float width = share * box.width;
    box.width -= width;
    return {box.right(), box.y, width, box.height};
}

/// The decision height beside the height that it is compared with.
void build_radio_minimum(const Painter& painter, const SymbologyInput& input, const Rect& box) {
    const ElementShow show = input.decisions[Element::radio_minimum].show;
    if (show == ElementShow::absent) return;
    if (show == ElementShow::failed) return painter.crossed_out(box, "DH");
    design::Color color = show == ElementShow::flagged ? kCautionColor : kSelectedColor;
    if (input.decisions.radio_minimum == policy::MinimumsState::near) color = kScaleColor;
    if (input.decisions.radio_minimum == policy::MinimumsState::at_or_below) color = kCautionColor;
    const Rect upper{box.x, box.y, box.width, 1.2f * painter.text_px()};
    const Rect lower{box.x, upper.bottom(), box.width, box.height - upper.height};
    const double feet = limited(input.guidance.radio_minimum_m / base::kMetresPerFoot, 0, 9999);
    painter.plate(upper, "DH", 0.8f, color);
    painter.plate(lower, whole_number(feet).view(), 1, color);
}

/// "first_climb" as "FIRST CLIMB".
void append_upper(base::FixedString<63>& text, std::string_view name) {
    for (char c : name) {
        const char upper = c == '_' ? ' ' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        text.append(std::string_view(&upper, 1));
    }
}

std::string_view source_text(flight::PhaseSource source) {
    switch (source) {
        case flight::PhaseSource::switches: return "BY SWITCH";
        case flight::PhaseSource::can: return "BY BUS";
        case flight::PhaseSource::motion: return "FROM MOTION";
        case flight::PhaseSource::held: return "HELD";
        case flight::PhaseSource::none: break;
    }
    return "NO SOURCE";
}

design::Color notice_color(NoticeLevel level) {
    if (level == NoticeLevel::information) return kScaleColor;
    return level == NoticeLevel::warning ? kWarningColor : kCautionColor;
}

constexpr std::size_t kNoticePlaces = 4;  // two columns of two lines

Rect notice_place(const Rect& box, std::size_t place, float gap) {
    const float width = (box.width - gap) / 2, height = (box.height - gap) / 2;
    const std::size_t row = place / 2, column = place % 2;
    return {box.x + static_cast<float>(column) * (width + gap), box.y + static_cast<float>(row) * (height + gap), width, height};
}

void build_notice(const Painter& painter, const Rect& place, std::string_view text, NoticeLevel level) {
    painter.framed_plate(place, text, 0.85f, notice_color(level));
}

}  // namespace

void build_baro_setting(const Painter& painter, const SymbologyInput& input) {
    const ElementShow show = input.decisions[Element::baro_setting].show;
    const Rect& box = painter.layout().baro_setting;
    if (show == ElementShow::absent) return;
    if (show == ElementShow::failed) return painter.failed(box, "BARO SET FAIL");
    const double hpa = limited(input.baro_setting_pa / base::kPascalsPerHectopascal, 0, 9999);
    labelled_number(painter, box, show == ElementShow::flagged ? "STALE QNH HPA" : "QNH HPA", whole_number(hpa).view(), show);
}

void build_ground_height(const Painter& painter, const SymbologyInput& input) {
    const policy::ElementDecision& decision = input.decisions[Element::ground_height];
    Rect box = painter.layout().ground_height;
    build_radio_minimum(painter, input, take_right(box, 0.42f, input.decisions[Element::radio_minimum].show));
    if (decision.show == ElementShow::absent) return;
    const bool radio = decision.source != flight::Signal::height_above_terrain;
    if (decision.show == ElementShow::failed) return painter.failed(box, "AGL FAIL");
    const double feet = limited(input.ground_height_m / base::kMetresPerFoot, -999, 99'999);
    base::FixedString<15> label(decision.show == ElementShow::flagged ? "STALE " : "");
    label.append(radio ? "RA FT" : "AGL FT");
    labelled_number(painter, box, label.view(), whole_number(feet).view(), decision.show);
}

void build_phase(const Painter& painter, const SymbologyInput& input) {
    const Rect& box = painter.layout().phase;
    const Rect upper{box.x, box.y, box.width, box.height / 2}, lower{box.x, upper.bottom(), box.width, box.height / 2};
    const bool uncertain = input.phase.source == flight::PhaseSource::none || input.phase.source == flight::PhaseSource::held;
    base::FixedString<63> text;
    append_upper(text, scenario_name(input.phase.phase));
    const std::string_view sub_phase = sub_phase_name(input.phase.phase);
    if (!sub_phase.empty()) text.append(" ");
    append_upper(text, sub_phase);
    painter.batch().box(box, kReadoutGround);
    painter.fitted_text(text.view(), upper, TextAnchor::left, 0.9f, uncertain ? kCautionColor : kEngagedColor, TextRim::none);
    base::FixedString<63> source("PHASE ");
    source.append(source_text(input.phase.source));
    painter.fitted_text(source.view(), lower, TextAnchor::left, 0.8f, uncertain ? kCautionColor : kScaleColor, TextRim::none);
}

void build_notices(const Painter& painter, const SymbologyInput& input) {
    const Rect& box = painter.layout().notices;
    const float gap = 0.15f * painter.text_px();
    const auto& notices = input.decisions.notices;
    std::size_t urgent = 0;
    for (const policy::Notice& notice : notices) urgent += notice.level != NoticeLevel::information ? 1 : 0;
    const std::size_t named = urgent <= kNoticePlaces ? urgent : kNoticePlaces - 1;
    std::size_t place = 0;
    base::FixedString<127> information;
    for (const policy::Notice& notice : notices) {
        if (notice.level == NoticeLevel::information) {
            if (!information.empty()) information.append("  \xC2\xB7  ");
            information.append(notice.text.view());
        } else if (place < named) {
            build_notice(painter, notice_place(box, place++, gap), notice.text.view(), notice.level);
        }
    }
    if (named < urgent) {
        ShortText more("+");
        more.append(whole_number(static_cast<double>(urgent - named)).view());
        more.append(" MORE");
        build_notice(painter, notice_place(box, place, gap), more.view(), NoticeLevel::caution);
    }
    if (!information.empty())
        painter.fitted_text(information.view(), painter.layout().information, TextAnchor::center, 0.8f, kScaleColor);
}

}  // namespace tedavis::draw
