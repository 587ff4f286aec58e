#include "render_core/draw/symbology/annunciations.hpp"

#include <algorithm>
#include <string_view>

#include "render_core/base/check.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/activity_mark.hpp"
#include "render_core/draw/symbology/short_words.hpp"

namespace tedavis::draw {
namespace {

using policy::Notice;
using policy::NoticeLevel;

// Sizes and distances in texts.
constexpr float kPhaseText = 0.85f, kSourceText = 0.65f, kNoticeText = 0.8f;
constexpr float kStripMargin = 0.4f;  // left and right of all fields
constexpr float kStripEdge = 0.2f;    // above and below them
constexpr float kRowEdge = 0.06f;     // above and below a notice in its row
constexpr float kNoticeGap = 0.3f;    // between notices
constexpr float kPhaseGap = 0.8f;     // between the phase and the first notice
constexpr float kNoticePad = 0.35f;   // between the words of a notice and its frame, at either side
constexpr float kMinNoticePad_px = 3;
constexpr float kMaxPhase = 0.48f;    // share of the strip's width
constexpr float kTwoRows = 2.4f;      // height from which the strip has two rows
constexpr float kPhaseShare = 0.54f;  // of the height; the rest has the source

/// "first_climb" as "FIRST CLIMB".
void append_upper(base::FixedString<63>& text, std::string_view name) {
    for (const char c : name) {
        const char upper = c == '_' ? ' ' : c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        text.append(std::string_view(&upper, 1));
    }
}

std::string_view source_text(flight::PhaseSource source) {
    switch (source) {
        case flight::PhaseSource::switches: return "PHASE BY SWITCH";
        case flight::PhaseSource::can: return "PHASE BY BUS";
        case flight::PhaseSource::motion: return "PHASE FROM MOTION";
        case flight::PhaseSource::held: return "PHASE HELD";
        case flight::PhaseSource::none: break;
    }
    return "PHASE NO SOURCE";
}

base::FixedString<63> phase_text(const flight::FlightPhase& phase) {
    base::FixedString<63> text;
    append_upper(text, scenario_name(phase));
    const std::string_view sub_phase = sub_phase_name(phase);
    if (!sub_phase.empty()) text.append(" ");
    append_upper(text, sub_phase);
    return text;
}

/// Lays out one strip; notices go from `left_` to `right_` in each row.
class StripPlan {
public:
    StripPlan(const Rect& strip, float text_px)
        : strip_(strip),
          t_(text_px),
          left_(strip.x + kStripMargin * text_px),
          right_(strip.right() - kStripMargin * text_px),
          rows_(strip.height >= kTwoRows * text_px ? 2 : 1) {}

    void add_phase(const flight::PhaseStatus& status) {
        Annunciation phase{AnnunciationKind::phase, {}, legible_size(kPhaseText, t_), phase_text(status.phase)};
        Annunciation source{AnnunciationKind::phase_source, {}, legible_size(kSourceText, t_), source_text(status.source)};
        for (Annunciation* field : {&phase, &source}) shorten(*field, kMaxPhase * strip_.width);
        const float width = std::min(kMaxPhase * strip_.width, std::max(width_of(phase), width_of(source)));
        const float top = strip_.y + kStripEdge / 2 * t_, height = strip_.height - kStripEdge * t_;
        phase.box = {left_, top, width, kPhaseShare * height};
        source.box = {left_, phase.box.bottom(), width, height - phase.box.height};
        add(plan_, phase);
        add(plan_, source);
        left_ += width + kPhaseGap * t_;
    }

    /// As many of the notices as have room.
    void add_notices(base::Span<const Notice> notices) {
        std::size_t count = 0;
        for (const Notice& notice : notices) count += notice.level != NoticeLevel::information ? 1 : 0;
        for (std::size_t shown = count; shown > 0; --shown) {
            AnnunciationPlan tried = plan_;
            if (!place(notices, shown, count - shown, tried)) continue;
            plan_ = tried;
            return;
        }
    }

    [[nodiscard]] const AnnunciationPlan& plan() const { return plan_; }

private:
    struct Pen {
        float x = 0;
        std::size_t row = 0;
    };

    static void add(AnnunciationPlan& plan, const Annunciation& field) {
        const bool added = plan.fields.try_push_back(field);
        TEDAVIS_CHECK(added);
    }

    [[nodiscard]] float width_of(const Annunciation& field) const {
        return text_width_px(field.text.view(), field.size * t_) + 2 * std::max(kNoticePad * t_, kMinNoticePad_px);
    }

    /// To the shorter wording where the whole one is wider.
    void shorten(Annunciation& field, float most) const {
        if (width_of(field) > most) field.text = short_wording(field.text.view());
    }

    /// False where a field has no room. The last attempt, with one notice, makes it narrower instead.
    bool place(base::Span<const Notice> notices, std::size_t shown, std::size_t others, AnnunciationPlan& plan) const {
        Annunciation more{AnnunciationKind::more, {}, legible_size(kNoticeText, t_), "+"};
        more.text.append(whole_number(static_cast<double>(others)).view());
        more.text.append(" MORE");
        const float for_more = shown == 1 && others > 0 && rows_ == 1 ? width_of(more) + kNoticeGap * t_ : 0;
        Pen pen{left_, 0};
        std::size_t placed = 0;
        for (const Notice& notice : notices) {
            if (notice.level == NoticeLevel::information || placed == shown) continue;
            const bool is_warning = notice.level == NoticeLevel::warning;
            const Annunciation field{is_warning ? AnnunciationKind::warning : AnnunciationKind::caution,
                                     {},
                                     legible_size(kNoticeText, t_),
                                     notice.text.view()};
            if (!put(field, right_ - left_ - for_more, pen, plan)) return false;
            ++placed;
        }
        plan.left_out = others;
        return others == 0 || put(more, right_ - left_, pen, plan);
    }

    bool put(Annunciation field, float most, Pen& pen, AnnunciationPlan& plan) const {
        shorten(field, most);
        const float width = std::min(width_of(field), most),
                    height = (strip_.height - kStripEdge * t_) / static_cast<float>(rows_);
        const float rounding = 0.001f * t_;
        if (pen.x + width > right_ + rounding) {
            if (pen.row + 1 == rows_) return false;
            pen = {left_, pen.row + 1};
        }
        const float y = strip_.y + kStripEdge / 2 * t_ + static_cast<float>(pen.row) * height, edge = kRowEdge * t_;
        field.box = {pen.x, y + edge, width, height - 2 * edge};
        pen.x += width + kNoticeGap * t_;
        add(plan, field);
        return true;
    }

    Rect strip_;
    float t_, left_, right_;
    std::size_t rows_;
    AnnunciationPlan plan_;
};

SymbolRole role_of(AnnunciationKind kind, bool is_certain) {
    switch (kind) {
        case AnnunciationKind::phase:
        case AnnunciationKind::phase_source: return is_certain ? SymbolRole::engaged : SymbolRole::caution;
        case AnnunciationKind::warning: return SymbolRole::warning;
        case AnnunciationKind::caution:
        case AnnunciationKind::more: break;
    }
    return SymbolRole::caution;
}

void build_field(const Painter& painter, const Annunciation& field, design::Color color) {
    const bool is_phase = field.kind == AnnunciationKind::phase || field.kind == AnnunciationKind::phase_source;
    if (!is_phase) {
        const float stroke = painter.stroke_px();
        painter.batch().frame(field.box, 2.5f * stroke, painter.color(SymbolRole::rim));
        painter.batch().frame(field.box.shrunk(0.75f * stroke), stroke, color);
    }
    painter.fitted_text(field.text.view(), field.box, is_phase ? TextAnchor::left : TextAnchor::center, field.size, color);
}

}  // namespace

bool is_phase_certain(const flight::PhaseStatus& status) noexcept {
    return status.source != flight::PhaseSource::none && status.source != flight::PhaseSource::held;
}

AnnunciationPlan plan_annunciations(const Rect& strip, float text_px, const flight::PhaseStatus* phase,
                                    base::Span<const Notice> notices) noexcept {
    StripPlan plan(strip, text_px);
    if (phase != nullptr) plan.add_phase(*phase);
    plan.add_notices(notices);
    return plan.plan();
}

void build_annunciations(const Painter& painter, const SymbologyInput& input) {
    const auto& notices = input.decisions.notices;
    const Rect& strip = painter.layout().annunciations;
    const Rect texts = shows_activity(input, strip) ? beside_activity_mark(strip, painter.text_px()) : strip;
    const AnnunciationPlan plan = plan_annunciations(texts, painter.text_px(), input.shown.phase ? &input.phase : nullptr,
                                                     {notices.data(), notices.size()});
    if (plan.fields.empty()) return;
    painter.batch().box(strip, painter.color(SymbolRole::strip_ground));
    for (const Annunciation& field : plan.fields)
        build_field(painter, field, painter.color(role_of(field.kind, is_phase_certain(input.phase))));
    build_activity_mark(painter, input);
}

}  // namespace tedavis::draw
