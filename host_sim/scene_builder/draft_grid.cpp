#include "host_sim/scene_builder/draft_grid.hpp"

namespace tedavis::host_sim {
namespace {

template <class T>
base::Span<const T> view(const std::vector<T>& values) {
    return {values.data(), values.size()};
}

}  // namespace

DraftGrid::DraftGrid(const LayerDraft& draft) : draft_(draft), entries_(draft.attributes.size()) {
    entry_.shape = draft.shape;
    entry_.role = draft.role;
    entry_.height_datum = draft.height_datum;
    entry_.data_time_ns = draft.data_time_ns;
    entry_.grid = draft.grid;
    for (std::size_t n = 0; n < draft.attributes.size(); ++n) {
        const AttributeDraft& from = draft.attributes[n];
        entries_[n].scale = from.scale;
        entries_[n].of = from.of;
        entries_[n].uncertainty_kind = from.uncertainty_kind;
        entries_[n].uncertainty_full = static_cast<float>(from.uncertainty_full);
        entries_[n].uncertainty_growth_per_hour = static_cast<float>(from.uncertainty_growth_per_hour);
        entries_[n].uncertainty_all = from.uncertainty_all;
        attributes_.push_back({&entries_[n], view(from.values), view(from.uncertainties), view(from.states), {}, {}});
    }
    layer_.entry = &entry_;
    layer_.levels_m = view(draft.levels_m);
    layer_.times_ns = view(draft.times_ns);
    layer_.attributes = view(attributes_);
}

const scene::Attribute* DraftGrid::find(std::string_view name) const {
    for (std::size_t n = 0; n < draft_.attributes.size(); ++n)
        if (draft_.attributes[n].name == name) return &attributes_[n];
    return nullptr;
}

}  // namespace tedavis::host_sim
