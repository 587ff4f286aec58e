/// How far the features of a layer are in the foci of a frame: by the value that a data focus asks for, else by their nearest
/// place on the ground: of points their own, in volumes with their height; of lines and areas their points, the places of their
/// sides that are nearest to the focus' own points, and an area that such a point lies in. Of several foci the greatest counts.
///
/// What may be dangerous (obstacles, other aircraft, no-go areas, storm cells) is in the focus wherever it is.
///
/// Pure but for the ground, which is asked for heights within volumes. Bounded: a feature's points. Thread  the ground's.
#pragma once

#include <optional>

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/frame_foci.hpp"
#include "render_core/draw/data/layer_values.hpp"
#include "render_core/draw/data/placement.hpp"

namespace tedavis::draw {

/// What foci leave as it is.
[[nodiscard]] bool is_hazard(scene::LayerRole role) noexcept;

class LayerFoci {
public:
    LayerFoci() = default;  ///< everything is in the focus
    /// `frame` and `layer` must stay; null: there are no foci.
    LayerFoci(const FrameFoci* frame, const scene::Layer& layer, std::int64_t time_ns, bool has_date);

    /// Null where all of the layer is as it is without foci.
    [[nodiscard]] const FrameFoci* frame() const { return changes_ ? frame_ : nullptr; }
    /// Of the foci together.
    [[nodiscard]] double degree(const ElementInput& input, std::uint32_t feature) const;
    [[nodiscard]] FocusLook look(const ElementInput& input, std::uint32_t feature) const;
    /// Of a point of a line or an area; never hidden, for the line is seen whole or not at all.
    [[nodiscard]] FocusLook look_of_point(const scene::PointOfFeature& of) const;
    /// Of one focus by itself, whether the layer is dangerous or not.
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

/// What a feature of the input looks like; as it is where there are no foci.
[[nodiscard]] FocusLook look_of_feature(const ElementInput& input, std::uint32_t feature);

/// Elements of a layer by what one focus makes of them: features; of grids posts, of data focus values.
struct FocusCounts {
    std::uint32_t in_focus = 0, intermediate = 0, context = 0;
};
[[nodiscard]] FocusCounts count_in_focus(const FrameFoci& foci, std::size_t focus, const LayerFoci& layer,
                                         const ElementInput& input);

}  // namespace tedavis::draw
