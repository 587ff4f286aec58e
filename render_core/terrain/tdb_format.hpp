/// The terrain database file (.tdb), version 1. Little-endian; every part carries a CRC-32.
///
/// Layout   FileHeader · ChunkEntry[chunk_count] · undulation grid (float) · chunk payloads.
/// Lattice  posts at longitude west + i*step (i east), latitude north - j*step (j south), i < columns, j < rows. The
///          true surface is these posts with two triangles a cell, diagonal (i+1,j)-(i,j+1), on WGS84 plus undulation.
/// Levels   level k covers 32*2^k cells a chunk; level 0 is exact. Chunks of a level are stored row by row, all that
///          overlap the raster, so that an index follows from (level, i, j).
/// Payload  ChunkVertex[vertex_count], then at level 0 the posts: float[33*33] heights above MSL and uint8[33*33] classes.
/// Mesh     Right-triangulated irregular network (Evans, Kirkpatrick, Townsend, "Right-Triangulated Irregular Networks",
///          Algorithmica 30, 2001) over the whole lattice: a vertex is in the mesh of level k when its `top_level` is at
///          least k. Chunks of one level agree on their common border by construction; see chunk_mesh.hpp for two levels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace tedavis::terrain {

inline constexpr char kTdbMagic[8] = {'T', 'E', 'D', 'A', 'V', 'T', 'D', 'B'};
inline constexpr std::uint32_t kTdbVersion = 1;
inline constexpr std::uint32_t kChunkCells = 32;
inline constexpr std::uint32_t kChunkPosts = kChunkCells + 1;
inline constexpr std::uint32_t kMaxLevels = 11;  ///< a chunk's border then has 2^15 cells, which 16-bit coordinates hold
inline constexpr std::uint32_t kMaxChunkVertices = 6144;
inline constexpr std::uint32_t kMaxChunkTriangles = 2 * kMaxChunkVertices;

enum class PostClass : std::uint8_t {
    land,
    sea,
    void_,    ///< the source has no height: no surface in any cell that touches it
    outside,  ///< beyond the raster, only there to fill the last chunk; never drawn
};

struct FileHeader {
    char magic[8];
    std::uint32_t version;
    std::uint32_t header_bytes;
    double west_deg, north_deg;         ///< post (0,0)
    double step_lon_deg, step_lat_deg;  ///< both positive
    std::uint32_t columns, rows;
    std::uint32_t levels;
    std::uint32_t chunk_count;
    float tolerance_m[16];             ///< mesh tolerance by level; 0 at level 0
    float min_height_m, max_height_m;  ///< valid posts, above MSL
    float le90_m;                      ///< vertical accuracy of the source, 90 % linear error; 0 unknown
    std::uint32_t void_posts;
    double undulation_west_deg, undulation_north_deg, undulation_step_deg;
    std::uint32_t undulation_columns, undulation_rows;
    std::uint64_t undulation_offset;
    std::uint64_t file_bytes;
    std::uint32_t undulation_crc;
    std::uint32_t directory_crc;
    char source[160];         ///< names of the rasters, zero-terminated
    char vertical_datum[16];  ///< of the source: "egm96" or "ellipsoid"
    std::uint32_t max_chunk_vertices, max_chunk_triangles;
    std::uint32_t reserved;
    std::uint32_t header_crc;  ///< over all bytes before it
};
static_assert(std::is_trivially_copyable_v<FileHeader> && sizeof(FileHeader) == 392);

struct ChunkEntry {
    std::uint64_t offset;
    std::uint32_t bytes;
    std::uint32_t crc;
    std::uint16_t level, reserved0;
    std::uint32_t i, j;  ///< chunk coordinates at its level
    std::uint32_t vertex_count, triangle_count;
    float above_m, below_m;            ///< exhaustive signed error of its mesh: drawn above / below the true surface
    float bound_m;                     ///< see lod_selection.hpp: error bound also for the strips of finer neighbours
    float min_height_m, max_height_m;  ///< of its posts, above MSL
    double centre_m[3];                ///< ECEF, whole metres: the vertices' origin
    float axes[9];                     ///< north, east, down unit vectors of the box, ECEF
    float half_extent_m[3];            ///< box about the centre along these axes, holds surface and mesh
    std::uint32_t flags;               ///< bit 0: contains void posts; bit 1: reaches outside the raster
    std::uint32_t reserved1;
};
static_assert(std::is_trivially_copyable_v<ChunkEntry> && sizeof(ChunkEntry) == 136);
inline constexpr std::uint32_t kChunkHasVoid = 1u;
inline constexpr std::uint32_t kChunkHasOutside = 2u;

/// Uploaded to the GPU as it is. Positions lie on a binary grid, 2^-10 m or coarser for vertices of high levels, so that
/// every chunk holds a shared vertex exactly: see draw/terrain_drawer.hpp.
struct ChunkVertex {
    float x, y, z;                 ///< ECEF minus the chunk's centre, metres
    float height_m;                ///< above MSL
    std::int8_t normal[3];         ///< unit normal of the full-resolution surface, ECEF, times 127
    std::uint8_t level_and_class;  ///< bits 0-3 top_level, bits 4-5 PostClass
    std::uint16_t i, j;            ///< lattice post, relative to the chunk's north-west corner

    [[nodiscard]] std::uint32_t top_level() const { return level_and_class & 15u; }
    [[nodiscard]] PostClass post_class() const { return static_cast<PostClass>(level_and_class >> 4); }
};
static_assert(std::is_trivially_copyable_v<ChunkVertex> && sizeof(ChunkVertex) == 24);

inline constexpr std::size_t kLeafPostBytes = std::size_t{kChunkPosts} * kChunkPosts * (sizeof(float) + 1);

}  // namespace tedavis::terrain
