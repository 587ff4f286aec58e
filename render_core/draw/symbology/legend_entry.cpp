#include "render_core/draw/symbology/legend_entry.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/legend_numbers.hpp"
#include "render_core/draw/symbology/legend_sample.hpp"
#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {
namespace {

// In texts.
constexpr float kEntryTitle = 1.0f;
constexpr float kRow = 0.85f;
constexpr float kBar = 0.75f, kNumbers = 0.75f;
constexpr float kEnds = 0.45f;  // half a number beyond each end of an upright scale
constexpr float kClass = 1.0f;
constexpr float kContinuous = 5, kMaxUpright = 8;
constexpr float kEntryInset = 0.3f, kEntryPad = 0.1f;
constexpr float kText = 0.7f;
constexpr float kNumberGap = 0.12f;

/// Names that stand in the legend; the rest is counted in a row of its own.
std::size_t named_classes(const DataLegend& legend, LegendDetail detail) {
    const std::size_t most = detail == LegendDetail::whole           ? design::kMaxClasses
                             : detail <= LegendDetail::without_signs ? 8
                             : detail < LegendDetail::scale          ? 3
                                                                     : 0;
    return std::min(most, legend.class_names.size());
}

float scale_height(const DataLegend& legend, LegendDetail detail) {
    if (!legend.has_scale) return 0;
    const std::size_t named = named_classes(legend, detail);
    if (named > 0) return kRow * static_cast<float>(named + (named < legend.class_names.size() ? 1 : 0));
    if (detail != LegendDetail::whole || !legend.class_names.empty()) return kBar + kNumbers;
    const auto classes = static_cast<float>(legend.scale.breaks.size() + 1);
    return 2 * kEnds + (classes < 2 ? kContinuous : std::min(kClass * classes, kMaxUpright));
}

/// The shortest entries are all of one height, for rows of them.
bool has_part_row(const DataLegend& legend, LegendDetail detail) { return !legend.part.empty() && detail < LegendDetail::scale; }

/// Rows under the scale.
struct Rows {
    bool time = false, age = false, line = false, source = false;
    std::size_t uncertainty = 0, signs = 0;

    [[nodiscard]] std::size_t count() const {
        return (time ? 1u : 0u) + (age ? 1u : 0u) + (line ? 1u : 0u) + (source ? 1u : 0u) + uncertainty + signs;
    }
};

Rows rows_of(const DataLegend& legend, LegendDetail detail) {
    Rows rows;
    rows.time = legend.has_time && detail < LegendDetail::scale;
    // With the word beside them time and age are too long for one.
    rows.age = rows.time && legend.is_stale && detail < LegendDetail::uncertainty_line;
    rows.line = (detail == LegendDetail::uncertainty_line || detail == LegendDetail::scales_alone) && !legend.uncertainty.empty();
    rows.uncertainty = detail < LegendDetail::uncertainty_line ? legend.uncertainty.size() : 0;
    const LegendDetail first_without = legend.has_scale ? LegendDetail::without_signs : LegendDetail::scales_alone;
    rows.signs = detail < first_without ? legend.signs.size() : 0;
    rows.source = detail < LegendDetail::without_source && !legend.source.empty();
    return rows;
}

/// Numbers along a scale, by their share of its length.
struct Mark {
    float share = 0;
    ShortText text;
};
using Marks = base::FixedVector<Mark, kMaxNumbers>;

/// The limits of the classes.
Marks class_marks(const DataLegend& legend) {
    const auto& breaks = legend.scale.breaks;
    Marks marks;
    for (std::size_t n = 0; n < breaks.size(); ++n)
        static_cast<void>(marks.try_push_back({static_cast<float>(n + 1) / static_cast<float>(breaks.size() + 1),
                                               number_text(written(legend, breaks[n]), written(legend, breaks[n]))}));
    return marks;
}

/// Round values; `pitch`: least share between two.
Marks value_marks(const DataLegend& legend, double pitch) {
    const double low = written(legend, lowest(legend.scale)), high = written(legend, highest(legend.scale));
    const double step = nice_step((high - low) * pitch);
    constexpr double kRounding = 1e-6;  // of a step: an end that is a round number is written
    const double first = std::ceil(low / step - kRounding);
    Marks marks;
    for (int n = 0; n < kMaxNumbers && (first + n) * step <= high + kRounding * step; ++n) {
        const double value = (first + n) * step;
        static_cast<void>(marks.try_push_back({static_cast<float>((value - low) / (high - low)), number_text(value, step)}));
    }
    return marks;
}

/// The pieces of an entry from the top of its box down.
class Entry {
public:
    Entry(const Painter& painter, const DataLegend& legend, LegendDetail detail, const Rect& box)
        : painter_(painter), legend_(legend), detail_(detail), t_(painter.text_px()), box_(box), y_(box.y) {}

    void build(std::size_t cut) {
        painter_.batch().box(box_, painter_.color(SymbolRole::tape_ground));
        build_title(cut);
        if (has_part_row(legend_, detail_)) build_centred(legend_.part.view(), false);
        if (legend_.has_scale) build_scale();
        build_rows();
    }

private:
    void build_scale() {
        if (named_classes(legend_, detail_) > 0)
            build_names();
        else if (detail_ == LegendDetail::whole)
            build_upright();
        else
            build_flat();
    }

    [[nodiscard]] Rect row(float height) {
        const Rect at{box_.x, y_, box_.width, height * t_};
        y_ += at.height;
        return at;
    }
    [[nodiscard]] bool has_classes() const { return !legend_.scale.breaks.empty(); }

    void build_title(std::size_t cut) {
        Rect at = row(kEntryTitle);
        if (cut > 0) {
            ShortText more("+");
            more.append(whole_number(static_cast<double>(cut)).view());
            at.width -= 1.2f * t_;
            painter_.plate({at.right(), at.y, 1.2f * t_, at.height}, more.view(), kText, painter_.color(SymbolRole::caution));
        }
        base::FixedString<63> text;
        if (!legend_.part.empty() && !has_part_row(legend_, detail_)) {
            text.append(legend_.part.view());
            text.append(" ");
        }
        text.append(legend_.title.view());
        if (!legend_.unit.empty()) text.append(" ");
        text.append(legend_.unit.view());
        painter_.plate(at, text.view(), 0.75f, painter_.color(legend_.is_stale ? SymbolRole::caution : SymbolRole::scale));
    }

    void build_names() {
        const std::size_t named = named_classes(legend_, detail_);
        for (std::size_t n = 0; n < named; ++n) {
            LegendSample sample;
            sample.color = scale_color(legend_.scale, static_cast<double>(n));
            build_sample(sample, legend_.class_names[n].view());
        }
        if (named < legend_.class_names.size()) count_names(row(kRow), "+", named, " MORE");
    }

    void count_names(const Rect& at, std::string_view before, std::size_t named, std::string_view behind) const {
        ShortText text(before);
        text.append(whole_number(static_cast<double>(legend_.class_names.size() - named)).view());
        text.append(behind);
        painter_.fitted_text(text.view(), at, TextAnchor::center, kText, painter_.color(SymbolRole::scale), TextRim::none);
    }

    /// A share of the bar's length from its low end: of class n where there are classes.
    [[nodiscard]] design::Color color_at(double share) const {
        const design::DataScale& scale = legend_.scale;
        if (!legend_.class_names.empty())
            return scale_color(scale, std::floor(share * static_cast<double>(legend_.class_names.size())));
        if (has_classes())
            return color_of_class(scale, static_cast<std::size_t>(share * static_cast<double>(scale.breaks.size() + 1)));
        return color_of_value(scale.palette, lowest(scale) + (highest(scale) - lowest(scale)) * share);
    }
    [[nodiscard]] int slices() const {
        if (!legend_.class_names.empty()) return static_cast<int>(legend_.class_names.size());
        return has_classes() ? static_cast<int>(legend_.scale.breaks.size() + 1) : kBarSlices;
    }

    /// Each slice reaches under the next one, so that no seam shows between two.
    void build_bar(const Rect& bar, bool upright) const {
        const int count = slices();
        for (int n = 0; n < count; ++n) {
            const float from = static_cast<float>(n) / static_cast<float>(count);
            const design::Color color = color_at((n + 0.5) / count);
            if (upright) {
                const float height = bar.height * (1 - from);
                painter_.batch().box({bar.x, bar.y, bar.width, height}, color);
            } else {
                const float left = bar.width * from;
                painter_.batch().box({bar.x + left, bar.y,
                                      std::min(bar.width / static_cast<float>(count) + kUnder_px, bar.width - left), bar.height},
                                     color);
            }
        }
        painter_.batch().frame(bar, painter_.stroke_px(), painter_.color(SymbolRole::scale));
    }

    void build_upright() {
        const Rect whole = row(scale_height(legend_, detail_));
        const Rect bar{whole.x + kEntryInset * t_, whole.y + kEnds * t_, kSampleWidth * t_, whole.height - 2 * kEnds * t_};
        build_bar(bar, true);
        const Marks marks = has_classes() ? class_marks(legend_) : value_marks(legend_, double{kRow * t_ / bar.height});
        float last = bar.bottom() + whole.height;
        for (const Mark& mark : marks) {
            const float y = bar.bottom() - bar.height * mark.share;
            if (last - y < kRow * t_ - 0.1f) continue;
            last = y;
            painter_.batch().box({bar.right() - 0.4f * t_, y - painter_.stroke_px() / 2, 0.4f * t_, painter_.stroke_px()},
                                 painter_.color(SymbolRole::scale));
            build_text(mark.text.view(), {bar.right(), y - kRow * t_ / 2, whole.right() - bar.right(), kRow * t_});
        }
    }

    /// So small that all limits have room, if they can be read then.
    [[nodiscard]] float number_size(const Marks& marks, float bar_width) const {
        const float smallest = std::min(kText, std::max(0.58f, kMinText_px / t_));
        float widest = 0;
        for (const Mark& mark : marks) widest = std::max(widest, text_width_px(mark.text.view(), t_));
        const float room = bar_width / static_cast<float>(marks.size() + 1) - kNumberGap * t_;
        return std::clamp(room / std::max(widest, 1.0f), smallest, kText);
    }

    void build_flat() {
        const Rect upper = row(kBar), lower = row(kNumbers);
        const Rect bar{upper.x + kEntryInset * t_, upper.y + 0.05f * t_, upper.width - 2 * kEntryInset * t_,
                       upper.height - 0.05f * t_};
        build_bar(bar, false);
        if (!legend_.class_names.empty()) return count_names(lower, "", 0, " CLASSES");
        const double widest = static_cast<double>(
            text_width_px(number_text(written(legend_, highest(legend_.scale)), 1).view(), painter_.em_px(kText)) +
            (kNumberGap + 0.5f) * t_);
        const Marks marks = has_classes() ? class_marks(legend_) : value_marks(legend_, widest / static_cast<double>(bar.width));
        float taken = lower.x;
        const float size = has_classes() ? number_size(marks, bar.width) : kText;
        for (const Mark& mark : marks) {
            const float half = text_width_px(mark.text.view(), painter_.em_px(size)) / 2;
            const float x =
                std::clamp(bar.x + bar.width * mark.share, lower.x + half + 0.1f * t_, lower.right() - half - 0.1f * t_);
            if (x - half < taken) continue;
            taken = x + half + kNumberGap * t_;
            painter_.batch().box({bar.x + bar.width * mark.share - painter_.stroke_px() / 2, bar.bottom() - 0.3f * t_,
                                  painter_.stroke_px(), 0.3f * t_},
                                 painter_.color(SymbolRole::scale));
            painter_.text(mark.text.view(), {x, lower.center().y}, TextAnchor::center, size, painter_.color(SymbolRole::scale), 0,
                          TextRim::none);
        }
    }

    void build_rows() {
        const Rows rows = rows_of(legend_, detail_);
        for (std::size_t n = 0; n < rows.uncertainty; ++n)
            build_sample(legend_.uncertainty[n], legend_.uncertainty[n].text.view());
        if (rows.line) build_uncertainty_line(row(kRow));
        for (std::size_t n = 0; n < rows.signs; ++n) build_sample(legend_.signs[n], legend_.signs[n].text.view());
        if (rows.time) build_time(rows.age);
        if (rows.source)
            painter_.fitted_text(legend_.source.view(), row(kRow), TextAnchor::center, 0.6f, painter_.color(SymbolRole::scale),
                                 TextRim::none);
    }

    void build_time(bool in_two_rows) {
        const bool is_amber = legend_.is_stale || !legend_.has_age;
        const base::FixedString<31> whole = time_and_age(legend_);
        const std::size_t end = legend_.is_stale ? whole.view().find(' ') : whole.size();
        if (in_two_rows) build_centred(whole.view().substr(0, end), is_amber);
        build_centred(legend_.is_stale ? whole.view().substr(end + 1) : whole.view(), is_amber);
    }

    void build_centred(std::string_view text, bool is_amber) {
        painter_.fitted_text(text, row(kRow), TextAnchor::center, kText,
                             painter_.color(is_amber ? SymbolRole::caution : SymbolRole::scale), TextRim::none);
    }

    void build_sample(const LegendSample& sample, std::string_view text) {
        const Rect at = row(kRow);
        if (sample.look == SampleLook::words)
            return painter_.fitted_text(text, at, TextAnchor::center, kText, painter_.color(SymbolRole::scale), TextRim::none);
        const Rect swatch{at.x + kEntryInset * t_, at.y + 0.08f * t_, kSampleWidth * t_, at.height - 0.16f * t_};
        draw::build_sample(painter_, sample, swatch);
        build_text(text, {swatch.right(), at.y, at.right() - swatch.right(), at.height});
    }

    void build_text(std::string_view text, const Rect& at) const {
        painter_.fitted_text(text, at, TextAnchor::left, kText, painter_.color(SymbolRole::scale), TextRim::none);
    }

    /// The samples side by side with texts short enough to be read: "0", the full scale's number, "?".
    void build_uncertainty_line(const Rect& at) const {
        constexpr float kSwatch = 0.6f, kLetter = 0.65f;
        const std::size_t count = legend_.uncertainty.size();
        const float narrow = (kSwatch + kLetter) * t_, room = at.width - kEntryInset * t_;
        float x = at.x + kEntryInset * t_;
        for (std::size_t n = 0; n < count; ++n) {
            const LegendSample& sample = legend_.uncertainty[n];
            const std::string_view text = line_text(n);
            const float width = text.size() <= 1 ? narrow : room - narrow * static_cast<float>(count - 1);
            const Rect swatch{x, at.y + 0.08f * t_, kSwatch * t_, at.height - 0.16f * t_};
            draw::build_sample(painter_, sample, swatch);
            painter_.fitted_text(text, {swatch.right() - 0.1f * t_, at.y, width - swatch.width + 0.1f * t_, at.height},
                                 TextAnchor::left, kText, painter_.color(SymbolRole::scale), TextRim::none);
            x += width;
        }
    }

    [[nodiscard]] std::string_view line_text(std::size_t n) const {
        const std::string_view text = legend_.uncertainty[n].text.view();
        return text == kUnknownText ? "?" : n == 0 ? "0" : text.substr(0, text.find(' '));
    }

    const Painter& painter_;
    const DataLegend& legend_;
    LegendDetail detail_;
    float t_;
    Rect box_;
    float y_;
};

}  // namespace

float data_legend_height(const DataLegend& legend, LegendDetail detail) noexcept {
    if (!legend.has_scale && detail >= LegendDetail::scales_alone) return 0;
    return kEntryTitle + (has_part_row(legend, detail) ? kRow : 0) + scale_height(legend, detail) +
           kRow * static_cast<float>(rows_of(legend, detail).count()) + kEntryPad + kLegendEntryGap;
}

void build_legend_entry(const Painter& painter, const DataLegend& legend, LegendDetail detail, const Rect& box, std::size_t cut) {
    Entry(painter, legend, detail, box).build(cut);
}

}  // namespace tedavis::draw
