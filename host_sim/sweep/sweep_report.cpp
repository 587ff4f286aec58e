#include "host_sim/sweep/sweep_report.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/evaluation/clutter_opinions.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/evaluation/report_look.hpp"
#include "host_sim/reports/base64.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/version.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kSweepStyle =
    ".ring td{min-width:7.5rem;padding:.2rem;font-size:.8rem;border:0;vertical-align:top}"
    ".ring td img{display:block;width:100%;height:auto}.ring th{padding:.2rem .4rem .2rem 0;white-space:nowrap}"
    ".ring .out{outline:3px solid #b3261e;outline-offset:-1px}.ring .none{color:var(--soft);background:var(--pale)}"
    ".views.three{grid-template-columns:repeat(3,1fr)}"
    "@media (max-width:46rem){.views.three{grid-template-columns:1fr}}";

std::string metre_text(double value) { return decimal(value, 0) + " m"; }

std::string viewpoint_words(const Viewpoint& viewpoint) {
    return metre_text(viewpoint.height_m) + " above, " + metre_text(viewpoint.distance_m) + " away, seen from " +
           decimal(viewpoint.bearing_deg, 0) + " degrees";
}

std::string place_words(const SweptView& view) {
    if (!view.place.is_inside) return sight_name(view.sight);
    return std::string(sight_name(view.sight)) + ", " + decimal(view.saliency.times_mean(), 1) +
           " times the mean saliency, its strongest pixel above " + percent_text(view.saliency.rank) + " of the picture";
}

/// The stronger, the more clutter; between the least and the greatest of the sweep.
std::string clutter_tint(const Sweep& sweep, double clutter) {
    const double least = sweep.views[least_cluttered(sweep.views)].measures.clutter;
    const double most = sweep.views[most_cluttered(sweep.views)].measures.clutter;
    const double share = most > least ? (clutter - least) / (most - least) : 0;
    return "hsl(28 90% " + decimal(96 - 36 * share, 0) + "%)";
}

bool stands_out(const Sweep& sweep, std::size_t index) {
    return std::any_of(sweep.standing_out.begin(), sweep.standing_out.end(),
                       [&](const StandingOut& one) { return one.index == index; });
}

std::string view_cell(const Sweep& sweep, std::size_t index) {
    const SweptView& view = sweep.views[index];
    const std::string words = viewpoint_words(view.viewpoint) + ": " + place_words(view);
    return "<td" + std::string(stands_out(sweep, index) ? " class='out'" : "") +
           " style='background:" + clutter_tint(sweep, view.measures.clutter) + "' title='" + escaped_html(words) +
           "'><img alt='" + escaped_html(words) + "' src='data:image/png;base64," + base64(view.small_png) + "'><b>" +
           clutter_text(view.measures.clutter) + "</b> " +
           (view.place.is_inside ? "place " + decimal(view.saliency.times_mean(), 1) + " &times;" : std::string()) +
           (view.sight == PlaceSight::seen ? std::string() : ", " + std::string(sight_name(view.sight))) + "</td>";
}

bool is_same(const Viewpoint& a, const Viewpoint& b) {
    return a.height_m == b.height_m && a.distance_m == b.distance_m && a.bearing_deg == b.bearing_deg;
}

std::string sweep_cell(const Sweep& sweep, const Viewpoint& wanted) {
    for (std::size_t n = 0; n < sweep.views.size(); ++n)
        if (is_same(sweep.views[n].viewpoint, wanted)) return view_cell(sweep, n);
    for (const SkippedViewpoint& skipped : sweep.skipped)
        if (is_same(skipped.viewpoint, wanted)) return "<td class='none'>" + escaped_html(skipped.reason) + "</td>";
    return "<td class='none'>not drawn</td>";
}

/// A row a distance, a column a bearing.
std::string ring_table(const Sweep& sweep, double height_m) {
    const auto count = static_cast<double>(sweep.rings.bearings);
    std::string head = "<tr><th>distance</th>", rows;
    for (double n = 0; n < count; ++n) head += "<th>from " + decimal(360 * n / count, 0) + "&deg;</th>";
    for (const double distance_m : sweep.rings.distances_m) {
        rows += "<tr><th>" + metre_text(distance_m) + "</th>";
        for (double n = 0; n < count; ++n) {
            Viewpoint wanted;
            wanted.height_m = height_m, wanted.distance_m = distance_m, wanted.bearing_deg = 360 * n / count;
            rows += sweep_cell(sweep, wanted);
        }
        rows += "</tr>\n";
    }
    return "<div class='wide-table ring'><table><thead>" + head + "</tr></thead><tbody>" + rows + "</tbody></table></div>\n";
}

std::string standing_out_section(const Sweep& sweep) {
    std::string html;
    for (const StandingOut& one : sweep.standing_out) {
        const SweptView& view = sweep.views[one.index];
        const std::string spoken = one.title + ": " + viewpoint_words(view.viewpoint);
        html += "<article class='moment'><h3>" + escaped_html(spoken) + "</h3><p class='soft'>" + escaped_html(view.file) +
                ", clutter " + clutter_text(view.measures.clutter) + "; " + escaped_html(opinions_words(one.opinions)) +
                ". The place: " + escaped_html(place_words(view)) + ".</p><div class='views three'>" +
                html_figure(one.picture_png, "picture", spoken) +
                html_figure(one.heat_png, "saliency over the picture", "its saliency as heat over the picture") +
                html_figure(one.edges_png, "edges", "its edges") + "</div>" + layer_bar(view.measures.layers, "") +
                "</article>\n";
    }
    return html_section("What stands out", layer_key(sweep.views.front().measures.layers, false) + html);
}

std::string sweep_facts(const Sweep& sweep) {
    const SweptView& least = sweep.views[least_cluttered(sweep.views)];
    const SweptView& most = sweep.views[most_cluttered(sweep.views)];
    const auto seen = std::count_if(sweep.views.begin(), sweep.views.end(),
                                    [](const SweptView& view) { return view.sight == PlaceSight::seen; });
    return "<div class='facts'>" +
           html_fact(clutter_text(most.measures.clutter), "most clutter, " + viewpoint_words(most.viewpoint)) +
           html_fact(clutter_text(least.measures.clutter), "least clutter, " + viewpoint_words(least.viewpoint)) +
           html_fact(std::to_string(seen) + " of " + std::to_string(sweep.views.size()),
                     "viewpoints from which the place is seen") +
           html_fact(std::to_string(sweep.skipped.size()),
                     "viewpoints skipped: below the ground, outside the terrain, or too steep") +
           "</div>\n";
}

std::string header_of(const Sweep& sweep) {
    return "<header><h1>Viewpoints round " + decimal(base::degrees(sweep.place.latitude_rad), 4) + ", " +
           decimal(base::degrees(sweep.place.longitude_rad), 4) + "</h1><p>" +
           escaped_html("At " + metre_text(sweep.place_msl_m) + " above sea level, " + metre_text(sweep.radius_m) +
                        " round it. Terrain: " + sweep.terrain +
                        (sweep.scene.empty() ? std::string() : ", scene: " + sweep.scene) + ", design: " + sweep.design +
                        ", device: " + sweep.device + (sweep.interrupted ? "; interrupted, the rest is missing" : "")) +
           ".</p></header>\n";
}

}  // namespace

std::string sweep_report_page(const Sweep& sweep) {
    std::string page =
        "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
        "content='width=device-width,initial-scale=1'><title>Sweep of viewpoints</title><style>" +
        std::string(kReportStyle) + kSweepStyle + "</style></head><body>\n" + header_of(sweep) + sweep_facts(sweep) + "<main>\n" +
        standing_out_section(sweep);
    for (const double height_m : sweep.rings.heights_m)
        page += html_section("From " + metre_text(height_m) + " above the place", ring_table(sweep, height_m));
    return page +
           "</main>\n<footer><p>Below each picture its clutter, the share of pixels that are edges, which the ground's colour "
           "follows; and how many times the picture's mean saliency lies on the place (Itti-CIO2, without the symbology, which "
           "stands before every place in the middle). Bearings are from the place "
           "to "
           "the viewpoint, true.</p><p>TEDAVIS " +
           escaped_html(version()) + ". A simulation; not certified for use in flight.</p></footer></body></html>\n";
}

}  // namespace tedavis::host_sim
