#include "host_sim/commands/trace_sheet.hpp"

#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/own_ground.hpp"
#include "host_sim/commands/trace.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/reports/contact_sheet.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/tracing/trace_sheet_page.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr PictureSize kUsualSize{640, 480};

void write_trace_sheet(const TraceSheet& sheet, const TracedGround& ground, const std::string& output) {
    NewFolder folder(output);
    for (const TraceSheet::Group& group : sheet.groups)
        for (const TraceSheet::Picture& picture : group.pictures)
            write_png(output + "/" + picture.file, view_of(picture.shot.pixels));
    write_png(output + "/" + kSheetPictureName, view_of(draw_contact_sheet(labelled_sheet(sheet, ground))));
    write_file_atomically(output + "/" + kSheetPageName, trace_sheet_page(sheet, ground));
    write_file_atomically(output + "/" + kSheetJsonName, trace_sheet_json(sheet, ground) + "\n");
    folder.keep();
}

}  // namespace

int run_trace_sheet(const SheetOptions& options, Console& console) {
    if (options.layers || !options.picture.scene.empty())
        throw UserError("sheet trace: draws the terrain alone; leave --layers and --scene out");
    const TemporaryFolder temporary;
    const std::unique_ptr<base::Workers> workers = trace_workers(0);
    const std::string& named = options.picture.terrain;
    const TracedGround ground(database_of({named, ""}, temporary.path(), console), *workers);
    TraceSheet sheet = plan_trace_sheet();
    sheet.terrain = named.empty() ? std::filesystem::path(kOwnRaster).filename().string() : named;
    sheet.pose = options.pose.value_or(usual_pose(ground));
    sheet.workers = workers->concurrency();
    const PictureSize size = options.picture.size.value_or(kUsualSize);
    TracedShotPlan plan;
    plan.pose = sheet.pose;
    plan.time = options.time;
    plan.width = size.width;
    plan.height = size.height;
    const InterruptGuard interrupt;
    draw_trace_sheet(sheet, ground, plan, *workers, [&](std::size_t done, std::size_t all) {
        console.progress("pictures", done, all);
        if (interrupt.requested()) throw Interrupted("interrupted; nothing was written");
    });
    console.progress_done();
    write_trace_sheet(sheet, ground, options.output);
    std::string text = options.output + ": ";
    for (const TraceSheet::Group& group : sheet.groups) text += (&group == &sheet.groups.front() ? "" : ", ") + group.title;
    console.result(text + " of " + sheet.terrain + ", all of them on " + kSheetPictureName + " and " + kSheetPageName,
                   trace_sheet_json(sheet, ground));
    return 0;
}

}  // namespace tedavis::host_sim
