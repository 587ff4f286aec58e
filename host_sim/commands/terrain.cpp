#include "host_sim/commands/terrain.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <utility>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/number_list.hpp"
#include "host_sim/terrain_builder/fractal_geotiff.hpp"
#include "host_sim/terrain_builder/tdb_image.hpp"
#include "host_sim/terrain_builder/terrain_check.hpp"
#include "host_sim/user_error.hpp"
#include "platform/files/memory_byte_source.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

GeoBounds parse_bounds(const std::string& text) {
    const std::vector<double> n = parse_number_list(text, ',');
    const GeoBounds b = n.size() == 4 ? GeoBounds{n[0], n[1], n[2], n[3]} : GeoBounds();
    if (n.size() != 4 || !(b.south_deg >= -90 && b.south_deg < b.north_deg && b.north_deg <= 90) ||
        !(b.west_deg >= -360 && b.west_deg < b.east_deg && b.east_deg <= 360))
        throw UserError("--bounds " + text +
                        ": not W,S,E,N in degrees with W < E and S < N; write for instance 9.6,46.5,10.2,47.1");
    return b;
}

MapExtent parse_extent(const std::string& text) {
    const std::vector<double> n = parse_number_list(text, ',');
    if (n.size() != 4 || !(n[0] < n[2]) || !(n[1] < n[3]))
        throw UserError("--extent " + text +
                        ": not W,S,E,N with W < E and S < N; write the outer edges of the raster, in degrees "
                        "or in units of the system named with --crs");
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
    if (!std::isfinite(options.accuracy_m)) throw UserError("--accuracy: must be a number of metres, 0 for unknown");
    if (!options.extent.empty()) raster.extent = parse_extent(options.extent);
    raster.vertical_datum = parse_choice<VerticalDatum>("--vertical-datum", options.vertical_datum,
                                                        {"egm96", VerticalDatum::egm96}, {"ellipsoid", VerticalDatum::ellipsoid});
    raster.encoding = parse_choice<HeightEncoding>("--encoding", options.encoding, {"terrain-rgb", HeightEncoding::terrain_rgb},
                                                   {"terrarium", HeightEncoding::terrarium});
    return raster;
}

void report_progress(const char* what, std::uint64_t done, std::uint64_t total, const InterruptGuard& interrupt,
                     Console& console) {
    console.progress(what, done, total);
    if (interrupt.requested()) throw Interrupted("interrupted; nothing was written");
}

BuildOptions build_options(const TerrainBuildOptions& options, const InterruptGuard& interrupt, Console& console) {
    BuildOptions build;
    build.le90_m = options.accuracy_m;
    build.progress = [&](std::uint64_t done, std::uint64_t total) {
        report_progress("terrain", done, total, interrupt, console);
    };
    return build;
}

Raster load(const TerrainBuildOptions& options, const RasterOptions& choice, Console& console) {
    Raster raster = load_rasters(options.rasters, choice);
    for (const std::string& note : raster.notes) console.note("note: " + note);
    return raster;
}

Json describe(const terrain::FileHeader& h) {
    Json json;
    json["source"] = h.source;
    json["columns"] = h.columns;
    json["rows"] = h.rows;
    json["west_deg"] = h.west_deg;
    json["north_deg"] = h.north_deg;
    json["east_deg"] = h.west_deg + h.step_lon_deg * (h.columns - 1);
    json["south_deg"] = h.north_deg - h.step_lat_deg * (h.rows - 1);
    json["min_height_m"] = h.min_height_m;
    json["max_height_m"] = h.max_height_m;
    json["void_posts"] = h.void_posts;
    json["le90_m"] = h.le90_m;
    json["vertical_datum"] = h.vertical_datum;
    json["levels"] = h.levels;
    json["chunks"] = h.chunk_count;
    json["bytes"] = h.file_bytes;
    json["tolerance_m"] = std::vector<float>(h.tolerance_m, h.tolerance_m + h.levels);
    return json;
}

std::string describe_in_words(const terrain::FileHeader& h, const std::string& name) {
    std::ostringstream text;
    text << name << ": " << h.columns << " x " << h.rows << " posts from " << h.source << "\n"
         << "  " << h.north_deg - h.step_lat_deg * (h.rows - 1) << " .. " << h.north_deg << " N, " << h.west_deg << " .. "
         << h.west_deg + h.step_lon_deg * (h.columns - 1) << " E, heights " << h.min_height_m << " .. " << h.max_height_m
         << " m above MSL (EGM96)\n"
         << "  " << h.void_posts << " void posts, " << h.chunk_count << " chunks on " << h.levels << " levels, " << h.file_bytes
         << " bytes";
    return text.str();
}

/// A right checksum does not make a number of a NaN.
bool holds_numbers(const std::vector<std::uint8_t>& payload, const terrain::ChunkEntry& entry) {
    const std::size_t posts_at = entry.vertex_count * sizeof(terrain::ChunkVertex),
                      posts = entry.level == 0 ? std::size_t{terrain::kChunkPosts} * terrain::kChunkPosts : 0;
    bool numbers = true;
    for (std::size_t n = 0; n < entry.vertex_count; ++n) {
        terrain::ChunkVertex v;
        std::memcpy(&v, payload.data() + n * sizeof v, sizeof v);
        numbers = numbers && std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.height_m);
    }
    for (std::size_t n = 0; n < posts; ++n) {
        float height_m;
        std::memcpy(&height_m, payload.data() + posts_at + n * sizeof height_m, sizeof height_m);
        numbers = numbers && std::isfinite(height_m);
    }
    return numbers;
}

terrain::FileHeader verified_header(const std::vector<std::uint8_t>& image, const std::string& name) {
    platform::MemoryByteSource bytes({image.data(), image.size()});
    std::vector<std::uint8_t> memory(image.size() + (1 << 16));
    base::Arena arena(memory.data(), memory.size());
    auto opened = terrain::TerrainDatabase::open(bytes, arena);
    const auto refuse = [&](const terrain::TdbFailure& failure) {
        throw UserError(name + ": " + to_string(failure.error) + " at offset " + std::to_string(failure.offset) +
                        "; build it again with 'terrain build'");
    };
    if (!opened.ok()) refuse(opened.error());
    std::vector<std::uint8_t> payload(terrain::kMaxChunkVertices * sizeof(terrain::ChunkVertex) + terrain::kLeafPostBytes);
    for (terrain::ChunkIndex chunk = 0; chunk < opened.value().chunk_count(); ++chunk) {
        const terrain::TdbFailure failure = opened.value().read_chunk(chunk, {payload.data(), payload.size()});
        if (failure.error != terrain::TdbError::none) refuse(failure);
        if (!holds_numbers(payload, opened.value().entry(chunk)))
            refuse({terrain::TdbError::chunk_damaged, opened.value().entry(chunk).offset});
    }
    return opened.value().header();
}

}  // namespace

int run_terrain_build(const TerrainBuildOptions& options, Console& console) {
    const InterruptGuard interrupt;
    const RasterOptions raster = raster_options(options);
    require_other_file(options.output, options.rasters);
    BuildOptions build = build_options(options, interrupt, console);
    Raster posts = load(options, raster, console);
    build.vertical_datum = posts.vertical_datum;
    AtomicFile file(options.output);
    const std::vector<std::uint8_t> image = make_tdb(make_model(std::move(posts), build), build);
    console.progress_done();
    const terrain::FileHeader header = verified_header(image, options.output);
    file.stream().write(reinterpret_cast<const char*>(image.data()), static_cast<std::streamsize>(image.size()));
    file.commit();
    console.result(describe_in_words(header, options.output), json_text(describe(header)));
    return 0;
}

int run_terrain_check(const TerrainCheckOptions& options, Console& console) {
    const InterruptGuard interrupt;
    const std::vector<std::uint8_t> image = read_bytes(options.database);
    const RasterOptions raster = raster_options(options.build);
    BuildOptions build = build_options(options.build, interrupt, console);
    Raster posts = load(options.build, raster, console);
    build.vertical_datum = posts.vertical_datum;
    const TerrainCheck check = check_tdb(image, options.database, make_model(std::move(posts), build), build);
    console.progress_done();
    Json json;
    json["chunks"] = check.chunks;
    json["violations"] = check.violations.size();
    json["worst_excess_m"] = check.worst_excess_m;
    json["violating_chunks"] = Json::array();
    std::ostringstream text;
    text << options.database << ": " << check.chunks << " chunks, " << check.violations.size() << " violations";
    for (const ChunkViolation& violation : check.violations) {
        json["violating_chunks"].push_back(
            {{"chunk", violation.chunk}, {"reason", violation.reason}, {"excess_m", violation.excess_m}});
        if (json["violating_chunks"].size() <= 10)
            text << "\n  chunk " << violation.chunk << ": " << violation.reason << " (" << violation.excess_m << " m)";
    }
    console.result(text.str(), json_text(json));
    return check.violations.empty() ? 0 : 1;
}

int run_terrain_info(const TerrainInfoOptions& options, Console& console) {
    const terrain::FileHeader header = verified_header(read_bytes(options.database), options.database);
    console.result(describe_in_words(header, options.database), json_text(describe(header)));
    return 0;
}

int run_terrain_fractal(const TerrainFractalOptions& options, Console& console) {
    if (options.size < kFewestFractalPosts || options.size > kMostFractalPosts)
        throw UserError("--size " + std::to_string(options.size) + ": must be from " + std::to_string(kFewestFractalPosts) +
                        " to " + std::to_string(kMostFractalPosts) + " posts");
    if (options.numbers != "float32" && options.numbers != "int16")
        throw UserError("--type " + options.numbers + ": unknown; choose float32 or int16");
    const InterruptGuard interrupt;
    write_fractal_geotiff(
        options.output, options.size, options.seed, options.numbers == "int16" ? FractalNumbers::int16 : FractalNumbers::float32,
        [&](std::uint64_t done, std::uint64_t total) { report_progress("fractal terrain", done, total, interrupt, console); });
    console.progress_done();
    const Json json = {{"file", options.output}, {"size", options.size}, {"seed", options.seed}};
    console.result(options.output + ": generated terrain, " + std::to_string(options.size) + " posts a side, seed " +
                       std::to_string(options.seed),
                   json_text(json));
    return 0;
}

}  // namespace tedavis::host_sim
