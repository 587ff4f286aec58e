/// The exact tracer over heights that need not be in memory; its hits equal those of trace_ray() over all heights, bit for bit.
///
/// The bounds of chunks stay in memory (chunk_bounds.hpp); a limited number of chunks is in memory at a time (chunk_slots.hpp).
/// A ray passes over the chunks that it cannot hit and waits before the first that it may hit. Each pass takes as many of the
/// requested chunks as there are slots, those nearest to the rays' origin first, and advances all rays that wait for them
/// through them and to their next chunk (after Pharr et al. 1997, "Rendering complex scenes with memory-coherent ray tracing").
/// The distance of rays from a common origin only grows, so each chunk is loaded once per picture, whatever the number of
/// slots, except where rays that change their side of the surface request it again.
///
/// Memory  an arena at start. Thread  trace() uses the workers; the result does not depend on their number, nor on the slots.
#pragma once

#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/paged/chunk_slots.hpp"
#include "render_core/raytrace/paged/hit_cell.hpp"
#include "render_core/raytrace/paged/paged_rays.hpp"
#include "render_core/raytrace/paged/ray_packet.hpp"

namespace tedavis::raytrace {

struct PagedSettings {
    std::uint32_t slots = 1, most_rays = 0;
    std::uint32_t desks = 1;  ///< desks of the ChunkHeights: threads that load concurrently
};

/// Counters of a call of trace().
struct PagedWork {
    std::uint32_t passes = 0, loads = 0;
    std::uint32_t damaged = 0;    ///< failed loads: chunks that count as without heights
    std::uint64_t crossings = 0;  ///< traversals of a chunk by a ray
    std::uint64_t loaded_bytes = 0;
};

template <class Height>
class PagedTracer {
public:
    enum class Started : std::uint8_t { yes, no_room, unreadable };

    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t columns, std::uint32_t rows, const PagedSettings& settings);
    /// `heights` must outlive the tracer.
    [[nodiscard]] Started start(ChunkHeights<Height>& heights, const PagedSettings& settings, base::Arena& arena);
    /// Writes one hit per ray. `from_below` enables hits from below, as TracedField::minima does. A damaged chunk counts as
    /// without heights while it is in memory. `cells` receives the cells of hits, one per ray, or is empty.
    PagedWork trace(const PagedRays& rays, CellSurface surface, bool from_below, const PacketKernel<Height>& kernel,
                    base::Workers& workers, base::Span<Hit> hits, base::Span<HitCell<Height>> cells = {});

    [[nodiscard]] const ChunkSlots<Height>& slots() const { return slots_; }

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu, kTaskRays = 256;

    /// State of a ray that is not finished.
    struct RayState {
        float from, t;
        std::int32_t column, row;    ///< mirrored
        std::uint32_t side_changes;  ///< changes of side: it searches the surface from above, then from below, and so on
        std::uint32_t link;          ///< the chunk that it waits for, then the next ray in that chunk's list
    };
    struct Task {
        std::uint32_t chunk, slot, first, end;  ///< in order_
    };
    struct Load {
        std::uint32_t slot;
        bool is_sound;
    };
    struct Job;

    [[nodiscard]] std::uint32_t order_rays(const PagedRays& rays, base::Span<const Hit> hits);
    void add_tasks(std::uint32_t chunk, std::uint32_t slot, std::uint32_t first, std::uint32_t end);
    void run_tasks(const Job& job, base::Workers& workers);
    void advance(const Job& job, const Task& task);
    void load_packet(const Job& job, const std::uint32_t* rays, std::uint32_t count, RayPacket& packet) const;
    void cross(const Job& job, const Task& task, const std::uint32_t* rays, std::uint32_t inside, RayPacket& packet);
    [[nodiscard]] TracedNodes<Height> nodes_of(const HeightMipmap<Height>& bounds, std::int32_t column, std::int32_t row) const;
    void keep_hit(const Job& job, const Task& task, std::uint32_t ray, std::uint32_t lane, RayPacket& packet);
    [[nodiscard]] HitCell<Height> cell_of(const Job& job, const Task& task, std::uint32_t ray) const;
    void seek(const Job& job, const std::uint32_t* rays, std::uint32_t inside, RayPacket& packet);
    void queue_rays(std::uint32_t count);
    std::uint32_t take_pass(const Job& job, PagedWork& work, base::Workers& workers);
    [[nodiscard]] std::uint32_t distance(std::uint32_t chunk) const;
    void load_chunks(PagedWork& work, base::Workers& workers);

    ChunkHeights<Height>* heights_ = nullptr;
    std::uint32_t chunk_columns_ = 0, desks_ = 1, max_side_changes_ = 0;
    ChunkBounds<Height> bounds_;
    ChunkSlots<Height> slots_;
    base::Span<RayState> states_;
    base::Span<std::uint32_t> order_;    ///< rays of a pass
    base::Span<std::uint32_t> waiting_;  ///< by chunk: the first waiting ray, or kNone
    base::Span<std::uint32_t> asked_;    ///< chunks that rays wait for
    base::Span<Task> tasks_;
    base::Span<Load> loads_;
    std::uint32_t asked_count_ = 0, task_count_ = 0, load_count_ = 0;
    std::int64_t near_column_ = 0, near_row_ = 0;  ///< chunk that distances are from
};

}  // namespace tedavis::raytrace
