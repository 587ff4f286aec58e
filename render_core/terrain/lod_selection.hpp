/// Chooses the chunks to draw for one view: the database is covered once, neighbours differ by at most one level, and the
/// projected error stays below tau unless a budget, the data or chunks that have not arrived prevent it.
///
/// Refinement  from the roots: the chunk with the largest projected error in view is split first, after the neighbours that this
///             forces (2:1 across edges, round the Earth too). A split happens with all that it forces or not at all.
/// Budgets     of triangles, chunks and milliseconds are held for the chunks in view at every step of the refinement. Where
///             they prevent tau, refinement restarts and splits by error times visibility; errors caused by neighbours count
///             too, and splits that do not fit are skipped. So the remaining error is where it is least visible. Visibility is
///             exp(-distance * haze_per_m), at least 0.05.
/// Coasts      chunks with sea and land are split until half a texel of their attribute page is at most tau on the screen. This
///             does not count in the worst error and has lower priority than true errors.
/// Image       where a drape is shown and tau is reached everywhere, the rest of the budgets is spent on chunks whose texels
///             are large on the screen, the largest first. Where that raises an error above tau, the selection is repeated
///             without it.
/// Lifts       with `conservative_up` every vertex is raised so far that the drawn surface is nowhere below the true one: by its
///             chunk's own lift; on borders and corners by the largest of all chunks that share them, so that shared vertices
///             agree (chunk_lift.hpp).
/// Neighbours  their effect on a chunk (strips beside coarser ones, lifts) is evaluated after the selection; where it raises an
///             error above tau, they are split as well.
/// Result      depends only on view, settings, entries and availability.
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

/// `height_weight` does not refine cells (of two triangles) that are smaller than this on the screen.
inline constexpr double kFinestCell_px = 3;

/// Model of the terrain pass's time, measured on the device.
struct CostModel {
    double ns_per_triangle = 0;
    double us_per_chunk = 0;
};

/// An image over the terrain. Chunks are split for it while its texels are larger on the screen than kLargestTexel_px.
struct DrapeDetail {
    double texel_m = 0;       ///< of the finest pages; 0: no image is shown
    std::uint32_t level = 0;  ///< of the finest pages
};
inline constexpr double kLargestTexel_px = 2;

struct LodSettings {
    double tau_px = 1;
    std::uint32_t max_triangles = 250000;
    std::uint32_t max_chunks = 512;
    std::uint32_t max_parts = std::numeric_limits<std::uint32_t>::max();  ///< chunks in view and their ancestors, without roots
    double max_ms = std::numeric_limits<double>::infinity();
    CostModel cost;
    /// Chunks whose boxes reach into this span of depth are drawn twice and cost twice their triangles. An empty span: none.
    DepthSpan twice{1, 0};
    double haze_per_m = 0;
    bool conservative_up = false;
    /// Weight 0..1 of an error of height itself, as if its length were seen in pixels, down to kFinestCell_px: for pictures
    /// such as a map, where colours and lines show heights although their errors do not displace the picture. It does not count
    /// in the worst error.
    double height_weight = 0;
    /// The image that the rest of the budgets is spent on after tau. It does not count in any error.
    DrapeDetail drape;
};

struct SelectedChunk {
    ChunkKey key = kNoChunk;
    const ChunkEntry* entry = nullptr;  ///< valid in this frame
    SlotIndex slot = kNoSlot;           ///< slot of its payload; kNoSlot only in ideal selections
    std::uint8_t coarser_edges = 0;     ///< EdgeBit
    float error_px = 0;
    float distance_m = 0;  ///< from the eye point to the chunk's centre
    ChunkLift lift;        ///< zeros without conservative_up
};

enum class SelectionKind : std::uint8_t {
    ideal,  ///< as if every payload had arrived
    drawn,  ///< a chunk is split only where all its children in view are available
};

/// Why the worst chunk was not split.
enum class LodStop : std::uint8_t { met, triangles, chunks, milliseconds, nodes, not_arrived, at_data_limit };
[[nodiscard]] const char* to_string(LodStop reason) noexcept;

struct LodResult {
    std::uint32_t chunks = 0;
    std::uint32_t triangles = 0;  ///< upper bound, without coarser edges; chunks drawn twice count twice
    double predicted_ms = 0;
    double tau_reached_px = 0;  ///< tau, or the worst error where that is more
    double worst_error_px = 0;
    double worst_coarse_px = 0;       ///< worst error of chunks for which the data have a finer level
    double worst_waiting_px = 0;      ///< the same for chunks that wait for finer ones to arrive: error times visibility
    ChunkKey worst_chunk = kNoChunk;  ///< kNoChunk: nothing in view
    LodStop reason = LodStop::met;
    bool within_budget = false;  ///< false only when the roots in view alone exceed the budgets: nothing may be drawn
};

class LodRefinement;

class LodSelector {
public:
    /// `nodes` is the number of chunks that one selection may examine, roots and hidden ones included; 4 times the drawn chunks
    /// suffice.
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t nodes);

    /// Writes the chosen chunks in view to `selected`, nearest first; its size is a further limit of the number of chunks.
    [[nodiscard]] LodResult select(ChunkCatalogue& catalogue, const View& view, const LodSettings& settings, SelectionKind kind,
                                   base::Span<SelectedChunk> selected);

    /// Writes the chunks that the last selection needs in memory: its chunks in view and their ancestors; then their siblings,
    /// for when the view turns. They are sorted by the error that is shown without them, largest first, ancestors before
    /// descendants. Returns their number; those that do not fit are left out at the end.
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
