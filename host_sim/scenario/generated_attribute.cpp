#include "host_sim/scenario/generated_attribute.hpp"

namespace tedavis::host_sim {

AttributeDraft generated_attribute(const std::string& name, const std::string& title, const std::string& unit,
                                   double full_sigma) {
    AttributeDraft attribute;
    attribute.name = name;
    attribute.title = title;
    attribute.unit = unit;
    if (full_sigma > 0) attribute.uncertainty_kind = scene::UncertaintyKind::standard_deviation;
    attribute.uncertainty_full = full_sigma;
    return attribute;
}

void add_value(AttributeDraft& attribute, double value, double sigma) {
    attribute.values.push_back(static_cast<float>(value));
    attribute.uncertainties.push_back(scene::Uncertainty::from_level(sigma / attribute.uncertainty_full));
}

}  // namespace tedavis::host_sim
