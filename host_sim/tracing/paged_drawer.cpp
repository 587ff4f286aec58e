#include "host_sim/tracing/paged_drawer.hpp"

#include "host_sim/tracing/trace_report.hpp"

namespace tedavis::host_sim {
namespace {

using Tracer = raytrace::PagedTracer<float>;

std::uint64_t ground_bytes(const TracedGround& ground, std::uint32_t slots, std::uint32_t desks) {
    return raytrace::DatabaseChunks::bytes_needed(desks) +
           Tracer::bytes_needed(ground.columns(), ground.rows(), {slots, 1, desks});
}

}  // namespace

PagedDrawer::PagedDrawer(const TracedGround& ground, const raytrace::TraceSettings& settings, const TracedShotPlan& plan,
                         base::Workers& workers)
    : path_(ground.path()),
      surface_(settings.surface.kind == raytrace::SurfaceKind::bilinear ? raytrace::CellSurface::bilinear
                                                                        : raytrace::CellSurface::two_triangles),
      drawer_(ground, terrain_, settings, plan) {
    divide_memory(ground, plan, workers.concurrency());
    memory_.resize((use_.held_bytes + use_.ray_bytes) / 8 + 16);
    arena_ = base::Arena(memory_.data(), memory_.size() * 8);
    const bool is_started = chunks_.start(ground.database(), ground.window(), paging_.desks, arena_) &&
                            terrain_.start(tracer_, surface_, plan.width, plan.height, arena_);
    if (!is_started)
        throw UserError(path_ + ": its heights cannot be paged; cut a part of it with 'terrain build --bounds W,S,E,N'");
}

/// As many slots as the memory has room for.
void PagedDrawer::divide_memory(const TracedGround& ground, const TracedShotPlan& plan, std::uint32_t desks) {
    constexpr std::uint32_t kCells = raytrace::DatabaseChunks::kCells;
    use_.memory_bytes = ground.memory().bytes;
    use_.chunks = (ground.columns() + kCells - 2) / kCells * ((ground.rows() + kCells - 2) / kCells);
    const std::uint32_t fewest = std::min(desks, use_.chunks);
    const std::uint64_t least = ground_bytes(ground, fewest, desks), each = ground_bytes(ground, fewest + 1, desks) - least;
    if (least > use_.memory_bytes)
        throw UserError(path_ + ": the bounds of its chunks and one chunk for each of " + std::to_string(desks) +
                        (desks == 1 ? " worker take " : " workers take ") + megabytes(least) + ", and --memory allows " +
                        megabytes(use_.memory_bytes) + "; give --memory " + megabytes_up(least) + " or more");
    use_.slots = static_cast<std::uint32_t>(std::min<std::uint64_t>(fewest + (use_.memory_bytes - least) / each, use_.chunks));
    use_.held_bytes = ground_bytes(ground, use_.slots, desks);
    paging_ = {use_.slots, plan.width * plan.height, desks};
    use_.ray_bytes = raytrace::DatabaseChunks::bytes_needed(desks) +
                     Tracer::bytes_needed(ground.columns(), ground.rows(), paging_) - use_.held_bytes +
                     raytrace::PagedTerrain::bytes_needed(plan.width, plan.height);
}

void PagedDrawer::build(const TracedGround& ground, base::Workers& workers) {
    if (tracer_.start(chunks_, paging_, arena_) != Tracer::Started::yes)
        throw UserError(path_ + ": there is no memory to page its heights; name a smaller --size");
    if (chunks_.damaged_pages() > 0) refuse_damage(chunks_.damaged_pages(), "directory pages");
    drawer_.build(ground, workers);
}

void PagedDrawer::refuse_damage(std::uint32_t parts, const char* what) const {
    throw UserError(path_ + ": has " + std::to_string(parts) + " damaged " + what +
                    "; 'tedavis check' says where, and 'terrain build' builds it anew");
}

std::uint32_t PagedDrawer::draw(const raytrace::TraceLook& look, base::Span<const std::uint8_t> regions, bool is_direct,
                                base::Workers& workers) {
    const std::uint64_t before = chunks_.read_bytes();
    const raytrace::PagedWork work = terrain_.trace_picture(drawer_.sight(), raytrace::packet_kernels<float>()[0], workers);
    if (work.damaged > 0) refuse_damage(work.damaged, "chunks");
    use_.chunks_read = work.loads;
    use_.passes = work.passes;
    use_.read_bytes = chunks_.read_bytes() - before;
    return drawer_.draw(look, regions, is_direct, workers);
}

void PagedDrawer::tell(TracedShot& shot) const {
    drawer_.tell(shot);
    shot.paged = use_;
    shot.items.push_back({"rays", use_.ray_bytes});
}

}  // namespace tedavis::host_sim
