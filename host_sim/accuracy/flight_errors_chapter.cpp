#include "host_sim/accuracy/flight_errors_chapter.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/accuracy/work_precision_chart.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/printed_text.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kChartWidth = 560, kChartHeight = 320, kLeftEdge = 64, kRightEdge = 130, kTopEdge = 14, kBottomEdge = 44;
constexpr const char *kAskedColor = "#57606a", *kProvenColor = "#0b57a4", *kMeasuredColor = "#b26a00";

/// One of the three lines, and its mark at a point.
struct ToleranceCurve {
    const char *name, *color, *dash;
    double ToleranceLine::*value;
    const char* mark;  ///< path round 0, 0
};
constexpr ToleranceCurve kCurves[] = {{"asked for", kAskedColor, "6 4", &ToleranceLine::asked_px, "M-5 0h10M0 -5v10"},
                                      {"proven", kProvenColor, "none", &ToleranceLine::proven_px, "M-5 -5h10v10h-10z"},
                                      {"measured", kMeasuredColor, "none", &ToleranceLine::measured_px, "M0 -6l6 11h-12z"}};

class ToleranceChart {
public:
    explicit ToleranceChart(const FlightErrors& flight) : flight_(flight) {
        std::vector<double> asked, errors;
        for (const ToleranceLine& line : flight.lines) {
            asked.push_back(line.asked_px);
            errors.insert(errors.end(), {line.asked_px, line.proven_px, line.measured_px});
        }
        across_ = DecadeScale::of(asked);
        down_ = DecadeScale::of(errors);
    }

    [[nodiscard]] std::string svg() const {
        std::string text = printed("<svg class='chart' viewBox='0 0 %g %g' role='img'>", kChartWidth, kChartHeight) + "<title>" +
                           escaped_html("Terrain's error over the tolerance: " + flight_.flight) + "</title>" + grid();
        for (const ToleranceCurve& curve : kCurves) text += drawn_curve(curve);
        return text + "</svg>\n";
    }

private:
    [[nodiscard]] double x(double px) const { return kLeftEdge + (kChartWidth - kLeftEdge - kRightEdge) * across_.place(px); }
    [[nodiscard]] double y(double px) const {
        return kChartHeight - kBottomEdge - (kChartHeight - kTopEdge - kBottomEdge) * down_.place(px);
    }

    [[nodiscard]] std::string grid() const {
        std::string text;
        for (int power = across_.first; power <= across_.last; ++power) {
            const double at = x(std::pow(10.0, power));
            text += printed("<line class='grid' x1='%.1f' y1='%g' x2='%.1f' y2='%g'/>", at, kTopEdge, at,
                            kChartHeight - kBottomEdge) +
                    printed("<text x='%.1f' y='%g' text-anchor='middle'>1e%d</text>", at, kChartHeight - kBottomEdge + 16, power);
        }
        for (int power = down_.first; power <= down_.last; ++power) {
            const double at = y(std::pow(10.0, power));
            text +=
                printed("<line class='grid' x1='%g' y1='%.1f' x2='%g' y2='%.1f'/>", kLeftEdge, at, kChartWidth - kRightEdge, at) +
                printed("<text x='%g' y='%.1f' text-anchor='end'>1e%d</text>", kLeftEdge - 6, at + 4, power);
        }
        return text +
               printed("<text x='%g' y='%g' text-anchor='middle'>error asked for, px</text>", 0.45 * kChartWidth,
                       kChartHeight - 8) +
               printed("<text transform='translate(14 %g) rotate(-90)' text-anchor='middle'>error, px</text>",
                       0.5 * (kChartHeight - kBottomEdge));
    }

    [[nodiscard]] std::string drawn_curve(const ToleranceCurve& curve) const {
        std::string points, marks;
        double last_x = 0, last_y = 0;
        for (const ToleranceLine& line : flight_.lines) {
            const double at_x = x(line.asked_px), at_y = y(line.*curve.value);
            points += printed("%.1f,%.1f ", at_x, at_y);
            marks += printed("<path transform='translate(%.1f %.1f)' d='%s'/>", at_x, at_y, curve.mark);
            if (at_x >= last_x) last_x = at_x, last_y = at_y;
        }
        return printed("<g stroke='%s' fill='none' stroke-width='1.5'><polyline stroke-dasharray='%s' points='", curve.color,
                       curve.dash) +
               points + "'/>" + marks + "</g>" +
               printed("<text x='%.1f' y='%.1f'>%s</text>", last_x + 10, last_y + label_shift(curve), curve.name);
    }

    /// Labels of lines that end close together stand one below the other.
    [[nodiscard]] static double label_shift(const ToleranceCurve& curve) {
        return &curve == &kCurves[0] ? -4.0 : &curve == &kCurves[1] ? 6.0 : 18.0;
    }

    const FlightErrors& flight_;
    DecadeScale across_, down_;
};

std::string tolerance_row(const ToleranceLine& line) {
    const double tight = line.proven_px > 0 ? line.measured_px / line.proven_px : 0;
    return std::string(line.broken == 0 ? "<tr>" : "<tr class='dominated'>") + "<th>" + printed("%g px", line.asked_px) +
           "</th>" + html_number(printed("%.3g", line.proven_px)) + html_number(printed("%.3g", line.measured_px)) +
           html_number(printed("%.0f %%", 100 * tight)) + html_number(std::to_string(line.samples)) +
           html_number(std::to_string(line.broken)) + "</tr>";
}

std::string along_chart(const FlightErrors& flight) {
    LineChart errors, times;
    errors.title = "Terrain's error along the flight";
    errors.unit = "px";
    times.title = "Time of a frame along the flight";
    times.unit = "ms";
    ChartCurve asked{"asked for", kAskedColor, {}, true}, proven{"proven", kProvenColor, {}, false},
        measured{"measured", kMeasuredColor, {}, false}, ms{"frame", kProvenColor, {}, false};
    for (const MeasuredMoment& moment : flight.moments) {
        errors.times_s.push_back(moment.time_s);
        asked.values.push_back(flight.asked_px);
        proven.values.push_back(moment.proven_px);
        measured.values.push_back(moment.measured_px);
        ms.values.push_back(moment.ms);
    }
    times.times_s = errors.times_s;
    errors.curves = {asked, proven, measured};
    times.curves = {ms};
    return line_chart_svg(errors) + line_chart_svg(times);
}

std::string worst_moment(const FlightErrors& flight) {
    const auto worst =
        std::max_element(flight.moments.begin(), flight.moments.end(),
                         [](const MeasuredMoment& a, const MeasuredMoment& b) { return a.measured_px < b.measured_px; });
    if (worst == flight.moments.end()) return "";
    return "<p>" +
           escaped_html(
               printed("The greatest measured error, %.3g px, is at %.0f s: tedavis shot --pose %s --tau %g -o worst.png",
                       worst->measured_px, worst->time_s, worst->pose.c_str(), flight.asked_px)) +
           "</p>\n";
}

std::string flight_chapter(const FlightErrors& flight) {
    std::string rows;
    for (const ToleranceLine& line : flight.lines) rows += tolerance_row(line);
    return "<h3>" + escaped_html(flight.flight) + "</h3>\n" + tolerance_chart_svg(flight) +
           html_table(
               "<tr><th>asked for</th><th class='n'>proven, px</th><th class='n'>measured, px</th><th class='n'>measured / "
               "proven</th>"
               "<th class='n'>samples</th><th class='n'>above the bound</th></tr>",
               rows) +
           along_chart(flight) + worst_moment(flight);
}

}  // namespace

std::string tolerance_chart_svg(const FlightErrors& flight) { return ToleranceChart(flight).svg(); }

std::string flight_errors_chapter(const std::vector<FlightErrors>& flights) {
    std::string html =
        "<p>The display states for each frame a bound that the error of its terrain cannot exceed. Places of the ground that the "
        "frame shows were compared with the true surface: none may lie above the bound of its frame.</p>\n";
    for (const FlightErrors& flight : flights) html += flight_chapter(flight);
    return html;
}

std::string flight_errors_text(const std::vector<FlightErrors>& flights) {
    std::string text;
    for (const FlightErrors& flight : flights) {
        text += "\n\nerror of the terrain, " + flight.flight + ": asked for, proven, measured";
        for (const ToleranceLine& line : flight.lines)
            text += printed("\n  %6g px %8.3g px %8.3g px  %llu samples, %llu above the bound", line.asked_px, line.proven_px,
                            line.measured_px, static_cast<unsigned long long>(line.samples),
                            static_cast<unsigned long long>(line.broken));
    }
    return text;
}

}  // namespace tedavis::host_sim
