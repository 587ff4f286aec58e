#include "host_sim/comparison/state_rows.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {
namespace {

constexpr double kRowsWidth = 960, kRowsLeft = 120, kRowsRight = 8, kRowsTop = 24, kRowHeight = 24, kRowsBottom = 22;

std::string rows_text(double x, double y, const char* anchor, const std::string& text, const char* kind = "") {
    return "<text" + std::string(kind) + " x='" + decimal(x, 1) + "' y='" + decimal(y, 1) + "' text-anchor='" + anchor + "'>" +
           escaped_html(text) + "</text>";
}

std::string row_span(const ChartSpan& span, double left, double right, double top) {
    constexpr double kLetter = 6.2;
    std::string svg = "<rect x='" + decimal(left, 1) + "' y='" + decimal(top, 1) + "' width='" +
                      decimal(std::max(right - left, 1.0), 1) + "' height='" + decimal(kRowHeight - 6, 1) + "' fill='" +
                      span.color + "'><title>" + escaped_html(span.label) + "</title></rect>";
    const std::string last = span.label.substr(span.label.rfind('.') + 1);
    for (const std::string& text : {span.label, last})
        if (kLetter * static_cast<double>(text.size()) < right - left)
            return svg + rows_text(0.5 * (left + right), top + 12.5, "middle", text, " class='span'");
    return svg;
}

/// 1, 2 or 5 times a power of ten, no less than `rough`.
double round_step(double rough) {
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (rough <= factor * power) return factor * power;
    return 10 * power;
}

}  // namespace

std::string state_rows_svg(const std::string& title, const std::vector<StateRow>& rows, double low, double high,
                           const std::string& unit) {
    constexpr int kTicks = 6;
    const double height = kRowsTop + kRowHeight * static_cast<double>(rows.size()) + kRowsBottom;
    const auto x = [&](double value) { return kRowsLeft + (value - low) / (high - low) * (kRowsWidth - kRowsLeft - kRowsRight); };
    std::string svg = "<svg class='chart' viewBox='0 0 " + decimal(kRowsWidth, 0) + " " + decimal(height, 0) +
                      "' role='img' aria-label='" + escaped_html(title) + "'>" + rows_text(0, 14, "start", title);
    for (std::size_t n = 0; n < rows.size(); ++n) {
        const double top = kRowsTop + kRowHeight * static_cast<double>(n);
        svg += rows_text(kRowsLeft - 8, top + 13, "end", rows[n].name);
        for (const ChartSpan& span : rows[n].spans) svg += row_span(span, x(span.begin), x(span.end), top);
    }
    const double step = round_step((high - low) / kTicks);
    for (double value = std::ceil(low / step) * step; value <= high; value += step)
        svg += rows_text(x(value), height - 6, "middle", decimal(value, step < 1 ? 1 : 0) + " " + unit);
    return svg + "</svg>\n";
}

}  // namespace tedavis::host_sim
