#include "host_sim/reports/line_chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace tedavis::host_sim {
namespace {

constexpr double kLeft = 46, kRight = 8, kTop = 26, kBottom = 24, kSpanHeight = 16, kMarkRoom = 22, kMarkRadius = 8.5;

struct Scale {
    double low = 0, high = 1, from = 0, to = 1;
    [[nodiscard]] double at(double value) const { return from + (value - low) / (high - low) * (to - from); }
};

/// 1, 2 or 5 times a power of ten, about `count` of them in the range.
double tick_step(double range, int count) {
    const double rough = range / count, power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (rough <= factor * power) return factor * power;
    }
    return 10.0 * power;
}

/// Decimals that tell ticks apart; two where one would do.
int digits_of(double step) { return step >= 1 ? 0 : step >= 0.01 ? 2 : static_cast<int>(std::ceil(-std::log10(step))); }

Scale time_scale(const LineChart& chart) {
    double begin = chart.times_s.empty() ? 0 : chart.times_s.front(), end = begin;
    for (const double t : chart.times_s) begin = std::min(begin, t), end = std::max(end, t);  // a reversed run counts down
    return {begin, std::max(end, begin + 1e-3), kLeft, chart.width - kRight};
}

/// Of each mark the row of its label, from the top: the first one in which it touches none.
std::vector<int> mark_rows(const LineChart& chart) {
    const Scale x = time_scale(chart);
    std::vector<int> rows;
    for (std::size_t n = 0; n < chart.marks.size(); ++n) {
        const auto touches = [&](std::size_t other) {
            return std::abs(x.at(chart.marks[n].time_s) - x.at(chart.marks[other].time_s)) < 2 * kMarkRadius + 1;
        };
        int row = 0;
        for (std::size_t other = 0; other < n;) {
            const bool is_taken = rows[other] == row && touches(other);
            row += is_taken ? 1 : 0;
            other = is_taken ? 0 : other + 1;
        }
        rows.push_back(row);
    }
    return rows;
}

double mark_room(const LineChart& chart) {
    const std::vector<int> rows = mark_rows(chart);
    return rows.empty() ? 0.0 : kMarkRoom * (*std::max_element(rows.begin(), rows.end()) + 1);
}

int tick_count(const LineChart& chart) { return std::max(4, static_cast<int>(chart.height / 50)); }

Scale vertical_scale(const LineChart& chart) {
    double low = INFINITY, high = -INFINITY;
    const auto include = [&](const std::vector<double>& values) {
        for (const double value : values) {
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    };
    for (const ChartCurve& curve : chart.curves) include(curve.values);
    for (const ChartBand& band : chart.bands) {
        include(band.low);
        include(band.high);
    }
    if (!(low <= high)) low = 0, high = 1;
    if (low == high) low -= 0.5, high += 0.5;
    const double step = tick_step(std::max(high - low, 1e-6), tick_count(chart));
    low = std::floor(low / step) * step;
    high = std::max(std::ceil(high / step) * step, low + step);
    const double spans = chart.spans.empty() ? 0.0 : kSpanHeight;
    return {low, high, chart.height - kBottom - spans, kTop + mark_room(chart)};
}

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
    return "<text x='" + decimal(x, 1) + "' y='" + decimal(y, 1) + "' text-anchor='" + anchor + "'>" + escaped_html(text) +
           "</text>";
}

std::string grid(const LineChart& chart, const Scale& x, const Scale& y) {
    std::string svg;
    const double y_step = tick_step(y.high - y.low, tick_count(chart)),
                 x_step = tick_step(x.high - x.low, static_cast<int>(chart.width / 80));
    const int y_count = static_cast<int>(std::lround((y.high - y.low) / y_step));
    for (int i = 0; i <= y_count; ++i) {
        const double value = y.low + i * y_step, place = y.at(value);
        svg += "<line class='grid' x1='" + decimal(kLeft, 1) + "' x2='" + decimal(chart.width - kRight, 1) + "' y1='" +
               decimal(place, 1) + "' y2='" + decimal(place, 1) + "'/>";
        svg += text_at(kLeft - 4, place + 4, "end", decimal(value, digits_of(y_step)));
    }
    for (double value = std::ceil(x.low / x_step) * x_step; value <= x.high; value += x_step) {
        svg += text_at(x.at(value), chart.height - 8, "middle",
                       decimal(value, x_step < 1 ? 1 : 0) + " " + escaped_html(chart.x_unit));
    }
    return svg;
}

/// Indices of what is drawn of a curve: all, or of each column of the drawing the least and the greatest value, and gaps.
std::vector<std::size_t> drawn_points(const LineChart& chart, const ChartCurve& curve, const Scale& x) {
    const std::size_t count = chart.times_s.size();
    std::vector<std::size_t> indices;
    const bool is_dense = static_cast<double>(count) > 3 * chart.width;
    for (std::size_t first = 0; first < count;) {
        std::size_t end = first + 1, least = first, greatest = first;
        const auto column = [&](std::size_t n) { return std::floor(x.at(chart.times_s[n])); };
        const auto goes_on = [&](std::size_t n) {
            return is_dense && std::isfinite(curve.values[n]) && std::isfinite(curve.values[first]) && column(n) == column(first);
        };
        for (; end < count && goes_on(end); ++end) {
            if (curve.values[end] < curve.values[least]) least = end;
            if (curve.values[end] > curve.values[greatest]) greatest = end;
        }
        indices.push_back(std::min(least, greatest));
        if (least != greatest) indices.push_back(std::max(least, greatest));
        first = end;
    }
    return indices;
}

std::string curve_path(const LineChart& chart, const ChartCurve& curve, const Scale& x, const Scale& y) {
    std::string path;
    bool drawing = false;
    for (const std::size_t i : drawn_points(chart, curve, x)) {
        if (!std::isfinite(curve.values[i])) {
            drawing = false;
            continue;
        }
        path += (drawing ? "L" : "M") + decimal(x.at(chart.times_s[i]), 1) + " " + decimal(y.at(curve.values[i]), 1);
        drawing = true;
    }
    return "<path d='" + path + "' fill='none' stroke='" + curve.color + "' stroke-width='1.5'" +
           (curve.dashed ? " stroke-dasharray='6 3'" : "") + "/>";
}

/// From `first` on as far as the band has values: forwards along its top, back along its bottom. Of a dense band the widest of
/// each column. `first` is then behind it.
std::string band_part(const LineChart& chart, const ChartBand& band, std::size_t& first, const Scale& x, const Scale& y) {
    const bool is_dense = static_cast<double>(chart.times_s.size()) > 3 * chart.width;
    const auto has_value = [&](std::size_t n) { return std::isfinite(band.low[n]) && std::isfinite(band.high[n]); };
    std::string top, bottom;
    while (first < chart.times_s.size() && has_value(first)) {
        double low = band.low[first], high = band.high[first];
        const double at = x.at(chart.times_s[first]);
        for (++first; is_dense && first < chart.times_s.size() && has_value(first) &&
                      std::floor(x.at(chart.times_s[first])) == std::floor(at);
             ++first) {
            low = std::min(low, band.low[first]);
            high = std::max(high, band.high[first]);
        }
        top += (top.empty() ? "M" : "L") + decimal(at, 1) + " " + decimal(y.at(high), 1);
        bottom.insert(0, "L" + decimal(at, 1) + " " + decimal(y.at(low), 1));
    }
    return top.empty() ? top : top + bottom + "Z";
}

std::string band_svg(const LineChart& chart, const ChartBand& band, const Scale& x, const Scale& y) {
    std::string path;
    for (std::size_t first = 0; first < chart.times_s.size(); ++first) path += band_part(chart, band, first, x, y);
    return path.empty() ? path : "<path class='band' d='" + path + "' fill='" + band.color + "' fill-opacity='0.25'/>";
}

/// The label, or what follows its last dot, or nothing, by the room there is.
std::string span_text(const std::string& label, double room) {
    constexpr double kLetter = 6.2;
    std::string name = label.substr(0, label.find(' ')), last = name.substr(name.rfind('.') + 1);
    if (kLetter * static_cast<double>(name.size()) < room) return name;
    return kLetter * static_cast<double>(last.size()) < room ? last : std::string();
}

std::string span_svg(const LineChart& chart, const ChartSpan& span, const Scale& x) {
    const double left = x.at(std::min(span.begin, span.end)), right = x.at(std::max(span.begin, span.end));
    const double top = chart.height - kBottom - kSpanHeight + 3;
    std::string svg = "<rect x='" + decimal(left, 1) + "' y='" + decimal(top, 1) + "' width='" +
                      decimal(std::max(right - left, 0.5), 1) + "' height='" + decimal(kSpanHeight - 4, 1) + "' fill='" +
                      span.color + "'><title>" + escaped_html(span.label) + "</title></rect>";
    const std::string text = span_text(span.label, right - left);
    if (!text.empty())
        svg += "<text class='span' x='" + decimal(0.5 * (left + right), 1) + "' y='" + decimal(top + 9.5, 1) +
               "' text-anchor='middle'>" + escaped_html(text) + "</text>";
    return svg;
}

/// A large unseen circle takes the finger, a small one shows the place.
std::string mark_svg(const ChartMark& mark, int row, const Scale& x, const Scale& y) {
    const double middle = kTop + kMarkRoom * (row + 0.5);
    const std::string left = decimal(x.at(mark.time_s), 1), top = decimal(y.at(mark.value), 1);
    const std::string label_y = decimal(middle, 1);
    return "<a class='mark' href='" + escaped_html(mark.link) + "' aria-label='" + escaped_html(mark.description) + "'><title>" +
           escaped_html(mark.description) + "</title><line x1='" + left + "' x2='" + left + "' y1='" + decimal(middle + 8, 1) +
           "' y2='" + top + "'/><circle class='place' cx='" + left + "' cy='" + top + "' r='3.5'/><circle class='label' cx='" +
           left + "' cy='" + label_y + "' r='" + decimal(kMarkRadius, 1) + "'/><circle class='finger' cx='" + left + "' cy='" +
           label_y + "' r='12' fill='transparent'/><text x='" + left + "' y='" + decimal(middle + 4, 1) +
           "' text-anchor='middle'>" + escaped_html(mark.label) + "</text></a>";
}

}  // namespace

std::string escaped_html(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            case '\'': out += "&#39;"; break;
            default: out += c;
        }
    }
    return out;
}

std::string decimal(double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, std::clamp(value, -1e15, 1e15));
    return text;
}

LineChart with_gaps(LineChart chart) {
    constexpr double kUsualSteps = 4;
    std::vector<double> steps;
    for (std::size_t n = 1; n < chart.times_s.size(); ++n) steps.push_back(chart.times_s[n] - chart.times_s[n - 1]);
    if (steps.empty()) return chart;
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
    const double longest_s = kUsualSteps * std::abs(steps[steps.size() / 2]);
    for (std::size_t n = chart.times_s.size() - 1; n > 0; --n) {
        const double before_s = chart.times_s[n - 1], after_s = chart.times_s[n];
        if (std::abs(after_s - before_s) <= longest_s) continue;
        const auto at = static_cast<std::ptrdiff_t>(n);
        chart.times_s.insert(chart.times_s.begin() + at, (before_s + after_s) / 2);
        for (ChartCurve& curve : chart.curves)
            curve.values.insert(curve.values.begin() + at, std::numeric_limits<double>::quiet_NaN());
        for (ChartBand& band : chart.bands)
            for (std::vector<double>* values : {&band.low, &band.high})
                values->insert(values->begin() + at, std::numeric_limits<double>::quiet_NaN());
    }
    return chart;
}

std::string line_chart_svg(const LineChart& chart) {
    const Scale x = time_scale(chart);
    const Scale y = vertical_scale(chart);
    // What is a picture as a whole hides its links from who does not see it.
    std::string svg = "<svg class='chart' viewBox='0 0 " + decimal(chart.width, 0) + " " + decimal(chart.height, 0) + "' role='" +
                      (chart.marks.empty() ? "img" : "group") + "' aria-label='" + escaped_html(chart.title) + "'>";
    if (!chart.description.empty())
        svg += "<title>" + escaped_html(chart.title) + "</title><desc>" + escaped_html(chart.description) + "</desc>";
    svg += text_at(kLeft, 14, "start", chart.title + (chart.unit.empty() ? "" : " [" + chart.unit + "]"));
    double legend = chart.width - kRight;
    for (auto curve = chart.curves.rbegin(); chart.curves.size() > 1 && curve != chart.curves.rend(); ++curve) {
        svg += "<text x='" + decimal(legend, 1) + "' y='14' text-anchor='end' style='fill:" + curve->color + "'>" +
               escaped_html(std::string(curve->dashed ? "- - " : "") + curve->name) + "</text>";
        legend -= 6.5 * static_cast<double>(curve->name.size() + (curve->dashed ? 4 : 0)) + 10;
    }
    svg += grid(chart, x, y);
    for (const ChartSpan& span : chart.spans) svg += span_svg(chart, span, x);
    for (const ChartBand& band : chart.bands) svg += band_svg(chart, band, x, y);
    for (const ChartCurve& curve : chart.curves) svg += curve_path(chart, curve, x, y);
    const std::vector<int> rows = mark_rows(chart);
    for (std::size_t n = 0; n < rows.size(); ++n) svg += mark_svg(chart.marks[n], rows[n], x, y);
    return svg + "</svg>";
}

}  // namespace tedavis::host_sim
