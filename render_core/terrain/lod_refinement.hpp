/// Refines a tree of chunks from its roots within budgets; a part of lod_selection.hpp. Thread  one.
#pragma once

#include "render_core/terrain/lod_selection.hpp"
#include "render_core/terrain/projected_error.hpp"

namespace tedavis::terrain {

enum class Priority : std::uint8_t { error, seen_error };  ///< seen_error: error times visibility

class LodRefinement {
public:
    /// All arguments must outlive the refinement; `heap` has room for as many nodes as the tree.
    LodRefinement(ChunkCatalogue& catalogue, const View& view, const LodSettings& settings, SelectionKind kind, LodTree& tree,
                  base::Span<NodeIndex> heap)
        : catalogue_(catalogue), view_(view), settings_(settings), kind_(kind), tree_(tree), heap_(heap) {}

    /// Refines from the roots. Boxes count as in view if they are when stretched upwards by `reach_m`. Returns false when the
    /// roots alone exceed a budget; stop() names it. With `with_image`, where tau is reached everywhere, the rest of the
    /// budgets is spent on the image.
    [[nodiscard]] bool run(Priority priority, double reach_m, bool with_image = true);
    /// True where the last run split chunks for the image's resolution.
    [[nodiscard]] bool refined_image() const { return refines_image_; }

    /// Returns why a leaf's error is not smaller: why the leaf, the leaf that raises it, or a coarser neighbour of either could
    /// not be split.
    [[nodiscard]] LodStop reason_for(NodeIndex leaf, NodeIndex raised_by) const;
    /// Returns the first budget that prevented a split; `met` when none did.
    [[nodiscard]] LodStop stop() const { return stop_; }
    [[nodiscard]] std::uint32_t triangles() const { return static_cast<std::uint32_t>(load_.triangles); }
    [[nodiscard]] double milliseconds() const { return milliseconds(load_); }
    /// Largest own lift of all examined chunks, for any combination of neighbours.
    [[nodiscard]] float largest_lift_m() const { return largest_lift_m_; }
    [[nodiscard]] const PoleLifts& poles() const { return poles_; }

private:
    /// 2:1 balance forces at most two more chunks a level.
    static constexpr std::uint32_t kMaxGroup = 4 * kMaxLevels;
    /// The use of the budgets by a selection.
    struct Load {
        std::int64_t triangles = 0, chunks = 0, parts = 0;
    };
    struct Child {
        ChunkKey key;
        const ChunkEntry* entry;
        bool is_visible;
    };
    struct Group {
        NodeIndex members[kMaxGroup];
        std::uint32_t count = 0;
        Child children[kMaxGroup * 4];
        std::uint32_t first_child[kMaxGroup + 1]{};
    };

    [[nodiscard]] bool add_roots();
    void refine_with_causes();
    void refine_band(double least_px);
    void refine(double least_px);
    [[nodiscard]] double comes_first() const { return tree_.node(heap_[0]).priority; }
    [[nodiscard]] LodStop try_split(NodeIndex node);
    [[nodiscard]] LodStop gather(NodeIndex node);
    [[nodiscard]] bool force_neighbours_of(NodeIndex node);
    [[nodiscard]] LodStop gather_children(std::uint32_t member);
    [[nodiscard]] LodStop exceeded_by_group() const;
    void split_group();
    void add(const Child& child, NodeIndex parent);
    void push_large_texels(NodeIndex node);
    [[nodiscard]] double priority_of(const LodNode& node, double error_px) const;
    void push(NodeIndex node, double error_px);
    [[nodiscard]] NodeIndex pop();
    [[nodiscard]] bool comes_after(NodeIndex a, NodeIndex b) const;
    [[nodiscard]] bool queue_causes_of_errors(double least_px);
    void queue_cause_of_error(NodeIndex leaf, double least_px);
    [[nodiscard]] bool queue_coarser_neighbours(NodeIndex leaf, double error_px);
    [[nodiscard]] bool queue(NodeIndex leaf, double error_px);

    [[nodiscard]] bool is_in_view(const ChunkEntry& entry) const { return !is_outside_view(entry, view_, reach_m_); }
    /// A chunk's use of the triangle budget.
    [[nodiscard]] std::int64_t triangles_of(const ChunkEntry& entry) const;
    [[nodiscard]] double mesh_error_px(const ChunkEntry& entry) const;
    [[nodiscard]] double texel_px(const LodNode& node) const;
    [[nodiscard]] double milliseconds(const Load& load) const;
    [[nodiscard]] LodStop exceeded(const Load& load) const;

    ChunkCatalogue& catalogue_;
    const View& view_;
    const LodSettings& settings_;
    SelectionKind kind_;
    LodTree& tree_;
    base::Span<NodeIndex> heap_;
    double reach_m_ = 0;
    bool refines_image_ = false;
    Priority priority_ = Priority::error;
    std::size_t queued_ = 0;
    Load load_;
    LodStop stop_ = LodStop::met;
    float largest_lift_m_ = 0;
    PoleLifts poles_;
    Group group_;
};

/// Visibility of a chunk through the haze, 0.05..1.
[[nodiscard]] double visibility(const ChunkEntry& entry, const View& view, double haze_per_m);

/// Projected error of a leaf as it is drawn, with its strips beside coarser neighbours; and the same with its lift.
[[nodiscard]] double drawn_error_px(const ChunkEntry& entry, const View& view, std::uint8_t coarser_edges);
[[nodiscard]] double lifted_error_px(const ChunkEntry& entry, const View& view, std::uint8_t coarser_edges, float lift_m);

}  // namespace tedavis::terrain
