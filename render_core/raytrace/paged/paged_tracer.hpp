/// The exact tracer over heights that need not be in memory: bit for bit what trace_ray() finds over all of them.
///
/// The bounds of chunks stay in memory (chunk_bounds.hpp), a number of chunks does as rays need them (chunk_slots.hpp). A ray
/// goes from chunk to chunk over those that it cannot meet and stops before the first that it may; there it waits. A pass takes
/// as many of the chunks that are asked for as there are slots, those nearest to where the rays begin, and takes all rays that
/// wait for them through them and on to their next (after Pharr et al. 1997, "Rendering complex scenes with memory-coherent ray
/// tracing"). Rays from one place only get farther away from it: so each chunk is loaded once a picture, whatever the slots, but
/// for those that rays ask for anew as they change their side of the surface.
///
/// Memory  an arena at start. Thread  trace() uses the workers; the result does not depend on their number, nor on the slots.
#pragma once

#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/paged/chunk_slots.hpp"
#include "render_core/raytrace/paged/paged_rays.hpp"
#include "render_core/raytrace/paged/ray_packet.hpp"

namespace tedavis::raytrace {

struct PagedSettings {
    std::uint32_t slots = 1, most_rays = 0;
    std::uint32_t desks = 1;  ///< of the ChunkHeights; threads that load at once
};

/// What a call of trace() did.
struct PagedWork {
    std::uint32_t passes = 0, loads = 0;
    std::uint32_t damaged = 0;    ///< of the loads: chunks that count as without heights
    std::uint64_t crossings = 0;  ///< rays through chunks
    std::uint64_t loaded_bytes = 0;
};

template <class Height>
class PagedTracer {
public:
    enum class Started : std::uint8_t { yes, no_room, unreadable };

    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t columns, std::uint32_t rows, const PagedSettings& settings);
    /// The heights are borrowed and must stay.
    [[nodiscard]] Started start(ChunkHeights<Height>& heights, const PagedSettings& settings, base::Arena& arena);
    /// A hit a ray. `from_below`: as with TracedField::minima. A damaged chunk counts as without heights while it is in memory.
    PagedWork trace(const PagedRays& rays, CellSurface surface, bool from_below, const PacketKernel<Height>& kernel,
                    base::Workers& workers, base::Span<Hit> hits);

    [[nodiscard]] const ChunkSlots<Height>& slots() const { return slots_; }

private:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu, kTaskRays = 256;

    /// Of a ray that is not done.
    struct Way {
        float from, t;
        std::int32_t column, row;  ///< mirrored
        std::uint32_t turns;       ///< it looks for the surface from above, then from below, then from above...
        std::uint32_t link;        ///< the chunk that it waits for, then the next ray that waits there
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
    void keep_meeting(const Job& job, std::uint32_t ray, std::uint32_t lane, RayPacket& packet);
    void seek(const Job& job, const std::uint32_t* rays, std::uint32_t inside, RayPacket& packet);
    void queue_rays(std::uint32_t count);
    std::uint32_t take_pass(const Job& job, PagedWork& work, base::Workers& workers);
    [[nodiscard]] std::uint32_t distance(std::uint32_t chunk) const;
    void load_chunks(PagedWork& work, base::Workers& workers);

    ChunkHeights<Height>* heights_ = nullptr;
    std::uint32_t chunk_columns_ = 0, desks_ = 1, most_turns_ = 0;
    ChunkBounds<Height> bounds_;
    ChunkSlots<Height> slots_;
    base::Span<Way> ways_;
    base::Span<std::uint32_t> order_;    ///< rays of a pass
    base::Span<std::uint32_t> waiting_;  ///< by chunk: the first ray, or kNone
    base::Span<std::uint32_t> asked_;    ///< chunks that rays wait for
    base::Span<Task> tasks_;
    base::Span<Load> loads_;
    std::uint32_t asked_count_ = 0, task_count_ = 0, load_count_ = 0;
    std::int64_t near_column_ = 0, near_row_ = 0;  ///< chunk that distances are from
};

}  // namespace tedavis::raytrace
