/// The terrain database file (.tdb), version 2. Little-endian; every part carries a CRC-32.
///
/// Layout   FileHeader, undulation grid (float), page table (uint64 offset a page), then in any order directory pages,
///          chunk payloads, attribute pages and drape pages.
/// Lattice  posts at longitude west + i*step (i east), latitude north - j*step (j south); lattice.hpp has the rest: closing
///          round the Earth and rows at the poles.
/// Surface  the true surface joins the posts of the exact chunks: two triangles per cell, diagonal (i+1,j)-(i,j+1), heights on
///          WGS84 plus undulation. Exact chunks lie at level 0; where the sources are coarser, at the level of their
///          resolution.
/// Levels   a chunk of level k covers 32*2^k cells; a chunk at the lattice's end covers the rest. Every chunk has either no
///          children and is exact, or covers its children. Side by side, the finest chunks differ by one level at most.
/// Pages    kPageChunks x kPageChunks neighbouring entries of one level; the page table lists the pages of level 0 row by
///          row, then of level 1 and so on; offset 0 means that no chunk lies there.
/// Payload  ChunkVertex[vertex_count], then uint16 indices[3*triangle_count] unless the chunk is regular.
/// Vertices the border comes first, clockwise seen from above from the north-west corner; then the others. A regular chunk has
///          every post (every 2^level-th) and its other vertices row by row.
/// Borders  a border vertex is kept beside a coarser neighbour if it is marked. The marked ones of level k are the border
///          vertices of level k+1 on the same line, and contain all corners of level k: two levels meet in the same vertices.
///          chunk_mesh.hpp removes the others.
/// Strips   the first `strip_count` triangles touch a border vertex that is not marked; no other triangle does.
/// Poles    triangles whose corners coincide at a pole are stored like others and left out in drawing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace tedavis::terrain {

inline constexpr char kTdbMagic[8] = {'T', 'E', 'D', 'A', 'V', 'T', 'D', 'B'};
inline constexpr std::uint32_t kTdbVersion = 3;
inline constexpr std::uint32_t kChunkCells = 32;
inline constexpr std::uint32_t kMaxLevels = 11;  ///< a chunk's border then has 2^15 cells, which 16-bit coordinates hold
inline constexpr std::uint32_t kMaxChunkVertices = 4096;
inline constexpr std::uint32_t kMaxChunkTriangles = 2 * kMaxChunkVertices;
inline constexpr std::uint32_t kPageChunks = 8;  ///< entries along the side of a directory page

/// Attribute pages belong to chunks of level 1 and above; a chunk of level 0 uses a quarter of its parent's page.
inline constexpr std::uint32_t kAttributePosts = 65;
inline constexpr std::uint32_t kHorizonPosts = 33;
inline constexpr int kHorizonDirections = 16;

/// Drape pages belong to chunks of FileHeader::drape_level and above; a chunk below uses a part of an ancestor's page. 128
/// steps across 32 cells, a power of two: texels of a level lie on every second one of the level below, and on posts.
inline constexpr std::uint32_t kDrapePosts = 129, kDrapeSteps = kDrapePosts - 1;

enum class PostClass : std::uint8_t {
    land,
    sea,
    void_,    ///< the source has no height: drawn at an interpolated height and marked as unknown; never part of the true surface
    outside,  ///< beyond the lattice; never stored
};

enum LatticeFlag : std::uint32_t {
    kLatticeClosed = 1,     ///< round the Earth: the last column repeats the first one's meridian
    kLatticeNorthPole = 2,  ///< row 0 is the north pole, `north_deg` the latitude of row 1
    kLatticeSouthPole = 4,  ///< the last row is the south pole
};

struct FileHeader {
    char magic[8];
    std::uint32_t version;
    std::uint32_t header_bytes;
    double west_deg, north_deg;         ///< position of post (0,0); see kLatticeNorthPole
    double step_lon_deg, step_lat_deg;  ///< both positive
    std::uint32_t columns, rows;        ///< numbers of posts, closing column and pole rows included
    std::uint32_t levels;
    std::uint32_t lattice_flags;
    std::uint64_t chunk_count;
    std::uint64_t void_posts;
    float tolerance_m[16];             ///< target error of the meshes of each level; 0 at level 0
    float min_height_m, max_height_m;  ///< valid posts, above MSL
    float le90_m;                      ///< worst vertical accuracy of the sources, 90 % linear error (LE90); 0: unknown
    std::uint32_t page_count;
    double undulation_west_deg, undulation_north_deg, undulation_step_deg;
    std::uint32_t undulation_columns, undulation_rows;
    std::uint64_t undulation_offset;
    std::uint64_t page_table_offset;
    std::uint64_t file_bytes;
    std::uint32_t undulation_crc;
    std::uint32_t page_table_crc;
    char source[160];                              ///< names of the rasters, zero-terminated
    char vertical_datum[16];                       ///< of the source: "egm96" or "ellipsoid"
    std::uint16_t drape_posts;                     ///< texels along the side of a drape page, kDrapePosts; 0: no drape
    std::uint16_t drape_level;                     ///< finest level with drape pages; matches the image's resolution
    float light_azimuth_deg, light_elevation_deg;  ///< of the baked light map
    std::uint32_t header_crc;                      ///< over all bytes before it
};
static_assert(std::is_trivially_copyable_v<FileHeader> && sizeof(FileHeader) == 416);

/// Location of a part in the file. `bytes` 0: there is none.
struct PartPlace {
    std::uint64_t offset;
    std::uint32_t bytes;
    std::uint32_t crc;
};

struct ChunkEntry {
    PartPlace payload;
    PartPlace attributes;  ///< AttributePage (attribute_page.hpp)
    PartPlace drape;       ///< DrapePage; none where the image does not cover the chunk
    std::uint32_t i, j;    ///< chunk coordinates at its level
    std::uint8_t level;
    std::uint8_t flags;     ///< ChunkFlag
    std::uint8_t children;  ///< bit by quadrant (bit 0 east, bit 1 south): the child exists
    std::uint8_t reserved;
    std::uint16_t vertex_count, border_count;
    std::uint16_t triangle_count, strip_count;
    float above_m, below_m;              ///< exhaustive signed error of its own mesh: drawn above / below the true surface
    float strip_above_m, strip_below_m;  ///< the same for its strips beside any combination of coarser neighbours
    float bound_m;                       ///< bound of both errors and of the strips that it causes in finer neighbours
    float min_height_m, max_height_m;    ///< range of its valid posts, above MSL
    float le90_m;                        ///< vertical accuracy of its sources; 0 unknown
    std::uint32_t reserved1;
    double centre_m[3];      ///< ECEF, whole metres: the vertices' origin
    float axes[9];           ///< north, east, down unit vectors of the box, ECEF
    float half_extent_m[3];  ///< box round the centre along these axes; contains surface and mesh
};
static_assert(std::is_trivially_copyable_v<ChunkEntry> && sizeof(ChunkEntry) == 176);

enum ChunkFlag : std::uint8_t {
    kChunkRegular = 1,
    kChunkHasVoid = 2,
    kChunkHasSea = 4,
    kChunkHasLand = 8,
};

struct DirectoryPage {
    std::uint32_t crc;  ///< over all bytes after it
    std::uint32_t level;
    std::uint32_t i, j;                             ///< page coordinates
    ChunkEntry entries[kPageChunks * kPageChunks];  ///< row by row; vertex_count 0: no chunk
};
static_assert(std::is_trivially_copyable_v<DirectoryPage> && sizeof(DirectoryPage) == 16 + 64 * sizeof(ChunkEntry));

/// A vertex as it is uploaded to the GPU. Positions lie on binary grids, as fine as floats allow within the largest chunks that
/// share the vertex, but not finer than 2^-14 m, so that each of these chunks stores it exactly: see
/// draw/drawers/terrain_drawer.hpp.
struct ChunkVertex {
    float x, y, z;          ///< ECEF minus the chunk's centre, metres
    float height_m;         ///< above MSL; interpolated where void
    std::int8_t normal[3];  ///< unit normal of the full-resolution surface, ECEF, times 127
    std::uint8_t kind;      ///< bits 0-1: PostClass; bit 2: kept beside a coarser neighbour (borders only)
    std::uint16_t i, j;     ///< lattice post, relative to the chunk's north-west corner

    [[nodiscard]] PostClass post_class() const { return static_cast<PostClass>(kind & 3u); }
    [[nodiscard]] bool stays_beside_coarser() const { return (kind & 4u) != 0; }
};
static_assert(std::is_trivially_copyable_v<ChunkVertex> && sizeof(ChunkVertex) == 24);

inline constexpr std::size_t kMaxPayloadBytes =
    kMaxChunkVertices * sizeof(ChunkVertex) + kMaxChunkTriangles * 3 * sizeof(std::uint16_t);

/// One page of each attribute map over its chunk's whole domain, texel (0,0) at the north-west corner post, row by row;
/// encodings in attribute_map.hpp. Beyond the lattice's end the last post is repeated.
struct AttributePage {
    std::uint8_t form[kAttributePosts * kAttributePosts][4];      ///< normal east, normal north, sky view, curvature
    std::uint8_t light[kAttributePosts * kAttributePosts][4];     ///< light map, openness, local relief, class
    std::uint8_t aperture[kAttributePosts * kAttributePosts][4];  ///< aperture east, north, radius, negative openness
    std::uint8_t horizon[kHorizonDirections][kHorizonPosts * kHorizonPosts];
};
static_assert(std::is_trivially_copyable_v<AttributePage>);

/// The image over a chunk's whole domain, texel (0,0) at the north-west corner post, row by row; the last row and column equal
/// the neighbours' first. Texels are RGB premultiplied by coverage, and coverage (0: no image data), so that filtered and
/// averaged texels are right at the image's edge. The format is RGBA8, uploaded unchanged: 16-bit formats have no room for
/// coverage or show steps of colour, and every lane can filter RGBA8.
struct DrapePage {
    std::uint8_t rgba[kDrapePosts * kDrapePosts][4];
};
static_assert(std::is_trivially_copyable_v<DrapePage>);

}  // namespace tedavis::terrain
