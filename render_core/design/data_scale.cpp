#include "render_core/design/data_scale.hpp"

#include <cmath>

#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

using base::ConfigSection;

constexpr double kLargest = 1e12;

/// Equal steps over the palette's range.
void set_classes(DataScale& scale, std::size_t classes) {
    const double low = scale.palette.stops[0].value, high = scale.palette.stops.back().value;
    scale.breaks.clear();
    for (std::size_t n = 1; n < classes; ++n)
        static_cast<void>(scale.breaks.try_push_back(low + (high - low) * static_cast<double>(n) / static_cast<double>(classes)));
}

void read_breaks(ConfigSection& section, std::string_view key, DataScale& scale) {
    double breaks[kMaxClasses - 1]{};
    const std::size_t count = section.element_count(key);
    if (count > kMaxClasses - 1) return fault_of(section, key, "has too many limits; keep at most 15");
    section.numbers(key, -kLargest, kLargest, {breaks, count});
    scale.breaks.clear();
    for (std::size_t n = 0; n < count; ++n) {
        if (n > 0 && !(breaks[n] > breaks[n - 1])) return fault_of(section, key, "must ascend; sort them");
        static_cast<void>(scale.breaks.try_push_back(breaks[n]));
    }
}

}  // namespace

std::size_t class_of(const DataScale& scale, double value) noexcept {
    std::size_t number = 0;
    while (number < scale.breaks.size() && value >= scale.breaks[number]) ++number;
    return number;
}

Color color_of_class(const DataScale& scale, std::size_t number) noexcept {
    const double low = scale.palette.stops[0].value, high = scale.palette.stops.back().value;
    if (scale.breaks.empty()) return color_of_value(scale.palette, 0.5 * (low + high));
    const double from = number == 0 ? std::fmin(low, scale.breaks[0]) : scale.breaks[number - 1];
    const double to = number == scale.breaks.size() ? std::fmax(high, scale.breaks.back()) : scale.breaks[number];
    return color_of_value(scale.palette, 0.5 * (from + to));
}

Color scale_color(const DataScale& scale, double value) noexcept {
    return scale.breaks.empty() ? color_of_value(scale.palette, value) : color_of_class(scale, class_of(scale, value));
}

void reduce_classes(DataScale& scale, std::size_t most) noexcept {
    if (scale.palette.is_nominal()) return;
    if (scale.breaks.empty()) return set_classes(scale, most);
    const std::size_t step = (scale.breaks.size() + 1 + most - 1) / most;
    base::FixedVector<double, kMaxClasses - 1> kept;
    for (std::size_t n = step; n <= scale.breaks.size(); n += step) static_cast<void>(kept.try_push_back(scale.breaks[n - 1]));
    scale.breaks = kept;
}

void read_scale(ConfigSection& section, PaletteSource& palettes, DataScale& scale, const ScaleKeys& keys) {
    const auto found = palettes.find(section.file(keys.palette));
    if (!found.ok()) return section.fault(keys.palette, found.error().message.view());
    scale.palette = found.value();
    const auto classes = static_cast<std::size_t>(section.integer(keys.classes, 0, kMaxClasses, 0));
    if (section.has(keys.classes) && section.has(keys.breaks))
        return fault_of(section, keys.classes, "and the limits of classes both say where classes end; keep one");
    if (scale.palette.is_nominal() && (classes > 0 || section.has(keys.breaks)))
        return fault_of(section, keys.palette, "is nominal and has classes of its own; leave limits of classes out");
    if (classes == 1) return fault_of(section, keys.classes, "must be 0 for a continuous scale, or 2 to 16");
    if (section.has(keys.breaks))
        read_breaks(section, keys.breaks, scale);
    else
        set_classes(scale, classes);
}

}  // namespace tedavis::design
