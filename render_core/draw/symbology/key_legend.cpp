#include "render_core/draw/symbology/key_legend.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/symbology/fitted_words.hpp"
#include "render_core/draw/symbology/legend_numbers.hpp"
#include "render_core/draw/symbology/legend_sample.hpp"
#include "render_core/draw/symbology/terrain_scale.hpp"

namespace tedavis::draw {
namespace {

enum KeyRank : int { kMemberRank, kBandsRank, kStaleRank, kDataRank, kTerrainRank };

// In ems of the key's text.
constexpr float kTitleRow = 1.15f, kKeyInset = 0.3f, kNumberSpace = 0.3f;
constexpr float kKeyBarHeight = 0.7f;
constexpr double kEndShare = 0.1;  // of the scale: numbers at its ends are written to a step of so much

void add_title(std::string_view a, std::string_view b, std::string_view c, KeyEntry& entry) {
    base::FixedString<47> title;
    for (const std::string_view part : {a, b, c}) {
        if (part.empty()) continue;
        if (!title.empty()) title.append(" ");
        title.append(part);
    }
    if (!title.empty()) static_cast<void>(entry.titles.try_push_back(title));
}

void add_number(const ShortText& text, std::size_t after, KeyEntry& entry) {
    static_cast<void>(entry.numbers.try_push_back({text, after}));
}

void add_colors(const design::Palette& palette, double low, double high, KeyEntry& entry) {
    for (std::size_t n = 0; n < kKeySlices; ++n) {
        const double share = (static_cast<double>(n) + 0.5) / static_cast<double>(kKeySlices);
        static_cast<void>(entry.colors.try_push_back(color_of_value(palette, low + (high - low) * share)));
    }
}

KeyEntry terrain_entry(const LegendInput& legend) {
    const TerrainScale scale = terrain_scale(legend);
    KeyEntry entry;
    entry.rank = kTerrainRank;
    add_title(legend.palette.title.view(), scale.unit, "", entry);
    add_title("GROUND", scale.unit, "", entry);
    add_colors(legend.palette, scale.low, scale.high, entry);
    add_number(whole_number(scale.low * scale.factor), 0, entry);
    add_number(whole_number(scale.high * scale.factor), entry.colors.size(), entry);
    return entry;
}

/// From the lowest band up; the last number stands where the highest begins.
KeyEntry bands_entry(const LegendInput& legend) {
    KeyEntry entry;
    entry.rank = kBandsRank;
    const double factor = base::height_unit(legend.units).of(1);
    const design::Color ground = legend.tint ? color_of_value(legend.palette, terrain_scale(legend).low) : legend.plain;
    add_title("RELATIVE", base::height_unit(legend.units).text, "", entry);
    const design::WarningBands& bands = legend.warning_bands;
    for (std::size_t n = bands.size(); n > 0; --n)
        static_cast<void>(entry.colors.try_push_back(blended(ground, bands[n - 1].color, bands[n - 1].strength)));
    add_number(signed_number(bands.back().lower_m * factor), 0, entry);
    if (bands.size() > 1) add_number(signed_number(bands[0].lower_m * factor), bands.size() - 1, entry);
    return entry;
}

/// "STALE 25 MIN", "AGE ?"; empty while the age is known and within its limit.
std::string_view age_remark(const DataLegend& legend, const base::FixedString<31>& time) {
    const bool is_amber = legend.has_time && (legend.is_stale || !legend.has_age);
    return is_amber ? time.view().substr(time.view().find(' ') + 1) : std::string_view();
}

void add_data_titles(const DataLegend& legend, KeyEntry& entry) {
    const base::FixedString<31> time = time_and_age(legend);
    const std::string_view title = legend.title.view(), part = legend.part.view(), unit = legend.unit.view(),
                           age = age_remark(legend, time);
    entry.is_amber = !age.empty();
    entry.rank = !part.empty() ? kMemberRank : entry.is_amber ? kStaleRank : kDataRank;
    if (entry.is_amber) {
        add_title(title, unit, age, entry);
        add_title(title, age, "", entry);
        return add_title(age, "", "", entry);
    }
    add_title(part, title, unit, entry);
    // The first word of a name with its unit says more than the name without.
    if (part.empty() && !unit.empty()) add_title(title.substr(0, title.find(' ')), unit, "", entry);
    add_title(part, title, "", entry);
    if (!part.empty()) add_title(part, "", "", entry);
}

KeyEntry data_entry(const DataLegend& legend) {
    KeyEntry entry;
    add_data_titles(legend, entry);
    const auto& breaks = legend.scale.breaks;
    if (breaks.empty()) {
        const double low = lowest(legend.scale), high = highest(legend.scale);
        const double from = written(legend, low), to = written(legend, high), step = nice_step(std::fabs(to - from) * kEndShare);
        add_colors(legend.scale.palette, low, high, entry);
        add_number(number_text(from, step), 0, entry);
        add_number(number_text(to, step), entry.colors.size(), entry);
        return entry;
    }
    for (std::size_t n = 0; n <= breaks.size(); ++n)
        static_cast<void>(entry.colors.try_push_back(color_of_class(legend.scale, n)));
    const auto limit = [&](std::size_t n) {
        const double value = written(legend, breaks[n]);
        add_number(number_text(value, value), n + 1, entry);
    };
    limit(0);
    if (breaks.size() > 1) limit(breaks.size() - 1);
    return entry;
}

/// Of one entry: the cell from its left end on.
class KeyCellBuilder {
public:
    KeyCellBuilder(const Painter& painter, const KeyCell& cell, const Rect& box)
        : painter_(painter), em_(cell.em_px), box_(box), size_(cell.em_px / painter.text_px()) {}

    void build(const KeyEntry& entry) {
        painter_.batch().box(box_, painter_.color(SymbolRole::tape_ground));
        const Rect row{box_.x, box_.y, box_.width, kTitleRow * em_};
        const float room = box_.width - 2 * kKeyInset * em_;
        painter_.text(fitting_title(entry, room).view(), {box_.x + kKeyInset * em_, row.center().y}, TextAnchor::left, size_,
                      entry.is_amber ? painter_.color(SymbolRole::caution) : painter_.color(SymbolRole::scale), 0, TextRim::none);
        build_scale(entry, {box_.x + kKeyInset * em_, row.bottom(), room, box_.bottom() - row.bottom()});
    }

private:
    [[nodiscard]] FittedText fitting_title(const KeyEntry& entry, float room) const {
        for (const auto& title : entry.titles)
            if (text_width_px(title.view(), em_) <= room) return FittedText(title.view());
        return cut_words(entry.titles.back().view(), room, em_);
    }

    void build_scale(const KeyEntry& entry, const Rect& row) {
        float taken = 0;
        for (const KeyEntry::Number& number : entry.numbers)
            taken += text_width_px(number.text.view(), em_) + ends_of(number, entry) * kNumberSpace * em_;
        const float slice = std::max(0.0f, row.width - taken) / static_cast<float>(entry.colors.size());
        std::size_t done = 0;
        x_ = row.x;
        for (const KeyEntry::Number& number : entry.numbers) {
            build_colors(entry, done, number.after, slice, row);
            if (number.after > 0) x_ += kNumberSpace * em_;
            painter_.text(number.text.view(), {x_, row.center().y}, TextAnchor::left, size_, painter_.color(SymbolRole::scale), 0,
                          TextRim::none);
            x_ += text_width_px(number.text.view(), em_);
            if (number.after < entry.colors.size()) x_ += kNumberSpace * em_;
            done = number.after;
        }
        build_colors(entry, done, entry.colors.size(), slice, row);
    }

    /// Sides of a number at which colors stand.
    static float ends_of(const KeyEntry::Number& number, const KeyEntry& entry) {
        return (number.after > 0 ? 1.0f : 0.0f) + (number.after < entry.colors.size() ? 1.0f : 0.0f);
    }

    /// Each slice reaches under the next one, so that no seam shows between two.
    void build_colors(const KeyEntry& entry, std::size_t from, std::size_t to, float slice, const Rect& row) {
        if (to <= from) return;
        const Rect bar{x_, row.center().y - 0.5f * kKeyBarHeight * em_, slice * static_cast<float>(to - from),
                       kKeyBarHeight * em_};
        for (std::size_t n = from; n < to; ++n) {
            const float left = bar.x + slice * static_cast<float>(n - from);
            painter_.batch().box({left, bar.y, std::min(slice + kUnder_px, bar.right() - left), bar.height}, entry.colors[n]);
        }
        painter_.batch().frame(bar, std::max(1.0f, 0.5f * painter_.stroke_px()), painter_.color(SymbolRole::scale));
        x_ = bar.right();
    }

    const Painter& painter_;
    float em_;
    Rect box_;
    float size_;
    float x_ = 0;
};

}  // namespace

KeyEntries key_entries(const SymbologyInput& input) noexcept {
    KeyEntries entries;
    if (!input.shown.legend) return entries;
    const bool is_key = input.legend_show != flight::LegendShow::none;
    for (const DataLegend& legend : input.data_legends)
        if (legend.has_scale && legend.class_names.empty() && (is_key || !legend.part.empty()))
            static_cast<void>(entries.try_push_back(data_entry(legend)));
    if (is_key && input.legend.bands && !input.legend.warning_bands.empty())
        static_cast<void>(entries.try_push_back(bands_entry(input.legend)));
    if (is_key && input.legend.tint) static_cast<void>(entries.try_push_back(terrain_entry(input.legend)));
    // An insertion sort allocates nothing, and keeps the order of entries of one rank.
    for (std::size_t n = 1; n < entries.size(); ++n)
        for (std::size_t k = n; k > 0 && entries[k].rank < entries[k - 1].rank; --k) std::swap(entries[k], entries[k - 1]);
    return entries;
}

void build_key(const Painter& painter, const SymbologyInput& input) {
    const KeyPlan& plan = painter.layout().key;
    if (plan.shown == 0) return;
    const KeyEntries entries = key_entries(input);
    for (std::size_t n = 0; n < std::min(plan.shown, entries.size()); ++n)
        KeyCellBuilder(painter, plan.cell, plan.cell_at(n)).build(entries[n]);
}

}  // namespace tedavis::draw
