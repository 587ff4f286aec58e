#include "render_core/draw/data/feature_sight.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kMargin_m = 300, kMarginShare = 0.005;
constexpr double kLowest_m = -500, kHighest_m = 15'000;  // of what has no stated heights
constexpr int kViewSides = 5;
constexpr unsigned kAllViewSides = (1u << kViewSides) - 1;

/// Round which the surroundings are mapped: the eye's own place; of eyes far above what they look at, from where the Earth is a
/// small part of the view.
glm::dvec3 middle_of(const terrain::View& view) {
    constexpr double kHighEye_m = 50'000;
    const double radius_m = earth::kMeanRadius_m, from_centre_m = glm::length(view.eye);
    const double towards_m = -glm::dot(view.eye, view.forward);
    const double square = towards_m * towards_m - (from_centre_m * from_centre_m - radius_m * radius_m);
    if (from_centre_m < radius_m + kHighEye_m || towards_m <= 0 || square < 0) return view.eye;
    return view.eye + view.forward * (towards_m - std::sqrt(square));
}

class Sight {
public:
    explicit Sight(const terrain::View& view) : Sight(view, middle_of(view)) {}
    Sight(const terrain::View& view, const glm::dvec3& middle)
        : middle_(earth::from_ecef(middle)), from_eye_(middle - view.eye), axes_(local_axes(middle)) {
        const double across = view.half_width_tangent(), along = view.half_height_tangent();
        const glm::dvec3 inwards[kViewSides] = {view.forward * across + view.right, view.forward * across - view.right,
                                                view.forward * along + view.down, view.forward * along - view.down, view.forward};
        for (int n = 0; n < kViewSides; ++n) inwards_[n] = glm::normalize(inwards[n]);
        for (const earth::Magnifier& magnifier : view.magnifiers) moved_m_ = std::fmax(moved_m_, magnifier.farthest_move_m());
        sine_ = std::sin(middle_.latitude_rad);
        cosine_ = std::cos(middle_.latitude_rad);
        across_m_ = earth::prime_vertical_radius_m(middle_.latitude_rad);
        along_m_ = earth::meridian_radius_m(middle_.latitude_rad);
    }

    /// A bit a side that the point is beyond, from one height to another, when it has gone so far east and north.
    [[nodiscard]] unsigned beyond(const scene::ScenePoint& point, const glm::dvec2& gone_m, double low_m, double high_m) const {
        const double north = point.latitude_rad - middle_.latitude_rad;
        const double east = std::remainder(point.longitude_rad - middle_.longitude_rad, 2 * base::kPi);
        if (!(std::fabs(north) < kFarthestSight_rad && std::fabs(east) < kFarthestSight_rad)) return 0;
        const double there = cosine_ - north * (sine_ + 0.5 * north * cosine_);  // cosine of its latitude
        const double east_m = across_m_ * there * east + gone_m.x;
        const double north_m = along_m_ * north + 0.5 * across_m_ * sine_ * there * east * east + gone_m.y;
        const double square = east_m * east_m + north_m * north_m;
        const double sunk_m = square / (across_m_ + along_m_) + middle_.height.m;
        const double margin_m = kMargin_m + kMarginShare * std::sqrt(square) + moved_m_;
        const glm::dvec3 level = from_eye_ + axes_.east * east_m + axes_.north * north_m;
        const glm::dvec3 low = level + axes_.up * (low_m - sunk_m), high = level + axes_.up * (high_m - sunk_m);
        unsigned sides = 0;
        for (int n = 0; n < kViewSides; ++n)
            if (glm::dot(inwards_[n], low) < -margin_m && glm::dot(inwards_[n], high) < -margin_m) sides |= 1u << n;
        return sides;
    }

private:
    earth::Geodetic middle_;
    glm::dvec3 from_eye_;
    LocalAxes axes_;
    glm::dvec3 inwards_[kViewSides]{};
    double sine_ = 0, cosine_ = 1, across_m_ = 1, along_m_ = 1;
    double moved_m_ = 0;  ///< as far as magnifiers move things
};

/// Areas have limits of their own, and in space-time the height is none.
bool has_heights(const ElementInput& input) {
    return input.layer.entry->shape != scene::LayerShape::areas &&
           input.layer.entry->height_datum != scene::HeightDatum::ground &&
           input.element.technique != design::DataTechnique::space_time;
}

bool is_out(const Sight& sight, const ElementInput& input, const scene::Run& run, const glm::dvec2& gone_m) {
    const bool with_heights = has_heights(input);
    unsigned sides = kAllViewSides;
    for (std::uint32_t n = 0; n < run.count && sides != 0; ++n) {
        const scene::ScenePoint& point = input.layer.points[run.first + n];
        const double height_m = static_cast<double>(point.height_m);
        const bool is_stated = with_heights && std::isfinite(height_m);
        sides &= sight.beyond(point, gone_m, is_stated ? height_m : kLowest_m, is_stated ? height_m : kHighest_m);
    }
    return sides != 0;
}

bool counts_points(const ElementInput& input) {
    return input.element.technique == design::DataTechnique::tube || input.element.technique == design::DataTechnique::space_time;
}

}  // namespace

std::uint32_t count_out_of_view(const ElementInput& input, const terrain::View& view) {
    const Sight sight(view);
    const scene::LayerShape shape = input.layer.entry->shape;
    const bool has_runs = shape == scene::LayerShape::lines || shape == scene::LayerShape::areas;
    std::uint32_t count = 0;
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        const scene::Run run = has_runs ? input.layer.points_of(feature) : scene::Run{feature, 1};
        if (is_out(sight, input, run, scene::drift_m(input.layer, feature, input.time_ns, input.has_date)))
            count += counts_points(input) ? run.count : 1;
    }
    return count;
}

}  // namespace tedavis::draw
