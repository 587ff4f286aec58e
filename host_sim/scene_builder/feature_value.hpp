/// Evaluates a recipe's attribute for one feature, or for each of its points.
#pragma once

#include <string>

#include "host_sim/scene_builder/bound_attribute.hpp"
#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// Stated values that could not be taken, and the first of them.
struct Misfits {
    std::size_t count = 0;
    std::string first;

    void add(const std::string& text) {
        if (count++ == 0) first = text;
    }
};

/// True when a feature states the variable, or the file has a column for it.
[[nodiscard]] bool is_stated(const SourceFeatures& source, const std::string& variable);
/// True when a feature states it of each point.
[[nodiscard]] bool is_of_points(const SourceFeatures& source, const std::string& variable);

/// The attribute's value: a number, or the number of the class that the text names, whose case does not matter. NaN where nothing
/// is stated, and where the text is neither, which `misfits` counts.
[[nodiscard]] float feature_value(const AttributeRecipe& recipe, const SourceFeature& feature, Misfits& misfits);
/// The same of one of its points; what is only stated of the feature holds for all of them.
[[nodiscard]] float point_value(const AttributeRecipe& recipe, const SourceFeature& feature, std::size_t point, Misfits& misfits);

/// How unsure these are, from the recipe's number or from its variable; of classes of certainty the first is certain and the last
/// is wholly unsure.
[[nodiscard]] scene::Uncertainty feature_uncertainty(const AttributeRecipe& recipe, const SourceFeature& feature,
                                                     Misfits& misfits);
[[nodiscard]] scene::Uncertainty point_uncertainty(const AttributeRecipe& recipe, const SourceFeature& feature, std::size_t point,
                                                   Misfits& misfits);

}  // namespace tedavis::host_sim
