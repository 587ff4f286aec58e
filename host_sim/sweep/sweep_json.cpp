#include "host_sim/sweep/sweep_json.hpp"

#include <cstdio>

#include "host_sim/evaluation/clutter_opinions.hpp"
#include "host_sim/evaluation/evaluation_files.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/reports/frame_record_json.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using SweepJson = nlohmann::ordered_json;

SweepJson viewpoint_json(const Viewpoint& viewpoint) {
    return {{"bearing_deg", viewpoint.bearing_deg}, {"distance_m", viewpoint.distance_m}, {"height_m", viewpoint.height_m}};
}

SweepJson pose_json(const AircraftPose& pose) {
    return {{"lat_deg", pose.latitude_deg},    {"lon_deg", pose.longitude_deg}, {"alt_msl_m", pose.altitude_msl_m},
            {"heading_deg", pose.heading_deg}, {"pitch_deg", pose.pitch_deg},   {"roll_deg", pose.roll_deg}};
}

SweepJson seen_place_json(const SweptView& view) {
    SweepJson json{{"sight", sight_name(view.sight)}};
    const bool is_inside = view.place.is_inside;
    const auto number = [&](const char* name, double value) { json[name] = is_inside ? SweepJson(value) : SweepJson(); };
    number("x_px", view.place.x_px);
    number("y_px", view.place.y_px);
    number("radius_px", view.place.radius_px);
    number("share", view.saliency.share);
    number("area", view.saliency.area);
    number("times_mean", view.saliency.times_mean());
    number("rank", view.saliency.rank);
    return json;
}

SweepJson view_json(const SweptView& view) {
    SweepJson json{{"file", view.file}};
    json.update(viewpoint_json(view.viewpoint));
    json["pose"] = pose_json(view.viewpoint.pose);
    json["hash"] = hash_text(view.hash);
    json["clutter"] = view.measures.clutter;
    json["saliency_level"] = view.measures.saliency_level;
    for (const LayerShare& layer : view.measures.layers) json["layer_shares"][layer.layer] = layer.share;
    json["place"] = seen_place_json(view);
    return json;
}

SweepJson standing_out_json(const Sweep& sweep, const StandingOut& one) {
    const SweptView& view = sweep.views[one.index];
    return {{"what", one.title},
            {"file", view.file},
            {"clutter", view.measures.clutter},
            {"feature_congestion", one.opinions.feature_congestion},
            {"subband_entropy", one.opinions.subband_entropy},
            {"sheet", view_files(view.viewpoint.name).sheet}};
}

std::string view_line(const SweptView& view) {
    char line[160];
    std::snprintf(line, sizeof line, "\n  %8.0f  %10.0f  %7.0f  %7.3f  %8.3f  ", view.viewpoint.height_m,
                  view.viewpoint.distance_m, view.viewpoint.bearing_deg, view.measures.clutter, view.measures.saliency_level);
    std::string text = line;
    if (view.place.is_inside) {
        std::snprintf(line, sizeof line, "%5.1f x  %3.0f %%  ", view.saliency.times_mean(), 100 * view.saliency.rank);
        text += line;
    } else {
        text += "      -      -  ";
    }
    return text + sight_name(view.sight);
}

}  // namespace

nlohmann::ordered_json sweep_json(const Sweep& sweep) {
    SweepJson json{{"place",
                    {{"lat_deg", base::degrees(sweep.place.latitude_rad)},
                     {"lon_deg", base::degrees(sweep.place.longitude_rad)},
                     {"alt_msl_m", sweep.place_msl_m},
                     {"radius_m", sweep.radius_m}}},
                   {"terrain", sweep.terrain},
                   {"scene", sweep.scene},
                   {"design", sweep.design},
                   {"device", sweep.device},
                   {"gl", sweep.gl},
                   {"interrupted", sweep.interrupted},
                   {"views", SweepJson::array()},
                   {"skipped", SweepJson::array()},
                   {"standing_out", SweepJson::array()}};
    for (const SweptView& view : sweep.views) json["views"].push_back(view_json(view));
    for (const SkippedViewpoint& skipped : sweep.skipped) {
        SweepJson one = viewpoint_json(skipped.viewpoint);
        one["reason"] = skipped.reason;
        json["skipped"].push_back(std::move(one));
    }
    for (const StandingOut& one : sweep.standing_out) json["standing_out"].push_back(standing_out_json(sweep, one));
    return json;
}

std::string sweep_text(const Sweep& sweep) {
    std::string text = "\n  height m  distance m  bearing  clutter  saliency    place   rank  sight";
    for (const SweptView& view : sweep.views) text += view_line(view);
    for (const StandingOut& one : sweep.standing_out) {
        const SweptView& view = sweep.views[one.index];
        text += "\n  " + one.title + ": " + view.file + ", clutter " + clutter_text(view.measures.clutter) + "; " +
                opinions_words(one.opinions);
    }
    return text;
}

}  // namespace tedavis::host_sim
