/// A chart over time as inline SVG: curves with gaps, a labelled grid, coloured spans along the bottom, marks that are links.
#pragma once

#include <string>
#include <vector>

namespace tedavis::host_sim {

struct ChartCurve {
    std::string name, color;
    std::vector<double> values;  ///< one for each time; NaN leaves a gap
    bool dashed = false;         ///< told apart without its colour
};

/// An area between two values, behind the curves: of what is not sure.
struct ChartBand {
    std::string color;
    std::vector<double> low, high;  ///< one for each time; NaN leaves a gap
};

struct ChartSpan {
    double begin = 0, end = 0;
    std::string label, color;
};

/// A place on a curve, with a short label over it; labels that would touch stand in rows.
struct ChartMark {
    double time_s = 0, value = 0;
    std::string label, link, description;  ///< `link`: what a click leads to, such as "#peak-a"
};

struct LineChart {
    std::string title, unit;
    std::vector<double> times_s;
    std::vector<ChartCurve> curves;
    std::vector<ChartSpan> spans;
    std::string description = {};  ///< what the chart shows, in a sentence, for who does not see it
    std::vector<ChartMark> marks = {};
    double width = 480,
           height = 230;  ///< of the drawing; by default narrow: on a phone it is shown nearly 1:1, on a desk it grows
    std::vector<ChartBand> bands = {};
    std::string x_unit = "s";  ///< of `times_s`, which may be distances
};

/// Scales with its container; text stays readable where that is three quarters of the drawing's width. Of many more values than
/// the drawing has columns, the least and the greatest of each column are drawn.
[[nodiscard]] std::string line_chart_svg(const LineChart& chart);
/// Where frames lie much farther apart than usual, as between two spans over the terrain, no line joins them.
[[nodiscard]] LineChart with_gaps(LineChart chart);
/// Text safe inside HTML and attributes.
[[nodiscard]] std::string escaped_html(const std::string& text);
/// A number with `digits` decimals.
[[nodiscard]] std::string decimal(double value, int digits);

}  // namespace tedavis::host_sim
