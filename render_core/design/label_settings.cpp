#include "render_core/design/label_settings.hpp"

#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

constexpr double kMaxWeight = 10, kMaxDwell_s = 60, kMinChanges = 0.1, kMaxChanges = 100, kUsualRelevance = 0.5;

void read_weights(base::ConfigSection& section, LabelWeights& weights) {
    weights.distance = section.number("distance", 0, kMaxWeight, weights.distance);
    weights.population = section.number("population", 0, kMaxWeight, weights.population);
    weights.height = section.number("height", 0, kMaxWeight, weights.height);
    weights.runway_length = section.number("runway_length", 0, kMaxWeight, weights.runway_length);
    weights.relevance = section.number("relevance", 0, kMaxWeight, weights.relevance);
    if (weights.distance + weights.relevance > 0) return;
    fault_of(section, "relevance", "and 'distance' must not both be 0; nothing else is known of every feature");
}

}  // namespace

double LabelSettings::relevance_of(scene::LayerRole role) const {
    for (std::size_t n = 0; n < kLabelRoles.size(); ++n)
        if (kLabelRoles[n] == role) return relevance[n];
    return kUsualRelevance;
}

void read_label_settings(base::ConfigSection section, LabelSettings& labels) {
    read_weights(section, labels.weights);
    labels.name_above = section.number("name_above", 0, 1, labels.name_above);
    labels.marker_above = section.number("marker_above", 0, 1, labels.marker_above);
    if (labels.marker_above > labels.name_above)
        fault_of(section, "marker_above", "must not be more than 'name_above': what has a name has a marker");
    labels.dwell_s = section.number("dwell_s", 0, kMaxDwell_s, labels.dwell_s);
    labels.most_changes = section.number("most_changes", kMinChanges, kMaxChanges, labels.most_changes);
    labels.show_suppressed = section.boolean("show_suppressed", labels.show_suppressed);
    base::ConfigSection relevance = section.section("role_relevance");
    for (std::size_t n = 0; n < kLabelRoles.size(); ++n)
        labels.relevance[n] = relevance.number(scene::name_of(kLabelRoles[n]), 0, 1, labels.relevance[n]);
}

}  // namespace tedavis::design
