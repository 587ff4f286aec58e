#include "host_sim/reports/line_chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tedavis::host_sim {
namespace {

// A narrow drawing: on a phone it is shown nearly 1:1, on a desk it grows.
constexpr double kWidth = 480, kHeight = 230, kLeft = 46, kRight = 8, kTop = 26, kBottom = 24, kSpanHeight = 16;

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

Scale vertical_scale(const LineChart& chart) {
    double low = INFINITY, high = -INFINITY;
    for (const ChartCurve& curve : chart.curves) {
        for (const double value : curve.values) {
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (!(low <= high)) low = 0, high = 1;
    const double step = tick_step(std::max(high - low, 1e-6), 4);
    low = std::floor(low / step) * step;
    high = std::max(std::ceil(high / step) * step, low + step);
    const double spans = chart.spans.empty() ? 0.0 : kSpanHeight;
    return {low, high, kHeight - kBottom - spans, kTop};
}

std::string text_at(double x, double y, const char* anchor, const std::string& text) {
    return "<text x='" + decimal(x, 1) + "' y='" + decimal(y, 1) + "' text-anchor='" + anchor + "'>" + escaped_html(text) +
           "</text>";
}

std::string grid(const Scale& x, const Scale& y) {
    std::string svg;
    const double y_step = tick_step(y.high - y.low, 4), x_step = tick_step(x.high - x.low, 6);
    const int y_count = static_cast<int>(std::lround((y.high - y.low) / y_step));
    for (int i = 0; i <= y_count; ++i) {
        const double value = y.low + i * y_step, place = y.at(value);
        svg += "<line class='grid' x1='" + decimal(kLeft, 1) + "' x2='" + decimal(kWidth - kRight, 1) + "' y1='" +
               decimal(place, 1) + "' y2='" + decimal(place, 1) + "'/>";
        svg += text_at(kLeft - 4, place + 4, "end", decimal(value, y_step < 1 ? 2 : 0));
    }
    for (double value = std::ceil(x.low / x_step) * x_step; value <= x.high; value += x_step) {
        svg += text_at(x.at(value), kHeight - 8, "middle", decimal(value, x_step < 1 ? 1 : 0) + " s");
    }
    return svg;
}

std::string curve_path(const LineChart& chart, const ChartCurve& curve, const Scale& x, const Scale& y) {
    std::string path;
    bool drawing = false;
    for (std::size_t i = 0; i < chart.times_s.size(); ++i) {
        if (!std::isfinite(curve.values[i])) {
            drawing = false;
            continue;
        }
        path += (drawing ? "L" : "M") + decimal(x.at(chart.times_s[i]), 1) + " " + decimal(y.at(curve.values[i]), 1);
        drawing = true;
    }
    return "<path d='" + path + "' fill='none' stroke='" + curve.color + "' stroke-width='1.5'/>";
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

std::string line_chart_svg(const LineChart& chart) {
    double begin = chart.times_s.empty() ? 0 : chart.times_s.front(), end = begin;
    for (const double t : chart.times_s) begin = std::min(begin, t), end = std::max(end, t);  // a reversed run counts down
    const Scale x{begin, std::max(end, begin + 1e-3), kLeft, kWidth - kRight};
    const Scale y = vertical_scale(chart);
    std::string svg = "<svg class='chart' viewBox='0 0 " + decimal(kWidth, 0) + " " + decimal(kHeight, 0) +
                      "' role='img' aria-label='" + escaped_html(chart.title) + "'>";
    svg += text_at(kLeft, 14, "start", chart.title + " [" + chart.unit + "]");
    double legend = kWidth - kRight;
    for (auto curve = chart.curves.rbegin(); chart.curves.size() > 1 && curve != chart.curves.rend(); ++curve) {
        svg += "<text x='" + decimal(legend, 1) + "' y='14' text-anchor='end' style='fill:" + curve->color + "'>" +
               escaped_html(curve->name) + "</text>";
        legend -= 6.5 * static_cast<double>(curve->name.size()) + 10;
    }
    svg += grid(x, y);
    for (const ChartSpan& span : chart.spans) {
        const double left = x.at(std::min(span.begin, span.end)), right = x.at(std::max(span.begin, span.end));
        svg += "<rect x='" + decimal(left, 1) + "' y='" + decimal(kHeight - kBottom - kSpanHeight + 3, 1) + "' width='" +
               decimal(std::max(right - left, 0.5), 1) + "' height='" + decimal(kSpanHeight - 4, 1) + "' fill='" + span.color +
               "'><title>" + escaped_html(span.label) + "</title></rect>";
    }
    for (const ChartCurve& curve : chart.curves) svg += curve_path(chart, curve, x, y);
    return svg + "</svg>";
}

}  // namespace tedavis::host_sim
