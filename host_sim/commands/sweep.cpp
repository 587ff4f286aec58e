#include "host_sim/commands/sweep.hpp"

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/own_ground.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/sweep/sweep_json.hpp"
#include "host_sim/sweep/sweep_report.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr char kSweepName[] = "sweep.json";

SweepJob sweep_job(const SweepOptions& options) {
    SweepJob job;
    job.picture = options.picture;
    job.picture.legend = flight::LegendShow::whole;
    job.place = options.place;
    job.radius_m = options.radius_m;
    job.rings = options.rings;
    if (!options.phase.empty())
        job.phase = flight::stated_phase(flight::phase_from_name(options.phase).phase, flight::PhaseSource::switches);
    job.time = options.time.value_or(kPosedTime);
    job.layers = options.layers;
    job.folder = options.output;
    return job;
}

/// Called before missing inputs are built in a temporary folder.
void name_ground(SweepJob& job) {
    const bool is_shipped = job.picture.terrain.empty();
    job.terrain_name = is_shipped ? "the shipped terrain" : job.picture.terrain;
    job.scene_name = is_shipped && job.picture.scene.empty() ? "that of the shipped scenario" : job.picture.scene;
}

std::string sweep_summary(const Sweep& sweep, const std::string& output) {
    const auto count = [](std::size_t n, const char* thing) { return std::to_string(n) + " " + thing + (n == 1 ? "" : "s"); };
    return output + ": " + count(sweep.views.size(), "viewpoint") + (sweep.interrupted ? " (interrupted)" : "") +
           (sweep.skipped.empty() ? std::string() : ", " + std::to_string(sweep.skipped.size()) + " skipped");
}

void add_skipped_note(const Sweep& sweep, Console& console) {
    for (const SkippedViewpoint& skipped : sweep.skipped)
        console.note("note: " + skipped.viewpoint.name + " is skipped: " + skipped.reason);
}

}  // namespace

int run_sweep(const SweepOptions& options, Console& console) {
    require_no_run(options.output);
    if (options.picture.saliency || options.picture.clutter)
        throw UserError("--saliency, --clutter: would lie over the pictures that are measured; leave them out");
    const TemporaryFolder temporary;
    SweepJob job = sweep_job(options);
    name_ground(job);
    use_own_ground(job.picture, temporary.path(), console);
    const InterruptGuard interrupt;
    job.is_stopped = [&] { return interrupt.requested(); };
    NewFolder folder(options.output);
    WrittenFiles files;
    std::string fault;
    const Sweep sweep = draw_sweep(job, files, console, fault);
    const nlohmann::ordered_json json = sweep_json(sweep);
    write_file_atomically(options.output + "/" + kSweepName, json_text(json) + "\n");
    write_file_atomically(options.output + "/" + kReportName, sweep_report_page(sweep));
    files.keep();
    folder.keep();
    add_skipped_note(sweep, console);
    console.result(sweep_summary(sweep, options.output) + sweep_text(sweep) + "\n" + options.output + "/" + kReportName,
                   json_text(json));
    if (sweep.interrupted) return kInterruptedExitCode;
    if (fault.empty()) return 0;
    console.note("note: " + fault);
    return kFaultyInputExitCode;
}

}  // namespace tedavis::host_sim
