// The pages of the terrain drawer: maps that the database has beside its meshes, and its image.
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/draw/drawers/terrain_drawer.hpp"
#include "render_core/terrain/projected_error.hpp"

namespace tedavis::draw {
namespace {

using design::BakedMap;
using terrain::SelectedChunk;

constexpr double kSmallestTexel_px = 0.7;
constexpr double kAzimuthStep_rad = 0.25 * base::kPi / 180;  // horizons are mixed for whole steps of the light's azimuth

/// The light's azimuth at a page, in whole steps: what a page shows depends on this frame's light alone.
double azimuth_at(const terrain::ChunkEntry& entry, const glm::dvec3& light) {
    const glm::dvec3 north(entry.axes[0], entry.axes[1], entry.axes[2]), east(entry.axes[3], entry.axes[4], entry.axes[5]);
    return kAzimuthStep_rad * std::round(std::atan2(glm::dot(light, east), glm::dot(light, north)) / kAzimuthStep_rad);
}

}  // namespace

bool TerrainDrawer::is_coast(const terrain::ChunkEntry& entry) {
    constexpr unsigned kBoth = terrain::kChunkHasSea | terrain::kChunkHasLand;
    return (entry.flags & kBoth) == kBoth;
}

/// The maps of all designs.
base::Error TerrainDrawer::start_pages(gl::Gl& gl, DrawnDesigns designs, effects::DeviceSettings& device, base::Arena& staging) {
    design::MapSet maps;
    for (const DrawnDesign& design : designs) maps.add(design.design->terrain.style);
    needs_maps_ = maps.any();
    const auto slots = static_cast<std::uint32_t>(store_->attribute_pages().use().capacity);
    if (slots == 0 || !reads_pages()) return {};
    page_slots_ = staging.allocate_array<PageSlot>(slots);
    if (page_slots_.empty()) return base::shortage_error(effects::kStaging, staging, "attribute_pages");
    for (PageSlot& slot : page_slots_) slot = PageSlot{};
    return atlas_.start(gl, *device.budget.find(effects::kTerrainPages), maps, database_has_coast(), slots, staging);
}

base::Error TerrainDrawer::start_drape(gl::Gl& gl, effects::DeviceSettings& device, base::Arena& staging) {
    const auto slots = static_cast<std::uint32_t>(store_->drape_pages().use().capacity);
    if (slots == 0) return {};
    drape_generations_ = staging.allocate_array<std::uint32_t>(slots);
    if (drape_generations_.empty()) return base::shortage_error(effects::kStaging, staging, "drape_pages");
    for (std::uint32_t& generation : drape_generations_) generation = 0;
    return drape_.start(gl, *device.budget.find(effects::kTerrainDrapePages), slots);
}

TerrainDrawer::PageChoice TerrainDrawer::page_of(const terrain::ChunkKey& key) const {
    if (!atlas_.is_started()) return {};
    const std::uint32_t levels = store_->lattice().levels();
    for (terrain::ChunkKey owner = terrain::TerrainStore::attribute_key(key); owner.level < levels; owner = owner.parent()) {
        const terrain::SlotIndex slot = store_->attribute_slot(owner);
        if (slot != terrain::kNoSlot) return {slot, owner};
    }
    return {};
}

bool TerrainDrawer::reads_pages() const { return needs_maps_ || database_has_coast(); }

/// The coarsest chunks, which never leave the store, know what lies in all below them.
bool TerrainDrawer::database_has_coast() const {
    const terrain::Lattice& lattice = store_->lattice();
    const std::uint32_t top = lattice.levels() - 1;
    for (std::uint32_t j = 0; j < lattice.grid_rows(top); ++j)
        for (std::uint32_t i = 0; i < lattice.grid_columns(top); ++i)
            if (const terrain::SlotIndex slot = store_->available_slot({top, i, j});
                slot != terrain::kNoSlot && is_coast(store_->entry(slot)))
                return true;
    return false;
}

bool TerrainDrawer::upload_page(gl::Gl& gl, const SelectedChunk& chunk, const TerrainDrawInput& input) {
    const PageChoice page = page_of(chunk.key);
    if (page.slot == terrain::kNoSlot) return true;
    PageSlot& slot = page_slots_[page.slot];
    const terrain::AttributePage& attributes = store_->attributes(page.slot);
    const bool is_new = slot.generation != store_->attribute_generation(page.slot);
    const bool coast = is_coast(store_->attribute_pages().entry(page.slot));
    if (is_new && !atlas_.upload(gl, page.slot, attributes, coast)) return false;
    slot.generation = store_->attribute_generation(page.slot);
    if (!atlas_.has(BakedMap::horizon)) return true;
    const double azimuth = azimuth_at(store_->attribute_pages().entry(page.slot), input.light_direction[0]);
    if (!is_new && azimuth == slot.azimuth_rad) return true;
    slot.azimuth_rad = azimuth;
    const GroundSize texel = texel_size(store_->lattice(), page.owner);
    return atlas_.upload_horizon(gl, page.slot, attributes, azimuth, texel.east_m, texel.north_m);
}

/// The finest page that is there and whose texels are no smaller than pixels where the chunk is nearest: coarser ones have the
/// mean of what would else flicker.
TerrainDrawer::PageChoice TerrainDrawer::drape_of(const SelectedChunk& chunk, const terrain::View& view) const {
    const terrain::Lattice& lattice = store_->lattice();
    const double pixel_m =
        terrain::box_distance_m(*chunk.entry, view) / (view.focal_px * terrain::magnification(*chunk.entry, view));
    PageChoice finest;
    for (terrain::ChunkKey owner = chunk.key; owner.level < lattice.levels(); owner = owner.parent()) {
        const terrain::SlotIndex slot = store_->drape_slot(owner);
        if (slot == terrain::kNoSlot) continue;
        finest = {slot, owner};
        if (drape_texel_size(lattice, owner).north_m >= kSmallestTexel_px * pixel_m) break;
    }
    return finest;
}

bool TerrainDrawer::upload_drape(gl::Gl& gl, const SelectedChunk& chunk, const terrain::View& view) {
    if (!drape_.is_started()) return true;
    const PageChoice page = drape_of(chunk, view);
    if (page.slot == terrain::kNoSlot) return true;
    const std::uint32_t generation = store_->drape_generation(page.slot);
    if (drape_generations_[page.slot] == generation) return true;
    drape_generations_[page.slot] = generation;
    return drape_.upload(gl, page.slot, store_->drape(page.slot));
}

}  // namespace tedavis::draw
