#include "render_core/draw/data/degree_of_interest.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::draw {
namespace {

constexpr double kNear_m = 1000;
constexpr double kFewPeople = 100, kManyPeople = 1'000'000;
constexpr double kUnknown = 0.5;

double value_of(const scene::Attribute& attribute, std::uint32_t n) {
    return n < attribute.values.size() ? static_cast<double>(attribute.values[n]) : std::nan("");
}

/// 0..1; what is not known is neither.
double share(double value, double full) { return value == value ? std::clamp(value / full, 0.0, 1.0) : kUnknown; }

const scene::Attribute* of_each_feature(const scene::Layer& layer, std::string_view name) {
    const scene::Attribute* const attribute = layer.find(name);
    const bool is_of_features =
        layer.entry->shape == scene::LayerShape::points || layer.entry->shape == scene::LayerShape::meshes;
    return attribute != nullptr && (is_of_features || attribute->entry->of == scene::AttributeOf::feature) ? attribute : nullptr;
}

/// Nothing is told apart by values that are all 0.
const scene::Attribute* positive(const scene::Attribute* attribute) {
    return attribute != nullptr && attribute->entry->maximum > 0 ? attribute : nullptr;
}

}  // namespace

DegreeOfInterest::DegreeOfInterest(const scene::Layer& layer, const design::LabelSettings& settings)
    : weights_(settings.weights), relevance_(settings.relevance_of(layer.entry->role)) {
    population_ = of_each_feature(layer, "population");
    const scene::Attribute* const kind = of_each_feature(layer, "kind");
    const bool is_ranked =
        kind != nullptr && kind->entry->scale == scene::AttributeScale::ordinal && kind->entry->class_count > 1;
    if (population_ == nullptr && is_ranked) kind_ = kind;
    height_ = positive(of_each_feature(layer, "height"));
    if (height_ == nullptr) height_ = positive(of_each_feature(layer, "elevation"));
    if (layer.entry->role == scene::LayerRole::runway) length_ = of_each_feature(layer, "length");
}

double DegreeOfInterest::of(std::uint32_t feature, double distance_m) const {
    double sum = 0, weight = 0;
    const auto add = [&](double weighs, double criterion) {
        sum += weighs * criterion;
        weight += weighs;
    };
    add(weights_.distance, nearness(distance_m));
    add(weights_.relevance, relevance_);
    if (population_ != nullptr || kind_ != nullptr) add(weights_.population, population(feature));
    if (height_ != nullptr) add(weights_.height, share(value_of(*height_, feature), double{height_->entry->maximum}));
    if (length_ != nullptr) add(weights_.runway_length, share(value_of(*length_, feature), kLongRunway_m));
    return weight > 0 ? sum / weight : 0;
}

double DegreeOfInterest::nearness(double distance_m) {
    return std::clamp(1 - std::log1p(distance_m / kNear_m) / std::log1p(kFarthestBillboard_m / kNear_m), 0.0, 1.0);
}

double DegreeOfInterest::population(std::uint32_t feature) const {
    if (population_ == nullptr) return share(value_of(*kind_, feature), kind_->entry->class_count - 1.0);
    const double people = value_of(*population_, feature);
    return people == people ? share(std::log(std::max(people, 1.0) / kFewPeople), std::log(kManyPeople / kFewPeople)) : kUnknown;
}

}  // namespace tedavis::draw
