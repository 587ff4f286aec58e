#include "host_sim/commands/terrain.hpp"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/terrain_builder/tdb_image.hpp"
#include "host_sim/terrain_builder/terrain_check.hpp"
#include "host_sim/user_error.hpp"
#include "platform/files/memory_byte_source.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

GeoBounds parse_bounds(const std::string& text) {
    GeoBounds b;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf,%lf,%lf%c", &b.west_deg, &b.south_deg, &b.east_deg, &b.north_deg, &rest) != 4 ||
        !(b.south_deg < b.north_deg) || !(b.west_deg < b.east_deg))
        throw UserError("--bounds " + text +
                        ": not W,S,E,N in degrees with W < E and S < N; write for instance 9.6,46.5,10.2,47.1");
    return b;
}

RasterOptions raster_options(const TerrainBuildOptions& options) {
    RasterOptions raster;
    if (!options.crs.empty()) raster.crs = options.crs;
    if (!options.bounds.empty()) raster.bounds = parse_bounds(options.bounds);
    raster.void_value = options.void_value;
    if (options.vertical_datum != "egm96" && options.vertical_datum != "ellipsoid")
        throw UserError("--vertical-datum " + options.vertical_datum + ": unknown; choose egm96 or ellipsoid");
    raster.vertical_datum = options.vertical_datum == "egm96" ? VerticalDatum::egm96 : VerticalDatum::ellipsoid;
    return raster;
}

BuildOptions build_options(const TerrainBuildOptions& options, const RasterOptions& raster, const InterruptGuard& interrupt,
                           Console& console) {
    BuildOptions build;
    build.le90_m = options.accuracy_m;
    build.vertical_datum = raster.vertical_datum;
    build.progress = [&](std::uint64_t done, std::uint64_t total) {
        console.progress("terrain", done, total);
        if (interrupt.requested()) throw UserError("terrain: interrupted; nothing was written");
    };
    return build;
}

TerrainModel load_model(const TerrainBuildOptions& options, const RasterOptions& raster_choice, const BuildOptions& build) {
    return make_model(load_rasters(options.rasters, raster_choice), build);
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
    }
    return opened.value().header();
}

std::vector<std::uint8_t> bytes_of(const std::string& file) {
    const std::string text = read_file(file);
    return {text.begin(), text.end()};
}

}  // namespace

int run_terrain_build(const TerrainBuildOptions& options, Console& console) {
    const InterruptGuard interrupt;
    const RasterOptions raster = raster_options(options);
    const BuildOptions build = build_options(options, raster, interrupt, console);
    const std::vector<std::uint8_t> image = make_tdb(load_model(options, raster, build), build);
    console.progress_done();
    write_file_atomically(options.output, {reinterpret_cast<const char*>(image.data()), image.size()});
    const terrain::FileHeader header = verified_header(image, options.output);
    console.result(describe_in_words(header, options.output), describe(header).dump());
    return 0;
}

int run_terrain_check(const TerrainCheckOptions& options, Console& console) {
    const InterruptGuard interrupt;
    const std::vector<std::uint8_t> image = bytes_of(options.database);
    const RasterOptions raster = raster_options(options.build);
    const BuildOptions build = build_options(options.build, raster, interrupt, console);
    const TerrainCheck check = check_tdb(image, options.database, load_model(options.build, raster, build), build);
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
    console.result(text.str(), json.dump());
    return check.violations.empty() ? 0 : 1;
}

int run_terrain_info(const TerrainInfoOptions& options, Console& console) {
    const terrain::FileHeader header = verified_header(bytes_of(options.database), options.database);
    console.result(describe_in_words(header, options.database), describe(header).dump());
    return 0;
}

/// Fractional Brownian terrain by the diamond-square method (Fournier, Fussell, Carpenter, CACM 25(6), 1982).
int run_terrain_fractal(const TerrainFractalOptions& options, Console& console) {
    constexpr std::uint32_t kLargest = 16385;
    if (options.size < 3 || options.size > kLargest)
        throw UserError("--size " + std::to_string(options.size) + ": must be from 3 to 16385 posts");
    std::uint32_t side = 2;
    while (side + 1 < options.size) side *= 2;
    const std::uint32_t posts = side + 1;
    std::vector<float> height(std::size_t{posts} * posts, 0.0f);
    std::mt19937_64 random(options.seed);
    // Drawn from the engine's own bits: library distributions differ between implementations.
    const auto jitter = [&random](float amplitude) {
        return amplitude * (static_cast<float>(random() >> 40) / 8388608.0f - 1.0f);
    };
    const auto at = [&](std::uint32_t i, std::uint32_t j) -> float& { return height[std::size_t{j} * posts + i]; };
    constexpr float kCell_m = 30;
    float amplitude = 0.15f * kCell_m * static_cast<float>(side) / 2;
    for (std::uint32_t step = side; step > 1; step /= 2, amplitude *= 0.5f) {
        const std::uint32_t half = step / 2;
        for (std::uint32_t j = half; j < posts; j += step)
            for (std::uint32_t i = half; i < posts; i += step)
                at(i, j) =
                    0.25f * (at(i - half, j - half) + at(i + half, j - half) + at(i - half, j + half) + at(i + half, j + half)) +
                    jitter(amplitude);
        for (std::uint32_t j = 0; j < posts; j += half)
            for (std::uint32_t i = (j / half) % 2 == 0 ? half : 0; i < posts; i += step) {
                float sum = 0;
                int count = 0;
                const auto add = [&](bool there, std::uint32_t a, std::uint32_t b) {
                    if (!there) return;
                    sum += at(a, b);
                    ++count;
                };
                add(i >= half, i - half, j);
                add(i + half < posts, i + half, j);
                add(j >= half, i, j - half);
                add(j + half < posts, i, j + half);
                at(i, j) = sum / static_cast<float>(count) + jitter(amplitude * 0.7f);
            }
    }
    float lowest = height.front(), highest = height.front();
    for (const float h : height) {
        lowest = std::min(lowest, h);
        highest = std::max(highest, h);
    }
    const float scale = std::min(1.0f, 4000.0f / std::max(1.0f, highest - lowest));
    for (float& h : height) h = (h - lowest) * scale;

    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    const std::string part = options.output + ".part";
    const int size = static_cast<int>(options.size);
    std::unique_ptr<GDALDataset, GDALDatasetUniquePtrDeleter> file(
        driver->Create(part.c_str(), size, size, 1, GDT_Float32, nullptr));
    if (file == nullptr) throw UserError(options.output + ": cannot be written; check the folder");
    constexpr double kStep_deg = 1.0 / 3600;
    double transform[6] = {10.0, kStep_deg, 0, 47.0, 0, -kStep_deg};
    file->SetGeoTransform(transform);
    OGRSpatialReference wgs84;
    wgs84.importFromEPSG(4326);
    file->SetSpatialRef(&wgs84);
    bool written = true;
    for (int j = 0; j < size; ++j)
        written = written && file->GetRasterBand(1)->RasterIO(GF_Write, 0, j, size, 1, &at(0, static_cast<std::uint32_t>(j)),
                                                              size, 1, GDT_Float32, 0, 0) == CE_None;
    file.reset();
    if (!written || std::rename(part.c_str(), options.output.c_str()) != 0)
        throw UserError(options.output + ": cannot be written whole; check the disk");
    Json json;
    json["file"] = options.output;
    json["size"] = options.size;
    json["seed"] = options.seed;
    console.result(options.output + ": generated terrain, " + std::to_string(options.size) + " posts a side, seed " +
                       std::to_string(options.seed),
                   json.dump());
    return 0;
}

}  // namespace tedavis::host_sim
