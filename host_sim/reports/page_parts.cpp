#include "host_sim/reports/page_parts.hpp"

#include "host_sim/reports/base64.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kRunPageStyle =
    ":root{color-scheme:light dark}"
    "body{font:16px/1.45 system-ui,sans-serif;max-width:70rem;margin:0 auto;padding:1rem}"
    "h1{font-size:1.4rem;margin:.2rem 0}h2{font-size:1.1rem;margin:1.4rem 0 .4rem;border-bottom:1px solid #8886}"
    ".strip{display:grid;grid-template-columns:repeat(auto-fill,minmax(9rem,1fr));gap:.5rem}"
    ".large{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,30rem),1fr));gap:.8rem}"
    "figure{margin:0}figure img{width:100%;height:auto;display:block;border:1px solid #8886}"
    "figcaption{font-size:.75rem;overflow-wrap:anywhere}"
    ".charts{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,22rem),1fr));gap:.5rem}"
    ".chart{width:100%;height:auto}.chart text{font:11px system-ui,sans-serif;fill:currentColor}"
    ".chart .span{font-size:9px;fill:#111}"
    ".grid{stroke:#8886;stroke-width:.5}"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-size:.85rem}"
    "th,td{text-align:left;padding:.2rem .6rem .2rem 0;border-bottom:1px solid #8884;vertical-align:top}"
    "td.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}"
    "td.whole{white-space:nowrap}"
    "@media(max-width:40rem){table{font-size:.75rem}th,td{padding-right:.35rem}}"
    ".key{display:inline-block;width:.8rem;height:.8rem;margin-right:.3rem;vertical-align:-.05rem}"
    ".bad{color:#c22;font-weight:600}li,p{overflow-wrap:anywhere}td{overflow-wrap:break-word}"
    ".map{max-height:40rem}.map-text{fill:#111!important}.map-halo{stroke:#fff;stroke-width:3px;fill:#fff!important}"
    ".mark line{stroke:#b3261e}.mark .place{fill:#b3261e}.mark .label{fill:#fff;stroke:#b3261e;stroke-width:1.5}"
    ".mark text{fill:#111!important;font-weight:600}"
    "details>summary{cursor:pointer;font-weight:600;margin:1.2rem 0 .4rem}"
    "@media print{@page{size:A4;margin:12mm}body{max-width:none;padding:0;font-size:10px}details{display:none}"
    // A section may be longer than a page: what must not be broken are its parts, and a heading stays with what follows it.
    "h2,h3{break-after:avoid}figure,svg,.wide,.charts>div,tr,p,li{break-inside:avoid}.wide{overflow:visible}h2{margin:.6rem 0 "
    ".2rem;font-size:12px}table{font-size:9px}"
    "th,td{padding:.05rem .5rem .05rem 0}.map{max-height:8cm}.charts{grid-template-columns:repeat(3,1fr)}"
    ".large{grid-template-columns:repeat(4,1fr)}"
    ".strip{grid-template-columns:repeat(8,1fr);gap:.2rem}.strip figure:not(.printed){display:none}figcaption{font-size:7px}}";

}  // namespace

std::string html_page(const std::string& title, const std::string& body, const std::string& more_style) {
    return "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
           "content='width=device-width,initial-scale=1'><title>" +
           escaped_html(title) + "</title><style>" + kRunPageStyle + more_style + "</style></head><body>\n" + body +
           "</body></html>\n";
}

std::string page_section(const std::string& title, const std::string& content) {
    return "<section><h2>" + title + "</h2>" + content + "</section>\n";
}

std::string page_table(const std::string& head, const std::string& rows) {
    return "<div class='wide'><table><thead><tr>" + head + "</tr></thead><tbody>" + rows + "</tbody></table></div>";
}

std::string text_cell(const std::string& text) { return "<td>" + escaped_html(text) + "</td>"; }

std::string number_cell(const std::string& html) { return "<td class='n'>" + html + "</td>"; }

std::string page_figure(const std::string& caption, const std::string& png, const std::string& kind) {
    return "<figure" + (kind.empty() ? kind : " class='" + kind + "'") + "><img alt='" + escaped_html(caption) +
           "' src='data:image/png;base64," + base64(png) + "'><figcaption>" + escaped_html(caption) + "</figcaption></figure>\n";
}

std::string folded_part(const std::string& title, const std::string& content) {
    return "<details><summary>" + title + "</summary>" + content + "</details>\n";
}

}  // namespace tedavis::host_sim
