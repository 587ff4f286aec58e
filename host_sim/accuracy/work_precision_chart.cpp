#include "host_sim/accuracy/work_precision_chart.hpp"
#include "host_sim/printed_text.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kWidth = 560, kHeight = 320, kLeft = 64, kRight = 12, kTop = 14, kBottom = 44;
constexpr double kMark = 5, kLabelGap = 8;
constexpr const char *kFrontColor = "#0b57a4", *kDominatedColor = "#b3261e";

class WorkPrecisionChart {
public:
    explicit WorkPrecisionChart(const MeasuredKnob& knob) : knob_(knob) {
        std::vector<double> times, errors;
        for (const MeasuredLevel& level : knob.levels) {
            times.insert(times.end(), {level.ms.p5, level.ms.p95});
            errors.insert(errors.end(), {level.error.mean, level.error.max});
        }
        times_ = DecadeScale::of(times);
        errors_ = DecadeScale::of(errors);
    }

    [[nodiscard]] std::string svg() const {
        std::string text = printed("<svg class='chart' viewBox='0 0 %g %g' role='img'>", kWidth, kHeight);
        text += "<title>" + escaped_html(knob_.title) + ": error over time</title>" + grid() + front();
        bool is_above = true;
        for (const MeasuredLevel& level : knob_.levels) {
            text += mark(level) + label(level, is_above);
            is_above = !is_above;  // neighbours often lie side by side
        }
        return text + "</svg>\n";
    }

private:
    [[nodiscard]] double x(double ms) const { return kLeft + (kWidth - kLeft - kRight) * times_.place(ms); }
    [[nodiscard]] double y(double error) const { return kHeight - kBottom - (kHeight - kTop - kBottom) * errors_.place(error); }

    [[nodiscard]] std::string grid() const {
        std::string text;
        for (int power = times_.first; power <= times_.last; ++power) {
            const double at = x(std::pow(10.0, power));
            text += printed("<line class='grid' x1='%.1f' y1='%g' x2='%.1f' y2='%g'/>", at, kTop, at, kHeight - kBottom) +
                    printed("<text x='%.1f' y='%g' text-anchor='middle'>1e%d</text>", at, kHeight - kBottom + 16, power);
        }
        for (int power = errors_.first; power <= errors_.last; ++power) {
            const double at = y(std::pow(10.0, power));
            text += printed("<line class='grid' x1='%g' y1='%.1f' x2='%g' y2='%.1f'/>", kLeft, at, kWidth - kRight, at) +
                    printed("<text x='%g' y='%.1f' text-anchor='end'>1e%d</text>", kLeft - 6, at + 4, power);
        }
        return text +
               printed("<text x='%g' y='%g' text-anchor='middle'>ms, median of the rounds</text>", 0.5 * (kLeft + kWidth),
                       kHeight - 8) +
               printed("<text transform='translate(14 %g) rotate(-90)' text-anchor='middle'>", 0.5 * (kHeight - kBottom)) +
               escaped_html("error, " + knob_.unit) + "</text>";
    }

    [[nodiscard]] std::string front() const {
        std::vector<const MeasuredLevel*> levels;
        for (const MeasuredLevel& level : knob_.levels)
            if (level.is_offered && !level.is_dominated) levels.push_back(&level);
        std::sort(levels.begin(), levels.end(),
                  [](const MeasuredLevel* a, const MeasuredLevel* b) { return a->ms.median < b->ms.median; });
        std::string points;
        for (const MeasuredLevel* const level : levels)
            points += printed("%.1f,%.1f ", x(level->ms.median), y(level->error.mean));
        return "<polyline fill='none' stroke='" + std::string(kFrontColor) + "' stroke-width='1.5' points='" + points + "'/>";
    }

    [[nodiscard]] std::string mark(const MeasuredLevel& level) const {
        const double at_x = x(level.ms.median), at_y = y(level.error.mean);
        const char* const color = level.is_dominated ? kDominatedColor : kFrontColor;
        std::string text = "<g stroke='" + std::string(color) + "' fill='" + color + "'>";
        text += printed("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f'/>", x(level.ms.p5), at_y, x(level.ms.p95), at_y);
        text += printed("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke-dasharray='2 2'/>", at_x, at_y, at_x,
                        y(level.error.max));
        if (!level.is_offered)
            text += printed("<circle cx='%.1f' cy='%.1f' r='%g' fill='none' stroke-width='2'/>", at_x, at_y, kMark);
        else if (level.is_dominated)
            text += printed("<path d='M%.1f %.1fl%g %gm0 %gl%g %g' stroke-width='2'/>", at_x - kMark, at_y - kMark, 2 * kMark,
                            2 * kMark, -2 * kMark, -2 * kMark, 2 * kMark);
        else if (level.error.max <= 0)
            text += printed("<rect x='%.1f' y='%.1f' width='%g' height='%g'/>", at_x - kMark, at_y - kMark, 2 * kMark, 2 * kMark);
        else
            text += printed("<circle cx='%.1f' cy='%.1f' r='%g'/>", at_x, at_y, kMark);
        return text + "</g>";
    }

    [[nodiscard]] std::string label(const MeasuredLevel& level, bool is_above) const {
        const double at_x = x(level.ms.median), at_y = y(level.error.mean);
        const bool is_right = at_x > 0.7 * kWidth;
        return printed("<text x='%.1f' y='%.1f' text-anchor='%s'>", at_x + (is_right ? -kLabelGap : kLabelGap),
                       at_y + (is_above ? -kLabelGap : 2 * kLabelGap), is_right ? "end" : "start") +
               escaped_html(level.name) + "</text>";
    }

    const MeasuredKnob& knob_;
    DecadeScale times_, errors_;
};

}  // namespace

DecadeScale DecadeScale::of(const std::vector<double>& values) {
    double least = 0, greatest = 0;
    for (const double value : values) {
        if (!(value > 0)) continue;
        least = least > 0 ? std::min(least, value) : value;
        greatest = std::max(greatest, value);
    }
    if (!(least > 0)) return {};
    const int first = static_cast<int>(std::floor(std::log10(least)));
    return {first, std::max(first + 1, static_cast<int>(std::ceil(std::log10(greatest))))};
}

double DecadeScale::place(double value) const {
    if (!(value > 0)) return 0;
    return std::clamp((std::log10(value) - first) / (last - first), 0.0, 1.0);
}

std::string work_precision_svg(const MeasuredKnob& knob) { return WorkPrecisionChart(knob).svg(); }

}  // namespace tedavis::host_sim
