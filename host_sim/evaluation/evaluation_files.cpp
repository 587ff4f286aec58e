#include "host_sim/evaluation/evaluation_files.hpp"

#include "host_sim/evaluation/clutter_opinions.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/reports/contact_sheet.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint32_t kPageWidth = 512;  // of a view on the page

}  // namespace

ViewFiles view_files(const std::string& name) {
    return {name + ".saliency.png",   name + ".heat.png",           name + ".edges.png", name + ".regions.png",
            name + ".congestion.png", name + ".second_opinion.png", name + ".sheet.png"};
}

std::vector<std::string> all_view_files(const std::string& name) {
    const ViewFiles views = view_files(name);
    return {views.saliency, views.heat, views.edges, views.regions, views.congestion, views.second_opinion, views.sheet};
}

PictureViews picture_views(const RgbaPicture& picture, PictureMeter& meter, const PictureMeasures& measures,
                           const FloatMap& congestion, const EvaluationSettings& settings) {
    const FloatMap saliency = meter.saliency();
    return {saliency_picture(saliency),
            heat_picture(picture, saliency),
            edge_picture(meter.edges(), picture.width, picture.height),
            region_picture(picture, settings.grid, measures.clutter_grid),
            saliency_picture(congestion),
            saliency_picture(meter.second_opinion(picture))};
}

RgbaPicture views_sheet(const std::string& title, const RgbaPicture& picture, const PictureViews& views,
                        const PictureMeasures& measures) {
    DrawnSheet sheet;
    sheet.title = title;
    sheet.columns = 4;
    DrawnSheet::Group group{"Clutter " + clutter_text(measures.clutter), {}};
    const auto add = [&](const char* label, const std::string& words, const RgbaPicture& pixels) {
        DrawnSheet::Picture one;
        one.title = label;
        one.design = words;
        one.pixels = pixels;
        group.pictures.push_back(std::move(one));
    };
    add("picture", std::to_string(picture.width) + " x " + std::to_string(picture.height), picture);
    add("saliency", "bright draws the eye", views.saliency);
    add("saliency over the picture", "dark to light: the more, the lighter", views.heat);
    add("edges", percent_text(measures.clutter) + " of the pixels", views.edges);
    add("regions", "share of pixels that are edges", views.regions);
    add("congestion", measures.opinions ? opinions_words(*measures.opinions) : "Feature Congestion", views.congestion);
    add("second opinion on saliency", "spectral residual", views.second_opinion);
    sheet.groups.push_back(std::move(group));
    return draw_contact_sheet(sheet);
}

void write_views(const std::string& folder, const std::string& name, const std::string& title, const RgbaPicture& picture,
                 const PictureViews& views, const PictureMeasures& measures) {
    const ViewFiles files = view_files(folder + "/" + name);
    write_png(files.saliency, view_of(views.saliency));
    write_png(files.heat, view_of(views.heat));
    write_png(files.edges, view_of(views.edges));
    write_png(files.regions, view_of(views.regions));
    write_png(files.congestion, view_of(views.congestion));
    write_png(files.second_opinion, view_of(views.second_opinion));
    write_png(files.sheet, view_of(views_sheet(title, picture, views, measures)));
}

MomentViews small_views(const RgbaPicture& picture, const PictureViews& views) {
    const auto small = [](const RgbaPicture& view) { return encode_small_png(view_of(shrunk(view_of(view), kPageWidth))); };
    return {small(picture), small(views.saliency), small(views.heat), small(views.edges), small(views.congestion)};
}

}  // namespace tedavis::host_sim
