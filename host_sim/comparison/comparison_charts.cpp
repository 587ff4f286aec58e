#include "host_sim/comparison/comparison_charts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "host_sim/comparison/state_rows.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/phase_color.hpp"

namespace tedavis::host_sim {
namespace {

/// By place the axis is a distance, which a fast aircraft and a gap both make great: the time of A tells gaps.
std::vector<bool> gaps_before_instants(const RunComparison& runs) {
    constexpr double kGapSteps = 4;
    const std::size_t count = runs.aligned.instants.size();
    std::vector<bool> gaps(count, false);
    std::vector<double> steps_s;
    const auto step_s = [&](std::size_t n) { return runs.frame_a(n).time_s - runs.frame_a(n - 1).time_s; };
    for (std::size_t n = 1; n < count; ++n) steps_s.push_back(step_s(n));
    if (steps_s.empty()) return gaps;
    const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
    std::nth_element(steps_s.begin(), middle, steps_s.end());
    for (std::size_t n = 1; n < count; ++n) gaps[n] = step_s(n) > kGapSteps * *middle;
    return gaps;
}

/// No line joins instants with a gap between them.
LineChart with_gaps_in_time(LineChart chart, const RunComparison& runs) {
    const std::vector<bool> gaps = gaps_before_instants(runs);
    for (std::size_t n = gaps.size(); n-- > 1;) {
        if (!gaps[n]) continue;
        const auto at = static_cast<std::ptrdiff_t>(n);
        chart.times_s.insert(chart.times_s.begin() + at, (chart.times_s[n - 1] + chart.times_s[n]) / 2);
        for (ChartCurve& curve : chart.curves)
            curve.values.insert(curve.values.begin() + at, std::numeric_limits<double>::quiet_NaN());
    }
    return chart;
}

LineChart empty_chart(const RunComparison& runs, const std::string& title, const std::string& unit) {
    LineChart chart{title, unit, {}, {}, {}};
    chart.x_unit = runs.aligned.axis_unit;
    for (const AlignedInstant& instant : runs.aligned.instants) chart.times_s.push_back(instant.axis);
    return chart;
}

std::string quantity_charts(const RunComparison& runs, const QuantityDifference& difference) {
    constexpr double kLowHeight = 130;
    const Quantity& quantity = kQuantities[difference.quantity];
    LineChart both = empty_chart(runs, quantity.title, quantity.shown_unit),
              apart = empty_chart(runs, "B - A", quantity.shown_unit);
    both.curves = {{"A", kColorOfA, {}}, {"B", kColorOfB, {}, true}};
    apart.curves = {{"B - A", "#7a4fa3", {}}};
    apart.height = kLowHeight;
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n) {
        const double a = runs.value_a(n, difference.quantity) * quantity.per_unit,
                     b = runs.value_b(n, difference.quantity) * quantity.per_unit;
        both.curves[0].values.push_back(a);
        both.curves[1].values.push_back(b);
        apart.curves[0].values.push_back(b - a);
    }
    both.description = std::string(quantity.title) + " of both runs, over the " + runs.aligned.axis;
    if (runs.has_equal(difference.quantity)) {
        both.curves.pop_back();
        both.title += ", equal in A and B";
        return "<div>" + line_chart_svg(with_gaps_in_time(both, runs)) + "</div>\n";
    }
    apart.description = std::string(quantity.title) + ": what B has more than A";
    return "<div>" + line_chart_svg(with_gaps_in_time(both, runs)) + line_chart_svg(with_gaps_in_time(apart, runs)) + "</div>\n";
}

/// Instants in a row of one state; states without a color are left out.
template <class State, class Color>
std::vector<ChartSpan> state_spans(const RunComparison& runs, State state_of, Color color_of) {
    std::vector<ChartSpan> spans;
    const auto& instants = runs.aligned.instants;
    std::string last;
    for (std::size_t n = 0; n < instants.size(); ++n) {
        const std::string state = state_of(n);
        if (n > 0 && !spans.empty() && !last.empty()) spans.back().end = instants[n].axis;
        if (state == last) continue;
        last = color_of(state).empty() ? std::string() : state;
        if (!last.empty()) spans.push_back({instants[n].axis, instants[n].axis, state, color_of(state)});
    }
    return spans;
}

void add_alert_rows(const RunComparison& runs, const std::string& what, int ComparedFrame::*alert, std::vector<StateRow>& rows) {
    static const std::array<std::string, 3> kLevels = {"", "caution", "warning"};
    const auto color_of = [](const std::string& level) -> std::string {
        return level.empty() ? "" : level == "caution" ? "#e0a92e" : "#e0707f";
    };
    const auto level_of = [&](const ComparedFrame& frame) { return kLevels[static_cast<std::size_t>(frame.*alert)]; };
    const auto of_a = state_spans(
        runs, [&](std::size_t n) { return level_of(runs.frame_a(n)); }, color_of);
    const auto of_b = state_spans(
        runs, [&](std::size_t n) { return level_of(runs.frame_b(n)); }, color_of);
    if (of_a.empty() && of_b.empty()) return;
    rows.push_back({"A, " + what, of_a});
    rows.push_back({"B, " + what, of_b});
}

}  // namespace

std::string comparison_charts(const RunComparison& runs) {
    std::string html;
    for (const QuantityDifference& difference : runs.quantities) html += quantity_charts(runs, difference);
    return html.empty() ? html : "<div class='charts'>" + html + "</div>";
}

std::string comparison_states(const RunComparison& runs) {
    const auto& instants = runs.aligned.instants;
    const auto by_axis = [](const AlignedInstant& one, const AlignedInstant& other) { return one.axis < other.axis; };
    const auto [low, high] = std::minmax_element(instants.begin(), instants.end(), by_axis);
    if (!(low->axis < high->axis)) return {};
    std::vector<StateRow> rows;
    rows.push_back({"A, phase", state_spans(
                                    runs, [&](std::size_t n) { return runs.frame_a(n).phase; }, phase_color)});
    rows.push_back({"B, phase", state_spans(
                                    runs, [&](std::size_t n) { return runs.frame_b(n).phase; }, phase_color)});
    add_alert_rows(runs, "terrain alert", &ComparedFrame::terrain_alert, rows);
    add_alert_rows(runs, "obstacle alert", &ComparedFrame::obstacle_alert, rows);
    return "<div class='wide'><div class='states'>" +
           state_rows_svg("Phases and alerts over the " + runs.aligned.axis, rows, low->axis, high->axis,
                          runs.aligned.axis_unit) +
           "</div></div>";
}

}  // namespace tedavis::host_sim
