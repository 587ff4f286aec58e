#include "host_sim/accuracy/flight_errors_chapter.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/accuracy/work_precision_chart.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/printed_text.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kChartWidth = 560, kPlotHeight = 320, kLeftEdge = 64, kRightEdge = 130, kTopEdge = 14, kBottomEdge = 44;
constexpr double kLegendLine = 18;
constexpr const char *kAskedColor = "#57606a", *kProvenColor = "#0b57a4", *kMeasuredColor = "#b26a00";

/// A line over the tolerance that each flight has.
struct ToleranceCurve {
    const char *name, *color, *dash;
    double ToleranceLine::*value;
};
constexpr ToleranceCurve kCurves[] = {{"proven", kProvenColor, "none", &ToleranceLine::proven_px},
                                      {"measured", kMeasuredColor, "2 3", &ToleranceLine::measured_px}};

/// Paths round 0, 0: each flight has a mark of its own on both of its lines. Of more flights the marks repeat.
constexpr const char* kFlightMarks[] = {"M-5 -5h10v10h-10z",     "M0 -6l6 11h-12z",          "M-5 0h10M0 -5v10",
                                        "M0 -6l6 6l-6 6l-6 -6z", "M-5 -5l10 10M5 -5l-10 10", "M0 6l6 -11h-12z"};

std::string mark_at(std::size_t flight, double x, double y) {
    return printed("<path transform='translate(%.1f %.1f)' d='%s'/>", x, y, kFlightMarks[flight % std::size(kFlightMarks)]);
}

std::string file_of(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

std::string title_of(const FlightErrors& flight) { return file_of(flight.flight) + " over " + file_of(flight.terrain); }

std::string tightness_words(const Tightness& tightness) {
    if (tightness.max <= 0) return "smaller than what can be measured";
    return printed("%.0f %% of the bound in the median, %.0f %% at most", 100 * tightness.median, 100 * tightness.max);
}

class ToleranceChart {
public:
    explicit ToleranceChart(const std::vector<FlightErrors>& flights) : flights_(flights) {
        std::vector<double> asked, errors;
        for (const FlightErrors& flight : flights)
            for (const ToleranceLine& line : flight.lines) {
                asked.push_back(line.asked_px);
                errors.insert(errors.end(), {line.asked_px, line.proven_px, line.measured_px});
            }
        across_ = DecadeScale::of(asked);
        down_ = DecadeScale::of(errors);
    }

    [[nodiscard]] std::string svg() const {
        std::string text = printed("<svg class='chart' viewBox='0 0 %g %g' role='img'>", kChartWidth,
                                   kPlotHeight + kLegendLine * static_cast<double>(flights_.size())) +
                           "<title>The terrain's error over the tolerance: asked for, proven, measured</title>" + grid() +
                           asked_line();
        for (std::size_t n = 0; n < flights_.size(); ++n) {
            for (const ToleranceCurve& curve : kCurves) text += drawn_curve(n, curve);
            text += legend_line(n);
        }
        return text + "</svg>\n";
    }

private:
    [[nodiscard]] double x(double px) const { return kLeftEdge + (kChartWidth - kLeftEdge - kRightEdge) * across_.place(px); }
    [[nodiscard]] double y(double px) const {
        return kPlotHeight - kBottomEdge - (kPlotHeight - kTopEdge - kBottomEdge) * down_.place(px);
    }

    [[nodiscard]] std::string grid() const {
        std::string text;
        for (int power = across_.first; power <= across_.last; ++power) {
            const double at = x(std::pow(10.0, power));
            text +=
                printed("<line class='grid' x1='%.1f' y1='%g' x2='%.1f' y2='%g'/>", at, kTopEdge, at, kPlotHeight - kBottomEdge) +
                printed("<text x='%.1f' y='%g' text-anchor='middle'>1e%d</text>", at, kPlotHeight - kBottomEdge + 16, power);
        }
        for (int power = down_.first; power <= down_.last; ++power) {
            const double at = y(std::pow(10.0, power));
            text +=
                printed("<line class='grid' x1='%g' y1='%.1f' x2='%g' y2='%.1f'/>", kLeftEdge, at, kChartWidth - kRightEdge, at) +
                printed("<text x='%g' y='%.1f' text-anchor='end'>1e%d</text>", kLeftEdge - 6, at + 4, power);
        }
        return text +
               printed("<text x='%g' y='%g' text-anchor='middle'>error asked for, px</text>", 0.45 * kChartWidth,
                       kPlotHeight - 8) +
               printed("<text transform='translate(14 %g) rotate(-90)' text-anchor='middle'>error, px</text>",
                       0.5 * (kPlotHeight - kBottomEdge));
    }

    /// Equal to the tolerance.
    [[nodiscard]] std::string asked_line() const {
        std::string points;
        double last_x = 0, last_y = 0;
        for (const ToleranceLine& line : flights_.front().lines) {
            const double at_x = x(line.asked_px), at_y = y(line.asked_px);
            points += printed("%.1f,%.1f ", at_x, at_y);
            if (at_x >= last_x) last_x = at_x, last_y = at_y;
        }
        return printed("<g stroke='%s' fill='none'><polyline stroke-dasharray='6 4' points='", kAskedColor) + points + "'/></g>" +
               printed("<text x='%.1f' y='%.1f'>asked for</text>", last_x + 10, last_y - 4);
    }

    [[nodiscard]] std::string drawn_curve(std::size_t n, const ToleranceCurve& curve) const {
        std::string points, marks;
        double last_x = 0, last_y = 0;
        for (const ToleranceLine& line : flights_[n].lines) {
            const double at_x = x(line.asked_px), at_y = y(line.*curve.value);
            points += printed("%.1f,%.1f ", at_x, at_y);
            marks += mark_at(n, at_x, at_y);
            if (at_x >= last_x) last_x = at_x, last_y = at_y;
        }
        std::string drawn = printed("<g stroke='%s' fill='none' stroke-width='1.5'><polyline stroke-dasharray='%s' points='",
                                    curve.color, curve.dash) +
                            points + "'/>" + marks + "</g>";
        if (n > 0) return drawn;
        return drawn + printed("<text x='%.1f' y='%.1f'>%s</text>", last_x + 10, last_y + (&curve == &kCurves[0] ? 6.0 : 18.0),
                               curve.name);
    }

    /// Its mark, its name, and how tight its bound is.
    [[nodiscard]] std::string legend_line(std::size_t n) const {
        const double at = kPlotHeight + kLegendLine * (static_cast<double>(n) + 0.5);
        return printed("<g stroke='%s' fill='none' stroke-width='1.5'>", kProvenColor) + mark_at(n, kLeftEdge, at) + "</g>" +
               printed("<text x='%g' y='%g'>", kLeftEdge + 14, at + 4) +
               escaped_html(title_of(flights_[n]) + ": " + tightness_words(flights_[n].tightness())) + "</text>";
    }

    const std::vector<FlightErrors>& flights_;
    DecadeScale across_, down_;
};

std::string tolerance_row(const ToleranceLine& line) {
    return std::string(line.broken == 0 ? "<tr>" : "<tr class='dominated'>") + "<th>" + printed("%g px", line.asked_px) +
           "</th>" + html_number(printed("%.3g", line.proven_px)) + html_number(printed("%.3g", line.measured_px)) +
           html_number(printed("%.0f %%", 100 * line.tightness.median)) +
           html_number(printed("%.0f %%", 100 * line.tightness.max)) + html_number(std::to_string(line.samples)) +
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
           escaped_html(printed("The greatest measured error, %.3g px, is at %.0f s: tedavis shot --pose %s --tau %g",
                                worst->measured_px, worst->time_s, worst->pose.c_str(), flight.asked_px) +
                        worst->phase + flight.drawn + " -o worst.png") +
           "</p>\n";
}

std::string flight_chapter(const FlightErrors& flight) {
    std::string rows;
    for (const ToleranceLine& line : flight.lines) rows += tolerance_row(line);
    return "<h3>" + escaped_html(title_of(flight)) + "</h3>\n" +
           html_table(
               "<tr><th>asked for</th><th class='n'>proven, px</th><th class='n'>measured, px</th><th class='n'>measured / "
               "proven of a frame, median</th><th class='n'>greatest</th>"
               "<th class='n'>samples</th><th class='n'>above the bound</th></tr>",
               rows) +
           "<p>" +
           escaped_html("At the design's tolerance the measured error of a frame is " + tightness_words(flight.tightness()) +
                        printed("; %llu samples in all.", static_cast<unsigned long long>(flight.samples()))) +
           "</p>\n" + along_chart(flight) + worst_moment(flight);
}

}  // namespace

std::string tolerance_chart_svg(const std::vector<FlightErrors>& flights) { return ToleranceChart(flights).svg(); }

std::string flight_errors_chapter(const std::vector<FlightErrors>& flights) {
    std::string html =
        "<p>The display states for each frame a bound that the error of its terrain cannot exceed. Places of the ground that the "
        "frame shows were compared with the true surface: none may lie above the bound of its frame.</p>\n" +
        tolerance_chart_svg(flights);
    for (const FlightErrors& flight : flights) html += flight_chapter(flight);
    return html;
}

std::string flight_errors_text(const std::vector<FlightErrors>& flights) {
    std::string text;
    for (const FlightErrors& flight : flights) {
        text += "\n\nerror of the terrain, " + title_of(flight) + ": asked for, proven, measured (" +
                tightness_words(flight.tightness()) + ")";
        for (const ToleranceLine& line : flight.lines)
            text += printed("\n  %6g px %8.3g px %8.3g px  %llu samples, %llu above the bound", line.asked_px, line.proven_px,
                            line.measured_px, static_cast<unsigned long long>(line.samples),
                            static_cast<unsigned long long>(line.broken));
    }
    return text;
}

}  // namespace tedavis::host_sim
