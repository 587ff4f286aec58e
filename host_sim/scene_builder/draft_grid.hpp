/// Presents the draft of a grid layer as a scene::Layer. The draft must outlive this object, unchanged.
#pragma once

#include <string_view>
#include <vector>

#include "host_sim/scene_builder/scene_draft.hpp"
#include "render_core/scene/grid_field.hpp"

namespace tedavis::host_sim {

class DraftGrid {
public:
    explicit DraftGrid(const LayerDraft& draft);
    DraftGrid(const DraftGrid&) = delete;
    DraftGrid& operator=(const DraftGrid&) = delete;

    [[nodiscard]] const scene::Layer& layer() const { return layer_; }
    /// Null where the layer has no attribute of that name.
    [[nodiscard]] const scene::Attribute* find(std::string_view name) const;

private:
    const LayerDraft& draft_;
    scene::LayerEntry entry_{};
    std::vector<scene::AttributeEntry> entries_;
    std::vector<scene::Attribute> attributes_;
    scene::Layer layer_;
};

}  // namespace tedavis::host_sim
