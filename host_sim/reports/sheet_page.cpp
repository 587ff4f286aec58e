#include "host_sim/reports/sheet_page.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "host_sim/json_text.hpp"
#include "host_sim/reports/base64.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/version.hpp"
#include "render_core/display/planner/picture_layer.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kStyle =
    ":root{color-scheme:light dark}"
    "body{font:16px/1.45 system-ui,sans-serif;max-width:110rem;margin:0 auto;padding:1rem}"
    "h1{font-size:1.4rem;margin:.2rem 0}h2{font-size:1.1rem;margin:1.4rem 0 .4rem;border-bottom:1px solid #8886}"
    ".sheet{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,20rem),1fr));gap:1rem}"
    "figure{margin:0;break-inside:avoid}figure img{width:100%;height:auto;display:block;border:1px solid #8886}"
    "figcaption{font-size:.85rem;overflow-wrap:anywhere}figcaption b{display:block;font-size:1rem}"
    ".bad{color:#c22;font-weight:600}"
    "@media print{body{max-width:none;font-size:11px}.sheet{grid-template-columns:repeat(3,1fr)}}";

/// "ambient occlusion: replaced by shade (reason)": the replacement in a picture for what its design requests.
std::string effect_lines(const FrameResult& result) {
    std::string lines;
    for (const display::EffectRecord& effect : result.record.effects) {
        if (effect.state != display::EffectState::replaced) continue;
        lines += "<div>" + escaped_html(std::string(effect.name.view())) + " replaced by " +
                 escaped_html(std::string(effect.replaced_by.view())) + ": " + escaped_html(std::string(effect.reason.view())) +
                 "</div>";
    }
    return lines;
}

/// What is wrong with the terrain; that an aircraft which only stands there lacks a speed is no news.
std::string flag_line(const FrameResult& result) {
    std::string names;
    for (const display::Name& flag : result.record.flags)
        if (flag.view().substr(0, 8) == "terrain.") names += (names.empty() ? "" : ", ") + std::string(flag.view());
    return names.empty() ? names : "<div class='bad'>" + escaped_html(names) + "</div>";
}

std::string measure_line(const DrawnSheet::Picture& picture) {
    if (!picture.measures) return "";
    const AspectMeasures& of = *picture.measures;
    return "<div>edges on " + decimal(100 * of.edge_density, 1) + " % of the pixels of its terrain, " +
           std::to_string(of.data_colors) + " colours of data, " + std::to_string(of.glyphs) + " glyphs</div>";
}

std::string caption_line(const DrawnSheet::Picture& picture) {
    return picture.caption.empty() ? "" : "<div>" + escaped_html(picture.caption) + "</div>";
}

std::string figure(const DrawnSheet::Picture& picture) {
    const std::string title = escaped_html(picture.title);
    return "<figure id='" + escaped_html(picture.file.substr(0, picture.file.rfind('.'))) + "'><img alt='" + title +
           "' src='data:image/png;base64," + base64(encode_png(view_of(picture.pixels))) + "'><figcaption><b>" + title + "</b>" +
           caption_line(picture) + escaped_html(picture.design) + ", " + std::to_string(picture.result.record.terrain.triangles) +
           " triangles" + flag_line(picture.result) + measure_line(picture) + effect_lines(picture.result) +
           "</figcaption></figure>\n";
}

std::string degrees_of(double angle_deg, char above_zero, char below_zero) {
    return decimal(std::abs(angle_deg), 4) + "&deg; " + (angle_deg < 0 ? below_zero : above_zero);
}

std::string view_in_words(const DrawnSheet& sheet) {
    const std::string device = " Device " + escaped_html(sheet.device) + ", " + escaped_html(sheet.gl) + ".";
    if (!sheet.pose) return "Terrain " + escaped_html(sheet.terrain) + ", seen along a flight." + device;
    const AircraftPose& p = *sheet.pose;
    return "Terrain " + escaped_html(sheet.terrain) + ", seen from " + degrees_of(p.latitude_deg, 'N', 'S') + " " +
           degrees_of(p.longitude_deg, 'E', 'W') + ", " + decimal(p.altitude_msl_m, 0) + " m above mean sea level, heading " +
           decimal(p.heading_deg, 0) + "&deg;, pitch " + decimal(p.pitch_deg, 0) + "&deg;, roll " + decimal(p.roll_deg, 0) +
           "&deg;." + device;
}

Json sheet_pose_json(const AircraftPose& pose) {
    return {{"lat_deg", pose.latitude_deg},    {"lon_deg", pose.longitude_deg}, {"alt_msl_m", pose.altitude_msl_m},
            {"heading_deg", pose.heading_deg}, {"pitch_deg", pose.pitch_deg},   {"roll_deg", pose.roll_deg}};
}

Json picture_json(const DrawnSheet::Picture& picture, const std::string& group) {
    const Json record = Json::parse(frame_record_json(picture.result, picture.result.record.time));
    Json json = {{"group", group},
                 {"title", picture.title},
                 {"design", picture.design},
                 {"file", picture.file},
                 {"hash", record.at("hash")},
                 {"triangles", record.at("terrain").at("triangles")},
                 {"data", record.at("data")},
                 {"flags", record.at("flags")},
                 {"effects", record.at("effects")},
                 {"weights", record.at("presentation").at("weights")}};
    if (!picture.caption.empty()) json["caption"] = picture.caption;
    if (picture.flight_s) json["flight_s"] = *picture.flight_s;
    if (picture.measures)
        json["measures"] = {{"edge_density", picture.measures->edge_density},
                            {"data_colors", picture.measures->data_colors},
                            {"glyphs", picture.measures->glyphs}};
    return json;
}

bool has_layers(const DrawnSheet& sheet) {
    return !sheet.groups.empty() && !sheet.groups[0].pictures.empty() && !sheet.groups[0].pictures[0].layers.empty();
}

}  // namespace

std::string sheet_page(const DrawnSheet& sheet) {
    const std::string title = escaped_html(sheet.title);
    std::string page =
        "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
        "content='width=device-width,initial-scale=1'><title>" +
        title + "</title><style>" + kStyle + "</style></head><body>\n<header><h1>" + title + "</h1><p>" + view_in_words(sheet) +
        " Version " + version() + ". A simulation; not certified for use in flight.</p></header>\n";
    for (const DrawnSheet::Group& group : sheet.groups) {
        page += "<section><h2>" + escaped_html(group.title) + "</h2><div class='sheet'>\n";
        for (const DrawnSheet::Picture& picture : group.pictures) page += figure(picture);
        page += "</div></section>\n";
    }
    return page + "</body></html>\n";
}

std::string sheet_json(const DrawnSheet& sheet) {
    Json json = {{"sheet", sheet.name},          {"title", sheet.title},
                 {"terrain", sheet.terrain},     {"pose", sheet.pose ? sheet_pose_json(*sheet.pose) : Json()},
                 {"device", sheet.device},       {"gl", sheet.gl},
                 {"picture", kSheetPictureName}, {"page", kSheetPageName},
                 {"pictures", Json::array()}};
    if (has_layers(sheet)) json["layers"] = display::kPictureLayerNames;
    for (const DrawnSheet::Group& group : sheet.groups)
        for (const DrawnSheet::Picture& picture : group.pictures) json["pictures"].push_back(picture_json(picture, group.title));
    return json_text(json);
}

}  // namespace tedavis::host_sim
