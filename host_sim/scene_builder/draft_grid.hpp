/// The layer of a grid that is still a draft, as readers of scenes see it. The draft must outlive it, unchanged.
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
    /// Null where it has none of that name.
    [[nodiscard]] const scene::Attribute* find(std::string_view name) const;

private:
    const LayerDraft& draft_;
    scene::LayerEntry entry_{};
    std::vector<scene::AttributeEntry> entries_;
    std::vector<scene::Attribute> attributes_;
    scene::Layer layer_;
};

}  // namespace tedavis::host_sim
