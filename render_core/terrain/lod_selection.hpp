/// Chooses the chunks to draw for one view: every place of the database in view is covered once, neighbours differ by
/// at most one level, and the projected error stays below tau unless a budget forbids it.
///
/// Error     a displacement e at view depth z and off-axis tangent rho moves the projected point by at most
///           e * focal * sqrt(1 + rho^2) / z = e * focal * (1 + rho^2) / distance pixels.
///           `bound_m` of a chunk also bounds the strips that finer neighbours coarsen towards it; those lie within half
///           a chunk of it, so distances are taken to its box grown by that much.
/// Budgets   when triangles or slots do not suffice, tau is raised by steps of 2^(1/4) until they do; the reached tau is
///           reported. The result depends on view and settings only, never on earlier frames.
/// Memory    `states` holds one byte a chunk of the database; nothing is allocated. Thread: any.
#pragma once

#include <cstdint>

#include "render_core/base/span.hpp"
#include "render_core/terrain/terrain_database.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

struct SelectedChunk {
    ChunkIndex chunk = kNoChunk;
    std::uint8_t coarser_edges = 0;
    float error_px = 0;
    float distance_m = 0;  ///< of the chunk's centre from the eye
};

struct LodSettings {
    double tau_px = 1;
    std::uint32_t max_triangles = 250000;
    std::uint32_t max_chunks = 256;
};

struct LodResult {
    std::uint32_t chunks = 0;
    std::uint32_t triangles = 0;  ///< upper bound, without coarser edges
    double tau_reached_px = 0;
    double worst_error_px = 0;
    ChunkIndex worst_chunk = kNoChunk;
    bool within_budget = false;  ///< false only when the coarsest selection exceeds the budgets
};

/// `selected` gets the chosen chunks, nearest first.
[[nodiscard]] LodResult select_chunks(const TerrainDatabase& database, const View& view, const LodSettings& settings,
                                      base::Span<std::uint8_t> states, base::Span<ChunkIndex> work,
                                      base::Span<SelectedChunk> selected);

/// True when no point of the chunk's box can be in the view. Never true for a visible one.
[[nodiscard]] bool is_outside_view(const ChunkEntry& entry, const View& view);
/// The bound described above, in pixels; infinite when the eye is inside the grown box of an inexact chunk.
[[nodiscard]] double projected_error_px(const ChunkEntry& entry, const View& view);

}  // namespace tedavis::terrain
