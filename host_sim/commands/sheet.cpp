#include "host_sim/commands/sheet.hpp"

#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/own_ground.hpp"
#include "host_sim/commands/sheet_plan.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/layer_mask.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/replay/drawn_layers.hpp"
#include "host_sim/replay/posed_frame.hpp"
#include "host_sim/reports/contact_sheet.hpp"
#include "host_sim/reports/sheet_page.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

/// What a command draws a sheet with.
struct SheetJob {
    std::string path;  ///< of the sheet's file
    SheetPlan plan;
    PictureOptions picture;
    AircraftPose pose;
    base::Time time;
    bool has_generated_image = false;
};

/// The addition to a title about the design's image, so that the picture is not misunderstood.
std::string words_about_image(const FrameResult& result, bool is_generated) {
    for (const display::EffectRecord& effect : result.record.effects) {
        if (effect.name.view() != "drape") continue;
        if (effect.state == display::EffectState::run) return is_generated ? " (generated)" : "";
        const std::string_view reason = effect.reason.view();
        return " (" + std::string(reason.substr(0, reason.find(';'))) + ")";
    }
    return "";
}

/// A sheet of nothing but the outside of a database shows no technique at all.
void require_view_within(const SheetJob& job, const FrameResult& result) {
    for (const display::Name& flag : result.record.flags)
        if (flag.view() == "terrain.outside_database")
            throw UserError(
                job.path + ": the pose lies outside the terrain " + job.picture.terrain +
                "; name a view of it with --pose lat,lon,alt_m,heading,pitch,roll ('tedavis terrain info' says what it covers)");
}

PictureOptions options_of(const SheetJob& job, const SheetPlan::Picture& picture) {
    PictureOptions options = job.picture;
    options.design = picture.design;
    options.detail = picture.detail;
    options.weights = picture.weights;
    options.foci = picture.foci;
    return options;
}

/// Every design is read before the first picture is drawn.
SheetJob read_job(const SheetOptions& options) {
    SheetJob job;
    job.path = resolve_config(options.sheet, "sheets");
    job.plan = read_sheet_plan(job.path);
    job.picture = options.picture;
    if (!job.picture.size) job.picture.size = job.plan.size;
    job.picture.symbology = job.plan.symbology;
    job.picture.legend = flight::LegendShow::whole;
    job.pose = options.pose.value_or(job.plan.pose);
    job.time = options.time.value_or(job.plan.time.value_or(kPosedTime));
    require_designs(job.plan, job.path);
    return job;
}

/// The sheet's own raster.
void build_terrain(SheetJob& job, const std::string& folder, Console& console) {
    job.picture.terrain = build_own_terrain({job.plan.terrain, job.plan.generated_image}, folder, console);
    job.has_generated_image = job.plan.generated_image;
}

/// The sheet's own scene.
void build_scene(SheetJob& job, const std::string& folder, Console& console) {
    if (!job.plan.scenario.empty())
        job.picture.scene = build_own_scenario(job.plan.scenario, folder, console);
    else if (!job.plan.scene.empty())
        job.picture.scene = build_own_scene(job.plan.scene, folder, console);
}

/// A view of its own is of the sheet's own terrain.
AircraftPose pose_of(const SheetJob& job, const SheetOptions& options, const SheetPlan::Picture& planned) {
    AircraftPose pose = options.pose ? job.pose : job.plan.pose_of(planned);
    if (options.time || pose.time.ns == kPosedTime.ns) pose.time = job.time;
    return pose;
}

RgbaPicture picture_of(PictureOptions options, ShownAspects shown, const AircraftPose& pose) {
    options.shown = shown;
    DisplaySession session(options, false);
    static_cast<void>(posed_frame(session, pose, {}));
    return upright(session.pixels());
}

AspectMeasures measures_of(const PictureOptions& options, const AircraftPose& pose) {
    const RgbaPicture terrain = picture_of(options, ShownAspects::terrain, pose),
                      data = picture_of(options, ShownAspects::ground_data, pose),
                      bare = picture_of(options, ShownAspects::nothing, pose);
    return {edge_density(view_of(terrain)), distinct_colors(view_of(data), view_of(bare), design::TerrainStyle().plain), 0};
}

/// Draws one picture into `drawn`; a sentence where a part of the terrain failed.
std::string draw_picture(const SheetJob& job, const AircraftPose& pose, const SheetPlan::Picture& planned,
                         DrawnSheet::Picture& drawn, bool layers, std::string& gl) {
    if (job.plan.measures_aspects) drawn.measures = measures_of(options_of(job, planned), pose);
    DisplaySession session(options_of(job, planned), false);
    drawn.title = planned.title;
    drawn.design = planned.design;
    drawn.file = planned.file;
    drawn.result = posed_frame(session, pose, {});
    require_view_within(job, drawn.result);
    drawn.pixels = upright(session.pixels());
    if (layers) drawn.layers = drawn_layers(session);
    drawn.title += words_about_image(drawn.result, job.has_generated_image);
    if (drawn.measures) drawn.measures->glyphs = session.display().planned().counters.glyphs;
    gl = session.gl_description();
    return session.terrain_fault();
}

/// `fault`: the first sentence about failed terrain.
DrawnSheet draw_sheet(const SheetJob& job, const SheetOptions& options, Console& console, std::string& fault) {
    const InterruptGuard interrupt;
    DrawnSheet sheet;
    sheet.title = job.plan.title;
    sheet.device = job.picture.device;
    sheet.pose = job.pose;
    sheet.columns = job.plan.columns;
    std::size_t done = 0;
    for (const SheetPlan::Group& group : job.plan.groups) {
        sheet.groups.push_back({group.title, {}});
        for (const SheetPlan::Picture& picture : group.pictures) {
            const std::string failed = draw_picture(job, pose_of(job, options, picture), picture,
                                                    sheet.groups.back().pictures.emplace_back(), options.layers, sheet.gl);
            if (fault.empty()) fault = failed;
            console.progress("pictures", ++done, job.plan.picture_count());
            if (interrupt.requested()) throw Interrupted("interrupted; nothing was written");
        }
    }
    console.progress_done();
    return sheet;
}

}  // namespace

void write_sheet(const DrawnSheet& sheet, const std::string& output) {
    NewFolder folder(output);
    for (const DrawnSheet::Group& group : sheet.groups)
        for (const DrawnSheet::Picture& picture : group.pictures) {
            write_png(output + "/" + picture.file, view_of(picture.pixels));
            if (!picture.layers.empty())
                write_layer_mask(output + "/" + picture.file,
                                 {picture.layers.data(), picture.pixels.width, picture.pixels.height});
        }
    write_png(output + "/" + kSheetPictureName, view_of(draw_contact_sheet(sheet)));
    write_file_atomically(output + "/" + kSheetPageName, sheet_page(sheet));
    write_file_atomically(output + "/" + kSheetJsonName, sheet_json(sheet) + "\n");
    folder.keep();
}

int run_sheet(const SheetOptions& options, Console& console) {
    SheetJob job = read_job(options);
    const std::string terrain =
        options.picture.terrain.empty() ? std::filesystem::path(job.plan.terrain).filename().string() : options.picture.terrain;
    const TemporaryFolder temporary;
    if (options.picture.terrain.empty()) build_terrain(job, temporary.path(), console);
    const bool is_own_ground = options.picture.terrain.empty() && options.picture.scene.empty();
    if (is_own_ground) build_scene(job, temporary.path(), console);
    std::string fault;
    DrawnSheet sheet = draw_sheet(job, options, console, fault);
    sheet.name = options.sheet;
    sheet.terrain = terrain;
    write_sheet(sheet, options.output);
    console.result(options.output + ": " + std::to_string(job.plan.picture_count()) + " pictures of " + terrain +
                       ", all of them on " + kSheetPictureName + " and " + kSheetPageName,
                   sheet_json(sheet));
    if (fault.empty()) return 0;
    console.note("note: " + fault);
    return kFaultyInputExitCode;
}

}  // namespace tedavis::host_sim
