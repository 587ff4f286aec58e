#include "host_sim/evaluation/html_parts.hpp"

#include <array>

#include "host_sim/reports/base64.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/phase_color.hpp"

namespace tedavis::host_sim {
namespace {

/// Light enough for dark text.
std::string layer_color(const std::string& layer) {
    static constexpr std::array<std::pair<const char*, const char*>, 5> kColors = {{{"terrain", "#c9a06c"},
                                                                                    {"data", "#7fb2ec"},
                                                                                    {"uncertainty", "#c8a2e8"},
                                                                                    {"labels", "#f0c75e"},
                                                                                    {"symbology", "#86cf9c"}}};
    for (const auto& [name, color] : kColors)
        if (layer == name) return color;
    return "#c4c9cf";
}

}  // namespace

std::string html_section(const std::string& title, const std::string& html) {
    return "<section><h2>" + escaped_html(title) + "</h2>\n" + html + "</section>\n";
}

std::string html_table(const std::string& head_rows, const std::string& rows) {
    return "<div class='wide-table'><table><thead>" + head_rows + "</thead><tbody>" + rows + "</tbody></table></div>\n";
}

std::string html_cell(const std::string& text) { return "<td>" + escaped_html(text) + "</td>"; }
std::string html_number(const std::string& text) { return "<td class='n'>" + escaped_html(text) + "</td>"; }
std::string html_aside(const std::string& text) { return "<td class='n aside'>" + escaped_html(text) + "</td>"; }

std::string html_phase(const std::string& phase) {
    return "<span class='phase'><span class='key' style='background:" + phase_color(phase) + "'></span>" + escaped_html(phase) +
           "</span>";
}

std::string html_fact(const std::string& number, const std::string& words) {
    return "<div class='fact'><b>" + escaped_html(number) + "</b><span>" + escaped_html(words) + "</span></div>";
}

std::string html_figure(const std::string& png, const std::string& caption, const std::string& spoken) {
    return "<figure><img alt='" + escaped_html(spoken) + "' src='data:image/png;base64," + base64(png) + "'><figcaption>" +
           escaped_html(caption) + "</figcaption></figure>\n";
}

std::string seconds_text(double time_s) { return decimal(time_s, 1) + " s"; }
std::string clutter_text(double clutter) { return decimal(clutter, 3); }
std::string percent_text(double share) { return decimal(100 * share, 0) + " %"; }

std::string layer_bar(const std::vector<LayerShare>& layers, const std::string& prioritized) {
    constexpr double kRoomForName = 0.14, kMin = 0.002;
    std::string bar;
    for (const LayerShare& layer : layers) {
        if (layer.share < kMin) continue;
        const bool is_first = layer.layer == prioritized;
        const std::string words = layer.layer + " " + percent_text(layer.share) + (is_first ? ", comes first" : "");
        bar += "<span" + std::string(is_first ? " class='first'" : "") + " title='" + escaped_html(words) +
               "' style='width:" + decimal(100 * layer.share, 2) + "%;background:" + layer_color(layer.layer) + "'>" +
               (layer.share >= kRoomForName ? escaped_html(percent_text(layer.share)) : std::string()) + "</span>";
    }
    return bar.empty() ? bar : "<div class='bar'>" + bar + "</div>";
}

std::string layer_key(const std::vector<LayerShare>& layers, bool with_outline) {
    std::string names;
    for (const LayerShare& layer : layers)
        names += "<span class='entry'><span class='key' style='background:" + layer_color(layer.layer) + "'></span>" +
                 escaped_html(layer.layer) + "</span> ";
    if (with_outline) names += "<span class='entry'><span class='key first'></span>comes first in the design</span>";
    return "<p class='soft'>" + names + "</p>";
}

}  // namespace tedavis::host_sim
