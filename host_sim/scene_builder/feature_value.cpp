#include "host_sim/scene_builder/feature_value.hpp"

#include <algorithm>
#include <cctype>
#include <limits>

#include "host_sim/scene_builder/stated_number.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

std::optional<std::size_t> class_of(const std::vector<std::string>& classes, const std::string& text) {
    const auto is_text = [&text](const std::string& name) {
        return std::equal(name.begin(), name.end(), text.begin(), text.end(),
                          [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
    };
    const auto found = std::find_if(classes.begin(), classes.end(), is_text);
    if (found == classes.end()) return std::nullopt;
    return static_cast<std::size_t>(found - classes.begin());
}

/// A field as a number, or NaN.
double stated(const SourceFeature& feature, const std::vector<std::string>& classes, const std::string& variable,
              Misfits& misfits) {
    const auto field = feature.fields.find(variable);
    if (field == feature.fields.end()) {
        const auto values = feature.point_values.find(variable);
        const bool is_one = values != feature.point_values.end() && values->second.size() == 1;
        return is_one ? values->second[0] : kNoValue;
    }
    if (const auto number = class_of(classes, field->second)) return static_cast<double>(*number);
    const std::optional<double> number = stated_number(field->second);
    if (!number) misfits.add(field->second);
    return number.value_or(kNoValue);
}

double stated_of_point(const SourceFeature& feature, const std::vector<std::string>& classes, const std::string& variable,
                       std::size_t point, Misfits& misfits) {
    const auto values = feature.point_values.find(variable);
    if (values != feature.point_values.end()) return values->second[point];
    return stated(feature, classes, variable, misfits);
}

/// A class that the text names is taken as it is; numbers are converted.
float value_from(const AttributeRecipe& recipe, double number, const SourceFeature& feature) {
    const auto field = feature.fields.find(recipe.variable);
    const bool is_named = field != feature.fields.end() && class_of(recipe.classes, field->second).has_value();
    return is_named ? static_cast<float>(number) : bound_value(recipe, number);
}

scene::Uncertainty uncertainty_from(const AttributeRecipe& recipe, double number) {
    const std::size_t classes = recipe.uncertainty.classes.size();
    if (classes < 2 || recipe.uncertainty.kind == scene::UncertaintyKind::none) return bound_uncertainty(recipe, number);
    const auto last = static_cast<double>(classes - 1);
    return number <= last ? scene::Uncertainty::from_level(number / last) : scene::Uncertainty();
}

}  // namespace

bool is_of_points(const SourceFeatures& source, const std::string& variable) {
    return std::any_of(source.features.begin(), source.features.end(),
                       [&](const SourceFeature& feature) { return feature.point_values.count(variable) > 0; });
}

bool is_stated(const SourceFeatures& source, const std::string& variable) {
    return source.columns.count(variable) > 0 || is_of_points(source, variable) ||
           std::any_of(source.features.begin(), source.features.end(),
                       [&](const SourceFeature& feature) { return feature.fields.count(variable) > 0; });
}

float feature_value(const AttributeRecipe& recipe, const SourceFeature& feature, Misfits& misfits) {
    return value_from(recipe, stated(feature, recipe.classes, recipe.variable, misfits), feature);
}

float point_value(const AttributeRecipe& recipe, const SourceFeature& feature, std::size_t point, Misfits& misfits) {
    return value_from(recipe, stated_of_point(feature, recipe.classes, recipe.variable, point, misfits), feature);
}

scene::Uncertainty feature_uncertainty(const AttributeRecipe& recipe, const SourceFeature& feature, Misfits& misfits) {
    const UncertaintyRecipe& unsure = recipe.uncertainty;
    if (unsure.variable.empty()) return bound_uncertainty(recipe, kNoValue);
    return uncertainty_from(recipe, stated(feature, unsure.classes, unsure.variable, misfits));
}

scene::Uncertainty point_uncertainty(const AttributeRecipe& recipe, const SourceFeature& feature, std::size_t point,
                                     Misfits& misfits) {
    const UncertaintyRecipe& unsure = recipe.uncertainty;
    if (unsure.variable.empty()) return bound_uncertainty(recipe, kNoValue);
    return uncertainty_from(recipe, stated_of_point(feature, unsure.classes, unsure.variable, point, misfits));
}

}  // namespace tedavis::host_sim
