#include "render_core/draw/data/label_features.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/billboard_place.hpp"
#include "render_core/draw/data/billboard_shape.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kBehind_m = 10'000;  // of the eye: what the ground's height may bring forward again
constexpr double kBeyond = 1e-6;      // a limit, by more than what a float rounds off
constexpr double kBeside_rad = 0.5;   // of the picture's corners: as far as an eye turns in an interval

/// Of the angle to the view's middle up to which features are offered.
double widest_cosine(const terrain::View& view) {
    const double corner = std::atan(std::hypot(view.half_width_tangent(), view.half_height_tangent()));
    return std::cos(std::min(corner + kBeside_rad, 1.5));
}

/// Shares of the picture from its middle.
double across(const glm::dvec3& from_eye, const terrain::View& view) {
    return 0.5 * glm::dot(from_eye, view.right) / (glm::dot(from_eye, view.forward) * view.half_width_tangent());
}
double down(const glm::dvec3& from_eye, const terrain::View& view) {
    return 0.5 * glm::dot(from_eye, view.down) / (glm::dot(from_eye, view.forward) * view.half_height_tangent());
}

glm::dvec3 way_to(const scene::ScenePoint& anchor, const terrain::View& view) {
    const double height_m = std::isnan(anchor.height_m) ? 0 : static_cast<double>(anchor.height_m);
    return earth::to_ecef({anchor.latitude_rad, anchor.longitude_rad, {height_m}}) - view.eye;
}

/// Of a layer that steps back beside the foci.
bool is_in_focus(const ElementInput& input, std::uint32_t feature) {
    return input.foci != nullptr && input.foci->frame() != nullptr && input.foci->degree(input, feature) >= 1;
}

/// What may lie within reach, by latitude and longitude alone: most of a large layer does not.
class Reach {
public:
    explicit Reach(const SignView& view) : eye_(earth::from_ecef(view.view.eye)) {
        const double reach_rad = kFarthestBillboard_m / view.seen_distance_m(1) / kMinRadius_m;
        const double farthest_rad = std::fabs(eye_.latitude_rad) + reach_rad;
        latitude_rad_ = reach_rad;
        if (farthest_rad < kHighLatitude_rad) longitude_rad_ = reach_rad / std::cos(farthest_rad);
    }
    [[nodiscard]] bool may_hold(const scene::ScenePoint& point) const {
        const double east = std::fabs(point.longitude_rad - eye_.longitude_rad);
        return std::fabs(point.latitude_rad - eye_.latitude_rad) <= latitude_rad_ &&
               std::fmin(east, 2 * base::kPi - east) <= longitude_rad_;
    }

private:
    static constexpr double kMinRadius_m = 6.2e6;  ///< less than any of the ellipsoid, and than what a chord cuts short
    static constexpr double kHighLatitude_rad = 1.5;
    earth::Geodetic eye_;
    double latitude_rad_ = 0, longitude_rad_ = base::kPi;
};

}  // namespace

bool is_protected(const scene::Layer& layer) {
    const scene::LayerRole role = layer.entry->role;
    return role == scene::LayerRole::obstacle || role == scene::LayerRole::storm_cell || has_limits(layer);
}

LabelGroup label_group(const ElementInput& input) {
    LabelGroup group;
    group.is_protected = is_protected(input.layer);
    group.named_share = input.element.detail;
    const bool are_places = input.layer.entry->role == scene::LayerRole::place;
    // Of foci the intermediate context has markers without names.
    group.only_named = are_places && (input.foci == nullptr || input.foci->frame() == nullptr);
    if (are_places && group.named_share < 1) group.most = std::ceil(kMaxPlaces * group.named_share);
    return group;
}

void offer_features(const ElementInput& input, std::uint32_t group, const SignView& view, const design::LabelSettings& settings,
                    LabelPlanner& planner) {
    const DegreeOfInterest interest(input.layer, settings);
    const double widest = widest_cosine(view.view);
    const Reach reach(view);
    const bool warns = is_protected(input.layer);
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        scene::ScenePoint anchor;
        if (!anchor_of(input, feature, anchor) || !reach.may_hold(anchor)) continue;
        const glm::dvec3 from_eye = way_to(anchor, view.view);
        const double length_m = glm::length(from_eye), distance_m = view.seen_distance_m(length_m);
        if (!(distance_m <= kFarthestBillboard_m)) continue;
        if (glm::dot(from_eye, view.view.forward) <= widest * length_m - kBehind_m) continue;
        const FocusLook look = look_of_feature(input, feature);
        if (look.is_hidden) continue;
        double degree = interest.of(feature, distance_m);
        if (look.detail < 1)
            degree = settings.marker_above + kBeyond;
        else if (is_in_focus(input, feature))
            degree = std::fmax(degree, settings.name_above + kBeyond);
        planner.offer(label_key(group, feature), degree, warns ? DegreeOfInterest::nearness(distance_m) : degree);
    }
}

LabelLevel level_left(const ElementInput& input, std::uint32_t feature, const SignView& view,
                      const design::LabelSettings& settings, const scene::DetailRegions& regions) {
    scene::ScenePoint anchor;
    if (is_protected(input.layer) || is_in_focus(input, feature) || !anchor_of(input, feature, anchor)) return LabelLevel::name;
    const glm::dvec3 from_eye = way_to(anchor, view.view);
    if (!(glm::dot(from_eye, view.view.forward) > 0)) return LabelLevel::name;
    const double left = regions.at(0.5 + across(from_eye, view.view), 0.5 + down(from_eye, view.view));
    if (left >= 1) return LabelLevel::name;
    const double distance_m = view.seen_distance_m(glm::length(from_eye));
    const double degree = left * DegreeOfInterest(input.layer, settings).of(feature, distance_m) + LabelPlanner::kHeldBonus;
    if (degree >= settings.name_above) return LabelLevel::name;
    return degree >= settings.marker_above && !label_group(input).only_named ? LabelLevel::marker : LabelLevel::none;
}

LabelShape label_shape(const ElementInput& input, std::uint32_t feature, const SignView& view) {
    BillboardShape shape;
    if (!billboard_shape(input, feature, view, true, shape)) return {};
    return {shape.box, true, sign_stems(input.layer)};
}

}  // namespace tedavis::draw
