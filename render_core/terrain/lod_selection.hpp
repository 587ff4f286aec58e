/// Chooses the chunks to draw for one view: every place of the database is covered once, neighbours differ by at most one level,
/// and the projected error stays below tau unless a budget, the data or what has arrived forbids it.
///
/// Refinement  from the roots: the chunk with the largest projected error in view is split first, after the neighbours that this
///             forces (2:1 across edges, round the Earth too). A split happens with all that it forces or not at all.
/// Budgets     of triangles, chunks and milliseconds hold for what is in view, at every moment of the refinement. Where they
///             forbid tau, refinement starts again and splits by error times visibility; what neighbours do to a chunk counts
///             among its errors, and splits that do not fit are passed over. So the error stays where it is seen least.
///             Visibility is exp(-distance * haze_per_m), 0.05 at least.
/// Coasts      chunks with sea and land are split until half a texel of their attribute page is a tau; this is no part of the
///             worst error, and comes after true errors where budgets end the refinement.
/// Image       where a drape is shown and tau is met everywhere, chunks are split whose texels are large in view, the largest
///             first, with what the budgets leave. Should that take an error over tau, all is chosen again without.
/// Lifts       with `conservative_up` every vertex is raised so far that the drawn surface is nowhere below the true one: by its
///             chunk's own lift; on borders and corners by the largest of all chunks that share them, so that shared vertices
///             agree (chunk_lift.hpp).
/// Neighbours  what they do to a chunk (strips beside coarser ones, lifts) is judged when all is chosen; where it takes an error
///             over tau, they are split as well.
/// Result      depends on view, settings, entries and availability only.
/// Memory      from an arena at start(). Thread  one.
#pragma once

#include <cstdint>
#include <limits>

#include "render_core/base/memory_budget.hpp"
#include "render_core/terrain/chunk_catalogue.hpp"
#include "render_core/terrain/chunk_lift.hpp"
#include "render_core/terrain/lod_tree.hpp"
#include "render_core/terrain/part_cache.hpp"
#include "render_core/terrain/projected_error.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::terrain {

/// Cells, of two triangles, are not made finer on the screen for the sake of heights alone.
inline constexpr double kFinestCell_px = 3;

/// Predicted time of the terrain pass: measured on the device.
struct CostModel {
    double ns_per_triangle = 0;
    double us_per_chunk = 0;
};

/// An image over the terrain. Chunks are split for its sake while its texels are larger on the screen than kLargestTexel_px.
struct DrapeDetail {
    double texel_m = 0;       ///< of the finest pages; 0: no image is shown
    std::uint32_t level = 0;  ///< of the finest pages
};
inline constexpr double kLargestTexel_px = 2;

struct LodSettings {
    double tau_px = 1;
    std::uint32_t max_triangles = 250000;
    std::uint32_t max_chunks = 512;
    std::uint32_t max_parts = std::numeric_limits<std::uint32_t>::max();  ///< chunks in view and all above them, without roots
    double max_ms = std::numeric_limits<double>::infinity();
    CostModel cost;
    /// Chunks whose boxes reach into this span of depth are drawn twice, and cost twice their triangles. Of nothing: none is.
    DepthSpan twice{1, 0};
    double haze_per_m = 0;
    bool conservative_up = false;
    /// 0..1: how much an error of height counts as such, in pixels of its length, down to kFinestCell_px: where colours and lines
    /// show heights though their errors do not displace the picture, as on a map. No part of the worst error.
    double height_weight = 0;
    /// What budgets leave after tau is spent on it. No part of any error.
    DrapeDetail drape;
};

struct SelectedChunk {
    ChunkKey key = kNoChunk;
    const ChunkEntry* entry = nullptr;  ///< valid in this frame
    SlotIndex slot = kNoSlot;           ///< of its payload; kNoSlot only in ideal selections
    std::uint8_t coarser_edges = 0;     ///< EdgeBit
    float error_px = 0;
    float distance_m = 0;  ///< of the chunk's centre from the eye
    ChunkLift lift;        ///< zeros without conservative_up
};

enum class SelectionKind : std::uint8_t {
    ideal,  ///< as if every payload had arrived
    drawn,  ///< a chunk is split only where all its children in view are available
};

/// What kept the worst chunk from being split.
enum class LodStop : std::uint8_t { met, triangles, chunks, milliseconds, nodes, not_arrived, at_data_limit };
[[nodiscard]] const char* to_string(LodStop reason) noexcept;

struct LodResult {
    std::uint32_t chunks = 0;
    std::uint32_t triangles = 0;  ///< upper bound, without coarser edges; those drawn twice count twice
    double predicted_ms = 0;
    double tau_reached_px = 0;  ///< tau, or the worst error where that is more
    double worst_error_px = 0;
    double worst_coarse_px = 0;       ///< of chunks that the data would allow to be finer
    double worst_waiting_px = 0;      ///< of chunks that wait for finer ones to arrive: error times visibility
    ChunkKey worst_chunk = kNoChunk;  ///< kNoChunk: nothing in view
    LodStop reason = LodStop::met;
    bool within_budget = false;  ///< false only when the roots in view alone exceed the budgets: nothing may be drawn
};

class LodRefinement;

class LodSelector {
public:
    /// `nodes`: chunks that one selection may look at, roots and hidden ones included; 4 times the chunks drawn is plenty.
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t nodes);

    /// `selected` gets the chosen chunks in view, nearest first; its size is one more limit of chunks.
    [[nodiscard]] LodResult select(ChunkCatalogue& catalogue, const View& view, const LodSettings& settings, SelectionKind kind,
                                   base::Span<SelectedChunk> selected);

    /// What the last selection needs in memory: its chunks in view and all through which it came to them; then their siblings,
    /// for when the view turns. Most urgent first: by the error that is shown without it, ancestors before their descendants.
    /// Returns how many; what does not fit is left out at the end.
    [[nodiscard]] std::uint32_t wanted(base::Span<WantedChunk> out);

    [[nodiscard]] const base::ResourceUse& use() const { return tree_.use(); }  ///< nodes
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t nodes);

private:
    [[nodiscard]] static bool refine(LodRefinement& refinement, double reach_m);
    void collect(const ChunkCatalogue& catalogue, const View& view, const LodSettings& settings, SelectionKind kind,
                 const LodRefinement& refinement, base::Span<SelectedChunk> selected, LodResult& result) const;
    [[nodiscard]] double shown_without(NodeIndex node) const;

    LodTree tree_;
    base::Span<NodeIndex> heap_;
};

}  // namespace tedavis::terrain
