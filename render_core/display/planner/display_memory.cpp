#include "render_core/display/planner/display_memory.hpp"

#include "render_core/effects/device.hpp"

namespace tedavis::display {
namespace {

constexpr std::uint64_t kAlignmentBytes = 4096;  // each arena may lose a little to alignment

}  // namespace

const DisplayMemory::Part DisplayMemory::kParts[] = {{effects::kTerrainHeights, &DisplayMemory::payloads_},
                                                     {effects::kTerrainIndex, &DisplayMemory::index_},
                                                     {effects::kTerrainChunkSlots, &DisplayMemory::records_},
                                                     {effects::kTerrainAttributes, &DisplayMemory::attributes_},
                                                     {effects::kTerrainDrape, &DisplayMemory::drape_},
                                                     {effects::kStaging, &DisplayMemory::staging_},
                                                     {effects::kLodScratch, &DisplayMemory::lod_},
                                                     {effects::kSymbology, &DisplayMemory::symbology_},
                                                     {effects::kSceneData, &DisplayMemory::scene_},
                                                     {effects::kSceneSlices, &DisplayMemory::slices_},
                                                     {effects::kSceneSolids, &DisplayMemory::solids_},
                                                     {effects::kSceneGlyphs, &DisplayMemory::glyphs_},
                                                     {effects::kSceneBillboards, &DisplayMemory::billboards_},
                                                     {effects::kPlannedFrames, &DisplayMemory::frames_},
                                                     {effects::kPlannerMemory, &DisplayMemory::memories_},
                                                     {effects::kPictureEdges, &DisplayMemory::edges_},
                                                     {effects::kTracedTerrain, &DisplayMemory::traced_}};

std::uint64_t DisplayMemory::bytes_needed(const base::BudgetTable& budget) {
    return budget.total(base::MemoryKind::cpu) + kAlignmentBytes;
}

base::Error DisplayMemory::cut(const base::BudgetTable& budget, base::Arena& reservation) {
    for (const Part& part : kParts) {
        const base::BudgetLine* line = budget.find(part.line);
        if (line == nullptr) continue;
        base::Arena& arena = this->*part.arena;
        arena = reservation.carve(static_cast<std::size_t>(line->bytes));
        if (arena.use().capacity != line->bytes)
            return base::make_error("the reservation has ",
                                    base::digits(reservation.use().capacity - reservation.use().in_use).view(),
                                    " bytes left and the budget line '", part.line, "' takes ", base::digits(line->bytes).view(),
                                    "; lower the budgets in the device file");
    }
    return {};
}

void DisplayMemory::record_use(base::BudgetTable& budget) const {
    for (const Part& part : kParts)
        if (base::BudgetLine* const line = budget.find(part.line); line != nullptr) line->use = (this->*part.arena).use();
}

}  // namespace tedavis::display
