#include "render_core/display/planner/data_legends.hpp"

#include <cmath>
#include <cstdio>

#include "render_core/base/units.hpp"
#include "render_core/design/grey_of.hpp"

namespace tedavis::display {
namespace {

using design::Color;
using design::IntrinsicUncertainty;
using design::UncertaintyOverlay;
using draw::LegendSample;
using draw::SampleLook;

constexpr std::int64_t kMinute_ns = 60'000'000'000;

/// A zero-terminated field.
template <std::size_t N>
std::string_view field_text(const char (&field)[N]) {
    const std::string_view all(field, N);
    return all.substr(0, all.find('\0'));
}

char upper_of(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

template <std::size_t N>
void append_upper(base::FixedString<N>& text, std::string_view words) {
    for (char c : words) {
        const char upper = c == '_' ? ' ' : upper_of(c);
        text.append(std::string_view(&upper, 1));
    }
}

/// "folder/wind.tif" as "wind.tif"; of a longer name its first words.
std::string_view short_name(std::string_view source) {
    constexpr std::size_t kLegible = 12;
    const std::size_t slash = source.find_last_of('/');
    const std::string_view name = slash == std::string_view::npos ? source : source.substr(slash + 1);
    if (name.size() <= kLegible) return name;
    const std::size_t end = name.substr(0, kLegible + 1).find_last_of(" _-.,;");
    return name.substr(0, end == std::string_view::npos || end == 0 ? kLegible : end);
}

bool same_words(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;
    for (std::size_t n = 0; n < a.size(); ++n)
        if (upper_of(a[n]) != upper_of(b[n])) return false;
    return true;
}

std::string_view title_of(const scene::AttributeEntry& attribute) {
    const std::string_view title = field_text(attribute.title);
    return title.empty() ? field_text(attribute.name) : title;
}

/// Whether its uncertainty is a level without a unit: that of a class, or of data that do not state what counts as uncertain.
bool is_graded(const scene::AttributeEntry& attribute) {
    return attribute.uncertainty_kind == scene::UncertaintyKind::ordinal || !(attribute.uncertainty_full > 0);
}

/// Beyond its times a layer is as old as the nearest of them, by the rule that ages the uncertainty (GridField::age). Within them
/// what comes after the layer's own time is a forecast made then, and what comes before it was measured at the step before.
void set_time(const scene::Layer& layer, std::int64_t now_ns, draw::DataLegend& legend) {
    legend.data_time_ns = layer.entry->data_time_ns;
    const auto& times = layer.times_ns;
    if (times.empty()) return;
    const std::int64_t first = times[0], last = times[times.size() - 1],
                       own = legend.data_time_ns == scene::kNoTime ? first : legend.data_time_ns;
    legend.data_time_ns = now_ns < first ? first : last;
    if (now_ns < first || now_ns > last) return;
    legend.is_forecast = now_ns >= own && last > own;
    if (legend.is_forecast) legend.data_time_ns = own;
    for (std::size_t n = 0; !legend.is_forecast && n < times.size() && times[n] <= now_ns; ++n) legend.data_time_ns = times[n];
}

/// Of a sample in the middle of the scale.
Color sample_color(const design::GroundData& ground, Color plain) {
    const auto& stops = ground.scale.palette.stops;
    return blended(plain, scale_color(ground.scale, 0.5 * (stops[0].value + stops.back().value)), ground.opacity);
}

/// The look of the greatest uncertainty, as ground_data.frag draws it.
LegendSample unsure_sample(const design::GroundUncertainty& uncertainty, Color color, Color plain) {
    LegendSample sample;
    sample.color = color;
    sample.under = plain;
    sample.share = uncertainty.strength;
    switch (uncertainty.technique) {
        case IntrinsicUncertainty::none: break;
        case IntrinsicUncertainty::transparency:
        case IntrinsicUncertainty::bivariate: sample.color = blended(color, plain, uncertainty.strength); break;
        case IntrinsicUncertainty::saturation: sample.color = blended(color, grey_of(color), uncertainty.strength); break;
        case IntrinsicUncertainty::noise: sample.look = SampleLook::grains; break;
        case IntrinsicUncertainty::strokes: sample.look = SampleLook::strokes; break;
        case IntrinsicUncertainty::bump: sample.look = SampleLook::rough; break;
        case IntrinsicUncertainty::blur: sample.look = SampleLook::washed; break;
    }
    return sample;
}

LegendSample sample_of(std::string_view text, Color color, Color under, SampleLook look) {
    LegendSample sample;
    sample.text.append(text);
    sample.color = color;
    sample.under = under;
    sample.look = look;
    return sample;
}

/// The look of the greatest uncertainty, or of the threshold, as ground_overlay.frag draws it.
LegendSample overlay_sample(const design::GroundOverlay& overlay, Color color) {
    LegendSample sample;
    sample.color = color;
    sample.under = blended(color, overlay.color, overlay.strength);
    sample.share = 1;
    switch (overlay.technique) {
        case UncertaintyOverlay::none: break;
        case UncertaintyOverlay::fog: sample.color = sample.under; break;
        case UncertaintyOverlay::grid: sample.look = SampleLook::mesh; break;
        case UncertaintyOverlay::contour:
        case UncertaintyOverlay::halo: sample.look = SampleLook::rim; break;
    }
    return sample;
}

/// Of a sure place: a mesh is there too.
LegendSample sure_sample(const design::GroundData& ground, Color color) {
    if (ground.overlay.technique != UncertaintyOverlay::grid) return sample_of("CERTAIN", color, color, SampleLook::plain);
    LegendSample sample = overlay_sample(ground.overlay, color);
    sample.text = "CERTAIN";
    sample.share = 0;
    return sample;
}

/// The text of the overlay's sample: the greatest uncertainty, or everything that is less certain than its threshold.
base::FixedString<15> overlay_text(const design::GroundOverlay& overlay, const scene::AttributeEntry& attribute,
                                   base::DisplayUnits units) {
    const bool is_line = overlay.technique == UncertaintyOverlay::contour || overlay.technique == UncertaintyOverlay::halo;
    if (!is_line) return full_uncertainty_text(attribute, units);
    base::FixedString<15> text(">");
    text.append(uncertainty_text(attribute, overlay.threshold, units).view());
    return text;
}

void add_uncertainty(const design::DesignSettings& design, const scene::Attribute& attribute, Color color, Color plain,
                     draw::DataLegend& legend) {
    const design::GroundData& ground = design.data.ground;
    const base::DisplayUnits units = design.symbology.units;
    const bool is_known = attribute.states_uncertainty();
    const bool has_look = ground.uncertainty.technique != IntrinsicUncertainty::none,
               has_overlay = ground.overlay.technique != UncertaintyOverlay::none;
    LegendSample overlay = overlay_sample(ground.overlay, color);
    overlay.text = overlay_text(ground.overlay, *attribute.entry, units).view();
    if (is_known && (has_look || has_overlay)) {
        static_cast<void>(legend.uncertainty.try_push_back(sure_sample(ground, color)));
        LegendSample unsure = has_look ? unsure_sample(ground.uncertainty, color, plain) : overlay;
        if (has_look) unsure.text = full_uncertainty_text(*attribute.entry, units).view();
        static_cast<void>(legend.uncertainty.try_push_back(unsure));
    }
    static_cast<void>(legend.uncertainty.try_push_back(sample_of(draw::kUnknownText, color, plain, SampleLook::cut_stripes)));
    if (is_known && has_look && has_overlay) static_cast<void>(legend.signs.try_push_back(overlay));
}

/// What the plain ground among the data means: values below those that are shown, such as of radar that sees nothing.
base::FixedString<23> words_for_none(const design::GroundData& ground, const draw::DataLegend& legend) {
    if (!(ground.shown_from > design::kShowsAll)) return {};
    if (legend.unit.view() == "DBZ") return "NO ECHO";
    char text[24];
    std::snprintf(text, sizeof text, "BELOW %.4g", ground.shown_from * legend.factor + legend.offset);
    return text;
}

/// "AIR TEMPERATURE", but "WIND SPEED" of an attribute "Wind speed" of the layer "Wind", and no unit in place of a title.
base::FixedString<31> legend_title(std::string_view layer, std::string_view attribute, std::string_view unit) {
    base::FixedString<31> title;
    const bool says_both = !layer.empty() && same_words(attribute.substr(0, layer.size()), layer);
    if (!says_both) append_upper(title, layer);
    if (!says_both && same_words(attribute, unit)) return title;
    if (!title.empty()) title.append(" ");
    append_upper(title, attribute);
    return title;
}

}  // namespace

ShownUnit shown_unit(const scene::AttributeEntry& attribute, base::DisplayUnits units) noexcept {
    const std::string_view unit = field_text(attribute.unit);
    if (unit == "rad") return {base::degrees(1), "DEG"};
    constexpr double kZeroCelsius_k = 273.15;
    if (unit == "K")
        return {1,
                "\xC2\xB0"
                "C",
                -kZeroCelsius_k};
    if (unit == "m/s") {
        const bool is_vertical = field_text(attribute.name).find("vertical") != std::string_view::npos;
        const base::DisplayUnit speed = is_vertical ? base::vertical_speed_unit(units) : base::speed_unit(units);
        return {speed.of(1), speed.text};
    }
    ShownUnit shown;
    append_upper(shown.name, unit);
    return shown;
}

base::FixedString<15> uncertainty_text(const scene::AttributeEntry& attribute, double level, base::DisplayUnits units) noexcept {
    const bool is_percent = attribute.uncertainty_kind == scene::UncertaintyKind::percent;
    char number[16];
    if (is_graded(attribute)) {
        if (level >= 1) return "UNCERTAIN";
        std::snprintf(number, sizeof number, "%.0f %%", 100 * level);
        return number;
    }
    const ShownUnit shown = is_percent ? ShownUnit{1, "%"} : shown_unit(attribute, units);
    std::snprintf(number, sizeof number, "\xC2\xB1%.3g", level * double{attribute.uncertainty_full} * shown.factor);
    base::FixedString<15> text(number);
    if (!shown.name.empty()) text.append(" ");
    text.append(shown.name.view());
    return text;
}

base::FixedString<15> full_uncertainty_text(const scene::AttributeEntry& attribute, base::DisplayUnits units) noexcept {
    return uncertainty_text(attribute, 1, units);
}

bool is_in_another_unit(const design::Palette& palette, const scene::AttributeEntry& attribute) noexcept {
    if (palette.unit == design::PaletteUnit::one) return false;
    // Angles are radians inside, whatever the palette's file says.
    const std::string_view unit = palette.unit == design::PaletteUnit::degrees ? "rad" : unit_name(palette.unit);
    return unit != field_text(attribute.unit);
}

base::Duration stale_age(const scene::Layer& layer, const flight::FlightTime& time, double stale_after_s) noexcept {
    draw::DataLegend legend;
    set_time(layer, time.utc.ns, legend);
    if (legend.data_time_ns == scene::kNoTime || legend.is_forecast) return {};
    const base::Duration age{time.utc.ns - legend.data_time_ns};
    return age > base::Duration::from_seconds(stale_after_s) ? age : base::Duration();
}

draw::DataLegend legend_of(const scene::Layer& layer, const scene::Attribute& attribute, const flight::FlightTime& time,
                           const design::DesignSettings& design, const scene::Layer* made_of) noexcept {
    draw::DataLegend legend;
    const scene::AttributeEntry& entry = *attribute.entry;
    const std::string_view layer_title = field_text(layer.entry->title);
    legend.title = legend_title(layer_title, title_of(entry), field_text(entry.unit));
    const ShownUnit shown = shown_unit(entry, design.symbology.units);
    legend.factor = shown.factor;
    legend.offset = shown.offset;
    legend.unit = shown.name;
    if (entry.scale != scene::AttributeScale::quantitative)
        for (std::uint32_t n = 0; n < entry.class_count; ++n) {
            base::FixedString<23> name;
            append_upper(name, attribute.class_name(n));
            if (!legend.class_names.try_push_back(name)) break;
        }
    const scene::Layer& source = made_of == nullptr ? layer : *made_of;
    append_upper(legend.source, short_name(field_text(source.entry->source)));
    set_time(source, time.is_date ? time.utc.ns : source.times_ns.empty() ? 0 : source.times_ns[0], legend);
    if (made_of != nullptr && entry.derived_minute > 0) {
        legend.data_time_ns = std::int64_t{entry.derived_minute} * kMinute_ns;
        legend.is_forecast = false;
    }
    legend.has_time = legend.data_time_ns != scene::kNoTime;
    legend.has_age = legend.has_time && time.is_confirmed;
    if (!legend.has_age) return legend;
    legend.age = base::Duration{time.utc.ns - legend.data_time_ns};
    legend.is_stale = !legend.is_forecast && legend.age > base::Duration::from_seconds(design.data.stale_after_s);
    return legend;
}

void keep_named_classes(const scene::Attribute& attribute, std::uint32_t in_use, draw::DataLegend& legend) noexcept {
    const design::Palette palette = legend.scale.palette;
    if (!palette.is_nominal()) return;
    legend.class_names.clear();
    legend.scale.palette.stops.clear();
    legend.scale.palette.class_names.clear();
    for (std::uint32_t n = 0; n < attribute.entry->class_count; ++n) {
        const Color color = color_of_name(palette, attribute.class_name(n));
        if ((in_use >> n & 1u) == 0 || color.alpha == 0) continue;
        base::FixedString<23> name;
        append_upper(name, attribute.class_name(n));
        const auto value = static_cast<double>(legend.class_names.size());
        static_cast<void>(legend.class_names.try_push_back(name));
        static_cast<void>(legend.scale.palette.stops.try_push_back({value, color}));
    }
    if (!legend.class_names.empty()) return;
    legend.scale.palette = palette;  // where nothing of it is in use, all that there could be
    for (const design::ClassName& name : palette.class_names) {
        base::FixedString<23> upper;
        append_upper(upper, name.view());
        static_cast<void>(legend.class_names.try_push_back(upper));
    }
}

draw::DataLegend uncertainty_legend_of(const scene::Layer& layer, const scene::Attribute& attribute,
                                       const flight::FlightTime& time, const design::DesignSettings& design) noexcept {
    draw::DataLegend legend = legend_of(layer, attribute, time, design);
    legend.title.append(" \xC2\xB1");
    legend.class_names.clear();
    legend.offset = 0;
    const scene::AttributeEntry& entry = *attribute.entry;
    if (entry.uncertainty_kind == scene::UncertaintyKind::percent) legend.factor = 1;
    legend.factor *= static_cast<double>(entry.uncertainty_full);
    if (entry.uncertainty_kind == scene::UncertaintyKind::percent) legend.unit = "%";
    if (!is_graded(entry)) return legend;
    legend.factor = 100;
    legend.unit = "%";
    return legend;
}

base::FixedString<31> attribute_title(const scene::AttributeEntry& attribute) noexcept {
    base::FixedString<31> title;
    append_upper(title, title_of(attribute));
    return title;
}

base::FixedString<15> member_text(std::uint32_t member, std::uint32_t count) noexcept {
    char text[24];
    std::snprintf(text, sizeof text, "MEMBER %u/%u", member + 1, count);
    return text;
}

void add_legend(const draw::DataLegend& entry, draw::DataLegends& legends) noexcept {
    for (const draw::DataLegend& known : legends)
        if (known.title == entry.title && known.part == entry.part && known.scale.palette.name == entry.scale.palette.name &&
            known.scale.breaks.size() == entry.scale.breaks.size())
            return;
    static_cast<void>(legends.try_push_back(entry));
}

void add_ground_legend(const SpatialData& data, const SpatialDataPlan& plan, const design::DesignSettings& design,
                       const flight::FlightTime& time, draw::DataLegends& legends) noexcept {
    const scene::GridSlice* const slice = data.ground();
    if (plan.ground != GroundDataState::shown || slice == nullptr || slice->attribute() == nullptr) return;
    const design::GroundData& ground = design.data.ground;
    const Color plain = design.terrain.style.plain, color = sample_color(ground, plain);
    draw::DataLegend legend = legend_of(*slice->layer(), *slice->attribute(), time, design);
    legend.scale = ground.scale;
    keep_named_classes(*slice->attribute(), slice->classes_in_use(), legend);
    if (plan.member != scene::kMean) legend.part = member_text(plan.member, slice->attribute()->member_count());
    add_uncertainty(design, *slice->attribute(), color, plain, legend);
    if (const base::FixedString<23> none = words_for_none(ground, legend); !none.empty())
        static_cast<void>(legend.signs.try_push_back(sample_of(none.view(), plain, plain, SampleLook::plain)));
    static_cast<void>(legend.signs.try_push_back(sample_of("MISSING", plain, design.data.missing, SampleLook::dots)));
    if (slice->attribute()->entry->scale != scene::AttributeScale::quantitative) return add_legend(legend, legends);
    static_cast<void>(legend.signs.try_push_back(sample_of("INTERPOLATED", color, plain, SampleLook::cut_grid)));
    add_legend(legend, legends);
}

}  // namespace tedavis::display
