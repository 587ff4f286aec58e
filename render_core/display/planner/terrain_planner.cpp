#include "render_core/display/planner/terrain_planner.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/draw/texel_size.hpp"
#include "render_core/terrain/lod_refinement.hpp"
#include "render_core/terrain/projected_error.hpp"

namespace tedavis::display {
namespace {

using terrain::SelectionKind;

constexpr std::uint32_t kNodesPerSlot = 8;  // looked at by one selection: hidden neighbours and split ancestors too
// What will be needed when it has arrived: a wider view, and a little finer.
constexpr std::uint32_t kAheadPercent = 125;
constexpr double kAheadTau = 0.8;
// Slots for chunks beside the view, for when it turns: about two a level of the deepest tree.
constexpr std::uint32_t kSlotsBeside = 24;
constexpr double kSplitMoves = 0.05;     // of a selection's split of depths, to the next one's of the same view
constexpr double kMinVertical = 1e-3;    // straight down the vertical has no direction on the screen
constexpr double kMagnifiersCost = 1.5;  // no more of the error that the ground has without them
constexpr double kSkyMargin_px = 3;      // silhouettes reach into the sky, and the processor rounds

constexpr std::string_view kOfDatabase = "the terrain database ";

terrain::View seen_soon(const terrain::View& view) {
    terrain::View wider = view;
    wider.width = view.width * kAheadPercent / 100;
    wider.height = view.height * kAheadPercent / 100;
    return wider;
}

terrain::LodSettings needed_soon(const terrain::LodSettings& now, std::uint32_t parts) {
    terrain::LodSettings soon = now;
    soon.tau_px *= kAheadTau;
    soon.max_triangles = now.max_triangles * 2;
    soon.max_chunks = now.max_chunks * 3 / 2;
    soon.max_parts = parts;
    soon.max_ms *= 2;
    return soon;
}

terrain::StoreSettings store_settings(const effects::DeviceSettings& device, terrain::ArrivalMode mode) {
    terrain::StoreSettings settings;
    settings.mode = mode;
    settings.payload_slots = device.max_chunk_slots;
    settings.attribute_slots = device.attribute_pages;
    settings.drape_slots = device.drape_pages;
    settings.arrival_frames = device.arrival_frames;
    return settings;
}

/// Of what budgets allow.
bool is_short(const terrain::LodResult& lod) {
    using terrain::LodStop;
    return !lod.within_budget || lod.reason == LodStop::triangles || lod.reason == LodStop::chunks ||
           lod.reason == LodStop::milliseconds || lod.reason == LodStop::nodes;
}

/// Of a line that only the store takes memory by, as it was before it did.
base::ResourceUse emptied(const base::Arena& arena) {
    base::ResourceUse use = arena.use();
    use.in_use = 0;
    return use;
}

base::Error database_error(const terrain::TdbFailure& failure) {
    return base::make_error(kOfDatabase, terrain::describe(failure).view());
}

}  // namespace

TerrainPlan as_traced(TerrainPlan plan, bool shades_chunks) {
    plan.lod.reason = terrain::LodStop::met;
    plan.lod.triangles = 0;
    plan.lod.within_budget = plan.lod.within_budget || !shades_chunks;
    plan.lod.worst_chunk = terrain::kNoChunk;
    plan.lod.worst_error_px = plan.lod.worst_coarse_px = plan.lod.worst_waiting_px = plan.lod.tau_reached_px = 0;
    return plan;
}

std::string_view database_fault(std::string_view message) { return base::text_behind(kOfDatabase, message); }

std::uint32_t TerrainPlanner::reader_tickets(const effects::DeviceSettings& device) {
    return terrain::TerrainStore::reader_tickets(store_settings(device, terrain::ArrivalMode::live));
}

std::uint64_t TerrainPlanner::lod_bytes(std::uint32_t slots) {
    return std::uint64_t{slots} * (sizeof(terrain::SelectedChunk) + sizeof(terrain::WantedChunk)) +
           alignof(terrain::SelectedChunk) + alignof(terrain::WantedChunk) +
           terrain::LodSelector::bytes_needed(kNodesPerSlot * slots);
}

base::Error TerrainPlanner::start(const TerrainInput& input, draw::DrawnDesigns designs, effects::DeviceSettings& device,
                                  const TerrainMemory& memory) {
    device_ = &device;
    auto opened = terrain::TerrainDatabase::open(*input.file, memory.index);
    if (!opened.ok() && opened.error().error == terrain::TdbError::too_large)
        return base::make_error(kOfDatabase,
                                "does not fit: ", base::shortage_error(effects::kTerrainIndex, memory.index).message.view());
    if (!opened.ok()) return database_error(opened.error());
    database_ = opened.value();
    for (const draw::DrawnDesign& drawn : designs)
        if (needs_map(drawn.design->terrain.style, design::BakedMap::drape)) decide_drape();
    if (base::Error error = start_store(input, memory)) return error;
    if (base::Error error = start_selection(memory)) return error;
    started_ = true;
    return {};
}

void TerrainPlanner::follow_painter(bool reads_pages, draw::TraceState tracer) {
    store_.fetch_attributes(reads_pages);
    tracer_ = tracer;
}

void TerrainPlanner::set_design(const draw::DrawnDesign& design) {
    if (!started_) return;
    shades_chunks_ = design.is_deferred;
    goes_off_screen_ = design.output != draw::TerrainOutput::color;
    design_trace_ = draw::trace_state_of(design);
    if (design_trace_ == draw::TraceState::traced) design_trace_ = tracer_;
    trace_ = design_trace_;
}

void TerrainPlanner::follow_view(const terrain::View& view) {
    const bool is_lost = design_trace_ == draw::TraceState::traced && !draw::can_trace(database_, view);
    trace_ = is_lost ? draw::TraceState::place_too_polar : design_trace_;
}

/// Pages are read only where a style shows them.
void TerrainPlanner::decide_drape() {
    const terrain::FileHeader& h = database_.header();
    drape_ = h.drape_posts == 0          ? DrapeState::not_in_database
             : device_->drape_pages == 0 ? DrapeState::not_on_device
                                         : DrapeState::shown;
    if (drape_ != DrapeState::shown) return;
    const terrain::ChunkKey middle{h.drape_level, database_.lattice().grid_columns(h.drape_level) / 2,
                                   database_.lattice().grid_rows(h.drape_level) / 2};
    drape_detail_ = {draw::drape_texel_size(database_.lattice(), middle).north_m, h.drape_level};
}

base::Error TerrainPlanner::start_store(const TerrainInput& input, const TerrainMemory& memory) {
    if (!heights_.start(database_, memory.payloads) || !ceiling_.start(database_, heights_, memory.payloads))
        return base::shortage_error(effects::kTerrainHeights, memory.payloads, "the height queries");
    terrain::StoreSettings settings = store_settings(*device_, input.arrival);
    if (drape_ != DrapeState::shown) settings.drape_slots = 0;
    const terrain::TdbFailure failure = store_.start(
        database_, *input.reader, settings, {memory.index, memory.records, memory.payloads, memory.attributes, &memory.drape});
    if (failure.error == terrain::TdbError::too_large) return store_error(memory, settings);
    return failure.error == terrain::TdbError::none ? base::Error{} : database_error(failure);
}

base::Error TerrainPlanner::start_selection(const TerrainMemory& memory) {
    const std::uint32_t slots = device_->max_chunk_slots;
    selected_ = memory.lod.allocate_array<terrain::SelectedChunk>(slots);
    wanted_ = memory.lod.allocate_array<terrain::WantedChunk>(slots);
    const bool has_nodes = selector_.start(memory.lod, kNodesPerSlot * slots);
    if (selected_.empty() || wanted_.empty() || !has_nodes)
        return base::shortage_error(effects::kLodScratch, memory.lod, "max_chunk_slots");
    if (!chunk_indices_.start(store_, memory.staging))
        return base::shortage_error(effects::kStaging, memory.staging, "the index lists of chunks");
    return {};
}

/// Of the lines that the store takes memory by, the first that refused.
base::Error TerrainPlanner::store_error(const TerrainMemory& memory, const terrain::StoreSettings& settings) const {
    if (memory.records.refused_bytes() > 0)
        return base::shortage_error(effects::kTerrainChunkSlots, emptied(memory.records),
                                    terrain::TerrainStore::record_bytes(settings), "max_chunk_slots");
    if (memory.payloads.refused_bytes() > 0)
        return base::shortage_error(effects::kTerrainHeights, memory.payloads, "max_chunk_slots");
    if (memory.attributes.refused_bytes() > 0)
        return base::shortage_error(effects::kTerrainAttributes, memory.attributes, "attribute_pages");
    if (memory.drape.refused_bytes() > 0)
        return base::shortage_error(effects::kTerrainDrape, emptied(memory.drape), terrain::TerrainStore::drape_bytes(settings),
                                    "drape_pages");
    // The directory takes what the line has, and needs a page more than the coarsest level has.
    const terrain::Lattice& lattice = database_.lattice();
    const std::uint32_t top = database_.top_level(), pages = lattice.page_columns(top) * lattice.page_rows(top) + 1;
    const std::uint64_t held = database_.table_bytes(), needed = terrain::DirectoryCache::bytes_needed(pages);
    base::ResourceUse use = memory.index.use();
    use.in_use = std::min(use.capacity, held);
    return base::shortage_error(effects::kTerrainIndex, use, needed, "pages of the directory");
}

terrain::HeightAnswer TerrainPlanner::true_height(double latitude_rad, double longitude_rad) {
    return heights_.at(latitude_rad, longitude_rad);
}

/// Chunks in view and above it for which there are slots: what roots and chunks beside the view leave, half of all at least.
std::uint32_t TerrainPlanner::parts_in_view() const {
    const std::uint32_t slots = device_->max_chunk_slots, top = database_.lattice().levels() - 1;
    const std::uint32_t roots = database_.lattice().grid_columns(top) * database_.lattice().grid_rows(top);
    return std::max(slots / 2, slots - std::min(slots, roots + kSlotsBeside));
}

terrain::LodSettings TerrainPlanner::lod_settings(const design::DesignSettings& design, const Camera& camera,
                                                  double tau_factor) const {
    terrain::LodSettings lod;
    lod.tau_px = design.terrain.tau_px * tau_factor;
    lod.max_triangles = device_->triangle_budget;
    lod.max_chunks = device_->max_chunk_slots * 2 / 3;  // the others hold ancestors
    if (device_->terrain_ms > 0) lod.max_ms = device_->terrain_ms;
    lod.cost = {device_->ns_per_triangle, device_->us_per_chunk};
    lod.haze_per_m = camera.haze_per_m;
    lod.height_weight = camera.height_weight;
    lod.conservative_up = design.terrain.conservative_up;
    if (needs_map(design.terrain.style, design::BakedMap::drape)) lod.drape = drape_detail_;
    return lod;
}

/// Returns the view with what is known of the ground close to its eye point. This is done for each view, since a wider one sees
/// more of the ground below.
terrain::View TerrainPlanner::over_ground(terrain::View view) {
    view.ground = terrain::near_ground(heights_, view);
    return view;
}

/// Returns what would be drawn if all had arrived.
terrain::LodResult TerrainPlanner::ask_for(const terrain::View& view, const terrain::LodSettings& lod) {
    const terrain::LodResult ideal = selector_.select(store_, over_ground(seen_soon(view)), needed_soon(lod, parts_in_view()),
                                                      SelectionKind::ideal, selected_);
    store_.want({wanted_.data(), selector_.wanted(wanted_)});
    return ideal;
}

TerrainPlan TerrainPlanner::plan(const Camera& camera, const design::DesignSettings& design, double tau_factor) {
    const terrain::LodSettings lod = lod_settings(design, camera, tau_factor);
    store_.begin_frame();
    TerrainPlan plan;
    terrain::View view = camera.view;
    follow_view(view);
    plan.is_unmagnified = !view.magnifiers.empty() && !can_magnify(view, lod);
    if (plan.is_unmagnified) view.magnifiers.clear();
    const terrain::LodResult ideal = ask_for(view, lod);
    plan.lod = select_drawn(view, lod);
    for (const terrain::SelectedChunk& chunk : selected())
        plan.has_void = plan.has_void || (chunk.entry->flags & terrain::kChunkHasVoid) != 0;
    plan.pending = store_.pending();
    // Nothing more will arrive: what the ideal had to leave out is missing.
    if (plan.lod.reason == terrain::LodStop::not_arrived && plan.pending == 0 && ideal.reason != terrain::LodStop::met)
        plan.lod.reason = ideal.reason;
    plan.is_short = is_short(plan.lod);
    plan.is_late = store_.is_late();
    plan.is_failing = store_.is_failing();
    return plan;
}

void TerrainPlanner::widen_error(const terrain::View& view, const design::DesignSettings& design, terrain::LodResult& lod) {
    const terrain::View seen = over_ground(view);
    for (const terrain::SelectedChunk& chunk : selected()) {
        if (terrain::is_outside_view(*chunk.entry, seen, double{greatest_lift_m(chunk.lift)})) continue;
        const double error_px = design.terrain.conservative_up ? terrain::lifted_error_px(*chunk.entry, seen, chunk.coarser_edges,
                                                                                          greatest_lift_m(chunk.lift))
                                                               : terrain::drawn_error_px(*chunk.entry, seen, chunk.coarser_edges);
        if (error_px <= lod.worst_error_px) continue;
        lod.worst_error_px = error_px;
        lod.worst_chunk = chunk.key;
        lod.tau_reached_px = std::fmax(lod.tau_reached_px, error_px);
    }
}

/// Returns false where magnifiers need so many triangles that the ground would be less accurate. It decides by what would be
/// drawn if all chunks had arrived, so that no arrival changes the result.
bool TerrainPlanner::can_magnify(const terrain::View& view, const terrain::LodSettings& lod) {
    const terrain::LodResult with = selector_.select(store_, over_ground(view), lod, SelectionKind::ideal, selected_);
    if (!is_short(with)) return true;
    terrain::View unmoved = view;
    unmoved.magnifiers.clear();
    const terrain::LodResult without = selector_.select(store_, over_ground(unmoved), lod, SelectionKind::ideal, selected_);
    return with.within_budget && with.worst_error_px <= kMagnifiersCost * std::fmax(without.worst_error_px, lod.tau_px);
}

/// Chunks that reach into both ranges of depth are drawn twice, which the budget of triangles bears too. Where the ranges part
/// follows from what is selected; so where it matters a second selection knows it from the first, a little widened, and where
/// even that is not enough, twice the half is the whole.
terrain::LodResult TerrainPlanner::select_drawn(const terrain::View& view, terrain::LodSettings lod) {
    const terrain::View seen = over_ground(view);
    const std::uint32_t budget = lod.max_triangles;
    terrain::LodResult result;
    for (int tries = 0; tries < 3; ++tries) {
        result = selector_.select(store_, seen, lod, SelectionKind::drawn, selected_);
        chunks_ = result.chunks;
        if (submitted_triangles(view) <= budget) break;
        const draw::DepthPlan depth = depth_plan(view);
        lod.twice = {depth.ranges[0].near_m * (1 - kSplitMoves), depth.ranges[depth.count - 1].far_m * (1 + kSplitMoves)};
        if (tries > 0) lod.max_triangles = budget / 2;
    }
    return result;
}

std::uint32_t TerrainPlanner::submitted_triangles(const terrain::View& view) const {
    const draw::DepthPlan depth = depth_plan(view);
    std::uint32_t triangles = 0;
    for (const terrain::SelectedChunk& chunk : selected()) {
        const double lift_m = double{greatest_lift_m(chunk.lift)};
        const terrain::DepthSpan reach = terrain::depth_span(*chunk.entry, view, lift_m);
        const std::uint32_t drawn = chunk.entry->triangle_count * terrain::draws_of(*chunk.entry, view, lift_m);
        for (std::size_t n = 0; n < depth.count; ++n) triangles += terrain::overlap(reach, depth.ranges[n]) ? drawn : 0u;
    }
    return triangles;
}

SeenTerrain TerrainPlanner::seen_from(const terrain::View& view) const {
    if (!started_) return {};
    return {selected(), depth_plan(view), goes_off_screen_ ? drawn_part(view) : draw::ScreenPart(), is_traced(), &database_};
}

draw::DepthPlan TerrainPlanner::depth_plan(const terrain::View& view) const {
    return draw::plan_depth(view.near_m, std::fmin(std::fmax(farthest_depth_m(view), 2 * view.near_m), view.far_m));
}

double TerrainPlanner::farthest_m(const terrain::View& view) const {
    const draw::DepthPlan depth = depth_plan(view);
    const double corner = std::hypot(view.half_width_tangent(), view.half_height_tangent());
    return depth.ranges[0].far_m * std::hypot(1, corner);
}

double TerrainPlanner::nearest_m(const terrain::View& view) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const terrain::SelectedChunk& chunk : selected())
        nearest = std::fmin(nearest, terrain::depth_span(*chunk.entry, view, double{greatest_lift_m(chunk.lift)}).near_m);
    return std::fmax(nearest, view.near_m);
}

void TerrainPlanner::rest() {
    if (!started_) return;
    store_.begin_frame();
    store_.want({});
    chunks_ = 0;
}

void TerrainPlanner::approach(const Camera& camera, const design::DesignSettings& design, double tau_factor) {
    if (!started_) return;
    const terrain::LodSettings lod = lod_settings(design, camera, tau_factor);
    store_.begin_frame();
    terrain::View view = camera.view;
    follow_view(view);
    view.magnifiers.clear();
    static_cast<void>(ask_for(view, lod));
    chunks_ = 0;
}

double TerrainPlanner::farthest_depth_m(const terrain::View& view) const {
    double farthest = 0;
    for (const terrain::SelectedChunk& chunk : selected())
        farthest = std::fmax(farthest, terrain::depth_span(*chunk.entry, view, double{greatest_lift_m(chunk.lift)}).far_m);
    return farthest;
}

draw::ScreenPart TerrainPlanner::drawn_part(const terrain::View& view) const {
    const glm::dvec3 up = glm::normalize(view.eye);
    glm::dvec2 on_screen(glm::dot(up, view.right), glm::dot(up, view.down));
    const double length = glm::length(on_screen);
    on_screen = length > kMinVertical ? on_screen / length : glm::dvec2(0, -1);
    double highest = -std::numeric_limits<double>::infinity();
    for (const terrain::SelectedChunk& chunk : selected())
        highest =
            std::fmax(highest, terrain::highest_tangent(*chunk.entry, view, on_screen, double{greatest_lift_m(chunk.lift)}));
    return {static_cast<float>(on_screen.x * view.half_width_tangent()),
            static_cast<float>(-on_screen.y * view.half_height_tangent()),
            static_cast<float>(highest + kSkyMargin_px / view.focal_px)};
}

base::Span<const terrain::ChunkVertex> TerrainPlanner::vertices(const terrain::SelectedChunk& chunk) {
    return store_.vertices(chunk.slot);
}

base::Span<const std::uint16_t> TerrainPlanner::stored_indices(const terrain::SelectedChunk& chunk) {
    return store_.indices(chunk.slot);
}

base::Span<const std::uint16_t> TerrainPlanner::drawn_indices(const terrain::SelectedChunk& chunk) {
    return chunk_indices_.of(chunk).indices;
}

terrain::DrawnPoint TerrainPlanner::drawn_point(double latitude_rad, double longitude_rad) {
    const terrain::LatticePoint point = database_.lattice().point(latitude_rad, longitude_rad);
    const terrain::SelectedChunk* chunk = terrain::chunk_under(database_.lattice(), selected(), point);
    if (chunk == nullptr) return {};
    return terrain::drawn_point(database_, {chunk, vertices(*chunk), drawn_indices(*chunk)}, point);
}

}  // namespace tedavis::display
