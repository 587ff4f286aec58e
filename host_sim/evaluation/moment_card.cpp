#include "host_sim/evaluation/moment_card.hpp"

#include "host_sim/evaluation/clutter_opinions.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

std::string busiest_words(const PictureMeasures& measures, const perception::RegionGrid& grid) {
    if (measures.clutter_grid.empty()) return {};
    const std::size_t busiest = busiest_region(measures.clutter_grid);
    const int column = static_cast<int>(busiest) % grid.columns, row = static_cast<int>(busiest) / grid.columns;
    return region_name(grid, column, row) + " (row " + std::to_string(row + 1) + ", column " + std::to_string(column + 1) +
           "), " + clutter_text(measures.clutter_grid[busiest]);
}

std::string layer_words(const std::vector<LayerShare>& layers) {
    std::string text;
    for (const LayerShare& layer : layers)
        text += (text.empty() ? "" : ", ") + layer.layer + " " + percent_text(layer.share) + " on " + percent_text(layer.area) +
                " of the pixels";
    return text;
}

std::string plan_list(const PlanLines& plan, const PictureMeasures& measures, const ClutterOpinions& opinions,
                      const perception::RegionGrid& grid) {
    std::string list;
    const auto add = [&](const std::string& term, const std::string& words) {
        if (!words.empty()) list += "<dt>" + escaped_html(term) + "</dt><dd>" + escaped_html(words) + "</dd>";
    };
    add("busiest region", busiest_words(measures, grid));
    add("other opinions", opinions_words(opinions));
    add("the eye", layer_words(measures.layers));
    for (const auto& [term, words] : plan) add(term, words);
    return list.empty() ? list : "<dl class='plan'>" + list + "</dl>";
}

std::string view_figures(const MomentViews& views, const std::string& whose) {
    const auto spoken = [&](const char* what) { return what + (whose.empty() ? "" : ", " + whose); };
    return "<div class='views'>" + html_figure(views.picture, "picture", spoken("the picture at this moment")) +
           html_figure(views.saliency, "saliency: bright draws the eye", spoken("its saliency map")) +
           html_figure(views.heat, "saliency over the picture", spoken("its saliency as heat over the picture")) +
           html_figure(views.edges, "edges", spoken("its edges")) +
           html_figure(views.congestion, "Feature Congestion", spoken("its Feature Congestion, bright is full")) + "</div>";
}

/// What a card shows of one of two flights.
struct CardSide {
    std::size_t index;
    const PlanLines& plan;
    const MomentViews& views;
    const ClutterOpinions& opinions;
};

std::string one_side(const ComparedFlight& side, const CardSide& shown, const EvaluationSettings& settings) {
    const PictureMeasures& measures = side.flight->measures[shown.index];
    std::string html;
    if (!side.name.empty())
        html += "<p><b>" + escaped_html(side.name) + "</b>: clutter " + clutter_text(measures.clutter) + "</p>";
    html += view_figures(shown.views, side.name);
    html += layer_bar(measures.layers, side.flight->run.frames[shown.index].prioritized);
    return html + plan_list(shown.plan, measures, shown.opinions, settings.grid);
}

}  // namespace

std::string moment_id(const FlightMoment& moment) { return "moment-" + moment.label; }

std::string moment_words(const EvaluatedFlight& flight, const FlightMoment& moment) {
    const FlightFrame& frame = flight.run.frames[moment.index];
    return moment.label + ": " + seconds_text(frame.time_s) + ", " + frame.phase + ", clutter " +
           clutter_text(flight.measures[moment.index].clutter);
}

std::string moment_tab(const EvaluatedFlight& flight, const FlightMoment& moment) {
    const FlightFrame& frame = flight.run.frames[moment.index];
    return "<li><a href='#" + moment_id(moment) + "'><b>" + escaped_html(moment.label) + "</b> " + seconds_text(frame.time_s) +
           "<br>" + clutter_text(flight.measures[moment.index].clutter) + "</a></li>";
}

std::string moment_card(const ComparedFlight& own, const FlightMoment& moment, const ComparedFlight& other,
                        const EvaluationSettings& settings) {
    const FlightFrame& frame = own.flight->run.frames[moment.index];
    std::string words = "frame " + std::to_string(frame.frame) + ", phase by " + frame.phase_source;
    words += moment.prominence > 0 ? ", rises by " + clutter_text(moment.prominence) + " over its surroundings"
                                   : ", the highest value of a flight without peaks";
    std::string html = "<article class='moment' id='" + moment_id(moment) + "'><h3>" +
                       escaped_html(moment_words(*own.flight, moment)) + "</h3><p class='soft'>" + escaped_html(words) + "</p>\n";
    html += one_side(own, {moment.index, moment.plan, moment.views, moment.opinions}, settings);
    if (other.flight != nullptr)
        html += one_side(other, {moment.other, moment.other_plan, moment.other_views, moment.other_opinions}, settings);
    return html + "</article>\n";
}

}  // namespace tedavis::host_sim
