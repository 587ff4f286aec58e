#include "host_sim/commands/display_sheet.hpp"

#include <nlohmann/json.hpp>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/own_ground.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/reports/callouts.hpp"
#include "host_sim/reports/display_parts.hpp"
#include "host_sim/reports/drawn_sheet.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/scenario/example_approach.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/version.hpp"
#include "render_core/display/preroll.hpp"
#include "render_core/draw/symbology/symbology.hpp"

namespace tedavis::host_sim {
namespace {

constexpr PictureSize kDisplaySheetSize{960, 540};
constexpr const char* kDisplaySheetPicture = "display.png";

/// The input of the symbology as the display has it for this frame.
draw::SymbologyInput symbology_of(const flight::FrameInput& frame, display::Display& display, const PictureSize& size) {
    return draw::make_symbology_input(frame.state, display.planned().decisions, frame.phase, *display.planned().shown, frame.time,
                                      size.width, size.height, display.record().altitude_msl_m);
}

std::vector<Callout> callouts_of(const flight::FrameInput& frame, display::Display& display, const PictureSize& size) {
    const draw::SymbologyInput input = symbology_of(frame, display, size);
    const draw::Layout layout =
        draw::make_layout(size.width, size.height, display.planned().shown->view.dpi, draw::legend_need(input));
    std::vector<Callout> callouts;
    for (const DisplayPart& part : display_parts()) callouts.push_back({std::string(part.name), part.place({input, layout})});
    return callouts;
}

std::string display_page() {
    std::string page =
        "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
        "content='width=device-width,initial-scale=1'><title>The parts of the display</title><style>body{font:16px/1.5 "
        "sans-serif;max-width:90rem;margin:0 "
        "auto;padding:1rem}img{width:100%;height:auto}td,th{text-align:left;vertical-align:top;"
        "padding:.2rem 1rem .2rem 0}</style></head><body>\n<h1>The parts of the display</h1>\n<p><img src='" +
        std::string(kDisplaySheetPicture) + "' alt='The display with its parts named'></p>\n<table>\n";
    for (const DisplayPart& part : display_parts())
        page += "<tr><th>" + escaped_html(std::string(part.name)) + "</th><td>" + escaped_html(std::string(part.shows)) +
                "</td></tr>\n";
    return page + "</table>\n<p>Version " + version() + ". A simulation; not certified for use in flight.</p></body></html>\n";
}

nlohmann::ordered_json sheet_facts(const std::string& terrain) {
    nlohmann::ordered_json json = {{"sheet", kDisplaySheetName}, {"terrain", terrain}, {"file", kDisplaySheetPicture}};
    for (const DisplayPart& part : display_parts()) json["parts"].push_back({{"name", part.name}, {"shows", part.shows}});
    return json;
}

}  // namespace

RgbaPicture named_display(const PictureOptions& options) {
    DisplaySession session(options, true);
    const flight::FrameInput frame = example_approach(session.display());
    display::settle(session.display(), frame);
    session.display().plan(frame);
    session.draw();
    return draw_callouts(upright(session.pixels()), callouts_of(frame, session.display(), {session.width(), session.height()}));
}

int run_display_sheet(const SheetOptions& options, Console& console) {
    if (options.layers || options.pose || options.time || !options.picture.scene.empty() || !options.picture.terrain.empty())
        throw UserError(
            "sheet display: shows one stated approach over the shipped terrain; leave --layers, --pose, --time, "
            "--scene and --terrain out");
    const TemporaryFolder temporary;
    PictureOptions picture = options.picture;
    picture.terrain = build_own_terrain({shipped_root() + kOwnRaster, false}, temporary.path(), console);
    if (!picture.size) picture.size = kDisplaySheetSize;
    if (picture.aircraft.empty()) picture.aircraft = "turboprop";
    const RgbaPicture named = named_display(picture);
    const std::string facts = sheet_facts(kOwnRaster).dump(1);
    require_uninterrupted(options.output);
    NewFolder folder(options.output);
    write_png(options.output + "/" + kDisplaySheetPicture, view_of(named));
    write_file_atomically(options.output + "/" + kSheetPageName, display_page());
    write_file_atomically(options.output + "/" + kSheetJsonName, facts + "\n");
    folder.keep();
    console.result(options.output + ": the display with " + std::to_string(display_parts().size()) + " parts named, on " +
                       kDisplaySheetPicture + " and " + kSheetPageName,
                   facts);
    return 0;
}

}  // namespace tedavis::host_sim
