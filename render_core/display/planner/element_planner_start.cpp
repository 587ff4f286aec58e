#include <algorithm>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::display {
namespace {

constexpr std::uint32_t kStandingQuarters = 3;  // of the room; the rest moves
constexpr std::uint32_t kVerticesAPiece = 64, kIndicesAVertex = 3;
constexpr std::uint64_t kQuarterVertex = 4 * (sizeof(draw::SolidVertex) + kIndicesAVertex * sizeof(std::uint16_t));
constexpr std::uint32_t kFewestVertices = 256;  // of the part of surfaces that moves, and of links

}  // namespace

SolidRooms solid_rooms(const base::BudgetTable& budget) {
    const auto quarter = static_cast<std::uint32_t>(budget.find(effects::kSceneSolidVertices)->bytes / kQuarterVertex);
    const auto room = [&](std::uint32_t quarters) {
        const std::uint32_t vertices = quarter * quarters;
        return draw::SolidRoom{vertices, vertices * kIndicesAVertex, vertices / kVerticesAPiece};
    };
    return {room(kStandingQuarters), room(4 - kStandingQuarters)};
}

base::Error ElementPlanner::start(bool has_instances, const base::BudgetTable& budget, const Memory& memory) {
    const SolidRooms rooms = solid_rooms(budget);
    standing_ = draw::SolidBatch(memory.solids, rooms.standing);
    moving_ = draw::SolidBatch(memory.solids, rooms.moving);
    if (base::Error error = glyphs_.start(has_instances, budget, memory.glyphs)) return error;
    if (rooms.moving.vertices < kFewestVertices)
        return base::shortage_error(*budget.find(effects::kSceneSolidVertices), kFewestVertices * kQuarterVertex, "surfaces");
    if (draw::max_link_vertices(budget) < kFewestVertices)
        return base::shortage_error(*budget.find(effects::kSceneBillboardVertices),
                                    4 * kFewestVertices * draw::QuadBatch::kBytesAVertex, "icons and names");
    if (!mesh_.start(memory.solids) || !start_scratch(memory.solids, rooms.standing.vertices))
        return base::shortage_error(effects::kSceneSolids, memory.solids);
    if (!sheet_.start(memory.billboards) || !labels_.start(memory.billboards) || !own_.start(memory.billboards) ||
        !traffic_.start(memory.billboards) || !links_.start(memory.billboards, draw::max_link_vertices(budget)) ||
        !signs_.start(memory.billboards, draw::max_sign_vertices(budget)))
        return base::shortage_error(effects::kSceneBillboards, memory.billboards);
    is_started_ = true;
    return {};
}

/// Builders without state between elements share their memory.
bool ElementPlanner::start_scratch(base::Arena& memory, std::uint32_t batch_vertices) {
    const std::uint32_t rings = draw::TubeSolids::rings_for(batch_vertices);
    const draw::IsosurfaceRoom room = draw::IsosurfaceRoom::beside(batch_vertices);
    const std::uint64_t bytes = std::max(draw::TubeSolids::bytes_needed(rings), draw::IsosurfaceSolids::bytes_needed(room));
    base::Arena for_tubes = memory.carve(bytes), for_isosurfaces = for_tubes, for_cues = for_tubes;
    return tubes_.start(for_tubes, rings) && isosurfaces_.start(for_isosurfaces, room) && cues_.start(for_cues, rings);
}

}  // namespace tedavis::display
