#include "host_sim/comparison/comparison_charts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host_sim/comparison/state_rows.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/phase_color.hpp"

namespace tedavis::host_sim {
namespace {

LineChart empty_chart(const RunComparison& runs, const std::string& title, const std::string& unit) {
    LineChart chart{title, unit, {}, {}, {}};
    chart.x_unit = runs.aligned.axis_unit;
    for (const AlignedInstant& instant : runs.aligned.instants) chart.times_s.push_back(instant.axis);
    return chart;
}

std::string quantity_charts(const RunComparison& runs, const QuantityDifference& difference) {
    constexpr double kLowHeight = 130;
    const Quantity& quantity = kQuantities[difference.quantity];
    LineChart both = empty_chart(runs, quantity.title, quantity.unit), apart = empty_chart(runs, "B - A", quantity.unit);
    both.curves = {{"A", kColorOfA, {}}, {"B", kColorOfB, {}, true}};
    apart.curves = {{"B - A", "#7a4fa3", {}}};
    apart.height = kLowHeight;
    for (std::size_t n = 0; n < runs.aligned.instants.size(); ++n) {
        const double a = runs.value_a(n, difference.quantity), b = runs.value_b(n, difference.quantity);
        both.curves[0].values.push_back(a);
        both.curves[1].values.push_back(b);
        apart.curves[0].values.push_back(b - a);
    }
    both.description = std::string(quantity.title) + " of both runs, over the " + runs.aligned.axis;
    if (difference.greatest == 0) {
        both.curves.pop_back();
        both.title += ", equal in A and B";
        return "<div>" + line_chart_svg(with_gaps(both)) + "</div>\n";
    }
    apart.description = std::string(quantity.title) + ": what B has more than A";
    return "<div>" + line_chart_svg(with_gaps(both)) + line_chart_svg(with_gaps(apart)) + "</div>\n";
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
