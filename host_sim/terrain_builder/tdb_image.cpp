#include "host_sim/terrain_builder/tdb_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <utility>

#include "host_sim/terrain_builder/make_chunk.hpp"
#include "render_core/base/hash.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

FileHeader make_header(const TerrainModel& model, const BuildOptions& options) {
    const Raster& r = model.raster;
    FileHeader h{};
    std::memcpy(h.magic, kTdbMagic, sizeof kTdbMagic);
    h.version = kTdbVersion;
    h.header_bytes = sizeof h;
    h.west_deg = r.west_deg;
    h.north_deg = r.north_deg;
    h.step_lon_deg = r.step_lon_deg;
    h.step_lat_deg = r.step_lat_deg;
    h.columns = r.columns;
    h.rows = r.rows;
    h.levels = model.lattice.levels;
    std::copy(model.tolerance_m.begin(), model.tolerance_m.end(), h.tolerance_m);
    h.min_height_m = std::numeric_limits<float>::max();
    h.max_height_m = std::numeric_limits<float>::lowest();
    for (const float height : r.height_m) {
        if (std::isnan(height)) continue;
        h.min_height_m = std::min(h.min_height_m, height);
        h.max_height_m = std::max(h.max_height_m, height);
    }
    h.le90_m = static_cast<float>(options.le90_m);
    h.void_posts = static_cast<std::uint32_t>(r.void_posts);
    h.undulation_west_deg = model.undulation_west_deg;
    h.undulation_north_deg = model.undulation_north_deg;
    h.undulation_step_deg = kUndulationStep_deg;
    h.undulation_columns = model.undulation_columns;
    h.undulation_rows = model.undulation_rows;
    std::strncpy(h.source, r.source.c_str(), sizeof h.source - 1);
    std::strncpy(h.vertical_datum, options.vertical_datum == VerticalDatum::egm96 ? "egm96" : "ellipsoid",
                 sizeof h.vertical_datum - 1);
    return h;
}

std::uint32_t chunks_across(std::uint32_t posts, std::uint32_t level) {
    return (posts - 1 + (kChunkCells << level) - 1) / (kChunkCells << level);
}

/// Level by level, row by row.
std::vector<MadeChunk> make_chunks(const TerrainModel& model, FileHeader& header, const BuildOptions& options) {
    for (std::uint32_t level = 0; level < header.levels; ++level)
        header.chunk_count += chunks_across(header.columns, level) * chunks_across(header.rows, level);
    std::vector<MadeChunk> chunks;
    const auto scratch = std::make_unique<ChunkMeshScratch>();
    for (std::uint32_t level = 0; level < header.levels; ++level) {
        for (std::uint32_t j = 0; j < chunks_across(header.rows, level); ++j) {
            for (std::uint32_t i = 0; i < chunks_across(header.columns, level); ++i) {
                chunks.push_back(make_chunk(model, level, i, j, *scratch));
                header.max_chunk_vertices = std::max(header.max_chunk_vertices, chunks.back().entry.vertex_count);
                header.max_chunk_triangles = std::max(header.max_chunk_triangles, chunks.back().entry.triangle_count);
                if (options.progress) options.progress(chunks.size(), header.chunk_count);
            }
        }
    }
    return chunks;
}

/// Offsets, sizes and checksums; the header's own last.
std::vector<ChunkEntry> finish_directory(const TerrainModel& model, const std::vector<MadeChunk>& chunks, FileHeader& header) {
    header.undulation_offset = sizeof header + chunks.size() * sizeof(ChunkEntry);
    std::uint64_t offset = header.undulation_offset + model.undulation_m.size() * sizeof(float);
    std::vector<ChunkEntry> entries;
    for (const MadeChunk& chunk : chunks) {
        entries.push_back(chunk.entry);
        entries.back().offset = offset;
        offset += chunk.payload.size();
    }
    header.file_bytes = offset;
    header.undulation_crc = base::crc32(model.undulation_m.data(), model.undulation_m.size() * sizeof(float));
    header.directory_crc = base::crc32(entries.data(), entries.size() * sizeof(ChunkEntry));
    header.header_crc = base::crc32(&header, offsetof(FileHeader, header_crc));
    return entries;
}

}  // namespace

std::vector<std::uint8_t> make_tdb(const TerrainModel& model, const BuildOptions& options) {
    FileHeader header = make_header(model, options);
    const std::vector<MadeChunk> chunks = make_chunks(model, header, options);
    const std::vector<ChunkEntry> entries = finish_directory(model, chunks, header);
    std::vector<std::uint8_t> image;
    image.reserve(header.file_bytes);
    const auto append = [&](const void* bytes, std::size_t count) {
        const auto* p = static_cast<const std::uint8_t*>(bytes);
        image.insert(image.end(), p, p + count);
    };
    append(&header, sizeof header);
    append(entries.data(), entries.size() * sizeof(ChunkEntry));
    append(model.undulation_m.data(), model.undulation_m.size() * sizeof(float));
    for (const MadeChunk& chunk : chunks) append(chunk.payload.data(), chunk.payload.size());
    return image;
}

}  // namespace tedavis::host_sim
