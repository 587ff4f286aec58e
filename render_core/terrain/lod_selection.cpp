#include "render_core/terrain/lod_selection.hpp"

#include <algorithm>

#include "render_core/terrain/lod_refinement.hpp"
#include "render_core/terrain/projected_error.hpp"

namespace tedavis::terrain {
namespace {

constexpr int kReachTries = 8;  // each only for a lift that exceeds all before
constexpr double kNotNeeded = -1;

/// A heap sort neither allocates nor recurses.
template <class T, class Before>
void sort(T* begin, T* end, const Before& before) {
    std::make_heap(begin, end, before);
    std::sort_heap(begin, end, before);
}

/// Nearest first, so that a depth test spares the shading of what is hidden.
bool is_nearer(const SelectedChunk& a, const SelectedChunk& b) {
    return a.distance_m != b.distance_m ? a.distance_m < b.distance_m : a.key < b.key;
}

/// After all that is in view: what it may turn to, the most urgent first too. Parents come before their children. Returns how
/// many are listed then.
std::uint32_t add_siblings(LodTree& tree, base::Span<NodeIndex> list, std::uint32_t listed) {
    for (NodeIndex n = 0; n < tree.size(); ++n) {
        LodNode& node = tree.node(n);
        if (node.priority != kNotNeeded || node.parent == kNoNode) continue;
        const LodNode& parent = tree.node(node.parent);
        if (parent.priority == kNotNeeded) continue;
        node.priority = std::min(parent.priority, -1 / (2 + parent.error_px));
        list[listed++] = n;
    }
    return listed;
}

double largest_root_lift_m(ChunkCatalogue& catalogue) {
    const Lattice& lattice = catalogue.lattice();
    const std::uint32_t top = lattice.levels() - 1;
    float largest_m = 0;
    for (std::uint32_t j = 0; j < lattice.grid_rows(top); ++j)
        for (std::uint32_t i = 0; i < lattice.grid_columns(top); ++i)
            if (const FoundEntry found = catalogue.find({top, i, j}); found.state == EntryState::present)
                largest_m = std::max({largest_m, found.entry->below_m, found.entry->strip_below_m});
    return double{largest_m};
}

}  // namespace

const char* to_string(LodStop reason) noexcept {
    switch (reason) {
        case LodStop::met: return "met";
        case LodStop::triangles: return "triangles";
        case LodStop::chunks: return "chunks";
        case LodStop::milliseconds: return "milliseconds";
        case LodStop::nodes: return "nodes";
        case LodStop::not_arrived: return "not_arrived";
        case LodStop::at_data_limit: return "at_data_limit";
    }
    return "unknown";
}

std::uint64_t LodSelector::bytes_needed(std::uint32_t nodes) {
    return LodTree::bytes_needed(nodes) + nodes * sizeof(NodeIndex) + alignof(NodeIndex);
}

bool LodSelector::start(base::Arena& arena, std::uint32_t nodes) {
    heap_ = arena.allocate_array<NodeIndex>(nodes);
    return !heap_.empty() && tree_.start(arena, nodes);
}

LodResult LodSelector::select(ChunkCatalogue& catalogue, const View& view, const LodSettings& settings, SelectionKind kind,
                              base::Span<SelectedChunk> selected) {
    LodSettings limits = settings;
    if (selected.size() < limits.max_chunks) limits.max_chunks = static_cast<std::uint32_t>(selected.size());
    LodRefinement refinement(catalogue, view, limits, kind, tree_, heap_);
    // Lifts stretch the boxes, and how far is known only when all is chosen. Most often the roots' are the largest.
    double reach_m = limits.conservative_up ? largest_root_lift_m(catalogue) : 0;
    bool fits = true;
    for (int tries = 0; tries < kReachTries; ++tries) {
        fits = refine(refinement, reach_m);
        if (!limits.conservative_up || double{refinement.largest_lift_m()} <= reach_m) break;
        reach_m = double{refinement.largest_lift_m()};
    }
    LodResult result;
    result.tau_reached_px = limits.tau_px;
    result.reason = refinement.stop();
    if (!fits) return result;
    result.within_budget = true;
    result.triangles = refinement.triangles();
    result.predicted_ms = refinement.milliseconds();
    collect(catalogue, view, limits, kind, refinement, selected, result);
    sort(selected.begin(), selected.begin() + result.chunks, is_nearer);
    return result;
}

/// Where a budget ends the refinement, once more in the order in which errors are seen.
bool LodSelector::refine(LodRefinement& refinement, double reach_m) {
    if (!refinement.run(Priority::error, reach_m, true)) return false;
    // A finer image must not cost accuracy.
    const bool spoilt = refinement.stop() != LodStop::met && refinement.refined_image();
    if (spoilt && !refinement.run(Priority::error, reach_m, false)) return false;
    return refinement.stop() == LodStop::met || refinement.run(Priority::seen_error, reach_m, false);
}

void LodSelector::collect(const ChunkCatalogue& catalogue, const View& view, const LodSettings& settings, SelectionKind kind,
                          const LodRefinement& refinement, base::Span<SelectedChunk> selected, LodResult& result) const {
    for (NodeIndex n = 0; n < tree_.size(); ++n) {
        const LodNode& node = tree_.node(n);
        if (!node.is_leaf || !node.is_visible) continue;
        const SlotIndex slot = catalogue.available_slot(node.key);
        if (kind == SelectionKind::drawn && slot == kNoSlot) continue;  // a root that did not arrive
        SelectedChunk chunk;
        chunk.key = node.key;
        chunk.entry = node.entry;
        chunk.slot = slot;
        chunk.coarser_edges = tree_.coarser_edges(node.key);
        chunk.distance_m = distance_m(*node.entry, view);
        double error_px = drawn_error_px(*node.entry, view, chunk.coarser_edges);
        NodeIndex raised_by = n;
        if (settings.conservative_up) {
            const LiftedLeaf lifted = lift_of_leaf(tree_, n, refinement.poles());
            error_px = lifted_error_px(*node.entry, view, chunk.coarser_edges, lifted.largest.lift_m);
            chunk.lift = lifted.lift;
            raised_by = lifted.largest.leaf;
        }
        chunk.error_px = static_cast<float>(error_px);
        selected[result.chunks++] = chunk;
        const LodStop reason = error_px <= settings.tau_px ? LodStop::met : refinement.reason_for(n, raised_by);
        if (reason != LodStop::at_data_limit) result.worst_coarse_px = std::max(result.worst_coarse_px, error_px);
        if (reason == LodStop::not_arrived)
            result.worst_waiting_px =
                std::max(result.worst_waiting_px, error_px * visibility(*node.entry, view, settings.haze_per_m));
        if (result.chunks > 1 && error_px <= result.worst_error_px) continue;
        result.worst_error_px = error_px;
        result.worst_chunk = node.key;
        result.reason = reason;
    }
    result.tau_reached_px = std::max(settings.tau_px, result.worst_error_px);
}

std::uint32_t LodSelector::wanted(base::Span<WantedChunk> out) {
    const NodeIndex count = tree_.size();
    std::uint32_t needed = 0;
    for (NodeIndex n = 0; n < count; ++n) tree_.node(n).priority = kNotNeeded;
    // Children come after their parents, so that backwards every need has come up when it is passed on.
    for (NodeIndex n = count; n-- > 0;) {
        LodNode& node = tree_.node(n);
        // A visible chunk may have hidden children only; its parent's split needs it all the same.
        if (node.is_visible) node.priority = std::max(node.priority, shown_without(n));
        if (node.priority == kNotNeeded) continue;
        heap_[needed++] = n;
        if (node.parent == kNoNode) continue;
        double& above = tree_.node(node.parent).priority;
        above = std::max({above, node.priority, shown_without(node.parent)});
    }
    needed = add_siblings(tree_, heap_, needed);
    sort(heap_.begin(), heap_.begin() + needed, [this](NodeIndex a, NodeIndex b) {
        const LodNode &first = tree_.node(a), &second = tree_.node(b);
        return first.priority != second.priority ? first.priority > second.priority : first.key < second.key;
    });
    const auto written = static_cast<std::uint32_t>(std::min<std::size_t>(needed, out.size()));
    for (std::uint32_t n = 0; n < written; ++n) out[n] = {tree_.node(heap_[n]).key, tree_.node(heap_[n]).entry};
    return written;
}

/// The error in the picture as long as a chunk is not there: its parent's.
double LodSelector::shown_without(NodeIndex node) const {
    const NodeIndex parent = tree_.node(node).parent;
    return parent == kNoNode ? std::numeric_limits<double>::max() : tree_.node(parent).error_px;
}

}  // namespace tedavis::terrain
