#include "render_core/draw/symbology/legend_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tedavis::draw {

double lowest(const design::DataScale& scale) noexcept { return scale.palette.stops[0].value; }
double highest(const design::DataScale& scale) noexcept { return scale.palette.stops.back().value; }
double written(const DataLegend& legend, double value) noexcept { return value * legend.factor + legend.offset; }

double nice_step(double least) noexcept {
    double step = std::pow(10, std::floor(std::log10(std::max(least, 1e-6))));
    for (const double times : {2.0, 2.5, 2.0}) {
        if (step >= least) break;
        step *= times;
    }
    return step;
}

ShortText number_text(double value, double step) noexcept {
    int decimals = 0;
    for (double left = std::fabs(step); decimals < 3 && std::fabs(left - std::round(left)) > 1e-4 * left; left *= 10) ++decimals;
    char text[24];
    const double kept = limited(value, -9'999'999, 9'999'999);
    std::snprintf(text, sizeof text, "%.*f", decimals, std::fabs(kept) < 0.5 * std::pow(10, -decimals) ? 0 : kept);
    return ShortText(text);
}

ShortText signed_number(double value) noexcept {
    ShortText text(std::lround(value) > 0 ? "+" : "");
    text.append(whole_number(value).view());
    return text;
}

}  // namespace tedavis::draw
