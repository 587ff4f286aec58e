#include "host_sim/device_plan/device_needs.hpp"

#include <filesystem>
#include <memory>

#include "host_sim/replay/load_design.hpp"
#include "host_sim/scene_builder/open_scene.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"
#include "render_core/draw/drawers/traced_words.hpp"
#include "render_core/draw/drawn_design.hpp"
#include "render_core/draw/traced_ground.hpp"

namespace tedavis::host_sim {
namespace {

void add_design_needs(const design::DesignSettings& design, DeviceNeeds& needs) {
    needs.maps.add(design.terrain.style);
    needs.has_drape = needs.has_drape || needs_map(design.terrain.style, design::BakedMap::drape);
    needs.has_shadows = needs.has_shadows || design.effects.shadows.is_any();
    needs.is_traced = needs.is_traced || design::may_trace(design.terrain);
    for (const bool has_focus : {false, true})
        needs.shades_traced = needs.shades_traced || draw::drawn_as(design, {true, true, true}, has_focus).is_deferred;
    needs.measures_clutter =
        needs.measures_clutter || design.priority.held_clutter() < 1 || design.effects.clutter != design::ClutterView::none;
}

/// The coarsest chunks know what lies in all below them.
bool finds_coast(const OpenDatabase& open) {
    constexpr unsigned kBoth = terrain::kChunkHasSea | terrain::kChunkHasLand;
    const terrain::TerrainDatabase& database = open.database();
    const terrain::Lattice& lattice = database.lattice();
    const std::uint32_t top = database.top_level(), first = lattice.page_index({top, 0, 0});
    const std::uint32_t count = lattice.page_columns(top) * lattice.page_rows(top);
    const auto page = std::make_unique<terrain::DirectoryPage>();
    for (std::uint32_t index = first; index < first + count; ++index) {
        if (!database.has_page(index)) continue;
        open.read_page(index, *page);
        for (const terrain::ChunkEntry& entry : page->entries)
            if (entry.vertex_count != 0 && (entry.flags & kBoth) == kBoth) return true;
    }
    return false;
}

void add_terrain_needs(const std::string& path, DeviceNeeds& needs) {
    const OpenDatabase open(path);
    const terrain::TerrainDatabase& database = open.database();
    needs.terrain = {
        database.table_bytes(), database.header().page_count, database.root_count(),
        draw::TracedGround::bytes_needed(database.lattice()) + draw::TracedWords::bytes_needed(database.lattice(), 0, 0)};
    needs.has_coast = finds_coast(open);
    needs.has_drape = needs.has_drape && database.header().drape_posts != 0;
}

}  // namespace

DeviceNeeds device_needs(const PictureOptions& options) {
    DeviceNeeds needs;
    needs.design = options.design;
    const std::unique_ptr<LoadedDesigns> designs = load_designs(options);
    add_design_needs(designs->design, needs);
    for (std::size_t place = 1; place <= designs->phases.size(); ++place) add_design_needs(designs->phases.at(place), needs);
    if (!options.terrain.empty()) add_terrain_needs(options.terrain, needs);
    if (!options.scene.empty()) {
        static_cast<void>(OpenScene(options.scene));  // whether it is sound
        needs.scene_file_bytes = std::filesystem::file_size(options.scene);
    }
    return needs;
}

}  // namespace tedavis::host_sim
