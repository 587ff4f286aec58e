#include "render_core/draw/symbology/data_legend.hpp"

#include <algorithm>

#include "render_core/draw/symbology/legend_entry.hpp"
#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {
namespace {

/// Entries that stand at this detail: an entry without a scale is the last.
std::size_t count_at(const DataLegends& legends, LegendDetail detail) {
    const bool ends_without = !legends.empty() && !legends.back().has_scale && detail >= LegendDetail::scales_alone;
    return legends.size() - (ends_without ? 1 : 0);
}

/// Areas are columns of five texts, or rows of several entries.
bool is_row(const Rect& area, float text_px) { return area.width > 8 * text_px; }

/// Entries in areas, as many as fit one after the other.
class Filling {
public:
    Filling(const DataLegends& legends, const Layout& layout, LegendDetail detail)
        : legends_(legends), layout_(layout), detail_(detail), count_(count_at(legends, detail)) {
        plan_.detail = detail;
        for (const Rect& area : layout.data_legends) {
            if (area.empty()) continue;
            if (is_row(area, layout.text_px))
                fill_row(area);
            else
                fill_column(area);
        }
        plan_.cut = legends.size() - plan_.shown;
    }
    [[nodiscard]] const DataLegendPlan& plan() const { return plan_; }
    [[nodiscard]] bool has_all() const { return plan_.shown == count_; }

private:
    void place(const Rect& box) { plan_.boxes[plan_.shown++] = box; }

    void fill_column(const Rect& area) {
        const float t = layout_.text_px;
        float y = area.y;
        while (plan_.shown < count_) {
            const float height = data_legend_height(legends_[plan_.shown], detail_) * t;
            if (y + height > area.bottom() + (kLegendEntryGap + 0.01f) * t) return;
            place({area.x, y, area.width, height - kLegendEntryGap * t});
            y += height;
        }
    }

    /// A row has room for the shortest only.
    void fill_row(const Rect& area) {
        if (detail_ != LegendDetail::scale) return;
        const float t = layout_.text_px, pitch = (area.width + kLegendEntryGap * t) / 3;
        for (int n = 0; n < 3 && plan_.shown < count_; ++n)
            place({area.x + pitch * static_cast<float>(n), area.y, pitch - kLegendEntryGap * t,
                   (data_legend_height(legends_[plan_.shown], detail_) - kLegendEntryGap) * t});
    }

    const DataLegends& legends_;
    const Layout& layout_;
    LegendDetail detail_;
    std::size_t count_;
    DataLegendPlan plan_;
};

/// "12 MIN" of an age that is not negative.
ShortText span_text(std::int64_t ns) {
    constexpr std::int64_t kMinute = 60'000'000'000;
    const std::int64_t minutes = ns / kMinute;
    const bool in_minutes = minutes < 100, in_hours = minutes < 48 * 60;
    const std::int64_t count = in_minutes ? minutes : in_hours ? minutes / 60 : minutes / (24 * 60);
    ShortText text = whole_number(static_cast<double>(count));
    text.append(in_minutes ? " MIN" : in_hours ? " H" : " D");
    return text;
}

}  // namespace

DataLegendNeed data_legend_need(const DataLegends& legends) noexcept {
    DataLegendNeed need;
    need.entries = legends.size();
    for (const DataLegend& legend : legends) {
        need.whole += data_legend_height(legend, LegendDetail::whole);
        need.shortest += data_legend_height(legend, LegendDetail::scale);
    }
    // The last one needs no gap.
    if (need.whole > 0) need.whole -= kLegendEntryGap;
    if (need.shortest > 0) need.shortest -= kLegendEntryGap;
    return need;
}

DataLegendPlan plan_data_legends(const DataLegends& legends, const Layout& layout) noexcept {
    for (std::size_t n = 0; n + 1 < kLegendDetails; ++n) {
        const Filling filling(legends, layout, static_cast<LegendDetail>(n));
        if (filling.has_all()) return filling.plan();
    }
    return Filling(legends, layout, LegendDetail::scale).plan();
}

void build_data_legends(const Painter& painter, const DataLegends& legends) {
    const DataLegendPlan plan = plan_data_legends(legends, painter.layout());
    for (std::size_t n = 0; n < plan.shown; ++n)
        build_legend_entry(painter, legends[n], plan.detail, plan.boxes[n], n + 1 == plan.shown ? plan.cut : 0);
}

base::FixedString<31> time_and_age(const DataLegend& legend) noexcept {
    if (!legend.has_time) return {};
    constexpr std::int64_t kMinute = 60'000'000'000, kDay = 24 * 60 * kMinute;
    const std::int64_t minutes = ((legend.data_time_ns % kDay) + kDay) % kDay / kMinute, hour = minutes / 60,
                       minute = minutes % 60;
    base::FixedString<31> text(whole_number(static_cast<double>(hour), 2).view());
    text.append(":");
    text.append(whole_number(static_cast<double>(minute), 2).view());
    text.append("Z ");
    if (!legend.has_age) {
        text.append("AGE ?");
        return text;
    }
    if (legend.is_stale) text.append("STALE ");
    if (legend.age.ns < 0) text.append("IN ");
    if (legend.is_forecast) text.append("+");
    text.append(span_text(legend.age.ns < 0 ? -legend.age.ns : legend.age.ns).view());
    return text;
}

}  // namespace tedavis::draw
