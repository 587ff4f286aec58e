#include "host_sim/replay/run_recorder.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "host_sim/atomic_file.hpp"
#include "host_sim/heap_trap/heap_trap.hpp"
#include "host_sim/replay/drawn_layers.hpp"
#include "host_sim/replay/log_facts.hpp"
#include "host_sim/reports/height_findings.hpp"
#include "host_sim/reports/html_report.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/user_error.hpp"
#include "platform/clock/monotonic_clock.hpp"

namespace tedavis::host_sim {
namespace {

using flight::Signal;

constexpr std::uint32_t kClosestWidth = 640;

double milliseconds_between(base::Time a, base::Time b) { return (b - a).to_seconds() * 1000; }

/// "000123.png", as frame_picture_path names them, and "000123.layers.png".
bool is_frame_picture(const std::filesystem::path& file) {
    const bool has_kind = file.stem().extension() == ".layers";
    const std::string stem = has_kind ? file.stem().stem().string() : file.stem().string();
    return file.extension() == ".png" && stem.size() >= 6 && stem.find_first_not_of("0123456789") == std::string::npos;
}

/// A shorter run must not end in pictures of a longer one before it.
void remove_frame_pictures(const std::string& folder) {
    std::error_code error;
    std::vector<std::filesystem::path> old;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (is_frame_picture(entry.path())) old.push_back(entry.path());
    for (const auto& file : old) std::filesystem::remove(file, error);
}

std::string denied_text(const gl::DeniedReport& denied, const std::string& device) {
    const gl::DeniedCall& first = denied.first[0];
    return "device " + device + ": " + std::to_string(denied.total) + " GL calls outside its table, the first kind gl" +
           gl::describe(first.call).name + ": " + first.reason + "; its pictures are not what the device would show";
}

const std::string& made_folder(const ReplayOptions& options) {
    if (options.layers && options.frame_output() != FrameOutput::png)
        throw UserError("--layers: lie beside the pictures of a run; leave --frames out, or say --frames png");
    const std::string frames = options.output + "/" + kFramesFolder;
    make_folder(options.output);
    remove_frame_pictures(frames);
    if (options.frame_output() == FrameOutput::png) make_folder(frames);
    return options.output;
}

}  // namespace

RunRecorder::RunRecorder(const ReplayOptions& options, DisplaySession& session, FlightPlayer& player)
    : options_(options),
      session_(session),
      player_(player),
      records_(made_folder(options), player.first()),
      story_(player.first()),
      tally_(player.first()),
      closest_(player.first()),
      scene_extent_(extent_of_scene(options.picture.scene)),
      scene_times_(times_of_scene(options.picture.scene)) {
    if (const terrain::TerrainDatabase* const database = session.display().planner().terrain_database(); database != nullptr)
        clearance_ = std::make_unique<ClearanceMeter>(*database);
}

const FrameResult& RunRecorder::draw(base::Time time) {
    input_ = player_.at(time);
    draw_watched(time);
    result_.record = session_.display().record();
    result_.has_layers = options_.layers;
    if (options_.layers) result_.obstacles = obstacles_of_frame(session_);
    result_.latency_ms = milliseconds_between(player_.newest_frame(), time);
    result_.hash = options_.frame_output() == FrameOutput::none ? 0 : session_.frame_hash();
    if (overlay_) overlaid_ = overlay_(session_, result_);
    return result_;
}

void RunRecorder::draw_watched(base::Time time) {
    HeapTrap trap;
    const base::Time start = platform::monotonic_now();
    session_.display().plan({input_.state, input_.phase, time, input_.trail, legend_ ? legend_ : input_.legend});
    const base::Time planned = platform::monotonic_now();
    session_.draw();
    const base::Time drawn = platform::monotonic_now();
    trap.close();
    heap_allocations_ += trap.counts().ours;
    result_.timing = {milliseconds_between(start, planned), milliseconds_between(planned, drawn),
                      milliseconds_between(start, drawn)};
}

void RunRecorder::keep() {
    if (clearance_) result_.clearance = clearance_->measure(input_.state, result_.record.time, result_.record.heading_rad);
    records_.write(result_);
    total_ms_.push_back(result_.timing.total_ms);
    deadline_.add(result_);
    const double above = input_.state[Signal::height_above_terrain].value_or(std::numeric_limits<double>::quiet_NaN());
    tally_.add(result_.record, above);
    effects_.add(result_.record);
    closest_.add(result_.record, options_.frame_output() == FrameOutput::png,
                 closest_.wants_picture(result_.record.time) ? encode_small_png(view_of(shrunk(shown(), kClosestWidth))) : "");
    if (story_.add(result_, above, input_.state[Signal::ground_speed].value_or(0))) story_.add_picture(result_, shown());
    legends_.note(std::string(session_.display().planned().shown->name.view()), result_, input_);
    if (options_.frame_output() == FrameOutput::png)
        pictures_.add(frame_picture_path(options_.output, result_.record.frame), shown());
    if (video_ != nullptr) video_->add(shown());
    if (options_.layers) write_drawn_layers(frame_picture_path(options_.output, result_.record.frame), session_);
}

int RunRecorder::finish(bool interrupted, Console& console) {
    pictures_.finish();
    records_.commit();
    RunSummary done = summary(interrupted);
    const base::BudgetTable memory = session_.display().planner().budget();  // of the run, without the legends' pictures
    legends_.draw(session_, story_);
    if (clearance_ && !interrupted) done.closest = closest_.find(player_, *clearance_);
    done.closest.assumes_heights = assumes_heights(options_.log);
    write_run_reports(options_.output, done, story_, memory, session_.display().planner().terrain_database());
    if (video_ != nullptr && video_->pictures() > 0) video_->commit();  // last: a disk that it fills leaves the records
    char line[200];
    std::snprintf(line, sizeof line, ": %s%s, %.1f frames/s median, ", counted(done.frames, "frame").c_str(),
                  interrupted ? " (interrupted)" : "", done.fps_median);
    if (!done.notes.empty())
        console.note("note: " + std::to_string(done.notes.size()) + (done.notes.size() == 1 ? " note" : " notes") +
                     " in summary.json, the first: " + done.notes.front());
    const gl::DeniedReport& denied = session_.display().gl().denied();
    if (denied.total > 0) console.note(denied_text(denied, done.device));
    print_warnings(done.warnings, console);
    console.result(options_.output + line + error_text(done) + start_error_text(done) + deadline_text(done.deadline),
                   run_summary_json(done, memory));
    if (interrupted) return kInterruptedExitCode;
    if (!session_.terrain_fault().empty()) return kFaultyInputExitCode;
    return denied.total > 0 ? kCheckFailedExitCode : exit_code_of(done.warnings, options_.strict);
}

RunSummary RunRecorder::summary(bool interrupted) {
    RunSummary s;
    s.frames = records_.written();
    const FrameTimes times = frame_times(total_ms_);
    s.fps_median = times.median_ms > 0 ? 1000 / times.median_ms : 0;
    s.ms_p99 = times.p99_ms;
    s.terrain_frames = tally_.frames_with_terrain();
    s.frames_over_void = tally_.frames_over_void();
    s.worst_error_px = tally_.worst_error_px();
    s.worst_start_error_px = tally_.worst_start_error_px();
    s.terrain_alerts = tally_.terrain_alerts();
    s.heap_allocations_after_start = heap_allocations_;
    s.gl_calls_outside_device = session_.display().gl().denied().total;
    s.device = options_.picture.device;
    s.design = options_.picture.design;
    s.aircraft = options_.picture.aircraft;
    s.palette = options_.picture.palette;
    s.light = design::kSymbologyLightNames[static_cast<std::size_t>(options_.picture.light)];
    s.terrain = options_.picture.terrain;
    s.scene = options_.picture.scene;
    s.log = options_.log;
    s.ghosts = options_.picture.ghosts.flights;
    s.switches = options_.switches;
    if (video_ != nullptr && video_->pictures() > 0) s.video = options_.video;
    s.width = session_.width();
    s.height = session_.height();
    s.costs = options_.picture.costs;
    s.deadline = deadline_.summary();
    s.effects = effects_.counts();
    s.has_accuracy_overlay = overlay_ != nullptr;
    s.gl = session_.gl_description();
    const LogFacts& log = player_.facts();
    s.can = {log.counters.frames,  log.counters.decoded, log.counters.alien, log.counters.errors,
             log.counters.dropped, log.broken_lines,     log.lines.other,    log.counters.traffic};
    s.warnings = player_.findings();
    append(s.warnings, tally_.findings(s.terrain, session_.display().planner().terrain_database()));
    if (const terrain::TerrainDatabase* const database = session_.display().planner().terrain_database(); database != nullptr)
        append(s.warnings, height_findings(s.terrain, height_counts(database->header())));
    append(s.warnings, scene_findings(s.scene, scene_extent_, tally_.extent()));
    if (story_.utc().is_known) append(s.warnings, time_findings(s.scene, scene_times_, story_.utc().begin, story_.utc().end));
    s.interrupted = interrupted;
    if (const std::string fault = session_.terrain_fault(); !fault.empty()) s.notes.push_back(fault);
    if (options_.picture.deadline_ms && options_.picture.costs.empty())
        s.notes.emplace_back("--deadline: no costs are known, so nothing is reduced; measure them with 'tedavis calibrate'");
    if (legends_.frames_left_out() > 0)
        s.notes.push_back(counted(legends_.frames_left_out(), "frame") +
                          " of further designs: report.html shows the legends of " + std::to_string(LegendPictures::kMaxDesigns) +
                          " designs only");
    const std::vector<std::string> lines = player_.notes();
    s.notes.insert(s.notes.end(), lines.begin(), lines.end());
    s.notes.insert(s.notes.end(), notes_.begin(), notes_.end());
    return s;
}

}  // namespace tedavis::host_sim
