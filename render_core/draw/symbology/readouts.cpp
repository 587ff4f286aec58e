#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/units.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/short_words.hpp"
#include "render_core/draw/symbology/symbology.hpp"

namespace tedavis::draw {
namespace {

using policy::Element;
using policy::ElementShow;

constexpr float kLabelRow = 1.2f;  // texts

/// A label over a number in one box.
void labelled_number(const Painter& painter, const Rect& box, const Words& label, std::string_view number, ElementShow show) {
    const Rect upper{box.x, box.y, box.width, legible_row_px(kLabelRow, painter.text_px())};
    const Rect lower{box.x, upper.bottom(), box.width, box.height - upper.height};
    painter.plate(upper, label, painter.type().label, painter.label_color(show));
    painter.readout(lower, number, show == ElementShow::flagged);
}

/// "RA FT", "STALE AGL FT" and their shorter wordings. The shortest keeps the source: an amber number is stale.
class GroundHeightLabel {
public:
    GroundHeightLabel(std::string_view source, bool is_stale, std::string_view unit) : is_stale_(is_stale), whole_("STALE ") {
        whole_.append(source);
        source_end_ = whole_.size();
        whole_.append(" ");
        whole_.append(unit);
    }
    /// Valid as long as this.
    [[nodiscard]] Words words() const {
        const std::string_view whole = whole_.view();
        if (!is_stale_) return label_words(whole.substr(kStale));
        return {whole, whole.substr(0, source_end_), whole.substr(kStale, source_end_ - kStale)};
    }

private:
    static constexpr std::size_t kStale = 6;
    bool is_stale_;
    ShortText whole_;
    std::size_t source_end_ = 0;
};

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
    design::Color color = painter.color(show == ElementShow::flagged ? SymbolRole::caution : SymbolRole::selected);
    if (input.decisions.radio_minimum == policy::MinimumsState::near) color = painter.color(SymbolRole::scale);
    if (input.decisions.radio_minimum == policy::MinimumsState::at_or_below) color = painter.color(SymbolRole::caution);
    const Rect upper{box.x, box.y, box.width, legible_row_px(kLabelRow, painter.text_px())};
    const Rect lower{box.x, upper.bottom(), box.width, box.height - upper.height};
    const double height = limited(base::height_unit(input.shown.units).of(input.guidance.radio_minimum_m), 0, 9999);
    painter.plate(upper, "DH", painter.type().label, color);
    painter.plate(lower, whole_number(height).view(), 1, color);
}

using InformationRow = base::FixedVector<std::string_view, 8>;

/// Notices that inform, the first `left_out` of them only counted: the last ones say that the flight is not a real one.
FittedText information_text(const InformationRow& row, std::size_t left_out, bool is_short) {
    const std::string_view gap = is_short ? " \xC2\xB7 " : "  \xC2\xB7  ";
    FittedText text;
    if (left_out > 0) {
        text.append("+");
        text.append(whole_number(static_cast<double>(left_out)).view());
    }
    for (std::size_t n = left_out; n < row.size(); ++n) {
        if (!text.empty()) text.append(gap);
        text.append(is_short ? short_wording(row[n]) : row[n]);
    }
    return text;
}

}  // namespace

void build_baro_setting(const Painter& painter, const SymbologyInput& input) {
    const ElementShow show = input.decisions[Element::baro_setting].show;
    const Rect& box = painter.layout().baro_setting;
    if (show == ElementShow::absent) return;
    if (show == ElementShow::failed) return painter.failed(box, "BARO SET FAIL");
    const double hpa = limited(input.baro_setting_pa / base::kPascalsPerHectopascal, 0, 9999);
    const bool is_stale = show == ElementShow::flagged;
    const Words label = is_stale ? Words({"STALE QNH HPA", "STALE QNH", "QNH"}) : label_words("QNH HPA");
    labelled_number(painter, box, label, whole_number(hpa).view(), show);
}

void build_ground_height(const Painter& painter, const SymbologyInput& input) {
    const policy::ElementDecision& decision = input.decisions[Element::ground_height];
    Rect box = painter.layout().ground_height;
    build_radio_minimum(painter, input, take_right(box, 0.42f, input.decisions[Element::radio_minimum].show));
    if (decision.show == ElementShow::absent) return;
    const bool radio = decision.source != flight::Signal::height_above_terrain;
    if (decision.show == ElementShow::failed) return painter.failed(box, "AGL FAIL");
    const base::DisplayUnit unit = base::height_unit(input.shown.units);
    const double height = limited(unit.of(input.ground_height_m), -999, 99'999);
    const GroundHeightLabel label(radio ? "RA" : "AGL", decision.show == ElementShow::flagged, unit.text);
    labelled_number(painter, box, label.words(), whole_number(height).view(), decision.show);
}

void build_information(const Painter& painter, const SymbologyInput& input) {
    InformationRow row;
    for (const policy::Notice& notice : input.decisions.notices)
        if (notice.level == policy::NoticeLevel::information) static_cast<void>(row.try_push_back(notice.text.view()));
    if (row.empty()) return;
    const Rect& box = painter.layout().information;
    const float room = box.width - 2 * painter.stroke_px();
    const auto draw = [&](const FittedText& text) {
        painter.fitted_text(text.view(), box, TextAnchor::center, painter.type().label, painter.color(SymbolRole::scale));
    };
    const auto fits = [&](const FittedText& text) { return text_width_px(text.view(), kMinText_px) <= room; };
    const FittedText whole = information_text(row, 0, false);
    if (fits(whole)) return draw(whole);
    for (std::size_t left_out = 0; left_out + 1 < row.size(); ++left_out) {
        const FittedText shorter = information_text(row, left_out, true);
        if (fits(shorter)) return draw(shorter);
    }
    draw(information_text(row, row.size() - 1, true));
}

}  // namespace tedavis::draw
