/// The processor memory of a display: one arena for each line of the device's budget table that it uses.
///
/// Memory  of the reservation given to cut(). Thread  one. Failure  cut() gives one message that names the line.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/error.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "render_core/display/planner/spatial_data.hpp"
#include "render_core/display/planner/terrain_planner.hpp"

namespace tedavis::display {

class DisplayMemory {
public:
    /// Returns the bytes that a reservation must hold for a table.
    [[nodiscard]] static std::uint64_t bytes_needed(const base::BudgetTable& budget);

    /// Divides the reservation by the lines of the table. The lines for edges and for traced terrain are optional; all others are
    /// required, and every device file has them. An empty message means success.
    [[nodiscard]] base::Error cut(const base::BudgetTable& budget, base::Arena& reservation);
    /// Writes into the lines how much their owners use.
    void record_use(base::BudgetTable& budget) const;

    /// References to the arenas: valid as long as this object.
    [[nodiscard]] TerrainMemory terrain() { return {index_, records_, payloads_, attributes_, drape_, lod_, staging_}; }
    /// Empty where the device has no such line.
    [[nodiscard]] base::Arena& traced_terrain() { return traced_; }
    /// Empty where the device has no such line.
    [[nodiscard]] base::Arena& picture_edges() { return edges_; }
    [[nodiscard]] base::Arena& symbology() { return symbology_; }
    [[nodiscard]] base::Arena& frames() { return frames_; }
    [[nodiscard]] base::Arena& memories() { return memories_; }
    [[nodiscard]] SpatialData::Memory scene() { return {scene_, slices_}; }
    [[nodiscard]] ElementPlanner::Memory elements() { return {solids_, glyphs_, billboards_}; }

private:
    struct Part {
        std::string_view line;
        base::Arena DisplayMemory::*arena;
    };
    static const Part kParts[17];

    base::Arena payloads_, index_, records_, attributes_, drape_, staging_, lod_, symbology_, scene_, slices_, solids_, glyphs_,
        billboards_, frames_, memories_, edges_, traced_;
};

}  // namespace tedavis::display
