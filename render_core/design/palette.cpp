#include "render_core/design/palette.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

using base::ConfigSection;

constexpr std::string_view kKinds[] = {"hypsometric", "sequential", "diverging", "nominal"};
constexpr std::string_view kUnits[] = {"m", "deg", "1", "m/s", "dBZ", "K"};
constexpr std::string_view kPurposes[] = {"terrain", "data", "objects"};
constexpr std::string_view kOrders[] = {"lightness", "hue"};

/// What a value in the file may be, and one of its units in ours.
struct UnitRange {
    double low, high, scale;
};
constexpr UnitRange kRanges[] = {
    {-12'000, 9000, 1}, {-180, 180, base::radians(1)}, {-1e6, 1e6, 1}, {-500, 500, 1}, {-100, 100, 1}, {0, 1000, 1}};

/// Absence is a fault.
template <class Enum>
void choose_required(ConfigSection& section, std::string_view key, base::Span<const std::string_view> names, Enum& value) {
    static_cast<void>(section.text(key));
    section.choose(key, names, value);
}

bool is_title(std::string_view text) {
    for (char c : text)
        if (!((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ')) return false;
    return !text.empty();
}

void read_names(ConfigSection& root, Palette& palette) {
    palette.name.append(root.text("name"));
    if (palette.name.empty() || palette.name.cut()) fault_of(root, "name", "must be 1 to 47 characters long");
    palette.title.append(root.text("title"));
    if (palette.title.cut() || !is_title(palette.title.view()))
        fault_of(root, "title", "must be 1 to 11 capitals, digits and spaces");
}

void read_stop(ConfigSection stop, const UnitRange& range, Palette& palette) {
    ColorStop entry;
    entry.value = stop.number("value", range.low, range.high) * range.scale;
    entry.color = required_color(stop, "color");
    if (entry.color.alpha != 255) fault_of(stop, "color", "must be opaque; write it as \"#rrggbb\"");
    if (!palette.stops.empty() && !(entry.value > palette.stops.back().value))
        fault_of(stop, "value", "must lie above the stop before it; sort the stops by value");
    if (!palette.stops.try_push_back(entry)) fault_of(stop, "value", "is one stop too many; keep at most 16");
}

void read_class(ConfigSection section, Palette& palette) {
    ClassName name(section.text("name"));
    const Color color = required_color(section, "color");
    if (name.empty() || name.cut()) fault_of(section, "name", "must be 1 to 23 characters long");
    if (color.alpha != 255) fault_of(section, "color", "must be opaque; write it as \"#rrggbb\"");
    for (const ClassName& other : palette.class_names)
        if (other == name) fault_of(section, "name", "is that of another class; give each its own");
    const bool has_room = palette.stops.try_push_back({static_cast<double>(palette.stops.size()), color}) &&
                          palette.class_names.try_push_back(name);
    if (!has_room) fault_of(section, "name", "is one class too many; keep at most 16");
}

void read_classes(ConfigSection& root, Palette& palette) {
    palette.unit = PaletteUnit::one;
    palette.order = PaletteOrder::hue;
    const std::size_t count = root.table_count("class");
    if (count < 2) fault_of(root, "kind", "needs at least two classes; add [[class]] tables");
    for (std::size_t i = 0; i < count; ++i) read_class(root.table_at("class", i), palette);
}

void read_stops(ConfigSection& root, Palette& palette) {
    choose_required(root, "unit", kUnits, palette.unit);
    choose_required(root, "order", kOrders, palette.order);
    if (palette.kind == PaletteKind::hypsometric && palette.unit != PaletteUnit::metres)
        fault_of(root, "unit", "of a hypsometric palette must be \"m\"");
    const std::size_t count = root.table_count("stop");
    if (count < 2) fault_of(root, "kind", "needs at least two colours; add [[stop]] tables");
    if (palette.kind == PaletteKind::diverging && count % 2 == 0)
        fault_of(root, "kind", "\"diverging\" needs a middle; give an odd number of stops");
    for (std::size_t i = 0; i < count; ++i)
        read_stop(root.table_at("stop", i), kRanges[static_cast<std::size_t>(palette.unit)], palette);
}

}  // namespace

std::string_view unit_name(PaletteUnit unit) noexcept { return kUnits[static_cast<std::size_t>(unit)]; }

Color color_of_value(const Palette& palette, double value) noexcept {
    const auto& stops = palette.stops;
    TEDAVIS_CHECK(!stops.empty());
    if (!(value > stops[0].value)) return stops[0].color;
    if (palette.is_nominal())
        return stops[std::min(static_cast<std::size_t>(std::lround(std::fmin(value, kMaxColorStops))), stops.size() - 1)].color;
    for (std::size_t i = 1; i < stops.size(); ++i)
        if (value < stops[i].value) {
            const ColorStop& below = stops[i - 1];
            return blended(below.color, stops[i].color, (value - below.value) / (stops[i].value - below.value));
        }
    return stops.back().color;
}

Color color_of_name(const Palette& palette, std::string_view name) noexcept {
    for (std::size_t n = 0; n < palette.class_names.size(); ++n)
        if (palette.class_names[n].view() == name) return palette.stops[n].color;
    return {0, 0, 0, 0};
}

Palette fitted_palette(const Palette& palette, double lowest_m, double highest_m) noexcept {
    Palette fitted = palette;
    if (!palette.fits_terrain || palette.stops.size() < 2) return fitted;
    const double first_m = palette.stops[0].value, span_m = std::fmax(highest_m - lowest_m, kMinFittedSpan_m);
    const double scale = span_m / (palette.stops.back().value - first_m);
    for (ColorStop& stop : fitted.stops) stop.value = lowest_m + (stop.value - first_m) * scale;
    return fitted;
}

Palette alpine_palette() noexcept {
    static constexpr ColorStop kStops[] = {
        {0, {0x32, 0x44, 0x3A}},    {300, {0x54, 0x64, 0x5A}},  {800, {0x80, 0x7A, 0x68}},  {1500, {0xA8, 0x92, 0x6C}},
        {2500, {0xC8, 0xAC, 0x84}}, {3500, {0xDC, 0xCD, 0xB4}}, {4500, {0xF6, 0xF4, 0xF0}},
    };
    Palette palette;
    palette.name = "alpine";
    palette.title = "GROUND ELEV";
    for (const ColorStop& stop : kStops) {
        const bool added = palette.stops.try_push_back(stop);
        TEDAVIS_CHECK(added);
    }
    return palette;
}

base::Result<Palette, base::Error> read_palette(std::string_view text, std::string_view file_name) {
    base::ConfigReader reader(text, file_name);
    ConfigSection root = reader.root();
    Palette palette;
    read_names(root, palette);
    choose_required(root, "kind", kKinds, palette.kind);
    root.choose("purpose", kPurposes, palette.purpose);
    palette.fits_terrain = root.boolean("fits_terrain", palette.fits_terrain);
    if (palette.fits_terrain && palette.kind != PaletteKind::hypsometric)
        fault_of(root, "fits_terrain", "is for heights of the terrain only; leave it out, or set kind = \"hypsometric\"");
    if (palette.is_nominal())
        read_classes(root, palette);
    else
        read_stops(root, palette);
    if (!reader.finish()) return base::fail(reader.error());
    return palette;
}

bool is_short_name(std::string_view name) noexcept { return name.find_first_of("./") == std::string_view::npos; }

}  // namespace tedavis::design
