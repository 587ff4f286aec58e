#include "host_sim/commands/terrain.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <utility>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/number_list.hpp"
#include "host_sim/reports/height_findings.hpp"
#include "host_sim/terrain_builder/file_sources.hpp"
#include "host_sim/terrain_builder/fractal_geotiff.hpp"
#include "host_sim/terrain_builder/raster_file.hpp"
#include "host_sim/terrain_builder/terrain_build.hpp"
#include "host_sim/terrain_builder/terrain_check.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMetresPerDegree = 111132;  // of latitude, mean

GeoBounds parse_bounds(const std::string& text) {
    const std::vector<double> n = parse_number_list(text, ',');
    const GeoBounds b = n.size() == 4 ? GeoBounds{n[0], n[1], n[2], n[3]} : GeoBounds();
    if (n.size() != 4 || !(b.south_deg >= -90 && b.south_deg < b.north_deg && b.north_deg <= 90) ||
        !(b.west_deg >= -360 && b.west_deg < b.east_deg && b.east_deg <= 360))
        throw UserError("--bounds " + text +
                        ": not W,S,E,N in degrees with W < E and S < N; write for instance 9.6,46.5,10.2,47.1");
    return b;
}

/// `option` is "--extent" or "--drape-extent", and `crs` the option beside it.
MapExtent parse_extent(const std::string& option, const std::string& crs, const std::string& text) {
    const std::vector<double> n = parse_number_list(text, ',');
    if (n.size() != 4 || !(n[0] < n[2]) || !(n[1] < n[3]))
        throw UserError(option + " " + text +
                        ": not W,S,E,N with W < E and S < N; write the outer edges of the raster, in degrees "
                        "or in units of the system named with " +
                        crs);
    return {n[0], n[1], n[2], n[3]};
}

/// Words that the command line has not checked; empty means nothing.
template <class Choice>
std::optional<Choice> parse_choice(const std::string& option, const std::string& word, std::pair<const char*, Choice> first,
                                   std::pair<const char*, Choice> second) {
    if (word.empty()) return std::nullopt;
    if (word == first.first) return first.second;
    if (word == second.first) return second.second;
    throw UserError(option + " " + word + ": unknown; choose " + first.first + " or " + second.first);
}

RasterOptions raster_options(const TerrainBuildOptions& options) {
    RasterOptions raster;
    if (!options.crs.empty()) raster.crs = options.crs;
    if (!options.bounds.empty()) raster.bounds = parse_bounds(options.bounds);
    raster.void_value = options.void_value;
    if (!std::isfinite(options.accuracy_m.value_or(0))) throw UserError("--accuracy: must be a number of metres, 0 for unknown");
    if (!options.extent.empty()) raster.extent = parse_extent("--extent", "--crs", options.extent);
    raster.vertical_datum = parse_choice<VerticalDatum>("--vertical-datum", options.vertical_datum,
                                                        {"egm96", VerticalDatum::egm96}, {"ellipsoid", VerticalDatum::ellipsoid});
    raster.encoding = parse_choice<HeightEncoding>("--encoding", options.encoding, {"terrain-rgb", HeightEncoding::terrain_rgb},
                                                   {"terrarium", HeightEncoding::terrarium});
    return raster;
}

void report_progress(std::string_view what, std::uint64_t done, std::uint64_t total, const InterruptGuard& interrupt,
                     Console& console, const char* left_behind) {
    console.progress(what, done, total);
    if (interrupt.requested()) throw Interrupted(std::string("interrupted; ") + left_behind);
}

std::optional<DrapeOptions> drape_options(const TerrainBuildOptions& options) {
    if (options.drape.empty()) {
        if (!options.drape_crs.empty() || !options.drape_extent.empty())
            throw UserError("--drape-crs and --drape-extent speak of an image; name it with --drape");
        return std::nullopt;
    }
    DrapeOptions drape;
    drape.file = options.drape;
    if (!options.drape_crs.empty()) drape.crs = options.drape_crs;
    if (!options.drape_extent.empty()) drape.extent = parse_extent("--drape-extent", "--drape-crs", options.drape_extent);
    return drape;
}

std::vector<std::string> files_of(const TerrainBuildOptions& options) {
    std::vector<std::string> files = options.rasters;
    if (!options.drape.empty()) files.push_back(options.drape);
    return files;
}

void put_identity(const std::string& file, std::ostream& text) {
    std::error_code ignored;
    text << std::filesystem::weakly_canonical(file, ignored).string() << '\n'
         << std::filesystem::file_size(file, ignored) << ' '
         << std::filesystem::last_write_time(file, ignored).time_since_epoch().count() << '\n';
}

/// A build goes on where files of the same names, sizes and times, beside the same ones, and the same options are given.
std::string identity_of(const TerrainBuildOptions& options) {
    std::ostringstream text;
    for (const std::string& named : files_of(options))
        for (const std::string& file : files_of_raster(named)) put_identity(file, text);
    text << options.crs << '\n'
         << options.extent << '\n'
         << options.bounds << '\n'
         << options.vertical_datum << '\n'
         << options.encoding << '\n'
         << options.drape_crs << '\n'
         << options.drape_extent;
    if (options.void_value) text << '\n' << std::hexfloat << *options.void_value;
    return text.str();
}

BuildOptions build_options(const TerrainBuildOptions& options, const InterruptGuard& interrupt, Console& console,
                           const char* left_behind) {
    BuildOptions build;
    build.le90_m = options.accuracy_m;
    build.identity = identity_of(options);
    build.progress = [&interrupt, &console, left_behind](std::string_view, std::uint64_t done, std::uint64_t total) {
        report_progress("terrain", done, total, interrupt, console, left_behind);
    };
    return build;
}

/// Sentences about the rasters go to the user once.
TerrainSources sources_of(const TerrainBuildOptions& options, Console& console) {
    std::vector<std::string> notes;
    TerrainSources sources = sources_of_files(options.rasters, raster_options(options), notes);
    for (const std::string& note : notes) console.note("note: " + note);
    for (const std::string& file : options.rasters) print_warnings(value_findings(file, raster_options(options)), console);
    sources.drape = drape_options(options);
    return sources;
}

double south_deg(const terrain::Lattice& lattice) { return base::degrees(lattice.latitude_rad(lattice.rows() - 1)); }

double drape_texel_deg(const terrain::FileHeader& h) {
    return h.step_lat_deg * std::ldexp(double{terrain::kChunkCells} / terrain::kDrapeSteps, h.drape_level);
}

Json describe_levels(const std::vector<LevelSummary>& levels) {
    Json json = Json::array();
    for (const LevelSummary& level : levels)
        json.push_back({{"chunks", level.chunks},
                        {"vertices", level.vertices},
                        {"triangles", level.triangles},
                        {"bytes", level.payload_bytes},
                        {"drape_pages", level.drape_pages},
                        {"worst_error_m", level.worst_error_m},
                        {"worst_bound_m", level.worst_bound_m}});
    return json;
}

Json describe(const OpenDatabase& open, const std::string& name) {
    const terrain::FileHeader& h = open.database().header();
    Json json;
    json["source"] = h.source;
    json["columns"] = h.columns;
    json["rows"] = h.rows;
    json["west_deg"] = h.west_deg;
    json["north_deg"] = h.north_deg;
    json["east_deg"] = h.west_deg + h.step_lon_deg * (h.columns - 1);
    json["south_deg"] = south_deg(open.database().lattice());
    json["min_height_m"] = h.min_height_m;
    json["max_height_m"] = h.max_height_m;
    json["void_posts"] = h.void_posts;
    json["le90_m"] = h.le90_m;
    json["vertical_datum"] = h.vertical_datum;
    json["levels"] = h.levels;
    json["chunks"] = h.chunk_count;
    json["bytes"] = h.file_bytes;
    json["tolerance_m"] = std::vector<float>(h.tolerance_m, h.tolerance_m + h.levels);
    json["drape"] = nullptr;
    if (h.drape_posts != 0) json["drape"] = {{"texel_deg", drape_texel_deg(h)}, {"finest_level", h.drape_level}};
    json["warnings"] = findings_json(height_findings(name, height_counts(h)));
    json["by_level"] = describe_levels(summarise_levels(open));
    return json;
}

std::string describe_in_words(const OpenDatabase& open, const std::string& name) {
    const terrain::FileHeader& h = open.database().header();
    const terrain::Lattice& lattice = open.database().lattice();
    std::ostringstream text;
    text << name << ": " << h.columns << " x " << h.rows << " posts from " << h.source << "\n"
         << "  " << south_deg(lattice) << " .. " << base::degrees(lattice.latitude_rad(0)) << " N, " << h.west_deg << " .. "
         << h.west_deg + h.step_lon_deg * (h.columns - 1) << " E, heights " << h.min_height_m << " .. " << h.max_height_m
         << " m above MSL (EGM96)\n"
         << "  " << h.void_posts << " void posts, " << h.chunk_count << " chunks on " << h.levels << " levels, " << h.file_bytes
         << " bytes\n  vertical accuracy (LE90) of the sources: ";
    if (h.le90_m > 0)
        text << h.le90_m << " m\n";
    else
        text << "not stated\n";
    if (h.drape_posts == 0) {
        text << "  no image drape";
    } else {
        std::uint64_t pages = 0;
        for (const LevelSummary& level : summarise_levels(open)) pages += level.drape_pages;
        text << "  image drape of " << pages << " pages, texels of "
             << std::lround(drape_texel_deg(h) * kMetresPerDegree * 10) / 10.0 << " m at the finest";
    }
    return text.str();
}

/// A database as a command's result, with what does not look like ground.
void state(const std::string& name, Console& console) {
    const OpenDatabase open(name);
    print_warnings(height_findings(name, height_counts(open.database().header())), console);
    console.result(describe_in_words(open, name), json_text(describe(open, name)));
}

}  // namespace

std::string terrain_build_identity(const TerrainBuildOptions& options) {
    std::ostringstream text;
    text << identity_of(options) << '\n' << std::hexfloat << options.accuracy_m.value_or(0);
    return text.str();
}

int run_terrain_build(const TerrainBuildOptions& options, Console& console) {
    const InterruptGuard interrupt;
    const TerrainSources sources = sources_of(options, console);
    require_other_file(options.output, files_of(options));
    require_replaceable(options.output, {terrain::kTdbMagic, sizeof terrain::kTdbMagic}, "terrain database");
    build_terrain(sources, options.output, build_options(options, interrupt, console, "the same command goes on from here"));
    console.progress_done();
    state(options.output, console);
    return 0;
}

int run_terrain_check(const TerrainCheckOptions& options, Console& console) {
    const InterruptGuard interrupt;
    const TerrainSources sources = sources_of(options.build, console);
    const TerrainCheck check =
        check_terrain(options.database, sources, build_options(options.build, interrupt, console, "nothing was found out"));
    console.progress_done();
    Json json;
    json["chunks"] = check.chunks;
    json["violations"] = check.violations;
    json["worst_excess_m"] = check.worst_excess_m;
    json["violating_chunks"] = Json::array();
    std::ostringstream text;
    text << options.database << ": " << check.chunks << " chunks, " << check.violations << " violations";
    for (const ChunkViolation& violation : check.first) {
        json["violating_chunks"].push_back(
            {{"chunk", violation.chunk}, {"reason", violation.reason}, {"excess_m", violation.excess_m}});
        if (json["violating_chunks"].size() > 10) continue;
        text << "\n  chunk " << violation.chunk << ": " << violation.reason;
        if (violation.excess_m > 0) text << " (" << violation.excess_m << " m)";
    }
    console.result(text.str(), json_text(json));
    return check.violations == 0 ? 0 : 1;
}

int run_terrain_info(const TerrainInfoOptions& options, Console& console) {
    state(options.database, console);
    return 0;
}

int run_terrain_fractal(const TerrainFractalOptions& options, Console& console) {
    if (options.size < kFewestFractalPosts || options.size > kMaxFractalPosts)
        throw UserError("--size " + std::to_string(options.size) + ": must be from " + std::to_string(kFewestFractalPosts) +
                        " to " + std::to_string(kMaxFractalPosts) + " posts");
    if (options.numbers != "float32" && options.numbers != "int16")
        throw UserError("--type " + options.numbers + ": unknown; choose float32 or int16");
    const InterruptGuard interrupt;
    write_fractal_geotiff(options.output, options.size, options.seed,
                          options.numbers == "int16" ? FractalNumbers::int16 : FractalNumbers::float32,
                          [&](std::uint64_t done, std::uint64_t total) {
                              report_progress("fractal terrain", done, total, interrupt, console, "nothing was written");
                          });
    console.progress_done();
    const Json json = {{"file", options.output}, {"size", options.size}, {"seed", options.seed}};
    console.result(options.output + ": generated terrain, " + std::to_string(options.size) + " posts a side, seed " +
                       std::to_string(options.seed),
                   json_text(json));
    return 0;
}

}  // namespace tedavis::host_sim
