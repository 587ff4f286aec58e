#include "host_sim/device_plan/device_draft.hpp"

#include <algorithm>

#include "render_core/display/planner/spatial_data.hpp"
#include "render_core/display/planner/terrain_planner.hpp"
#include "render_core/draw/drawers/drape_atlas.hpp"
#include "render_core/draw/drawers/geometry_picture.hpp"
#include "render_core/draw/drawers/page_atlas.hpp"
#include "render_core/draw/drawers/picture_edges.hpp"
#include "render_core/draw/traced_view.hpp"
#include "render_core/terrain/directory_cache.hpp"
#include "render_core/terrain/height_ceiling.hpp"
#include "render_core/terrain/height_query.hpp"
#include "render_core/terrain/terrain_store.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint64_t kLineUnit = 4096;   // lines are whole memory pages
constexpr std::uint64_t kArenaSlack = 256;  // that arenas may lose
constexpr std::uint32_t kSlotsInView = 24, kSlotsBeside = 24;
constexpr std::uint64_t kStagedSlotBytes = 16;  // a record of a slot on the GPU
constexpr std::uint32_t kMaxSlots = 65'536;
constexpr std::uint64_t kSlotVertexBytes = std::uint64_t{terrain::kMaxChunkVertices} * sizeof(terrain::ChunkVertex);
constexpr std::uint64_t kSlotIndexBytes = std::uint64_t{terrain::kMaxChunkTriangles} * 3 * sizeof(std::uint16_t);

std::uint64_t whole_units(std::uint64_t bytes) { return (bytes + kLineUnit - 1) / kLineUnit * kLineUnit; }

std::uint64_t asked_pixels(const DeviceAsk& ask) { return std::uint64_t{ask.size.width} * ask.size.height; }

terrain::StoreSettings store_of(const DeviceRoom& room) {
    terrain::StoreSettings settings;
    settings.payload_slots = room.slots;
    settings.attribute_slots = room.attribute_pages;
    settings.drape_slots = room.drape_pages;
    return settings;
}

/// The lines of a draft, one after the other.
class DraftLines {
public:
    DraftLines(const DraftSource& source, const DeviceAsk& ask, const DeviceNeeds& needs, const DeviceRoom& room)
        : source_(source), ask_(ask), needs_(needs), room_(room) {}

    [[nodiscard]] base::BudgetTable table() {
        for (const base::BudgetLine& line : source_.shipped.budget.lines())
            if (is_needed(line.name.view())) static_cast<void>(table_.try_add(line));
        set_terrain();
        set_pages();
        set_pictures();
        if (needs_.scene_file_bytes)
            set(effects::kSceneData, display::SpatialData::scene_bytes(*needs_.scene_file_bytes),
                "the scene of " + std::to_string(*needs_.scene_file_bytes) + " bytes, and the next of this size");
        raise();
        return table_;
    }

private:
    [[nodiscard]] bool is_needed(std::string_view name) const {
        if (name == effects::kPictureEdges) return needs_.measures_clutter;
        return room_.is_traced || (name != effects::kTracedTerrain && name != effects::kTracedPictures);
    }
    void set(std::string_view name, std::uint64_t bytes, const std::string& reason = {}) {
        base::BudgetLine* const line = table_.find(name);
        if (line == nullptr) return;
        line->bytes = whole_units(bytes);
        if (!reason.empty()) line->reason = std::string_view(reason);
    }

    void set_terrain() {
        const terrain::StoreSettings store = store_of(room_);
        const std::string slots = std::to_string(room_.slots) + " slots";
        set(effects::kTerrainChunkSlots, terrain::TerrainStore::record_bytes(store) + kArenaSlack,
            slots + ": a record a resident chunk, and what the last frames wanted");
        set(effects::kTerrainHeights,
            terrain::TerrainStore::payload_bytes(store) + terrain::HeightQuery::bytes_needed() +
                terrain::HeightCeiling::bytes_needed() + kArenaSlack,
            slots + " of 4096 vertices and 8192 triangles, and the height queries");
        set(effects::kTerrainVertices, room_.slots * kSlotVertexBytes, slots + " of 4096 vertices of 24 bytes");
        set(effects::kTerrainIndices, room_.slots * kSlotIndexBytes, slots + " of 8192 triangles of three 16-bit indices");
        set(effects::kLodScratch, display::TerrainPlanner::lod_bytes(room_.slots) + kArenaSlack,
            slots + ": chunks that one selection looks at, the selected and the wanted ones");
        const effects::DeviceSettings& shipped = source_.shipped;
        const std::uint32_t more = std::max(room_.slots, shipped.max_chunk_slots) - shipped.max_chunk_slots;
        set(effects::kStaging, shipped.budget.find(effects::kStaging)->bytes + more * kStagedSlotBytes);
        if (needs_.terrain) set_index(*needs_.terrain);
    }

    /// As many pages as the shipped line has room for, where the database has so many.
    void set_index(const TerrainNeeds& terrain) {
        const std::uint64_t a_page = terrain::DirectoryCache::bytes_needed(1);
        const std::uint64_t shipped = source_.shipped.budget.find(effects::kTerrainIndex)->bytes / a_page;
        const std::uint32_t all = std::min(terrain.pages + 1, terrain::kMaxDirectoryPages);
        const auto pages = static_cast<std::uint32_t>(std::min<std::uint64_t>(all, shipped));
        set(effects::kTerrainIndex, terrain.table_bytes + terrain::DirectoryCache::bytes_needed(pages) + kArenaSlack,
            "tables of the database, " + std::to_string(pages) + " pages of its directory");
    }

    void set_pages() {
        const terrain::StoreSettings store = store_of(room_);
        const bool has_maps = room_.attribute_pages > 0, has_drape = room_.drape_pages > 0;
        const std::string maps = std::to_string(room_.attribute_pages) + " pages",
                          drape = std::to_string(room_.drape_pages) + " pages";
        set(effects::kTerrainAttributes, terrain::TerrainStore::attribute_bytes(store),
            has_maps ? maps + ": baked maps of every resident attribute page" : "no attribute pages");
        set(effects::kTerrainPages,
            has_maps ? draw::PageAtlas::bytes_needed(needs_.maps, needs_.has_coast, room_.attribute_pages) : 0,
            has_maps ? maps + ": those baked maps that the design shows" : "no attribute pages");
        set(effects::kTerrainDrape, terrain::TerrainStore::drape_bytes(store) + (has_drape ? kArenaSlack : 0),
            has_drape ? drape + " of the image over the terrain, and their records" : "no image over the terrain");
        set(effects::kTerrainDrapePages, has_drape ? draw::DrapeAtlas::bytes_needed(room_.drape_pages) : 0,
            has_drape ? drape + " of 129 x 129 texels, in a square whose side is a power of two" : "no image over the terrain");
    }

    void set_pictures() {
        const auto known = source_.target_bytes.find(room_.has_pictures);
        set(effects::kRenderTargets, known == source_.target_bytes.end() ? kUnknownTargetBytes : known->second,
            room_.has_pictures ? "color and depth of what the design draws off screen, as a start takes it"
                               : "colors of the design; no pictures off screen");
        set(effects::kPictureEdges, draw::PictureEdges::bytes(ask_.size.width, ask_.size.height),
            "edges of the picture, a byte a pixel; rows of it, and a strip read back");
        if (!room_.is_traced) return;
        const std::uint64_t word_bytes = needs_.shades_traced ? sizeof(draw::GeometryWords) * asked_pixels(ask_) : 0;
        set(effects::kTracedPictures, 4 * asked_pixels(ask_) + word_bytes,
            "depths of a traced picture, 4 bytes a pixel; 16 for its geometry, where a style needs it");
        if (needs_.terrain)
            set(effects::kTracedTerrain,
                needs_.terrain->traced_bytes + 4 * asked_pixels(ask_) + word_bytes +
                    draw::TracedView::bytes_needed(ask_.size.width, ask_.size.height) + kArenaSlack,
                "posts of the database and a traced picture");
    }

    void raise() {
        for (const auto& [name, bytes] : source_.raised)
            if (base::BudgetLine* const line = table_.find(name); line != nullptr && line->bytes > 0)  // 0: given up
                line->bytes = std::max(line->bytes, whole_units(bytes));
    }

    const DraftSource& source_;
    const DeviceAsk& ask_;
    const DeviceNeeds& needs_;
    const DeviceRoom& room_;
    base::BudgetTable table_;
};

}  // namespace

std::uint32_t fewest_slots(const DeviceNeeds& needs) {
    return (needs.terrain ? needs.terrain->roots : 1) + kSlotsInView + kSlotsBeside;
}

DeviceRoom whole_room(const DraftSource& source, const DeviceAsk& ask, const DeviceNeeds& needs) {
    const effects::DeviceSettings& shipped = source.shipped;
    const double larger =
        static_cast<double>(asked_pixels(ask)) / static_cast<double>(std::uint64_t{shipped.width_px} * shipped.height_px);
    const std::uint32_t limit = needs.shades_traced ? draw::kMaxGeometrySlots : kMaxSlots;
    const double slots = std::min<double>(limit, shipped.max_chunk_slots * std::max(1.0, larger));
    DeviceRoom room;
    room.slots = std::max(static_cast<std::uint32_t>(slots), fewest_slots(needs));
    const bool has_maps = draw::PageAtlas::bytes_needed(needs.maps, needs.has_coast, 1) > 0;
    room.attribute_pages = has_maps ? shipped.attribute_pages : 0;
    room.drape_pages = needs.has_drape ? shipped.drape_pages : 0;
    room.has_pictures = shipped.capability.depth24_targets;
    room.is_traced = needs.is_traced && shipped.budget.find(effects::kTracedTerrain) != nullptr;
    return room;
}

effects::DeviceSettings draft_device(const DraftSource& source, const DeviceAsk& ask, const DeviceNeeds& needs,
                                     const DeviceRoom& room) {
    effects::DeviceSettings device = source.shipped;
    device.name = std::string_view(ask.name);
    device.width_px = ask.size.width;
    device.height_px = ask.size.height;
    device.frame_rate_hz = ask.rate_hz;
    device.max_chunk_slots = room.slots;
    device.attribute_pages = room.attribute_pages;
    device.drape_pages = room.drape_pages;
    if (!room.has_pictures) {
        device.capability.off_screen_pictures = 0;
        device.capability.depth24_targets = false;
        device.affords_antialiasing = false;
    }
    if (!room.has_pictures || !needs.has_shadows) device.capability.shadow_map_px = 0;
    device.budget = DraftLines(source, ask, needs, room).table();
    return device;
}

std::uint64_t total_bytes(const effects::DeviceSettings& device) {
    return device.budget.total(base::MemoryKind::cpu) + device.budget.total(base::MemoryKind::gpu);
}

}  // namespace tedavis::host_sim
