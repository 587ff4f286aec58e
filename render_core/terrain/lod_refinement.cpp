#include "render_core/terrain/lod_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace tedavis::terrain {
namespace {

constexpr double kMinVisibility = 0.05;
constexpr double kFirstBand_px = 4096,
                 kBandRatio = 4;  // from far more than a picture down to tau; each costs a look at all leaves
constexpr double kNoBand = -std::numeric_limits<double>::infinity();

float larger(float a, float b) { return a > b ? a : b; }

/// Of the chunk's ground, where it is nearest.
double px_per_m(const ChunkEntry& entry, const View& view) {
    return magnification(entry, view) * view.focal_px / std::fmax(box_distance_m(entry, view), view.near_m);
}

/// As far as colours and lines can show it: by its length on the screen, and no finer than cells are worth.
double shown_height_error_px(const ChunkEntry& entry, const View& view, double tau_px) {
    const double scale = px_per_m(entry, view);
    const double area_m2 = 4 * double{entry.half_extent_m[0]} * double{entry.half_extent_m[1]};
    const double cell_m = std::sqrt(2 * area_m2 / std::fmax(entry.triangle_count, 1));
    const double by_height = double{larger(entry.above_m, entry.below_m)} * scale;
    // Splitting halves the cells.
    return std::fmin(by_height, tau_px * cell_m * scale / (2 * kFinestCell_px));
}

/// How far the coast of a chunk with sea and land can lie beside the true one: half a texel of its attribute page, for its
/// triangles know nothing of it. Pages of level 1 hold every post. True errors go first: never much over tau.
double coast_error_px(const ChunkEntry& entry, const View& view, double tau_px) {
    constexpr unsigned kBoth = kChunkHasSea | kChunkHasLand;
    if ((entry.flags & kBoth) != kBoth || entry.level < 2) return 0;
    const double side_m = 2 * double{larger(entry.half_extent_m[0], entry.half_extent_m[1])};
    const double coast_px = 0.5 * side_m / (kAttributePosts - 1) * px_per_m(entry, view);
    return coast_px <= tau_px ? coast_px : tau_px * (1.25 - 0.25 * tau_px / coast_px);
}

}  // namespace

double visibility(const ChunkEntry& entry, const View& view, double haze_per_m) {
    return std::fmax(kMinVisibility, std::exp(-haze_per_m * box_distance_m(entry, view)));
}

double drawn_error_px(const ChunkEntry& entry, const View& view, std::uint8_t coarser_edges) {
    float error_m = larger(entry.above_m, entry.below_m);
    if (coarser_edges != 0) error_m = larger(error_m, larger(entry.strip_above_m, entry.strip_below_m));
    return error_in_box_px(entry, view, double{error_m}, 0);
}

double lifted_error_px(const ChunkEntry& entry, const View& view, std::uint8_t coarser_edges, float lift_m) {
    const float above_m = coarser_edges != 0 ? larger(entry.above_m, entry.strip_above_m) : entry.above_m;
    return error_in_box_px(entry, view, double{above_m} + double{lift_m}, double{lift_m});
}

bool LodRefinement::run(Priority priority, double reach_m, bool with_image) {
    priority_ = priority;
    reach_m_ = reach_m;
    refines_image_ = false;
    queued_ = 0;
    load_ = {};
    stop_ = LodStop::met;
    largest_lift_m_ = 0;
    tree_.clear(catalogue_.lattice());
    if (!add_roots()) return false;
    refine_with_causes();
    refines_image_ = with_image && settings_.drape.texel_m > 0 && stop_ == LodStop::met;
    if (refines_image_) {
        for (NodeIndex n = 0; n < tree_.size(); ++n)
            if (tree_.node(n).is_leaf && tree_.node(n).is_visible && !tree_.node(n).is_tried) push_large_texels(n);
        refine_with_causes();
    }
    if (settings_.conservative_up) poles_ = lift_leaves(tree_);
    return true;
}

bool LodRefinement::add_roots() {
    const Lattice& lattice = catalogue_.lattice();
    const std::uint32_t top = lattice.levels() - 1;
    for (std::uint32_t j = 0; j < lattice.grid_rows(top); ++j)
        for (std::uint32_t i = 0; i < lattice.grid_columns(top); ++i) {
            const ChunkKey root{top, i, j};
            const FoundEntry found = catalogue_.find(root);
            if (found.state != EntryState::present) continue;
            if (tree_.room() == 0) {
                stop_ = LodStop::nodes;
                return false;
            }
            add({root, found.entry, is_in_view(*found.entry)}, kNoNode);
        }
    stop_ = exceeded(load_);
    return stop_ == LodStop::met;
}

/// Under a budget in bands of errors: what neighbours do to a chunk is known when the band is chosen, and is mended before
/// smaller errors get what is left.
void LodRefinement::refine_with_causes() {
    const bool in_bands = priority_ == Priority::seen_error;
    for (double least_px = in_bands ? kFirstBand_px : kNoBand; least_px > settings_.tau_px; least_px /= kBandRatio)
        refine_band(least_px);
    refine_band(kNoBand);
}

void LodRefinement::refine_band(double least_px) {
    do {
        refine(least_px);
    } while (queue_causes_of_errors(least_px) && !(comes_first() < least_px));
}

/// Splits the worst first. What cannot be split is left, and what is less urgent may still fit.
void LodRefinement::refine(double least_px) {
    while (queued_ > 0 && !(comes_first() < least_px)) {
        const NodeIndex n = pop();
        if (tree_.node(n).is_tried) continue;
        const LodStop reason = try_split(n);
        LodNode& node = tree_.node(n);
        node.is_tried = true;
        node.blocked = static_cast<std::uint8_t>(reason);
        if (reason == LodStop::met || reason == LodStop::not_arrived || reason == LodStop::at_data_limit) continue;
        if (stop_ == LodStop::met && node.priority >= 0) stop_ = reason;
    }
}

LodStop LodRefinement::try_split(NodeIndex node) {
    if (const LodStop reason = gather(node); reason != LodStop::met) return reason;
    if (const LodStop reason = exceeded_by_group(); reason != LodStop::met) return reason;
    split_group();
    return LodStop::met;
}

/// The node and all that its split forces, finer ones first, with their children.
LodStop LodRefinement::gather(NodeIndex node) {
    group_.count = 0;
    group_.members[group_.count++] = node;
    for (std::uint32_t n = 0; n < group_.count; ++n)
        if (!force_neighbours_of(group_.members[n])) return LodStop::nodes;
    for (std::uint32_t n = 0; n < group_.count; ++n)
        if (const LodStop reason = gather_children(n); reason != LodStop::met) return reason;
    return LodStop::met;
}

/// Where a neighbour of the same level is not there, its parent is a leaf, which must be split first.
bool LodRefinement::force_neighbours_of(NodeIndex node) {
    const ChunkKey key = tree_.node(node).key;
    for (const EdgeBit side : {kEdgeNorth, kEdgeEast, kEdgeSouth, kEdgeWest}) {
        const ChunkKey beside = catalogue_.lattice().neighbour(key, side);
        if (beside == kNoChunk || tree_.find(beside) != kNoNode) continue;
        const NodeIndex coarser = tree_.find(beside.parent());
        if (coarser == kNoNode) continue;  // a root that the database lacks
        NodeIndex* const end = group_.members + group_.count;
        if (std::find(group_.members, end, coarser) != end) continue;
        if (group_.count == kMaxGroup) return false;
        group_.members[group_.count++] = coarser;
    }
    return true;
}

LodStop LodRefinement::gather_children(std::uint32_t member) {
    const LodNode& node = tree_.node(group_.members[member]);
    std::uint32_t count = group_.first_child[member];
    if (node.entry->children == 0) return LodStop::at_data_limit;
    for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
        if ((node.entry->children >> quadrant & 1u) == 0) continue;
        const ChunkKey key = node.key.child(quadrant);
        const FoundEntry found = catalogue_.find(key);
        if (found.state == EntryState::absent) return LodStop::at_data_limit;
        if (found.state == EntryState::missing) return LodStop::not_arrived;
        const bool is_visible = is_in_view(*found.entry);
        if (is_visible && kind_ == SelectionKind::drawn && catalogue_.available_slot(key) == kNoSlot) return LodStop::not_arrived;
        group_.children[count++] = {key, found.entry, is_visible};
    }
    group_.first_child[member + 1] = count;
    return LodStop::met;
}

LodStop LodRefinement::exceeded_by_group() const {
    Load load = load_;
    const std::uint32_t children = group_.first_child[group_.count];
    if (children > tree_.room()) return LodStop::nodes;
    for (std::uint32_t n = 0; n < group_.count; ++n) {
        const LodNode& node = tree_.node(group_.members[n]);
        if (!node.is_visible) continue;
        load.triangles -= triangles_of(*node.entry);
        --load.chunks;
    }
    for (std::uint32_t n = 0; n < children; ++n) {
        if (!group_.children[n].is_visible) continue;
        load.triangles += triangles_of(*group_.children[n].entry);
        ++load.chunks;
        ++load.parts;
    }
    return exceeded(load);
}

/// Coarse ones first, so that levels stay within one of each other. Those that the first member forces are as urgent as it.
void LodRefinement::split_group() {
    const double error_px = tree_.node(group_.members[0]).error_px;
    for (std::uint32_t n = group_.count; n-- > 0;) {
        LodNode& node = tree_.node(group_.members[n]);
        node.error_px = std::fmax(node.error_px, error_px);
        node.is_leaf = false;
        node.is_tried = true;
        if (node.is_visible) {
            load_.triangles -= triangles_of(*node.entry);
            --load_.chunks;
        }
        for (std::uint32_t child = group_.first_child[n]; child < group_.first_child[n + 1]; ++child)
            add(group_.children[child], group_.members[n]);
    }
}

void LodRefinement::add(const Child& child, NodeIndex parent) {
    const NodeIndex n = tree_.add(child.key, child.entry, parent);
    LodNode& node = tree_.node(n);
    node.is_visible = child.is_visible;
    largest_lift_m_ = larger(largest_lift_m_, larger(child.entry->below_m, child.entry->strip_below_m));
    if (!child.is_visible) return;
    load_.triangles += triangles_of(*child.entry);
    ++load_.chunks;
    if (parent != kNoNode) ++load_.parts;
    node.error_px = mesh_error_px(*child.entry);
    // A comparison that NaN refuses refines.
    if (!(node.error_px <= settings_.tau_px)) return push(n, node.error_px);
    if (refines_image_) push_large_texels(n);
}

/// Priorities below zero: after all that have an error, the largest texels first.
void LodRefinement::push_large_texels(NodeIndex n) {
    if (const double texel = texel_px(tree_.node(n)); texel > kLargestTexel_px) push(n, -1 / texel);
}

/// Of the image as the node shows it, where it is nearest; 0 where no finer pages are to be had.
double LodRefinement::texel_px(const LodNode& node) const {
    const DrapeDetail& drape = settings_.drape;
    if (!(drape.texel_m > 0) || node.key.level <= drape.level || node.entry->drape.bytes == 0) return 0;
    const double texel_m = drape.texel_m * std::exp2(node.key.level - drape.level);
    const double shown_m = magnification(*node.entry, view_) * texel_m;
    return shown_m * view_.focal_px / std::fmax(box_distance_m(*node.entry, view_), view_.near_m);
}

std::int64_t LodRefinement::triangles_of(const ChunkEntry& entry) const {
    const std::int64_t drawn = std::int64_t{entry.triangle_count} * draws_of(entry, view_, reach_m_);
    if (!(settings_.twice.near_m <= settings_.twice.far_m)) return drawn;
    const bool is_twice = overlap(depth_span(entry, view_, reach_m_), settings_.twice);
    return drawn * (is_twice ? 2 : 1);
}

/// Chunks are judged by themselves first; what they do to their neighbours is found out when all is chosen.
double LodRefinement::mesh_error_px(const ChunkEntry& entry) const {
    const double drawn_px =
        settings_.conservative_up ? lifted_error_px(entry, view_, 0, entry.below_m) : drawn_error_px(entry, view_, 0);
    const double seen_px = std::fmax(drawn_px, coast_error_px(entry, view_, settings_.tau_px));
    if (!(settings_.height_weight > 0)) return seen_px;
    return std::fmax(seen_px, settings_.height_weight * shown_height_error_px(entry, view_, settings_.tau_px));
}

double LodRefinement::milliseconds(const Load& load) const {
    return 1e-6 * settings_.cost.ns_per_triangle * static_cast<double>(load.triangles) +
           1e-3 * settings_.cost.us_per_chunk * static_cast<double>(load.chunks);
}

LodStop LodRefinement::exceeded(const Load& load) const {
    if (load.triangles > std::int64_t{settings_.max_triangles}) return LodStop::triangles;
    if (load.chunks > std::int64_t{settings_.max_chunks} || load.parts > std::int64_t{settings_.max_parts})
        return LodStop::chunks;
    return milliseconds(load) > settings_.max_ms ? LodStop::milliseconds : LodStop::met;
}

double LodRefinement::priority_of(const LodNode& node, double error_px) const {
    const bool by_sight = priority_ == Priority::seen_error && error_px > 0;
    return by_sight ? error_px * visibility(*node.entry, view_, settings_.haze_per_m) : error_px;
}

void LodRefinement::push(NodeIndex n, double error_px) {
    LodNode& node = tree_.node(n);
    node.is_queued = true;
    node.priority = priority_of(node, error_px);
    heap_[queued_++] = n;
    std::push_heap(heap_.begin(), heap_.begin() + queued_, [this](NodeIndex a, NodeIndex b) { return comes_after(a, b); });
}

NodeIndex LodRefinement::pop() {
    std::pop_heap(heap_.begin(), heap_.begin() + queued_, [this](NodeIndex a, NodeIndex b) { return comes_after(a, b); });
    return heap_[--queued_];
}

bool LodRefinement::comes_after(NodeIndex a, NodeIndex b) const {
    const LodNode &first = tree_.node(a), &second = tree_.node(b);
    return first.priority != second.priority ? first.priority < second.priority : second.key < first.key;
}

/// What neighbours do to a leaf, strips beside coarser ones and lifts, is known when all is chosen. Where it takes an error over
/// tau, its cause is to be split.
bool LodRefinement::queue_causes_of_errors(double least_px) {
    if (settings_.conservative_up) poles_ = lift_leaves(tree_);
    for (NodeIndex n = 0; n < tree_.size(); ++n)
        if (tree_.node(n).is_leaf && tree_.node(n).is_visible) queue_cause_of_error(n, least_px);
    return queued_ > 0;
}

/// A neighbour that raises the leaf's border, because of its own strips or its mesh; or the leaf's strips.
void LodRefinement::queue_cause_of_error(NodeIndex leaf, double least_px) {
    const LodNode& node = tree_.node(leaf);
    const std::uint8_t coarser_edges = tree_.coarser_edges(node.key);
    const LiftSource raised_by = settings_.conservative_up ? lift_of_leaf(tree_, leaf, poles_).largest : LiftSource{0, leaf};
    const double error_px = settings_.conservative_up ? lifted_error_px(*node.entry, view_, coarser_edges, raised_by.lift_m)
                                                      : drawn_error_px(*node.entry, view_, coarser_edges);
    if (error_px <= settings_.tau_px || error_px < least_px) return;
    const bool raised = raised_by.leaf != leaf;
    if (raised && (queue_coarser_neighbours(raised_by.leaf, error_px) || queue(raised_by.leaf, error_px))) return;
    (void)queue_coarser_neighbours(leaf, error_px);
}

bool LodRefinement::queue_coarser_neighbours(NodeIndex leaf, double error_px) {
    const ChunkKey& key = tree_.node(leaf).key;
    const std::uint8_t coarser = tree_.coarser_edges(key);
    bool any = false;
    for (const EdgeBit side : {kEdgeNorth, kEdgeEast, kEdgeSouth, kEdgeWest})
        if ((coarser & side) != 0) any = queue(tree_.coarser_beyond(key, side), error_px) || any;
    return any;
}

LodStop LodRefinement::reason_for(NodeIndex leaf, NodeIndex raised_by) const {
    for (const NodeIndex cause : {leaf, raised_by}) {
        if (tree_.node(cause).blocked != static_cast<std::uint8_t>(LodStop::met))
            return static_cast<LodStop>(tree_.node(cause).blocked);
        const ChunkKey& key = tree_.node(cause).key;
        const std::uint8_t coarser = tree_.coarser_edges(key);
        for (const EdgeBit side : {kEdgeNorth, kEdgeEast, kEdgeSouth, kEdgeWest}) {
            const NodeIndex beside = (coarser & side) != 0 ? tree_.coarser_beyond(key, side) : kNoNode;
            if (beside != kNoNode && tree_.node(beside).blocked != static_cast<std::uint8_t>(LodStop::met))
                return static_cast<LodStop>(tree_.node(beside).blocked);
        }
    }
    return stop_ == LodStop::met ? LodStop::at_data_limit : stop_;
}

/// True when the leaf waits for its split now.
bool LodRefinement::queue(NodeIndex leaf, double error_px) {
    if (leaf == kNoNode || tree_.node(leaf).is_tried) return false;
    LodNode& node = tree_.node(leaf);
    node.error_px = std::fmax(node.error_px, error_px);
    const double priority = priority_of(node, error_px);
    if (!node.is_queued) push(leaf, error_px);
    if (node.priority < priority) {
        node.priority = priority;
        std::make_heap(heap_.begin(), heap_.begin() + queued_, [this](NodeIndex a, NodeIndex b) { return comes_after(a, b); });
    }
    return true;
}

}  // namespace tedavis::terrain
