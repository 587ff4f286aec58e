#include "host_sim/commands/shot.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "host_sim/accuracy/accuracy_overlay.hpp"
#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/replay/drawn_layers.hpp"
#include "host_sim/replay/pose_findings.hpp"
#include "host_sim/replay/posed_frame.hpp"
#include "host_sim/replay/scene_findings.hpp"
#include "host_sim/reports/height_findings.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

std::string record_path(const std::string& picture) { return std::filesystem::path(picture).replace_extension(".json").string(); }

void require_png_name(const std::string& picture) {
    std::string extension = std::filesystem::path(picture).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!extension.empty() && extension != ".png")
        throw UserError("-o " + picture + ": the picture is a PNG; give it a name that ends in .png");
}

flight::PhaseStatus named_phase(const std::string& name) {
    if (name.empty()) return {};
    const flight::ParsedPhase phase = flight::phase_from_name(name);
    if (!phase.ok) throw UserError("--phase " + name + ": unknown; write for instance takeoff.first_climb or cruise");
    return flight::stated_phase(phase.phase, flight::PhaseSource::switches);
}

/// Requested foci come before those of the design.
void add_hidden_foci_note(const display::FrameRecord& record, std::size_t asked, Console& console) {
    for (std::size_t n = 0; n < std::min<std::size_t>(asked, record.foci.size()); ++n)
        if (!record.foci[n].is_shown)
            console.note("note: focus " + std::to_string(n + 1) +
                         " of --focus is nowhere: " + std::string(record.foci[n].reason.view()));
}

}  // namespace

int run_shot(const ShotOptions& options, Console& console) {
    require_png_name(options.output);
    require_replaceable(options.output, "\x89PNG\r\n\x1a\n", "PNG picture");
    require_replaceable(record_path(options.output), "{\"frame\":", "record of a picture");
    const flight::PhaseStatus phase = named_phase(options.phase);
    const AccuracyOverlay overlay({options.accuracy, true}, options.picture.terrain);
    DisplaySession session(options.picture, false);
    AircraftPose pose = options.pose;
    pose.time = options.time.value_or(kPosedTime);
    FrameResult result = posed_frame(session, pose, phase);
    result.has_layers = options.layers;
    if (options.layers) result.obstacles = obstacles_of_frame(session);
    result.warnings = pose_findings(pose, result.record, options.picture.terrain, session.display());
    append(*result.warnings, scene_findings(options.picture.scene, extent_of_scene(options.picture.scene),
                                            {pose.latitude_deg, pose.latitude_deg, pose.longitude_deg, pose.longitude_deg}));
    for (const display::StaleRecord& stale : result.record.stale)
        result.warnings->push_back(
            {"data.stale", "the layer " + std::string(stale.layer.view()) + " is stale, " + age_words(stale.age_s) + " old", 1});
    if (const terrain::TerrainDatabase* const database = session.display().planner().terrain_database(); database != nullptr)
        append(*result.warnings, height_findings(options.picture.terrain, height_counts(database->header())));
    const RgbaPicture picture = overlay.over(session, result);
    const std::string json = frame_record_json(result, pose.time);
    write_png(options.output, view_of(picture));
    if (options.layers) write_drawn_layers(options.output, session);
    write_file_atomically(record_path(options.output), json + "\n");
    print_warnings(*result.warnings, console);
    console.result(options.output + ": " + std::to_string(session.width()) + " x " + std::to_string(session.height()) +
                       " pixels, " + std::to_string(result.record.terrain.triangles) + " terrain triangles, hash " +
                       hash_text(result.hash),
                   json);
    add_hidden_foci_note(result.record, options.picture.foci.size(), console);
    const std::string fault = session.terrain_fault();
    if (fault.empty()) return exit_code_of(*result.warnings, options.strict);
    console.note("note: " + fault);
    return kFaultyInputExitCode;
}

}  // namespace tedavis::host_sim
