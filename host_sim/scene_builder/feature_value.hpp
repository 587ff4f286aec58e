/// Evaluates a recipe's attribute for one feature, or for each of its points.
#pragma once

#include <string>

#include "host_sim/scene_builder/bound_attribute.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// Number of stated values that could not be converted, and the first of them.
struct Misfits {
    std::size_t count = 0;
    std::string first;

    void add(const std::string& text) {
        if (count++ == 0) first = text;
    }
};

/// True when a feature states the variable, or the file has a column for it.
[[nodiscard]] bool is_stated(const SourceFeatures& source, const std::string& variable);
/// True if a feature states the variable for each point.
[[nodiscard]] bool is_of_points(const SourceFeatures& source, const std::string& variable);

/// Returns the attribute's value: a number, or the number of the class that the text names, ignoring case. NaN where nothing is
/// stated, and where the text is neither, which `misfits` counts.
[[nodiscard]] float feature_value(const AttributeRecipe& recipe, const SourceFeature& feature, Misfits& misfits);
/// The same for one of its points; a value that is stated for the feature holds for all its points.
[[nodiscard]] float point_value(const AttributeRecipe& recipe, const SourceFeature& feature, std::size_t point, Misfits& misfits);

/// Return the uncertainties of these values, from the recipe's number or variable; of classes of certainty the first is certain
/// and the last is fully uncertain.
[[nodiscard]] scene::Uncertainty feature_uncertainty(const AttributeRecipe& recipe, const SourceFeature& feature,
                                                     Misfits& misfits);
[[nodiscard]] scene::Uncertainty point_uncertainty(const AttributeRecipe& recipe, const SourceFeature& feature, std::size_t point,
                                                   Misfits& misfits);

}  // namespace tedavis::host_sim
