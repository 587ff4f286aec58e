#include "host_sim/scene_builder/bound_attribute.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tedavis::host_sim {

AttributeDraft bind_attribute(const AttributeRecipe& recipe) {
    AttributeDraft attribute;
    attribute.name = recipe.name;
    attribute.title = recipe.title;
    attribute.unit = recipe.unit;
    attribute.scale = recipe.scale;
    attribute.classes = recipe.classes;
    attribute.uncertainty_kind = recipe.uncertainty.kind;
    attribute.uncertainty_scope = recipe.uncertainty.scope;
    attribute.uncertainty_full = recipe.uncertainty.full;
    attribute.uncertainty_growth_per_hour = recipe.uncertainty.growth_per_hour;
    return attribute;
}

double stated_value(const AttributeRecipe& recipe, double stated) {
    const double value = recipe.undetected && stated == *recipe.undetected ? recipe.undetected_value : stated;
    const bool is_missing = !std::isfinite(value) ||
                            std::find(recipe.missing.begin(), recipe.missing.end(), value) != recipe.missing.end() ||
                            (recipe.least && value < *recipe.least) || (recipe.most && value > *recipe.most);
    return is_missing ? std::numeric_limits<double>::quiet_NaN() : value;
}

float bound_value(const AttributeRecipe& recipe, double stated) {
    constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
    double value = stated_value(recipe, stated);
    if (std::isnan(value)) return kMissing;
    if (!recipe.class_values.empty()) {
        const auto found = std::find(recipe.class_values.begin(), recipe.class_values.end(), value);
        return found == recipe.class_values.end() ? kMissing : static_cast<float>(found - recipe.class_values.begin());
    }
    value = recipe.factor * value + recipe.offset;
    if (recipe.scale == scene::AttributeScale::quantitative) return static_cast<float>(value);
    const bool is_class = value == std::floor(value) && value >= 0 && value < static_cast<double>(recipe.classes.size());
    return is_class ? static_cast<float>(value) : kMissing;
}

scene::Uncertainty bound_uncertainty(const AttributeRecipe& recipe, double stated) {
    constexpr double kMaxPercent = 100, kRounding = 1e-6;  // of a bound
    const UncertaintyRecipe& unsure = recipe.uncertainty;
    if (unsure.kind == scene::UncertaintyKind::none) return {};
    const double in_unit = unsure.value.value_or(stated);
    if (!(in_unit >= 0) || std::isinf(in_unit)) return {};
    const bool is_of_full = unsure.is_quality || unsure.kind == scene::UncertaintyKind::ordinal;
    if (is_of_full && in_unit > unsure.full * (1 + kRounding)) return {};
    if (unsure.kind == scene::UncertaintyKind::percent && in_unit > kMaxPercent * (1 + kRounding)) return {};
    const double level = std::fmin(in_unit / unsure.full, 1);
    return scene::Uncertainty::from_level(unsure.is_quality ? 1 - level : level);
}

}  // namespace tedavis::host_sim
