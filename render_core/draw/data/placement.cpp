#include "render_core/draw/data/placement.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/draw/data/layer_foci.hpp"

namespace tedavis::draw {
namespace {

const scene::Attribute* unsure_attribute(const ElementInput& input, const design::ColorEncoding& encoding) {
    if (encoding.is_used()) return input.layer.find(encoding.attribute.view());
    for (const scene::Attribute& attribute : input.layer.attributes)
        if (attribute.entry->uncertainty_kind != scene::UncertaintyKind::none) return &attribute;
    return nullptr;
}

Placed at_height(double latitude_rad, double longitude_rad, double height_m) {
    if (!std::isfinite(height_m)) return {};
    return {earth::to_ecef({latitude_rad, longitude_rad, {height_m}}), height_m, true};
}

constexpr std::string_view kPositionAccuracy = "position_accuracy", kHeightAccuracy = "height_accuracy";

/// Attributes of features may be asked by points, which do not count alike.
bool holds(const scene::Attribute* attribute, std::size_t n) { return attribute != nullptr && n < attribute->values.size(); }

scene::Uncertainty uncertainty_of(const scene::Attribute* attribute, const design::ColorEncoding& encoding, std::size_t n) {
    if (attribute == nullptr) return scene::Uncertainty::from_code(encoding.is_used() ? scene::Uncertainty::kUnknown : 0);
    if (attribute->entry->uncertainty_kind == scene::UncertaintyKind::none) return scene::Uncertainty::from_code(0);
    return holds(attribute, n) ? attribute->uncertainty(n) : scene::Uncertainty();
}

}  // namespace

LocalAxes local_axes(double latitude_rad, double longitude_rad) {
    const glm::dmat3 ned = earth::north_east_down(latitude_rad, longitude_rad);
    return {ned[1], ned[0], -ned[2]};
}

LocalAxes local_axes(const earth::Ecef& place) {
    constexpr double kMinPoleDistance = 1e-9;
    const glm::dvec3 up = earth::up_at(place);
    const double from_axis = std::hypot(up.x, up.y);
    const glm::dvec3 east = from_axis > kMinPoleDistance ? glm::dvec3(-up.y, up.x, 0) / from_axis : glm::dvec3(0, 1, 0);
    return {east, glm::cross(up, east), up};
}

Placed placed_over_ground(const ElementInput& input, double latitude_rad, double longitude_rad, double over_m) {
    return at_height(latitude_rad, longitude_rad, over_m + input.ground.height_m(latitude_rad, longitude_rad));
}

Placed placed(const ElementInput& input, double latitude_rad, double longitude_rad, double height_m) {
    if (std::isnan(height_m)) return placed_over_ground(input, latitude_rad, longitude_rad, 0);
    switch (input.layer.entry->height_datum) {
        case scene::HeightDatum::ground: return placed_over_ground(input, latitude_rad, longitude_rad, height_m);
        case scene::HeightDatum::msl:
            return at_height(latitude_rad, longitude_rad, height_m + input.ground.undulation_m(latitude_rad, longitude_rad));
        default: return at_height(latitude_rad, longitude_rad, height_m);
    }
}

Placed placed(const ElementInput& input, const scene::ScenePoint& point) {
    return placed(input, point.latitude_rad, point.longitude_rad, static_cast<double>(point.height_m));
}

double height_in_datum_m(const ElementInput& input, double latitude_rad, double longitude_rad, double height_m) {
    switch (input.layer.entry->height_datum) {
        case scene::HeightDatum::ground: return height_m - input.ground.height_m(latitude_rad, longitude_rad);
        case scene::HeightDatum::msl: return height_m - input.ground.undulation_m(latitude_rad, longitude_rad);
        default: return height_m;
    }
}

namespace {

design::Color color_of_value(const ElementInput& input, const design::ColorEncoding& encoding, std::size_t n) {
    if (!encoding.is_used()) return input.element.color;
    const scene::Attribute* const attribute = input.layer.find(encoding.attribute.view());
    if (!holds(attribute, n) || attribute->state(n) == scene::ValueState::missing) return input.missing;
    const double value = static_cast<double>(attribute->values[n]);
    if (!encoding.scale.palette.is_nominal()) return design::scale_color(encoding.scale, value);
    if (attribute->entry->class_count == 0) return input.missing;
    const design::Color color =
        design::color_of_name(encoding.scale.palette, attribute->class_name(static_cast<std::uint32_t>(value)));
    return color.alpha > 0 ? color : input.missing;
}

}  // namespace

design::Color encoded_color(const ElementInput& input, const design::ColorEncoding& encoding, std::size_t n) {
    const design::Color color = color_of_value(input, encoding, n);
    return input.foci == nullptr ? color : shown_color(input.foci->look(input, static_cast<std::uint32_t>(n)), color);
}

scene::Uncertainty encoded_uncertainty(const ElementInput& input, std::size_t n) {
    return uncertainty_of(unsure_attribute(input, input.element.by_color), input.element.by_color, n);
}

double uncertainty_growth_per_hour(const ElementInput& input) {
    const scene::Attribute* const attribute = unsure_attribute(input, input.element.by_color);
    return attribute == nullptr ? 0 : static_cast<double>(attribute->entry->uncertainty_growth_per_hour);
}

design::Color encoded_color(const ElementInput& input, const design::ColorEncoding& encoding, const scene::PointOfFeature& of) {
    const design::Color color =
        color_of_value(input, encoding, scene::value_number(input.layer.find(encoding.attribute.view()), of));
    return input.foci == nullptr ? color : shown_color(input.foci->look_of_point(of), color);
}

scene::Uncertainty encoded_uncertainty(const ElementInput& input, const design::ColorEncoding& encoding,
                                       const scene::PointOfFeature& of) {
    const scene::Attribute* const attribute = unsure_attribute(input, encoding);
    return uncertainty_of(attribute, encoding, scene::value_number(attribute, of));
}

PlaceAccuracy place_accuracy(const scene::Layer& layer, const scene::PointOfFeature& of) {
    const auto stated = [&](std::string_view attribute, float whole_m) {
        const double own_m = scene::value_or_nan(layer, attribute, of);
        return own_m > 0 ? own_m : static_cast<double>(whole_m);
    };
    return {stated(kPositionAccuracy, layer.entry->position_accuracy_m), stated(kHeightAccuracy, layer.entry->height_accuracy_m)};
}

PlaceAccuracy cautious_accuracy(const scene::Layer& layer, const scene::PointOfFeature& of, const PlaceAccuracy& worst) {
    PlaceAccuracy accuracy = place_accuracy(layer, of);
    if (!(accuracy.level_m > 0)) accuracy.level_m = worst.level_m;
    if (!(accuracy.height_m > 0)) accuracy.height_m = worst.height_m;
    if (!(accuracy.height_m > 0)) accuracy.height_m = accuracy.level_m;
    return accuracy;
}

PlaceAccuracy worst_accuracy(const scene::Layer& layer) {
    const auto worst = [&](std::string_view name) {
        const scene::Attribute* const attribute = layer.find(name);
        return attribute == nullptr ? 0 : std::fmax(double{attribute->entry->maximum}, 0.0);
    };
    return {worst(kPositionAccuracy), worst(kHeightAccuracy)};
}

bool states_accuracy(const scene::Layer& layer) {
    return layer.entry->position_accuracy_m > 0 || layer.find(kPositionAccuracy) != nullptr;
}

}  // namespace tedavis::draw
