#include "host_sim/accuracy/picture_section.hpp"

#include <cstdio>

#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/reports/base64.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

std::string embedded(const ReportPicture& picture, const std::string& spoken, const char* css) {
    return "<img class='" + std::string(css) + "' alt='" + escaped_html(spoken) + "' src='data:image/png;base64," +
           base64(picture.png) + "'>";
}

/// Left of the slider the cheap picture, right of it the exact one.
std::string slider(const KnobPictures& pictures) {
    return "<figure class='pair'><div class='stack'>" + embedded(pictures.exact, pictures.exact_level, "under") +
           embedded(pictures.cheap, pictures.cheap_level, "over") +
           "</div><input type='range' min='0' max='100' value='50' aria-label='where the cheap picture ends' "
           "oninput=\"this.previousElementSibling.style.setProperty('--end',this.value+'%')\"><figcaption>" +
           escaped_html("left: " + pictures.cheap_level + "; right: " + pictures.exact_level) + "</figcaption></figure>\n";
}

std::string map_caption(const char* format, double mean, double greatest) {
    char text[200];
    std::snprintf(text, sizeof text, format, mean, greatest);
    return text;
}

}  // namespace

const char* picture_style() {
    return ".pair .stack{position:relative;--end:50%}.pair .over{position:absolute;inset:0;clip-path:inset(0 calc(100% - "
           "var(--end)) 0 0)}"
           ".pair "
           "input{width:100%}.maps{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,15rem),1fr));gap:.6rem}"
           ".maps img,.crops img{image-rendering:pixelated}.crops{display:flex;flex-wrap:wrap;gap:.6rem}.crops "
           "figure{max-width:15rem}";
}

std::string picture_section(const KnobPictures& pictures) {
    const PictureErrors& errors = pictures.errors;
    const std::string where = "pixel " + std::to_string(pictures.place.x) + ", " + std::to_string(pictures.place.y);
    return "<h3>From cheap to exact</h3>\n" + slider(pictures) + "<div class='maps'>" +
           html_figure(pictures.color_map.png,
                       map_caption("Difference of colour, CIEDE2000: mean %.3g, at most %.3g; yellow is 20 and more",
                                   errors.color_mean, errors.color_max),
                       "map of the difference of colours") +
           html_figure(pictures.perceived_map.png,
                       map_caption("Difference that a viewer notices, FLIP: mean %.3g, at most %.3g; yellow is 1",
                                   errors.perceived_mean, errors.perceived_max),
                       "map of the perceived difference") +
           html_figure(pictures.metric_map.png, map_caption("Error, yellow is %.3g: ", pictures.metric_max, 0) + pictures.metric,
                       "map of the setting's own error") +
           "</div>\n<div class='crops'>" +
           html_figure(pictures.cheap_crop.png, pictures.cheap_level + ", " + where, "cheap, enlarged") +
           html_figure(pictures.exact_crop.png, pictures.exact_level + ", " + where, "exact, enlarged") +
           "</div>\n<p class='soft'>" +
           escaped_html("The place of the greatest error of " + pictures.cheap_level + ": " + pictures.place.pose +
                        ". Again: " + pictures.place.command) +
           "</p>\n";
}

}  // namespace tedavis::host_sim
