#include "host_sim/commands/convert.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "host_sim/atomic_file.hpp"
#include "host_sim/flight_log/flight_log_writer.hpp"
#include "host_sim/importers/fix_cleaner.hpp"
#include "host_sim/importers/flight_importer.hpp"
#include "host_sim/importers/resampled_flight.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/user_error.hpp"
#include "host_sim/version.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kLowestQnh_hpa = 870.0, kHighestQnh_hpa = 1085.0;  // the extremes ever measured at sea level
constexpr std::uint64_t kProgressSteps = 1000;

void check_options(const ConvertOptions& options) {
    if (options.qnh_hpa && !(*options.qnh_hpa >= kLowestQnh_hpa && *options.qnh_hpa <= kHighestQnh_hpa)) {
        throw UserError("--qnh " + std::to_string(*options.qnh_hpa) +
                        ": a QNH lies within 870..1085 hPa; give it in hectopascals");
    }
}

/// To the microsecond: nanoseconds since 1970 do not fit a double, and would show it in the last digits.
double seconds_of(base::Time time) { return static_cast<double>(time.ns / 1000) / 1e6; }  // NOLINT(bugprone-integer-division)

Json cleaning_json(const CleaningCounts& counts) {
    return {{"out_of_order", counts.out_of_order},
            {"duplicates", counts.duplicates},
            {"position_jumps", counts.position_jumps},
            {"gnss_height_jumps", counts.gnss_height_jumps},
            {"pressure_altitude_jumps", counts.pressure_jumps}};
}

Json derivation_json(const Derivation& d) {
    return {{"position", d.position},
            {"height", d.height},
            {"height_is_geometric", d.height_is_geometric},
            {"velocity", d.velocity},
            {"vertical_speed", d.vertical_speed},
            {"heading", d.heading},
            {"roll", d.roll},
            {"pitch", d.pitch},
            {"fixes", d.fixes},
            {"segments", d.segments},
            {"gap_limit_s", d.gap_limit_s},
            {"longest_gap_s", d.longest_gap_s},
            {"largest_height_smoothing_m", d.largest_height_smoothing_m},
            {"velocities_not_believed", d.velocities_not_believed}};
}

Json report(const ConvertOptions& options, const ImportedFile& file, const RecordedFlight& flight, const CleaningCounts& cleaning,
            const ResampledFlight& resampled, const FlightLogCounts& counts) {
    Json json = {{"source", options.flight},
                 {"format", file.format},
                 {"aircraft", flight.aircraft},
                 {"callsign", flight.callsign},
                 {"log", options.output},
                 {"begin_s", seconds_of(resampled.begin())},
                 {"end_s", seconds_of(resampled.end())},
                 {"frames", counts.frames},
                 {"silent_s", static_cast<double>(counts.silent_ms) / 1e3},
                 {"interrupted", counts.interrupted},
                 {"rejected", cleaning_json(cleaning)},
                 {"derived", derivation_json(resampled.derivation())},
                 {"notes", file.notes},
                 {"version", version()}};
    json["qnh_hpa"] = options.qnh_hpa ? Json(*options.qnh_hpa) : Json(nullptr);
    json["gnss_datum"] = flight.gnss_datum == HeightDatum::msl_egm96 ? "msl_egm96" : "wgs84_ellipsoid";
    json["assume_geometric"] = options.assume_geometric;
    return json;
}

std::vector<std::string> what_was_done(const ImportedFile& file, const CleaningCounts& cleaning, const Derivation& d,
                                       const ConvertOptions& options) {
    std::vector<std::string> said = file.notes;
    const std::size_t rejected =
        cleaning.duplicates + cleaning.position_jumps + cleaning.gnss_height_jumps + cleaning.pressure_jumps;
    if (rejected > 0) {
        said.push_back("rejected as impossible: " + std::to_string(cleaning.position_jumps) + " positions, " +
                       std::to_string(cleaning.gnss_height_jumps) + " GNSS heights, " + std::to_string(cleaning.pressure_jumps) +
                       " pressure altitudes, " + std::to_string(cleaning.duplicates) + " duplicates");
    }
    if (d.segments > 1) {
        said.push_back("the recording has gaps (the longest " + std::to_string(static_cast<int>(d.longest_gap_s)) +
                       " s); nothing is sent there");
    }
    if (d.velocities_not_believed > 0) {
        said.push_back("speed: of " + std::to_string(d.velocities_not_believed) + " of " + std::to_string(d.fixes) +
                       " fixes the recorded speed contradicts the recorded positions, and the speed is that of the positions");
    }
    said.push_back("height: " + d.height);
    said.push_back("heading " + d.heading + "; bank " + d.roll + "; pitch " + d.pitch);
    if (!d.height_is_geometric && !options.qnh_hpa) {
        said.emplace_back(
            "terrain will be shown as degraded and flagged; give --qnh HPA, or --assume-geometric to take the altitude as it is");
    }
    return said;
}

}  // namespace

int run_convert(const ConvertOptions& options, Console& console) {
    std::vector<std::string> said;
    const int code = run_convert(options, console, said);
    if (code == kInterruptedExitCode) console.note("note: interrupted; the log is valid and ends early");
    return code;
}

int run_convert(const ConvertOptions& options, Console& console, std::vector<std::string>& said) {
    check_options(options);
    require_other_file(options.output, {options.flight});
    require_replaceable_log(options.output);
    require_replaceable(options.output + ".json", "{\n  \"source\": ", "report of a conversion");
    ImportedFile file = import_flight_file(options.flight);
    const ImportedFile about{file.format, {}, file.notes};
    RecordedFlight flight = choose_aircraft(std::move(file), options.aircraft, options.flight);
    const CleaningCounts cleaning = clean_fixes(flight);
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    ResampleSettings settings;
    if (options.qnh_hpa) settings.qnh_pa = *options.qnh_hpa * base::kPascalsPerHectopascal;
    settings.assume_geometric = options.assume_geometric;
    const ResampledFlight resampled(flight, settings, geoid, options.flight);

    const InterruptGuard interrupt;
    require_uninterrupted(options.output);  // so that no log of a millisecond takes the place of an earlier one
    AtomicFile log(options.output), companion(options.output + ".json");
    FlightLogSettings log_settings;
    log_settings.name = options.output;
    const FlightLogCounts counts = write_flight_log(resampled, log_settings, log.stream(), [&](double share) {
        console.progress("writing " + options.output, static_cast<std::uint64_t>(share * kProgressSteps), kProgressSteps);
        return !interrupt.requested();
    });
    console.progress_done();
    const Json json = report(options, about, flight, cleaning, resampled, counts);
    companion.stream() << json_text(json, 2) << '\n';
    for (AtomicFile* written : {&log, &companion}) written->seal();
    for (AtomicFile* written : {&log, &companion}) written->commit();
    for (std::string& done : what_was_done(about, cleaning, resampled.derivation(), options)) {
        console.note("note: " + done);
        said.push_back(std::move(done));
    }
    console.result(options.output + ": " + std::to_string(counts.frames) + " frames of " + about.format + " flight" +
                       (flight.aircraft.empty() ? "" : " " + flight.aircraft),
                   json_text(json));
    return counts.interrupted ? kInterruptedExitCode : 0;
}

}  // namespace tedavis::host_sim
