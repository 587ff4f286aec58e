/// A chart over time as inline SVG: curves with gaps, a labelled grid, coloured spans along the bottom, marks that are links.
#pragma once

#include <string>
#include <vector>

namespace tedavis::host_sim {

struct ChartCurve {
    std::string name, color;
    std::vector<double> values;  ///< one for each time; NaN leaves a gap
    bool dashed = false;         ///< dashed, to be distinct without colour
};

/// An area between two values, behind the curves, for an uncertainty.
struct ChartBand {
    std::string color;
    std::vector<double> low, high;  ///< one for each time; NaN leaves a gap
};

struct ChartSpan {
    double begin = 0, end = 0;
    std::string label, color;
};

/// A point of a curve with a short label above; labels that would overlap are stacked in rows.
struct ChartMark {
    double time_s = 0, value = 0;
    std::string label, link, description;  ///< `link` is the target of a click, such as "#peak-a"
};

struct LineChart {
    std::string title, unit;
    std::vector<double> times_s;
    std::vector<ChartCurve> curves;
    std::vector<ChartSpan> spans;
    std::string description = {};  ///< the chart in a sentence, for readers who cannot see it
    std::vector<ChartMark> marks = {};
    double width = 480,
           height = 230;  ///< of the drawing; by default narrow: on a phone it is shown nearly 1:1, on a desk it grows
    std::vector<ChartBand> bands = {};
    std::string x_unit = "s";  ///< of `times_s`, which may be distances
};

/// Returns an SVG that scales with its container; its text stays readable down to three quarters of the drawing's width. If there
/// are many more values than pixel columns, the least and the greatest of each column are drawn.
[[nodiscard]] std::string line_chart_svg(const LineChart& chart);
/// Breaks the curves where frames are much farther apart in time than usual, as between two spans over the terrain.
[[nodiscard]] LineChart with_gaps(LineChart chart);
/// Text safe inside HTML and attributes.
[[nodiscard]] std::string escaped_html(const std::string& text);
/// A number with `digits` decimals.
[[nodiscard]] std::string decimal(double value, int digits);

}  // namespace tedavis::host_sim
