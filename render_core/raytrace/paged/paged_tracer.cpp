#include "render_core/raytrace/paged/paged_tracer.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::raytrace {
namespace {

std::uint32_t chunks_of(std::uint32_t columns, std::uint32_t rows) {
    constexpr std::uint32_t kCells = ChunkHeights<float>::kCells;
    return (columns + kCells - 2) / kCells * ((rows + kCells - 2) / kCells);
}

std::uint32_t most_tasks(std::uint32_t slots, std::uint32_t rays, std::uint32_t task_rays) {
    return slots + rays / task_rays + 1;
}

/// Where a ray looks for the surface after so many turns.
HitSide side_of(std::uint32_t side_changes) { return side_changes % 2 == 0 ? HitSide::above : HitSide::below; }

void set_origin(RayPacket& p, std::uint32_t lane, const glm::dvec3& origin) {
    const double column = std::floor(origin.x), row = std::floor(origin.y), z = std::floor(origin.z);
    p.column[lane] = static_cast<std::int32_t>(column);
    p.row[lane] = static_cast<std::int32_t>(row);
    p.z[lane] = static_cast<std::int32_t>(z);
    p.column_fraction[lane] = static_cast<float>(origin.x - column);
    p.row_fraction[lane] = static_cast<float>(origin.y - row);
    p.z_fraction[lane] = static_cast<float>(origin.z - z);
}

void set_direction(RayPacket& p, std::uint32_t lane, const Ray& ray) {
    p.direction_x[lane] = ray.direction.x;
    p.direction_y[lane] = ray.direction.y;
    p.direction_z[lane] = ray.direction.z;
    p.to[lane] = ray.to;
    p.gap[lane] = ray.gap;
}

}  // namespace

template <class Height>
struct PagedTracer<Height>::Job {
    const PagedRays* rays;
    const PacketKernel<Height>* kernel;
    base::Span<Hit> hits;
    base::Span<HitCell<Height>> cells;
    CellSurface surface;
    bool from_below;
    TracedNodes<Height> highest, lowest;  // of chunks
};

template <class Height>
std::uint64_t PagedTracer<Height>::bytes_needed(std::uint32_t columns, std::uint32_t rows, const PagedSettings& settings) {
    const std::uint64_t chunks = chunks_of(columns, rows), rays = settings.most_rays;
    const std::uint64_t tasks = most_tasks(settings.slots, settings.most_rays, kTaskRays);
    return ChunkBounds<Height>::bytes_needed(columns, rows) +
           ChunkSlots<Height>::bytes_needed(settings.slots, chunks_of(columns, rows)) +
           rays * (sizeof(RayState) + sizeof(std::uint32_t)) + (chunks + std::min(chunks, rays)) * sizeof(std::uint32_t) +
           tasks * sizeof(Task) + settings.slots * sizeof(Load) + 256;
}

template <class Height>
typename PagedTracer<Height>::Started PagedTracer<Height>::start(ChunkHeights<Height>& heights, const PagedSettings& settings,
                                                                 base::Arena& arena) {
    TEDAVIS_CHECK(settings.slots > 0 && settings.most_rays > 0 && settings.desks > 0);
    heights_ = &heights;
    chunk_columns_ = heights.chunk_columns();
    desks_ = settings.desks;
    max_side_changes_ = 2 * (heights.columns() + heights.rows());
    const std::uint32_t chunks = chunk_columns_ * heights.chunk_rows();
    using BoundsStarted = typename ChunkBounds<Height>::Started;
    const BoundsStarted bounds = bounds_.start(heights, arena);
    if (bounds == BoundsStarted::unreadable) return Started::unreadable;
    if (bounds == BoundsStarted::no_room || !slots_.start(settings.slots, chunks, arena)) return Started::no_room;
    states_ = arena.allocate_array<RayState>(settings.most_rays);
    order_ = arena.allocate_array<std::uint32_t>(settings.most_rays);
    waiting_ = arena.allocate_array<std::uint32_t>(chunks);
    asked_ = arena.allocate_array<std::uint32_t>(std::min(chunks, settings.most_rays));
    tasks_ = arena.allocate_array<Task>(most_tasks(settings.slots, settings.most_rays, kTaskRays));
    loads_ = arena.allocate_array<Load>(settings.slots);
    if (states_.empty() || order_.empty() || waiting_.empty() || asked_.empty() || tasks_.empty() || loads_.empty())
        return Started::no_room;
    std::fill(waiting_.begin(), waiting_.end(), kNone);
    return Started::yes;
}

/// Tiles of 8 x 4 pixels, which pass the same chunks. Rays that are out of reach are none of them.
template <class Height>
std::uint32_t PagedTracer<Height>::order_rays(const PagedRays& rays, base::Span<const Hit> hits) {
    constexpr std::uint32_t kAcross = 8, kDown = 4;
    std::uint32_t count = 0;
    const auto add = [&](std::uint32_t n, const Ray& ray) {
        states_[n] = {ray.from, 0, 0, 0, 0, kNone};
        if (is_in_reach(ray.origin)) order_[count++] = n;
    };
    if (rays.cameras.empty()) {
        for (std::uint32_t n = 0; n < rays.count(); ++n)
            if (hits[n].side == HitSide::none) add(n, rays.single[n]);
        return count;
    }
    Ray ray = rays.at(0);
    for (std::uint32_t top = 0; top < rays.height; top += kDown)
        for (std::uint32_t left = 0; left < rays.width; left += kAcross) {
            // A tile of a picture has whole ones of these.
            if (!rays.have_one_origin()) ray = rays.at(top * rays.width + left);
            for (std::uint32_t y = top; y < std::min(top + kDown, rays.height); ++y)
                for (std::uint32_t x = left; x < std::min(left + kAcross, rays.width); ++x)
                    if (hits[y * rays.width + x].side == HitSide::none) add(y * rays.width + x, ray);
        }
    return count;
}

template <class Height>
void PagedTracer<Height>::add_tasks(std::uint32_t chunk, std::uint32_t slot, std::uint32_t first, std::uint32_t end) {
    for (; first < end; first += kTaskRays) tasks_[task_count_++] = {chunk, slot, first, std::min(first + kTaskRays, end)};
}

template <class Height>
void PagedTracer<Height>::run_tasks(const Job& job, base::Workers& workers) {
    struct Work {
        PagedTracer* self;
        const Job* job;
    } work{this, &job};
    workers.parallel_for(
        task_count_,
        [](void* context, std::uint32_t n) {
            const Work& all = *static_cast<const Work*>(context);
            all.self->advance(*all.job, all.self->tasks_[n]);
        },
        &work);
    task_count_ = 0;
}

template <class Height>
void PagedTracer<Height>::advance(const Job& job, const Task& task) {
    const std::uint32_t lanes = job.kernel->lanes;
    RayPacket packet{};
    if (job.rays->have_one_origin())
        for (std::uint32_t lane = 0; lane < lanes; ++lane) set_origin(packet, lane, job.rays->cameras[0].origin);
    for (std::uint32_t first = task.first; first < task.end; first += lanes) {
        const std::uint32_t count = std::min(lanes, task.end - first);
        const std::uint32_t* const rays = order_.data() + first;
        const std::uint32_t inside = count == 32 ? ~0u : (1u << count) - 1;
        load_packet(job, rays, count, packet);
        packet.begin = packet.pass = packet.ask = packet.hit = packet.beyond = 0;
        if (task.slot == kNone)
            packet.begin = inside;
        else
            cross(job, task, rays, inside, packet);
        seek(job, rays, inside, packet);
    }
}

template <class Height>
void PagedTracer<Height>::load_packet(const Job& job, const std::uint32_t* rays, std::uint32_t count, RayPacket& packet) const {
    for (std::uint32_t lane = 0; lane < count; ++lane) {
        const RayState& state = states_[rays[lane]];
        const Ray ray = job.rays->at(rays[lane]);
        if (!job.rays->have_one_origin()) set_origin(packet, lane, ray.origin);
        set_direction(packet, lane, ray);
        packet.from[lane] = state.from;
        packet.t[lane] = state.t;
        packet.at_column[lane] = state.column;
        packet.at_row[lane] = state.row;
    }
}

/// Of a chunk's own cells: at the end of the grid there are fewer than its slot has room for.
template <class Height>
TracedNodes<Height> PagedTracer<Height>::nodes_of(const HeightMipmap<Height>& bounds, std::int32_t column,
                                                  std::int32_t row) const {
    TracedNodes<Height> nodes(bounds);
    nodes.columns = std::min(nodes.columns, bounds_.layout().columns[0] - column);
    nodes.rows = std::min(nodes.rows, bounds_.layout().rows[0] - row);
    return nodes;
}

/// Through the chunk that they wait for.
template <class Height>
void PagedTracer<Height>::cross(const Job& job, const Task& task, const std::uint32_t* rays, std::uint32_t inside,
                                RayPacket& packet) {
    const auto column = static_cast<std::int32_t>(task.chunk % chunk_columns_ * ChunkHeights<Height>::kCells);
    const auto row = static_cast<std::int32_t>(task.chunk / chunk_columns_ * ChunkHeights<Height>::kCells);
    std::uint32_t below = 0;
    for (std::uint32_t left = inside, lane = 0; left != 0; left >>= 1, ++lane)
        below |= (states_[rays[lane]].side_changes & 1) << lane;
    if (const std::uint32_t above = inside & ~below; above != 0)
        job.kernel->cross(nodes_of(slots_.maxima(task.slot), column, row), job.surface, HitSide::above, column, row, above,
                          packet);
    if (below != 0)
        job.kernel->cross(nodes_of(slots_.minima(task.slot), column, row), job.surface, HitSide::below, column, row, below,
                          packet);
    packet.pass = inside & ~packet.hit;
    for (std::uint32_t lane = 0; lane < RayPacket::kMaxLanes; ++lane)
        if ((packet.hit >> lane & 1) != 0) keep_hit(job, task, rays[lane], lane, packet);
}

/// A ray that is beyond the surface turns and begins again there, as trace_ray() has it.
template <class Height>
void PagedTracer<Height>::keep_hit(const Job& job, const Task& task, std::uint32_t ray, std::uint32_t lane, RayPacket& packet) {
    RayState& state = states_[ray];
    if ((packet.beyond >> lane & 1) != 0) {
        if (!job.from_below || ++state.side_changes >= max_side_changes_) return;
        state.from = packet.from[lane] = packet.hit_t[lane];
        packet.begin |= 1u << lane;
        return;
    }
    job.hits[ray] = {side_of(state.side_changes), packet.hit_t[lane], static_cast<std::uint32_t>(packet.hit_column[lane]),
                     static_cast<std::uint32_t>(packet.hit_row[lane])};
    if (!job.cells.empty()) job.cells[ray] = cell_of(job, task, ray);
}

/// Of a ray that has its hit, in the chunk that it waited for.
template <class Height>
HitCell<Height> PagedTracer<Height>::cell_of(const Job& job, const Task& task, std::uint32_t ray) const {
    constexpr std::uint32_t kCells = ChunkHeights<Height>::kCells;
    const Hit& hit = job.hits[ray];
    const HeightGrid<Height>& grid = slots_.maxima(task.slot).grid();
    const std::uint32_t column = hit.column - task.chunk % chunk_columns_ * kCells;
    const std::uint32_t row = hit.row - task.chunk / chunk_columns_ * kCells;
    return {hit_place(job.rays->at(ray), hit),
            {grid.at(column, row), grid.at(column + 1, row), grid.at(column, row + 1), grid.at(column + 1, row + 1)}};
}

/// To the next chunk; those that end without one have met nothing.
template <class Height>
void PagedTracer<Height>::seek(const Job& job, const std::uint32_t* rays, std::uint32_t inside, RayPacket& packet) {
    std::uint32_t below = 0;
    for (std::uint32_t left = inside, lane = 0; left != 0; left >>= 1, ++lane)
        below |= (states_[rays[lane]].side_changes & 1) << lane;
    const std::uint32_t go_on = packet.begin | packet.pass;
    if ((go_on & ~below) != 0) job.kernel->seek(job.highest, HitSide::above, go_on & ~below, packet);
    if ((go_on & below) != 0) job.kernel->seek(job.lowest, HitSide::below, go_on & below, packet);
    for (std::uint32_t left = inside, lane = 0; left != 0; left >>= 1, ++lane) {
        RayState& state = states_[rays[lane]];
        state.link = kNone;
        if ((packet.ask >> lane & 1) == 0) continue;
        state.t = packet.t[lane];
        state.column = packet.at_column[lane];
        state.row = packet.at_row[lane];
        state.link = static_cast<std::uint32_t>(packet.chunk_row[lane]) * chunk_columns_ +
                     static_cast<std::uint32_t>(packet.chunk_column[lane]);
    }
}

/// Rays of a pass to the chunks that they wait for: the first of them first.
template <class Height>
void PagedTracer<Height>::queue_rays(std::uint32_t count) {
    for (std::uint32_t n = count; n-- > 0;) {
        RayState& state = states_[order_[n]];
        const std::uint32_t chunk = state.link;
        if (chunk == kNone) continue;
        if (waiting_[chunk] == kNone) asked_[asked_count_++] = chunk;
        state.link = waiting_[chunk];
        waiting_[chunk] = order_[n];
    }
}

template <class Height>
std::uint32_t PagedTracer<Height>::distance(std::uint32_t chunk) const {
    const std::int64_t across = std::int64_t{chunk % chunk_columns_} - near_column_;
    const std::int64_t down = std::int64_t{chunk / chunk_columns_} - near_row_;
    return static_cast<std::uint32_t>(std::abs(across) + std::abs(down));
}

/// Selects the nearest of the requested chunks, as many as there are slots, with their rays.
template <class Height>
std::uint32_t PagedTracer<Height>::take_pass(const Job& job, PagedWork& work, base::Workers& workers) {
    std::uint32_t nearest = kNone, left = 0, taken = 0, count = 0;
    for (std::uint32_t n = 0; n < asked_count_; ++n) nearest = std::min(nearest, distance(asked_[n]));
    for (std::uint32_t n = 0; n < asked_count_; ++n) {
        const std::uint32_t chunk = asked_[n];
        if (taken == slots_.size() || distance(chunk) != nearest) {
            asked_[left++] = chunk;
            continue;
        }
        ++taken;
        const auto place = slots_.take(chunk);
        if (place.must_be_filled) loads_[load_count_++] = {place.slot, true};
        const std::uint32_t first = count;
        for (std::uint32_t ray = waiting_[chunk]; ray != kNone; ray = states_[ray].link) order_[count++] = ray;
        waiting_[chunk] = kNone;
        add_tasks(chunk, place.slot, first, count);
    }
    asked_count_ = left;
    load_chunks(work, workers);
    run_tasks(job, workers);
    return count;
}

template <class Height>
void PagedTracer<Height>::load_chunks(PagedWork& work, base::Workers& workers) {
    workers.parallel_for(
        std::min(desks_, load_count_),
        [](void* context, std::uint32_t desk) {
            PagedTracer& self = *static_cast<PagedTracer*>(context);
            for (std::uint32_t n = desk; n < self.load_count_; n += self.desks_)
                self.loads_[n].is_sound = self.slots_.fill(self.loads_[n].slot, *self.heights_, self.bounds_, desk);
        },
        this);
    for (std::uint32_t n = 0; n < load_count_; ++n) work.damaged += loads_[n].is_sound ? 0 : 1;
    work.loads += load_count_;
    load_count_ = 0;
}

template <class Height>
PagedWork PagedTracer<Height>::trace(const PagedRays& rays, CellSurface surface, bool from_below,
                                     const PacketKernel<Height>& kernel, base::Workers& workers, base::Span<Hit> hits,
                                     base::Span<HitCell<Height>> cells) {
    constexpr std::uint32_t kCells = ChunkHeights<Height>::kCells, kPosts = ChunkHeights<Height>::kPosts;
    TEDAVIS_CHECK(rays.count() <= states_.size() && hits.size() == rays.count());
    TEDAVIS_CHECK(cells.empty() || cells.size() == hits.size());
    TEDAVIS_CHECK(rays.cameras.size() <= 1 || rays.cameras.size() == ViewTiles(rays.width, rays.height).count());
    PagedWork work;
    if (!rays.goes_on) std::fill(hits.begin(), hits.end(), Hit{});
    std::uint32_t count = order_rays(rays, hits);
    if (count == 0) return work;
    const Job job{&rays,
                  &kernel,
                  hits,
                  cells,
                  surface,
                  from_below,
                  TracedNodes<Height>(bounds_.layout(), bounds_.maxima()),
                  TracedNodes<Height>(bounds_.layout(), bounds_.minima())};
    const glm::dvec3 origin = rays.at(order_[0]).origin;
    near_column_ = static_cast<std::int64_t>(std::floor(origin.x / kCells));
    near_row_ = static_cast<std::int64_t>(std::floor(origin.y / kCells));
    asked_count_ = 0;
    add_tasks(kNone, kNone, 0, count);
    run_tasks(job, workers);
    queue_rays(count);
    while (asked_count_ > 0) {
        count = take_pass(job, work, workers);
        queue_rays(count);
        ++work.passes;
        work.crossings += count;
    }
    work.loaded_bytes = std::uint64_t{work.loads} * kPosts * kPosts * sizeof(Height);
    return work;
}

template class PagedTracer<std::int16_t>;
template class PagedTracer<float>;

}  // namespace tedavis::raytrace
