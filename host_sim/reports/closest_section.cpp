#include "host_sim/reports/closest_section.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/page_parts.hpp"
#include "host_sim/reports/phase_color.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

std::string whole_feet(double metres) { return decimal(metres / base::kMetresPerFoot, 0); }

std::string feet_and_metres(double metres) { return whole_feet(metres) + " ft (" + decimal(metres, 0) + " m)"; }

std::string closest_uncertainty_text(const ClearanceUncertainty& uncertainty) {
    const std::optional<double> both_m = uncertainty.height_above_terrain_m();
    if (both_m) return ", ± " + whole_feet(*both_m) + " ft (95 %),";
    if (!uncertainty.terrain_m) return ", of unstated uncertainty,";
    return ", ± " + whole_feet(*uncertainty.terrain_m) +
           " ft (95 %) by the terrain alone, for the own height's accuracy is not stated,";
}

/// Half the 95 % range of the height above the terrain, in feet.
std::string uncertainty_cell(const ClearanceUncertainty& uncertainty) {
    const std::optional<double> both_m = uncertainty.height_above_terrain_m();
    if (both_m) return "± " + whole_feet(*both_m);
    return uncertainty.terrain_m ? "± " + whole_feet(*uncertainty.terrain_m) + " (terrain alone)" : "not stated";
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

/// What a height above the terrain rests on where it is no height of GNSS, up to "it".
std::string height_words(const ClosestReport& report, const TrackSample& sample) {
    if (!sample.own.is_geometric) return "By pressure altitude alone, which is no height above sea level, i";
    return report.assumes_heights ? "By pressure altitude, taken for a height above sea level (--assume-geometric), i" : "I";
}

std::string alert_words(policy::TerrainAhead alert) {
    if (alert == policy::TerrainAhead::none) return "the display showed no terrain alert";
    return std::string("the display showed a terrain ") + alert_level_text(alert);
}

std::string closest_row(const std::string& number, const StatedClosest& closest) {
    const TrackSample& sample = closest.point.sample;
    const GroundPlace& ground = closest.point.nearest;
    const std::string frame =
        "frame " + std::to_string(closest.frame.frame) + ", " + decimal(closest.frame.time_s - closest.time_s, 1) + " s";
    const std::string picture =
        closest.frame.picture.empty() ? frame : "<a href='" + escaped_html(closest.frame.picture) + "'>" + frame + "</a>";
    const auto cell = [](const std::string& text) { return "<td class='n'>" + text + "</td>"; };
    return "<tr>" + cell(number) + cell(escaped_html(when_text(closest))) + cell(whole_feet(sample.height_above_terrain_m)) +
           cell(whole_feet(ground.distance_m)) + cell(uncertainty_cell(sample.uncertainty)) + cell(place_text(sample.own.place)) +
           cell(whole_feet(sample.own.height_msl_m)) + cell(decimal(base::degrees(ground.bearing_rad), 0)) +
           cell(decimal(base::degrees(ground.elevation_rad), 0)) + "<td>" + phase_words(sample.phase) + "</td><td>" +
           alert_level_text(closest.frame.alert) + "</td><td class='whole'>" + picture + "</td></tr>";
}

/// `first`: the number of the first row, 1 or a.
std::string closest_table(const std::string& title, const std::vector<StatedClosest>& closest, char first) {
    if (closest.empty()) return {};
    std::string rows;
    for (std::size_t n = 0; n < closest.size(); ++n)
        rows += closest_row(std::string(1, static_cast<char>(first + static_cast<char>(n))), closest[n]);
    return "<p>" + title +
           "</p><div class='wide'><table><thead><tr><th>no.</th><th>time</th><th>above terrain ft</th>"
           "<th>nearest ground ft</th><th>95 % range ft</th><th>place</th><th>altitude ft</th><th>bearing °</th><th>elevation "
           "°</th><th>phase</th><th>alert</th>"
           "<th>picture</th></tr></thead><tbody>" +
           rows + "</tbody></table></div>";
}

/// Of the frames that were drawn for closest points, each once.
std::string closest_pictures(const ClosestReport& report) {
    std::string figures;
    std::vector<std::uint64_t> shown;
    const auto add = [&](const StatedClosest& closest, const std::string& what) {
        const FrameBeside& frame = closest.frame;
        if (frame.small_png.empty() || std::count(shown.begin(), shown.end(), frame.frame) > 0) return;
        shown.push_back(frame.frame);
        figures += page_figure("The display at " + when_text(closest) + ": " + what + ", frame " + std::to_string(frame.frame),
                               frame.small_png);
    };
    for (const StatedClosest& closest : report.by_height)
        add(closest, whole_feet(closest.point.sample.height_above_terrain_m) + " ft above the terrain");
    for (const StatedClosest& closest : report.by_distance)
        add(closest, whole_feet(closest.point.nearest.distance_m) + " ft from the nearest ground");
    return figures.empty() ? figures : "<div class='large'>" + figures + "</div>";
}

/// Where samples are far apart in time, the curves have a gap.
void add_to_profile(const TrackSample& sample, LineChart& chart) {
    chart.times_s.push_back(sample.along_m / 1000);
    const auto feet = [](double metres) { return metres / base::kMetresPerFoot; };
    const double own_m = sample.own.height_msl_m, ground_m = own_m - sample.height_above_terrain_m;
    const double own_half_m = sample.uncertainty.height_m.value_or(std::nan("")),
                 ground_half_m = sample.uncertainty.terrain_m.value_or(std::nan(""));
    chart.curves[0].values.push_back(feet(own_m));
    chart.curves[1].values.push_back(feet(ground_m));
    chart.bands[0].low.push_back(feet(own_m - own_half_m));
    chart.bands[0].high.push_back(feet(own_m + own_half_m));
    chart.bands[1].low.push_back(feet(ground_m - ground_half_m));
    chart.bands[1].high.push_back(feet(ground_m + ground_half_m));
}

void add_phase_to_profile(const TrackSample& sample, LineChart& chart) {
    const double along_km = sample.along_m / 1000;
    const std::string phase = phase_words(sample.phase);
    if (!chart.spans.empty()) chart.spans.back().end = along_km;
    if (chart.spans.empty() || chart.spans.back().label != phase)
        chart.spans.push_back({along_km, along_km, phase, phase_color(phase)});
}

std::string profile_svg(const ClosestReport& report) {
    LineChart chart{"Profile along the track", "ft", {}, {{"own ship", "#3a78c2", {}}, {"terrain", "#9a6b3f", {}}}, {}};
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
            {closest.point.sample.along_m / 1000, closest.point.sample.own.height_msl_m / base::kMetresPerFoot,
             std::to_string(n + 1), "#closest",
             when_text(closest) + ": " + whole_feet(closest.point.sample.height_above_terrain_m) + " ft above the terrain"});
    }
    return line_chart_svg(chart);
}

}  // namespace

std::string closest_sentence(const ClosestReport& report) {
    if (report.by_height.empty())
        return "No closest point: the run has no part in flight over known terrain in which the height above it has a minimum.";
    const StatedClosest& closest = report.by_height.front();
    const TrackSample& sample = closest.point.sample;
    std::string text = height_words(report, sample) + "t came within " + feet_and_metres(sample.height_above_terrain_m) +
                       closest_uncertainty_text(sample.uncertainty) + " of the ground below at " + when_text(closest) + " at " +
                       place_text(sample.own.place) + ", in " + phase_words(sample.phase) + "; " +
                       alert_words(closest.frame.alert) + ".";
    if (report.by_distance.empty()) return text;
    const StatedClosest& nearest = report.by_distance.front();
    const GroundPlace& ground = nearest.point.nearest;
    return text + " The nearest ground in any direction was " + feet_and_metres(ground.distance_m) + " away, at bearing " +
           decimal(base::degrees(ground.bearing_rad), 0) + "°, at " + when_text(nearest) + ".";
}

std::string closest_html(const ClosestReport& report) {
    if (!report.is_searched) return {};
    std::string html = "<p id='closest'>" + escaped_html(closest_sentence(report)) + "</p>";
    html += closest_pictures(report);
    html += closest_table("By height above the terrain below:", report.by_height, '1');
    html += closest_table("By distance to the nearest ground in any direction:", report.by_distance, 'a');
    html += "<p>Points are minima at least 30 s apart, from positions at most " + decimal(report.sample_step_s, 2) +
            " s apart and between them. Take-off and landing are left out (" + decimal(report.left_out_s, 0) +
            " s): the phase ground, and 30 s before and after it. Without a position or known ground: " +
            decimal(std::fmax(report.unknown_s, 0), 0) + " s. Alerts are those of the frame next in time.</p>";
    return html + (report.track.empty() ? std::string() : profile_svg(report));
}

}  // namespace tedavis::host_sim
