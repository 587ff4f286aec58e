#include "host_sim/commands/calibrate.hpp"

#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/calendar_time.hpp"
#include "host_sim/commands/own_ground.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/replay/desk_bench.hpp"
#include "host_sim/reports/calibration_file.hpp"
#include "host_sim/temporary_folder.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/utc_time.hpp"

namespace tedavis::host_sim {
namespace {

/// Over the own terrain, with data of every kind in view.
constexpr AircraftPose kPose{36.64, -84.36, 2100, 140, -14, 0};
constexpr const char* kTime = "2026-06-01T14:02:00Z";

struct PicturePlace {
    PictureOptions picture;
    AircraftPose pose;
};

/// Where the bench stands and what lies round it.
PicturePlace place_of(const CalibrateOptions& options, const std::string& folder, Console& console) {
    PicturePlace place{options.picture, options.pose.value_or(kPose)};
    if (!options.picture.terrain.empty() && !options.pose)
        throw UserError("--terrain: a terrain of your own needs a view of it; add --pose lat,lon,alt_m,heading,pitch,roll");
    base::Time time = kPosedTime;
    if (options.picture.terrain.empty()) static_cast<void>(base::parse_utc(kTime, time));
    use_own_ground(place.picture, folder, console);
    place.pose.time = options.time.value_or(time);
    return place;
}

std::string json_path(const std::string& output) { return std::filesystem::path(output).replace_extension(".json").string(); }

void require_toml_name(const std::string& output) {
    if (std::filesystem::path(output).extension() != ".toml")
        throw UserError("-o " + output + ": costs are a TOML file; give it a name that ends in .toml");
}

std::string told(const effects::MeasuredCosts& measured, const std::string& output) {
    std::string text = output + ": what everything costs on " + std::string(measured.subject.device.view()) + ", " +
                       std::string(measured.subject.renderer.view());
    for (const effects::MeasuredCost& cost : measured.costs) {
        char line[160];
        std::snprintf(line, sizeof line, "\n  %-14s %8.3f ms +- %.3f", cost.name.c_str(), cost.ms, cost.spread_ms);
        text += cost.note.empty() ? std::string(line)
                                  : "\n  " + std::string(cost.name.view()) + ": not measured, " + std::string(cost.note.view());
    }
    const effects::QualityLevels levels = effects::choose_levels(measured.candidates);
    for (std::size_t n = 0; n < levels.count; ++n) {
        const effects::QualityLevel& level = levels.at[n];
        char line[200];
        std::snprintf(line, sizeof line, "\n  level %zu %8.3f ms, terrain within %.2f px, picture differs by %.2f (CIEDE2000)", n,
                      level.ms, level.error_px, level.error_color);
        text += line;
    }
    return text;
}

}  // namespace

int run_calibrate(const CalibrateOptions& options, Console& console) {
    require_toml_name(options.output);
    static_cast<void>(DeskBench(options.picture, {}));  // wrong options are said at once
    AtomicFile toml(options.output), json(json_path(options.output));
    const TemporaryFolder temporary;
    const PicturePlace place = place_of(options, temporary.path(), console);
    const InterruptGuard interrupt;
    DeskBench bench(place.picture, {[&](std::size_t done, std::size_t total) { console.progress("costs", done, total); },
                                    [&] { return interrupt.requested(); }});
    effects::MeasuredCosts measured = bench.measure(place.pose, options.rounds);
    console.progress_done();
    const std::string date = utc_now();
    const std::string terrain =
        options.picture.terrain.empty() ? std::filesystem::path(kOwnRaster).filename().string() : options.picture.terrain;
    measured.date = std::string_view(date);
    measured.design = std::string_view(options.picture.design);
    measured.terrain = std::string_view(terrain);
    const auto text = std::make_unique<effects::CalibrationText>();
    write_calibration(measured, *text);
    toml.stream() << text->view();
    json.stream() << calibration_json(measured);
    toml.seal();
    json.seal();
    toml.commit();
    json.commit();
    console.result(told(measured, options.output), calibration_json(measured));
    return 0;
}

}  // namespace tedavis::host_sim
