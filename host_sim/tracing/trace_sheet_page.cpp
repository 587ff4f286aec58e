#include "host_sim/tracing/trace_sheet_page.hpp"

#include "host_sim/json_text.hpp"
#include "host_sim/reports/base64.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/tracing/trace_report.hpp"
#include "host_sim/version.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kTitle = "The ray tracer's presets and operators";
constexpr const char* kPageStyle =
    ":root{color-scheme:light dark}"
    "body{font:16px/1.45 system-ui,sans-serif;max-width:110rem;margin:0 auto;padding:1rem}"
    "h1{font-size:1.4rem;margin:.2rem 0}h2{font-size:1.1rem;margin:1.4rem 0 .4rem;border-bottom:1px solid #8886}"
    "table{border-collapse:collapse}td,th{padding:.15rem .6rem;text-align:right;border-bottom:1px solid #8886}"
    "td:first-child,th:first-child,td:nth-child(2),th:nth-child(2){text-align:left}"
    ".sheet{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,20rem),1fr));gap:1rem}"
    "figure{margin:0;break-inside:avoid}figure img{width:100%;height:auto;display:block;border:1px solid #8886}"
    "figcaption{font-size:.85rem;overflow-wrap:anywhere}figcaption b{display:block;font-size:1rem}"
    "@media print{body{max-width:none;font-size:11px}.sheet{grid-template-columns:repeat(3,1fr)}}";

std::string costs(const TraceSheet::Picture& picture, const TracedGround& ground) {
    return decimal(picture.shot.picture_ms, 1) + " ms, " + megabytes(ground.bytes() + picture.shot.bytes()) + ", " +
           decimal(picture.from_quality.mean, 2) + " from quality";
}

std::string row(const TraceSheet::Picture& picture, const TracedGround& ground) {
    return "<tr><td>" + escaped_html(picture.title) + "</td><td>" + escaped_html(describe(picture.settings)) + "</td><td>" +
           decimal(picture.shot.picture_ms, 1) + "</td><td>" + decimal(picture.shot.build_ms, 1) + "</td><td>" +
           decimal(static_cast<double>(ground.bytes() + picture.shot.bytes()) * 1e-6, 1) + "</td><td>" +
           decimal(picture.from_quality.mean, 2) + "</td><td>" + decimal(picture.from_quality.largest, 1) + "</td></tr>\n";
}

std::string figure_of(const TraceSheet::Picture& picture, const TracedGround& ground) {
    const std::string title = escaped_html(picture.title);
    return "<figure><img alt='" + title + "' src='data:image/png;base64," +
           base64(encode_small_png(view_of(picture.shot.pixels))) + "'><figcaption><b>" + title + "</b>" +
           escaped_html(costs(picture, ground)) + "</figcaption></figure>\n";
}

}  // namespace

DrawnSheet labelled_sheet(const TraceSheet& sheet, const TracedGround& ground) {
    DrawnSheet drawn;
    drawn.title = kTitle;
    drawn.terrain = sheet.terrain;
    drawn.pose = sheet.pose;
    drawn.columns = 4;
    for (const TraceSheet::Group& group : sheet.groups) {
        drawn.groups.push_back({group.title, {}});
        for (const TraceSheet::Picture& picture : group.pictures) {
            DrawnSheet::Picture label;
            label.title = picture.title;
            label.design = costs(picture, ground);
            label.file = picture.file;
            label.pixels = picture.shot.pixels;
            drawn.groups.back().pictures.push_back(std::move(label));
        }
    }
    return drawn;
}

std::string trace_sheet_page(const TraceSheet& sheet, const TracedGround& ground) {
    std::string page =
        std::string(
            "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
            "content='width=device-width,initial-scale=1'><title>") +
        kTitle + "</title><style>" + kPageStyle + "</style></head><body>\n<header><h1>" + kTitle + "</h1><p>Terrain " +
        escaped_html(sheet.terrain) + ", " + std::to_string(ground.columns()) + " x " + std::to_string(ground.rows()) +
        " posts; " + std::to_string(sheet.workers) + " workers. Version " + version() +
        ". A simulation; not certified for use in flight.</p></header>\n"
        "<p>Errors are CIEDE2000, against the picture of the quality preset.</p>\n"
        "<table><tr><th></th><th>operators</th><th>picture, ms</th><th>preparing, ms</th><th>MB</th><th>mean error</th>"
        "<th>largest</th></tr>\n";
    for (const TraceSheet::Group& group : sheet.groups)
        for (const TraceSheet::Picture& picture : group.pictures) page += row(picture, ground);
    page += "</table>\n";
    for (const TraceSheet::Group& group : sheet.groups) {
        page += "<section><h2>" + escaped_html(group.title) + "</h2><div class='sheet'>\n";
        for (const TraceSheet::Picture& picture : group.pictures) page += figure_of(picture, ground);
        page += "</div></section>\n";
    }
    return page + "</body></html>\n";
}

std::string trace_sheet_json(const TraceSheet& sheet, const TracedGround& ground) {
    nlohmann::ordered_json json = {{"sheet", "trace"},
                                   {"title", kTitle},
                                   {"terrain", sheet.terrain},
                                   {"pose", pose_json(sheet.pose)},
                                   {"picture", kSheetPictureName},
                                   {"page", kSheetPageName},
                                   {"pictures", nlohmann::ordered_json::array()}};
    for (const TraceSheet::Group& group : sheet.groups)
        for (const TraceSheet::Picture& picture : group.pictures) {
            nlohmann::ordered_json one = {{"group", group.title}, {"title", picture.title}, {"file", picture.file}};
            one.update(shot_json(ground, describe(picture.settings), picture.shot, sheet.workers));
            one["error"] = {{"mean", picture.from_quality.mean},
                            {"largest", picture.from_quality.largest},
                            {"edges", picture.from_quality.edges}};
            json["pictures"].push_back(one);
        }
    return json_text(json);
}

}  // namespace tedavis::host_sim
