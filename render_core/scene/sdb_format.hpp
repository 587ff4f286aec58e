/// The scene database file (.sdb): spatial data and their uncertainty, written by `tedavis scene build` and read by the
/// display.
///
///     SceneHeader
///     LayerEntry     x layer_count        at table_offset
///     AttributeEntry x attribute_count    after the layers
///     parts                               arrays, each with its checksum, at multiples of 8 bytes
///
/// A layer is a set of features that share a shape and attributes. Little-endian; numbers are in SI units and radians where a
/// name does not say otherwise; times are nanoseconds since 1970 UTC. Texts are UTF-8, zero-terminated within their field.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "render_core/scene/uncertainty.hpp"

namespace tedavis::scene {

inline constexpr char kSdbMagic[8] = {'T', 'E', 'D', 'A', 'S', 'D', 'B', '\n'};
inline constexpr std::uint32_t kSdbVersion = 2;
inline constexpr std::uint32_t kMaxLayers = 32;
inline constexpr std::uint32_t kMaxAttributes = 96;
inline constexpr std::uint32_t kMaxClasses = 16;
inline constexpr std::uint32_t kMaxMembers = 16;  ///< members of an ensemble, without its mean
inline constexpr std::int64_t kNoTime = INT64_MIN;

/// The geometry of a layer's features.
enum class LayerShape : std::uint8_t {
    grid,    ///< values at posts of a lattice in longitude, latitude, height and time
    points,  ///< each is a feature
    lines,   ///< runs of points
    areas,   ///< runs of points, closed; the first point is not repeated
    meshes,  ///< points at which the layer's model stands
};

/// The meaning of a layer; it determines symbols and the available techniques.
enum class LayerRole : std::uint8_t {
    field,   ///< a quantity in space
    wind,    ///< attributes "east" and "north", m/s; "up" may stand beside them
    sample,  ///< values measured or stated at points
    trajectory,
    traffic,  ///< other aircraft
    obstacle,
    no_go,  ///< areas with floor and ceiling that must not be entered
    airspace,
    storm_cell,
    runway,
    place,
    road,
    river,
    land_cover,
    building,
    model,
    ghost,  ///< another flight beside this one, for comparison; it is neither traffic nor a plan
    count,
};

/// Names in scene files, records and reports.
inline constexpr std::array<std::string_view, static_cast<std::size_t>(LayerRole::count)> kLayerRoleNames = {
    "field",  "wind",  "sample", "trajectory", "traffic",    "obstacle", "no_go", "airspace", "storm_cell",
    "runway", "place", "road",   "river",      "land_cover", "building", "model", "ghost"};
[[nodiscard]] constexpr std::string_view name_of(LayerRole role) { return kLayerRoleNames[static_cast<std::size_t>(role)]; }

/// The datum of heights.
enum class HeightDatum : std::uint8_t { msl, ellipsoid, ground };

enum class AttributeScale : std::uint8_t { nominal, ordinal, quantitative };

/// Whether an attribute has one value per feature or per point.
enum class AttributeOf : std::uint8_t { feature, point };

/// Location of an array in the file. `bytes` 0: there is none.
struct ScenePart {
    std::uint64_t offset;
    std::uint64_t bytes;
    std::uint32_t crc;
    std::uint32_t reserved;
};

struct SceneHeader {
    char magic[8];
    std::uint32_t version;
    std::uint32_t header_bytes;
    std::uint64_t revision;  ///< increases with every build; a running display only takes over a larger one
    std::uint64_t file_bytes;
    std::uint64_t table_offset;
    std::uint32_t layer_count, attribute_count;
    std::uint32_t table_crc;
    std::uint32_t reserved;
    char name[64];
    char origin[128];  ///< origin of the data; "generated" for those of a scenario
    std::uint32_t reserved1;
    std::uint32_t header_crc;  ///< over all bytes before it
};
static_assert(std::is_trivially_copyable_v<SceneHeader> && sizeof(SceneHeader) == 256);

/// Posts of a grid: column i at west + i * step, row j at north - j * step, heights and times from their parts. With one level
/// or one time the value holds at any height or time.
struct GridShape {
    double west_rad, north_rad, step_lon_rad, step_lat_rad;
    std::uint32_t columns, rows, levels, times;
};

struct LayerEntry {
    char name[32];     ///< unique; used in designs
    char title[32];    ///< for legends
    char source[128];  ///< file and licence, for the report
    LayerShape shape;
    LayerRole role;
    HeightDatum height_datum;
    std::uint8_t importance;  ///< 0..255; budgets keep the most important first
    std::uint32_t first_attribute, attribute_count;
    std::uint32_t feature_count, point_count;  ///< for a grid both are the number of its posts
    std::int64_t data_time_ns;                 ///< time of measurement or computation; kNoTime: not stated
    std::int64_t valid_from_ns, valid_until_ns;
    float position_accuracy_m;  ///< horizontal accuracy of positions, 95 %; 0: not stated
    float height_accuracy_m;    ///< vertical accuracy, 95 %; 0: not stated
    GridShape grid;
    ScenePart points;     ///< ScenePoint x point_count; none for a grid
    ScenePart starts;     ///< std::uint32_t x feature_count + 1: lines and areas
    ScenePart levels;     ///< float x grid.levels: heights, m, ascending
    ScenePart times;      ///< std::int64_t x grid.times, ascending
    ScenePart names;      ///< char[kNameBytes] x feature_count: names of features
    ScenePart vertices;   ///< ModelVertex: the model of meshes
    ScenePart triangles;  ///< std::uint16_t x 3 a triangle
    std::uint32_t vertex_count, triangle_count;
};
static_assert(std::is_trivially_copyable_v<LayerEntry> && sizeof(LayerEntry) == 472);

inline constexpr std::uint32_t kNameBytes = 24;

struct ScenePoint {
    double latitude_rad, longitude_rad;
    float height_m;  ///< in the layer's datum; NaN: on the ground
    float reserved;
    std::int64_t time_ns;  ///< kNoTime: the layer's
};
static_assert(std::is_trivially_copyable_v<ScenePoint> && sizeof(ScenePoint) == 32);

/// A vertex of a model, in metres right, ahead and up of the model's point.
struct ModelVertex {
    float place_m[3];
    std::int8_t normal[4];  ///< unit normal times 127; the fourth byte is 0
    std::uint8_t color[4];
};
static_assert(std::is_trivially_copyable_v<ModelVertex> && sizeof(ModelVertex) == 20);

struct AttributeEntry {
    char name[24];  ///< unique in its layer
    char title[16];
    char unit[12];  ///< "m/s"; empty: a plain number
    AttributeScale scale;
    AttributeOf of;
    UncertaintyKind uncertainty_kind;
    UncertaintyScope uncertainty_scope;
    std::uint32_t class_count;          ///< nominal and ordinal: values are 0..class_count-1
    float minimum, maximum;             ///< range of the values and members that are not missing; both 0 where there are none
    float uncertainty_full;             ///< uncertainty that counts as level 1, in the attribute's unit (percent: share of 100)
    float uncertainty_growth_per_hour;  ///< growth of the level by the data's age
    std::uint64_t value_count;
    ScenePart values;         ///< float; NaN where missing
    ScenePart uncertainties;  ///< Uncertainty; absent: all are `uncertainty_all`
    ScenePart states;         ///< ValueState; absent: all values that are not missing are valid
    ScenePart classes;        ///< char[kNameBytes] x class_count
    ScenePart members;        ///< float x value_count x member_count, one member after the other; NaN where missing
    Uncertainty uncertainty_all;
    std::uint8_t member_count;  ///< members of the ensemble whose mean the values are; 0, or 2 .. kMaxMembers
    std::uint8_t derived_from;  ///< 1 + index of the layer from whose values it was derived; 0: not derived
    std::uint8_t reserved;
    std::uint32_t derived_minute;  ///< time of those values, minutes since 1970 UTC; 0: each has its point's time
};
static_assert(std::is_trivially_copyable_v<AttributeEntry> && sizeof(AttributeEntry) == 216);

}  // namespace tedavis::scene
