#include "host_sim/measure/palette_check.hpp"

#include <cmath>
#include <cstdio>
#include <limits>

#include "host_sim/measure/color_vision.hpp"
#include "render_core/base/units.hpp"
#include "render_core/design/color_difference.hpp"

namespace tedavis::host_sim {
namespace {

using design::Color;
using design::Palette;
using Labs = std::vector<design::Lab>;

constexpr int kSamplesBetweenStops = 8;
constexpr int kLights = 5;

std::string one_decimal(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

std::string color_text(Color color) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", color.red, color.green, color.blue);
    return text;
}

/// "stop 3 (#a0b0c0)", counted from 1 as the file is read.
std::string stop_text(const Palette& palette, std::size_t i) {
    return "stop " + std::to_string(i + 1) + " (" + color_text(palette.stops[i].color) + ")";
}

/// As the terrain is drawn: encoded values times light.
Color lit(Color color, double light) { return design::blended({0, 0, 0}, color, light); }

design::Lab lab_of_color(Color color) { return lab_of(linear_rgb(color)); }

Labs labs_of(const Palette& palette, ColorVision vision) {
    Labs labs;
    for (const design::ColorStop& stop : palette.stops) labs.push_back(lab_of(seen_with(vision, linear_rgb(stop.color))));
    return labs;
}

/// Which way lightness must go from stop i to i + 1: 1 brighter, -1 darker.
double lightness_way(const Palette& palette, const Labs& normal, std::size_t i) {
    const std::size_t last = normal.size() - 1, middle = last / 2;
    const std::size_t from = palette.kind == design::PaletteKind::diverging && i >= middle ? middle : 0;
    const std::size_t to = palette.kind == design::PaletteKind::diverging && i < middle ? middle : last;
    return normal[to].lightness > normal[from].lightness ? 1 : -1;
}

void check_lightness(const Palette& palette, ColorVision vision, const std::string& name, std::vector<std::string>& faults) {
    const Labs normal = labs_of(palette, ColorVision::normal), labs = labs_of(palette, vision);
    double least = std::numeric_limits<double>::infinity();
    std::size_t worst = 0;
    for (std::size_t i = 0; i + 1 < labs.size(); ++i) {
        const double step = lightness_way(palette, normal, i) * (labs[i + 1].lightness - labs[i].lightness);
        if (step < least) least = step, worst = i;
    }
    if (least >= kLightnessStep) return;
    faults.push_back(name + ": in " + to_string(vision) + " " + stop_text(palette, worst + 1) +
                     " goes on from the stop before by " + one_decimal(least) + " of lightness L* and needs " +
                     one_decimal(kLightnessStep) + "; choose another lightness for it");
}

/// Degrees from one hue to the next, -180..180.
double turn_deg(const design::Lab& from, const design::Lab& to) {
    return base::degrees(std::remainder(std::atan2(to.b, to.a) - std::atan2(from.b, from.a), 2 * base::radians(180)));
}

void check_hue(const Palette& palette, const std::string& name, std::vector<std::string>& faults) {
    const Labs labs = labs_of(palette, ColorVision::normal);
    const double way = turn_deg(labs[0], labs[1]) > 0 ? 1 : -1;
    double turned = 0;
    for (std::size_t i = 0; i < labs.size(); ++i) {
        const double chroma = std::hypot(labs[i].a, labs[i].b), step = i == 0 ? 1 : way * turn_deg(labs[i - 1], labs[i]);
        turned += i == 0 ? 0 : step;
        if (chroma >= kHueChroma && step > 0 && turned < 360) continue;
        faults.push_back(name + ": " + stop_text(palette, i) + " does not go on in the order of hues (chroma " +
                         one_decimal(chroma) + " of at least " + one_decimal(kHueChroma) + ", turned on by " + one_decimal(step) +
                         " degrees, " + one_decimal(turned) + " of at most 360 since the first stop); choose another hue for it");
        return;
    }
}

void check_steps(const Palette& palette, ColorVision vision, const std::string& name, std::vector<std::string>& faults) {
    const Labs labs = labs_of(palette, vision);
    for (std::size_t i = 0; i + 2 < labs.size(); ++i) {
        const double one = color_difference(labs[i], labs[i + 1]), two = color_difference(labs[i], labs[i + 2]);
        if (two > one) continue;
        faults.push_back(name + ": in " + to_string(vision) + " " + stop_text(palette, i + 2) + " differs from " +
                         stop_text(palette, i) + " by " + one_decimal(two) + " and needs more than the " + one_decimal(one) +
                         " of the stop between them; choose another colour for it");
        return;
    }
}

void check_distance(const Palette& palette, ColorVision vision, const std::string& name, std::vector<std::string>& faults) {
    const Labs labs = labs_of(palette, vision);
    const double needed = vision == ColorVision::normal ? kDistance : kDeficientDistance;
    double least = std::numeric_limits<double>::infinity();
    std::size_t first = 0, second = 0;
    for (std::size_t i = 0; i < labs.size(); ++i)
        for (std::size_t j = i + 1; j < labs.size(); ++j)
            if (const double d = color_difference(labs[i], labs[j]); d < least) least = d, first = i, second = j;
    if (least >= needed) return;
    faults.push_back(name + ": in " + to_string(vision) + " " + stop_text(palette, second) + " differs from " +
                     stop_text(palette, first) + " by " + one_decimal(least) + " and needs " + one_decimal(needed) +
                     " (CIEDE2000); choose colours farther apart");
}

void check_light(const Palette& palette, double ambient, const std::string& name, std::vector<std::string>& faults) {
    double least = std::numeric_limits<double>::infinity(), at_light = 1;
    std::size_t worst = 0;
    for (int n = 0; n < kLights; ++n) {
        const double light = ambient + (1 - ambient) * n / (kLights - 1);
        for (std::size_t i = 0; i + 1 < palette.stops.size(); ++i) {
            const double d = color_difference(lab_of_color(lit(palette.stops[i].color, light)),
                                              lab_of_color(lit(palette.stops[i + 1].color, light)));
            if (d < least) least = d, at_light = light, worst = i;
        }
    }
    if (least >= kLitDistance) return;
    faults.push_back(name + ": in " + one_decimal(100 * at_light) + " % of the light " + stop_text(palette, worst + 1) +
                     " differs from the stop before by " + one_decimal(least) + " and needs " + one_decimal(kLitDistance) +
                     " (CIEDE2000); choose colours farther apart or more ambient light");
}

std::vector<Color> colors_of(const Palette& palette) {
    std::vector<Color> colors;
    const int samples = palette.is_nominal() ? 1 : kSamplesBetweenStops;
    for (std::size_t i = 0; i + 1 < palette.stops.size(); ++i)
        for (int n = 0; n < samples; ++n)
            colors.push_back(design::blended(palette.stops[i].color, palette.stops[i + 1].color,
                                             static_cast<double>(n) / kSamplesBetweenStops));
    colors.push_back(palette.stops.back().color);
    return colors;
}

/// Something that must not be taken for the palette: all colours that it is displayed with.
struct Stranger {
    std::string name;
    std::vector<Color> colors;
};

std::vector<Stranger> strangers_in(const design::DesignSettings& design, const std::vector<Color>& colors,
                                   design::PalettePurpose purpose) {
    std::vector<Stranger> strangers = {
        {"missing data", {purpose == design::PalettePurpose::terrain ? design.terrain.unknown : design.data.missing}}};
    // What stands in the air has a shape of its own; no ground is taken for it.
    if (purpose == design::PalettePurpose::objects) return strangers;
    strangers.push_back({"the sea", {design.terrain.sea}});
    if (!design.warning_colors) return strangers;
    for (const design::WarningBand& band : design.warning_bands) {
        Stranger stranger;
        stranger.name = "the warning band from " + one_decimal(band.lower_m / base::kMetresPerFoot) + " ft";
        for (const Color color : colors) stranger.colors.push_back(design::blended(color, band.color, band.strength));
        stranger.colors.push_back(design::blended(design.terrain.sea, band.color, band.strength));
        strangers.push_back(stranger);
    }
    return strangers;
}

void check_apart(const std::vector<Color>& colors, const Stranger& stranger, double light, double needed, const std::string& name,
                 std::vector<std::string>& faults) {
    double least = std::numeric_limits<double>::infinity();
    Color own, other;
    Labs labs;
    for (const Color color : colors) labs.push_back(lab_of_color(lit(color, light)));
    for (const Color color : stranger.colors) {
        const design::Lab lab = lab_of_color(lit(color, light));
        for (std::size_t i = 0; i < colors.size(); ++i)
            if (const double d = color_difference(labs[i], lab); d < least) least = d, own = colors[i], other = color;
    }
    if (least >= needed) return;
    faults.push_back(name + ": its colour " + color_text(own) + " differs from " + stranger.name + " (" + color_text(other) +
                     ") by " + one_decimal(least) + " in " + one_decimal(100 * light) + " % of the light and needs " +
                     one_decimal(needed) + " (CIEDE2000); change one of the two");
}

}  // namespace

std::vector<std::string> palette_faults(const Palette& palette, const std::string& name) {
    std::vector<std::string> faults;
    const bool by_hue = palette.order == design::PaletteOrder::hue, has_order = !palette.is_nominal();
    if (has_order && by_hue) check_hue(palette, name, faults);
    for (const ColorVision vision : kColorVisions) {
        if (has_order && by_hue) check_steps(palette, vision, name, faults);
        if (has_order && !by_hue) check_lightness(palette, vision, name, faults);
        check_distance(palette, vision, name, faults);
    }
    return faults;
}

std::vector<std::string> palette_faults_in_design(const Palette& palette, const design::DesignSettings& design,
                                                  const std::string& name) {
    std::vector<std::string> faults;
    const double ambient = design.terrain.style.shade.ambient;
    check_light(palette, ambient, name, faults);
    const std::vector<Color> colors = colors_of(palette);
    for (const Stranger& stranger : strangers_in(design, colors, palette.purpose)) {
        const std::size_t before = faults.size();
        check_apart(colors, stranger, 1, kApart, name, faults);
        if (faults.size() == before) check_apart(colors, stranger, ambient, kApartInShade, name, faults);
    }
    return faults;
}

}  // namespace tedavis::host_sim
