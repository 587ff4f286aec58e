#include "host_sim/scene_builder/draft_of.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::int64_t kDraftMinute_ns = 60'000'000'000;

template <class T>
std::vector<T> copied(const base::Span<const T>& values) {
    return {values.begin(), values.end()};
}

AttributeDraft draft_of_attribute(const scene::Attribute& attribute, const scene::Scene& scene) {
    const scene::AttributeEntry& entry = *attribute.entry;
    AttributeDraft draft;
    draft.name = entry.name;
    draft.title = entry.title;
    draft.unit = entry.unit;
    draft.scale = entry.scale;
    draft.of = entry.of;
    for (std::uint32_t n = 0; n < entry.class_count; ++n) draft.classes.emplace_back(attribute.class_name(n));
    draft.values = copied(attribute.values);
    draft.uncertainties = copied(attribute.uncertainties);
    draft.states = copied(attribute.states);
    for (std::uint32_t n = 0; n < attribute.member_count(); ++n) draft.members.push_back(copied(attribute.member(n).values));
    draft.uncertainty_all = entry.uncertainty_all;
    draft.uncertainty_kind = entry.uncertainty_kind;
    draft.uncertainty_scope = entry.uncertainty_scope;
    if (entry.derived_from > 0) draft.derived_from = scene.layers()[entry.derived_from - 1u].entry->name;
    if (entry.derived_minute > 0) draft.derived_time_ns = entry.derived_minute * kDraftMinute_ns;
    draft.uncertainty_full = static_cast<double>(entry.uncertainty_full);
    draft.uncertainty_growth_per_hour = static_cast<double>(entry.uncertainty_growth_per_hour);
    return draft;
}

LayerDraft draft_of_layer(const scene::Layer& layer, const scene::Scene& scene) {
    const scene::LayerEntry& entry = *layer.entry;
    LayerDraft draft;
    draft.name = entry.name;
    draft.title = entry.title;
    draft.source = entry.source;
    draft.shape = entry.shape;
    draft.role = entry.role;
    draft.height_datum = entry.height_datum;
    draft.importance = entry.importance;
    draft.data_time_ns = entry.data_time_ns;
    draft.valid_from_ns = entry.valid_from_ns;
    draft.valid_until_ns = entry.valid_until_ns;
    draft.position_accuracy_m = static_cast<double>(entry.position_accuracy_m);
    draft.height_accuracy_m = static_cast<double>(entry.height_accuracy_m);
    draft.grid = entry.grid;
    draft.levels_m = copied(layer.levels_m);
    draft.times_ns = copied(layer.times_ns);
    draft.points = copied(layer.points);
    draft.starts = copied(layer.starts);
    for (std::uint32_t n = 0; n * scene::kNameBytes < layer.names.size(); ++n) draft.names.emplace_back(layer.name_of(n));
    draft.model.vertices = copied(layer.vertices);
    for (std::size_t n = 0; n + 2 < layer.triangles.size(); n += 3)
        draft.model.triangles.push_back({layer.triangles[n], layer.triangles[n + 1], layer.triangles[n + 2]});
    for (const scene::Attribute& attribute : layer.attributes) draft.attributes.push_back(draft_of_attribute(attribute, scene));
    return draft;
}

}  // namespace

SceneDraft draft_of(const scene::Scene& scene) {
    SceneDraft draft;
    draft.name = scene.header().name;
    draft.origin = scene.header().origin;
    draft.revision = scene.header().revision;
    for (const scene::Layer& layer : scene.layers()) draft.layers.push_back(draft_of_layer(layer, scene));
    return draft;
}

}  // namespace tedavis::host_sim
