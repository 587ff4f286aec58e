/// The focus degrees of a layer's features: for a data focus by value, else by the position nearest to the focus. A point has
/// its own position, in volumes with its height. For lines and areas their points count, the points of their sides that are
/// nearest to the points of the focus, and an area that contains such a point. Of several foci the greatest degree counts.
///
/// Possible hazards (obstacles, other aircraft, no-go areas, storm cells) are always in the focus.
///
/// Pure, apart from queries to the ground for heights in volumes. Bounded: a feature's points. Thread  the ground's.
#pragma once

#include <optional>

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/frame_foci.hpp"
#include "render_core/draw/data/layer_values.hpp"
#include "render_core/draw/data/placement.hpp"

namespace tedavis::draw {

/// True for roles that foci do not change.
[[nodiscard]] bool is_hazard(scene::LayerRole role) noexcept;

class LayerFoci {
public:
    LayerFoci() = default;  ///< everything is in the focus
    /// `frame` and `layer` must outlive the object; `frame` null: no foci.
    LayerFoci(const FrameFoci* frame, const scene::Layer& layer, std::int64_t time_ns, bool has_date);

    /// Null where foci do not change the layer.
    [[nodiscard]] const FrameFoci* frame() const { return changes_ ? frame_ : nullptr; }
    /// Degree of all foci together.
    [[nodiscard]] double degree(const ElementInput& input, std::uint32_t feature) const;
    [[nodiscard]] FocusLook look(const ElementInput& input, std::uint32_t feature) const;
    /// Look of a point of a line or an area; never hidden, because a line is shown whole or not at all.
    [[nodiscard]] FocusLook look_of_point(const scene::PointOfFeature& of) const;
    /// Degree of one focus alone, also for hazards.
    [[nodiscard]] double degree_in(std::size_t focus, const ElementInput& input, std::uint32_t feature) const;
    [[nodiscard]] bool is_by_value(std::size_t focus) const { return values_[focus].has_value(); }
    [[nodiscard]] const LayerValues& values(std::size_t focus) const { return *values_[focus]; }

private:
    [[nodiscard]] double by_place(std::size_t focus, const ElementInput& input, std::uint32_t feature) const;
    [[nodiscard]] double by_value(std::size_t focus, std::uint32_t feature) const;

    const FrameFoci* frame_ = nullptr;
    const scene::Layer* layer_ = nullptr;
    bool changes_ = false;
    std::array<std::optional<LayerValues>, scene::kMaxFoci> values_{};
};

/// Look of a feature of the input; unchanged where there are no foci.
[[nodiscard]] FocusLook look_of_feature(const ElementInput& input, std::uint32_t feature);

/// Counts of a layer's items by their degree in one focus: features, posts of grids, or values for a data focus.
struct FocusCounts {
    std::uint32_t in_focus = 0, intermediate = 0, context = 0;
};
[[nodiscard]] FocusCounts count_in_focus(const FrameFoci& foci, std::size_t focus, const LayerFoci& layer,
                                         const ElementInput& input);

}  // namespace tedavis::draw
