#include "host_sim/commands/gallery_sheet.hpp"

#include <filesystem>

#include "host_sim/commands/gallery_flight.hpp"
#include "host_sim/commands/own_ground.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/replay/drawn_layers.hpp"
#include "host_sim/reports/sheet_page.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr PictureSize kGalleryPictureSize{960, 540};
constexpr std::uint32_t kGalleryColumns = 4;

DrawnSheet gallery_without_pictures(const PictureOptions& picture, GalleryFlight& flight) {
    DrawnSheet sheet;
    sheet.name = kGallerySheetName;
    sheet.title = "The default flight (generated)";
    sheet.terrain = std::filesystem::path(kOwnRaster).filename().string();
    sheet.device = picture.device;
    sheet.gl = flight.session().gl_description();
    sheet.columns = kGalleryColumns;
    return sheet;
}

DrawnSheet draw_gallery(const SheetOptions& options, const GalleryFiles& files, std::string& fault, Console& console) {
    PictureOptions picture = options.picture;
    if (!picture.size) picture.size = kGalleryPictureSize;
    const InterruptGuard interrupt;
    GalleryFlight flight(files, picture);
    DrawnSheet sheet = gallery_without_pictures(picture, flight);
    std::size_t done = 0;
    for (const GalleryMoment& moment : gallery_moments()) {
        if (sheet.groups.empty() || sheet.groups.back().title != moment.group) sheet.groups.push_back({moment.group, {}});
        DrawnSheet::Picture& drawn = sheet.groups.back().pictures.emplace_back(flight.draw(moment));
        if (options.layers) drawn.layers = drawn_layers(flight.session());
        console.progress("pictures", ++done, gallery_moments().size());
        if (interrupt.requested()) throw Interrupted("interrupted; nothing was written");
    }
    console.progress_done();
    fault = flight.session().terrain_fault();
    return sheet;
}

}  // namespace

void require_default_flight(const SheetOptions& options, const std::string& sheet) {
    if (options.pose || options.time || !options.picture.scene.empty() || !options.picture.terrain.empty())
        throw UserError("sheet " + sheet +
                        ": shows the default flight over the shipped terrain; leave --pose, --time, --scene and --terrain out");
}

int run_gallery_sheet(const SheetOptions& options, Console& console) {
    require_default_flight(options, kGallerySheetName);
    const GalleryFiles files(console);
    std::string fault;
    const DrawnSheet sheet = draw_gallery(options, files, fault, console);
    write_sheet(sheet, options.output);
    console.result(options.output + ": " + std::to_string(gallery_moments().size()) + " pictures of the default flight over " +
                       sheet.terrain + ", all of them on " + kSheetPictureName + " and " + kSheetPageName,
                   sheet_json(sheet));
    if (fault.empty()) return 0;
    console.note("note: " + fault);
    return kFaultyInputExitCode;
}

}  // namespace tedavis::host_sim
