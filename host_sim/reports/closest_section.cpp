#include "host_sim/reports/closest_section.hpp"

#include <cmath>

#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/phase_color.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

std::string metres_and_feet(double metres) {
    return decimal(metres / base::kMetresPerFoot, 0) + " ft (" + decimal(metres, 0) + " m";
}

std::string closest_uncertainty_text(const ClearanceUncertainty& uncertainty) {
    const std::optional<double> both_m = uncertainty.height_above_terrain_m();
    if (both_m) return " ± " + decimal(*both_m, 0) + " m, 95 %";
    if (!uncertainty.terrain_m) return ", uncertainty not stated";
    return "; terrain ± " + decimal(*uncertainty.terrain_m, 0) + " m, the own height's accuracy is not stated";
}

std::string place_text(const earth::Geodetic& place) {
    const double latitude = base::degrees(place.latitude_rad), longitude = base::degrees(place.longitude_rad);
    return decimal(std::fabs(latitude), 4) + (latitude < 0 ? " S " : " N ") + decimal(std::fabs(longitude), 4) +
           (longitude < 0 ? " W" : " E");
}

std::string phase_words(flight::FlightPhase phase) {
    const std::string sub = flight::sub_phase_name(phase);
    return flight::scenario_name(phase) + (sub.empty() ? sub : "." + sub);
}

std::string alert_words(policy::TerrainAhead alert) {
    if (alert == policy::TerrainAhead::none) return "the display showed no terrain alert";
    return std::string("the display showed a terrain ") + alert_level_text(alert);
}

std::string closest_row(std::size_t number, const StatedClosest& closest) {
    const TrackSample& sample = closest.point.sample;
    const GroundPlace& ground = closest.point.nearest;
    const std::string frame =
        "frame " + std::to_string(closest.frame.frame) + ", " + decimal(closest.frame.time_s - closest.time_s, 1) + " s";
    const std::string picture =
        closest.frame.picture.empty() ? frame : "<a href='" + escaped_html(closest.frame.picture) + "'>" + frame + "</a>";
    const auto cell = [](const std::string& text) { return "<td class='n'>" + text + "</td>"; };
    return "<tr>" + cell(std::to_string(number)) + cell(escaped_html(when_text(closest))) + cell(place_text(sample.own.place)) +
           cell(decimal(sample.own.height_msl_m, 0)) +
           cell(escaped_html(decimal(sample.height_above_terrain_m, 0) + closest_uncertainty_text(sample.uncertainty))) +
           cell(decimal(ground.distance_m, 0)) + cell(decimal(base::degrees(ground.bearing_rad), 0)) +
           cell(decimal(base::degrees(ground.elevation_rad), 0)) + "<td>" + phase_words(sample.phase) + "</td><td>" +
           alert_level_text(closest.frame.alert) + "</td><td>" + picture + "</td></tr>";
}

std::string closest_table(const std::string& title, const std::vector<StatedClosest>& closest) {
    if (closest.empty()) return {};
    std::string rows;
    for (std::size_t n = 0; n < closest.size(); ++n) rows += closest_row(n + 1, closest[n]);
    return "<p>" + title +
           "</p><div class='wide'><table><thead><tr><th>no.</th><th>time</th><th>place</th><th>altitude m</th>"
           "<th>above terrain m</th><th>nearest ground m</th><th>bearing °</th><th>elevation °</th><th>phase</th><th>alert</th>"
           "<th>picture</th></tr></thead><tbody>" +
           rows + "</tbody></table></div>";
}

/// Where samples are far apart in time, the curves have a gap.
void add_to_profile(const TrackSample& sample, LineChart& chart) {
    chart.times_s.push_back(sample.along_m / 1000);
    const double ground_m = sample.own.height_msl_m - sample.height_above_terrain_m;
    const double own_half_m = sample.uncertainty.height_m.value_or(std::nan("")),
                 ground_half_m = sample.uncertainty.terrain_m.value_or(std::nan(""));
    chart.curves[0].values.push_back(sample.own.height_msl_m);
    chart.curves[1].values.push_back(ground_m);
    chart.bands[0].low.push_back(sample.own.height_msl_m - own_half_m);
    chart.bands[0].high.push_back(sample.own.height_msl_m + own_half_m);
    chart.bands[1].low.push_back(ground_m - ground_half_m);
    chart.bands[1].high.push_back(ground_m + ground_half_m);
}

void add_phase_to_profile(const TrackSample& sample, LineChart& chart) {
    const double along_km = sample.along_m / 1000;
    const std::string phase = phase_words(sample.phase);
    if (!chart.spans.empty()) chart.spans.back().end = along_km;
    if (chart.spans.empty() || chart.spans.back().label != phase)
        chart.spans.push_back({along_km, along_km, phase, phase_color(phase)});
}

std::string profile_svg(const ClosestReport& report) {
    LineChart chart{"Profile along the track", "m", {}, {{"own ship", "#3a78c2", {}}, {"terrain", "#9a6b3f", {}}}, {}};
    chart.description = "altitude of the own ship and height of the terrain below it, with their uncertainty (95 %)";
    chart.x_unit = "km";
    chart.width = 960;
    chart.height = 320;
    chart.bands = {{"#3a78c2", {}, {}}, {"#9a6b3f", {}, {}}};
    for (const TrackSample& sample : report.track) {
        add_to_profile(sample, chart);
        add_phase_to_profile(sample, chart);
    }
    for (std::size_t n = 0; n < report.by_height.size(); ++n) {
        const StatedClosest& closest = report.by_height[n];
        chart.marks.push_back(
            {closest.point.sample.along_m / 1000, closest.point.sample.own.height_msl_m, std::to_string(n + 1), "#closest",
             when_text(closest) + ": " + decimal(closest.point.sample.height_above_terrain_m, 0) + " m above the terrain"});
    }
    return line_chart_svg(chart);
}

}  // namespace

std::string closest_sentence(const ClosestReport& report) {
    if (report.by_height.empty())
        return "No closest point: the run has no part in flight over known terrain in which the height above it has a minimum.";
    const StatedClosest& closest = report.by_height.front();
    const TrackSample& sample = closest.point.sample;
    std::string text = "It came within " + metres_and_feet(sample.height_above_terrain_m) +
                       closest_uncertainty_text(sample.uncertainty) + ") of the ground below at " + when_text(closest) + " at " +
                       place_text(sample.own.place) + ", in " + phase_words(sample.phase) + "; " +
                       alert_words(closest.frame.alert) + ".";
    if (report.by_distance.empty()) return text;
    const StatedClosest& nearest = report.by_distance.front();
    const GroundPlace& ground = nearest.point.nearest;
    return text + " The nearest ground in any direction was " + metres_and_feet(ground.distance_m) + ") away, at bearing " +
           decimal(base::degrees(ground.bearing_rad), 0) + "°, at " + when_text(nearest) + ".";
}

std::string closest_html(const ClosestReport& report) {
    if (!report.is_searched) return {};
    std::string html = "<p id='closest'>" + escaped_html(closest_sentence(report)) + "</p>";
    html += closest_table("By height above the terrain below:", report.by_height);
    html += closest_table("By distance to the nearest ground in any direction:", report.by_distance);
    html += "<p>Points are minima at least 30 s apart, from positions at most " + decimal(report.sample_step_s, 2) +
            " s apart and between them. Take-off and landing are left out (" + decimal(report.left_out_s, 0) +
            " s): the phase ground, and 30 s before and after it. Without a position or known ground: " +
            decimal(std::fmax(report.unknown_s, 0), 0) + " s. Alerts are those of the frame next in time.</p>";
    return html + (report.track.empty() ? std::string() : profile_svg(report));
}

}  // namespace tedavis::host_sim
