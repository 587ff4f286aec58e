/// A device file (configs/devices/*.toml): size, frame rate, budgets and GL rules of one display computer.
///
/// Memory  reading allocates (start-up only); the result is plain data. Failure  one sentence with file and line.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/base/result.hpp"
#include "render_core/effects/device_capability.hpp"
#include "render_core/effects/effect_planner.hpp"

namespace tedavis::effects {

/// Names of the budget lines that every device file has; their owners find them by these names.
inline constexpr std::string_view kTerrainChunkSlots = "terrain_chunk_slots";
inline constexpr std::string_view kTerrainHeights = "terrain_heights";
inline constexpr std::string_view kTerrainIndex = "terrain_index";
inline constexpr std::string_view kTerrainVertices = "terrain_vertices";
inline constexpr std::string_view kTerrainIndices = "terrain_indices";
inline constexpr std::string_view kTerrainAttributes = "terrain_attributes";
inline constexpr std::string_view kTerrainPages = "terrain_pages";
inline constexpr std::string_view kTerrainDrape = "terrain_drape";
inline constexpr std::string_view kTerrainDrapePages = "terrain_drape_pages";
inline constexpr std::string_view kSymbology = "symbology";
inline constexpr std::string_view kSymbologyVertices = "symbology_vertices";
inline constexpr std::string_view kFontAtlas = "font_atlas";
inline constexpr std::string_view kRenderTargets = "render_targets";
inline constexpr std::string_view kStaging = "staging";
inline constexpr std::string_view kLodScratch = "lod_scratch";
inline constexpr std::string_view kSceneData = "scene_data";
inline constexpr std::string_view kSceneSlices = "scene_slices";
inline constexpr std::string_view kSceneGround = "scene_ground";
inline constexpr std::string_view kSceneSolids = "scene_solids";
inline constexpr std::string_view kSceneSolidVertices = "scene_solid_vertices";
inline constexpr std::string_view kSceneGlyphs = "scene_glyphs";
inline constexpr std::string_view kSceneGlyphVertices = "scene_glyph_vertices";
inline constexpr std::string_view kSceneBillboards = "scene_billboards";
inline constexpr std::string_view kSceneBillboardVertices = "scene_billboard_vertices";
inline constexpr std::string_view kPlannedFrames = "planned_frames";
inline constexpr std::string_view kPlannerMemory = "planner_memory";

/// An optional line, present where the device has room to measure the clutter of its picture.
inline constexpr std::string_view kPictureEdges = "picture_edges";  ///< cpu
/// Optional lines, present where the device has room for ray-traced terrain.
inline constexpr std::string_view kTracedTerrain = "traced_terrain";    ///< cpu
inline constexpr std::string_view kTracedPictures = "traced_pictures";  ///< gpu

struct DeviceSettings {
    base::FixedString<31> name;
    DeviceCapability capability;
    EffectSet forbidden;                ///< effects listed by `forbid` in [effects]
    bool affords_antialiasing = false;  ///< smooths edges of designs that leave it to the device (design_on())
    std::uint32_t width_px = 0;         ///< default picture size
    std::uint32_t height_px = 0;
    double frame_rate_hz = 0;
    double deadline_ms = 0;                        ///< frame deadline, held where the costs are known; 0: none
    std::uint32_t triangle_budget = 0;             ///< terrain triangles per frame
    std::uint32_t max_chunk_slots = 0;             ///< terrain chunks resident at once, drawn ones and their ancestors
    std::uint32_t attribute_pages = 0;             ///< attribute pages resident at once; 0: only vertex normals are used
    std::uint32_t drape_pages = 0;                 ///< pages of an image drape resident at once; 0: none are read
    std::uint32_t arrival_frames = 2;              ///< in a replay, chunks arrive this many frames after they are requested
    double terrain_ms = 0;                         ///< time budget of the terrain pass, ms; 0: none
    double ns_per_triangle = 0, us_per_chunk = 0;  ///< cost of terrain on this device, for the budget terrain_ms
    base::BudgetTable budget;                      ///< `use.capacity` of a line is its bytes
};

/// Reads a device file; `text` is its content, `file_name` its name in error messages. A file that lacks one of the
/// required lines above, has one of the lines above with the other kind of memory, has a line twice, has more than 32 lines, or
/// has an unknown key is refused.
[[nodiscard]] base::Result<DeviceSettings, base::Error> read_device_settings(std::string_view text, std::string_view file_name);

}  // namespace tedavis::effects
