/// A chart over time as inline SVG: curves with gaps, a labelled grid, coloured spans along the bottom.
#pragma once

#include <string>
#include <vector>

namespace tedavis::host_sim {

struct ChartCurve {
    std::string name, color;
    std::vector<double> values;  ///< one for each time; NaN leaves a gap
};

struct ChartSpan {
    double begin = 0, end = 0;
    std::string label, color;
};

struct LineChart {
    std::string title, unit;
    std::vector<double> times_s;
    std::vector<ChartCurve> curves;
    std::vector<ChartSpan> spans;
};

/// Scales with its container; text stays readable from a width of 360 pixels.
[[nodiscard]] std::string line_chart_svg(const LineChart& chart);
/// Text safe inside HTML and attributes.
[[nodiscard]] std::string escaped_html(const std::string& text);
/// A number with `digits` decimals.
[[nodiscard]] std::string decimal(double value, int digits);

}  // namespace tedavis::host_sim
