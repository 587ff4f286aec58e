#include "host_sim/commands/readme_sheet.hpp"

#include <nlohmann/json.hpp>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/gallery_flight.hpp"
#include "host_sim/commands/gallery_sheet.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/palette_picture.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

struct ReadmePicture {
    std::string file, bytes;
};

/// Appends the moments of one place, all of one size.
void draw_readme_pictures(const GalleryFiles& files, PictureOptions picture, ReadmePlace place, const PictureSize& size,
                          std::vector<ReadmePicture>& drawn) {
    const InterruptGuard interrupt;
    picture.size = size;
    GalleryFlight flight(files, picture);
    for (const GalleryMoment& moment : gallery_moments()) {
        if (moment.readme != place) continue;
        const DrawnSheet::Picture shown = flight.draw(moment);
        drawn.push_back({shown.file, encode_palette_png(with_palette(view_of(shown.pixels)))});
        if (interrupt.requested()) throw Interrupted("interrupted; nothing was written");
    }
    if (const std::string fault = flight.session().terrain_fault(); !fault.empty())
        throw UserError("sheet readme: " + fault + "; nothing was written");
}

}  // namespace

int run_readme_sheet(const SheetOptions& options, Console& console) {
    require_default_flight(options, kReadmeSheetName);
    if (options.layers || options.picture.size)
        throw UserError("sheet readme: has pictures of two stated sizes and no layers; leave --size and --layers out");
    const GalleryFiles files(console);
    std::vector<ReadmePicture> drawn;
    draw_readme_pictures(files, options.picture, ReadmePlace::large, kReadmeLargeSize, drawn);
    draw_readme_pictures(files, options.picture, ReadmePlace::row, kReadmeRowSize, drawn);
    NewFolder folder(options.output);
    nlohmann::ordered_json facts = {{"sheet", kReadmeSheetName}, {"pictures", nlohmann::ordered_json::array()}};
    for (const ReadmePicture& picture : drawn) {
        write_file_atomically(options.output + "/" + picture.file, picture.bytes);
        facts["pictures"].push_back({{"file", picture.file}, {"bytes", picture.bytes.size()}});
    }
    folder.keep();
    console.result(options.output + ": " + std::to_string(drawn.size()) + " pictures of the default flight for README.md",
                   facts.dump(1));
    return 0;
}

}  // namespace tedavis::host_sim
