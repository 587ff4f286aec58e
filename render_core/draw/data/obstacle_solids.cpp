#include "render_core/draw/data/obstacle_solids.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/icons.hpp"
#include "render_core/draw/data/obstacle_color.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/draw/data/solid_shapes.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/obstacle_stand.hpp"

namespace tedavis::draw {
namespace {

constexpr design::Color kBand{240, 240, 240};
constexpr int kBands = 7;  // ICAO Annex 14, 6.2: bands of a seventh of the height
constexpr int kFewestBands = 3, kFewestSides = 4;
constexpr double kGuyReach = 0.45, kJibReach = 0.8, kRotorReach = 0.38, kArmReach = 0.1;  // of the height
constexpr int kEdgeSides = 3;

/// Where an obstacle stands: heights over the ellipsoid.
struct Stand : scene::ObstacleStand {
    double latitude_rad = 0, longitude_rad = 0;

    [[nodiscard]] glm::dvec3 at(double height_m) const { return earth::to_ecef({latitude_rad, longitude_rad, {height_m}}); }
    [[nodiscard]] glm::dvec3 top() const { return at(top_m); }
};

Stand stand_of(const ElementInput& input, const scene::ScenePoint& point, double height_m, double unknown_m) {
    return {scene::obstacle_stand(input.layer, point, height_m, unknown_m, input.ground), point.latitude_rad,
            point.longitude_rad};
}

/// Puts one obstacle together in a mesh.
class Shape {
public:
    Shape(SolidMesh& mesh, const Stand& stand, design::Color color, double detail)
        : mesh_(mesh),
          stand_(stand),
          detail_(detail),
          axes_(local_axes(stand.latitude_rad, stand.longitude_rad)),
          color_(color),
          foot_(stand.at(stand.foot_m)),
          height_m_(stand.height_m()) {
        mesh_.begin(foot_);
    }
    void set_uncertainty(scene::Uncertainty uncertainty) { uncertainty_ = uncertainty; }

    void add(Icon icon) {
        if (detail_ < kShapesFrom) return add_body(icon);
        switch (icon) {
            case Icon::mast: return add_mast();
            case Icon::turbine: return add_turbine();
            case Icon::chimney: return add_banded(0.05 * height_m_, 0.03 * height_m_, 10);
            case Icon::crane: return add_crane();
            case Icon::pole: return add_pole();
            default: return add_banded(std::max(1.0, 0.08 * height_m_), std::max(0.3, 0.02 * height_m_), 4);
        }
    }

private:
    /// Radii at foot and top that hold the whole shape, whichever way it turns.
    [[nodiscard]] glm::dvec2 body_radii_m(Icon icon) const {
        const auto round = [&](double reach, double more_m) { return glm::dvec2(reach * height_m_ + more_m); };
        switch (icon) {
            case Icon::mast: return {kGuyReach * height_m_ + mast_radius_m(), mast_radius_m()};
            case Icon::turbine: return round(kRotorReach, 0);
            case Icon::chimney: return {0.05 * height_m_, 0.03 * height_m_};
            case Icon::crane: return round(kJibReach, crane_half_m());
            case Icon::pole: return round(kArmReach, 0.25);
            default: return {std::max(1.0, 0.08 * height_m_), std::max(0.3, 0.02 * height_m_)};
        }
    }
    void add_body(Icon icon) {
        const int sides = kFewestSides + static_cast<int>(8 * detail_);
        const glm::dvec2 radii_m = body_radii_m(icon) / std::cos(base::kPi / sides);  // the middles of its sides are as far out
        paint(0);
        rod(0, height_m_, radii_m.x, radii_m.y, sides);
    }
    [[nodiscard]] double mast_radius_m() const { return std::max(0.3, height_m_ / 120); }
    [[nodiscard]] double crane_half_m() const { return std::max(0.5, height_m_ / 60); }

    void add_pole() {
        paint(0);
        rod(0, height_m_, 0.25, 0.15, 6);
        const double arm_m = kArmReach * height_m_;
        add_frustum(mesh_, at(0.97 * height_m_) - axes_.east * arm_m, at(0.97 * height_m_) + axes_.east * arm_m, 0.15, 0.15, 4,
                    axes_.up);
    }

    void paint(int band) {
        mesh_.set_color(band % 2 == 0 ? color_ : design::Color{kBand.red, kBand.green, kBand.blue, color_.alpha}, uncertainty_);
    }
    [[nodiscard]] glm::dvec3 at(double height_m) const { return foot_ + axes_.up * height_m; }
    void rod(double from_m, double to_m, double from_radius_m, double to_radius_m, int sides) {
        add_frustum(mesh_, at(from_m), at(to_m), from_radius_m, to_radius_m, sides, axes_.north);
    }

    void add_banded(double foot_radius_m, double top_radius_m, int sides) {
        const double more = (detail_ - kShapesFrom) / (1 - kShapesFrom);
        const int bands = kFewestBands + 2 * static_cast<int>(0.5 * (kBands - kFewestBands) * more);
        for (int band = 0; band < bands; ++band) {
            const double low = static_cast<double>(band) / bands, high = static_cast<double>(band + 1) / bands;
            paint(band);
            rod(low * height_m_, high * height_m_, foot_radius_m + (top_radius_m - foot_radius_m) * low,
                foot_radius_m + (top_radius_m - foot_radius_m) * high, sides);
        }
    }

    /// A slender tower and two rings of three guys.
    void add_mast() {
        add_banded(mast_radius_m(), mast_radius_m(), 4);
        paint(1);
        constexpr double kGuy_m = 0.03;
        for (const double share : {0.6, 0.95})
            for (int n = 0; n < 3; ++n) {
                const double turn = 2 * base::kPi * n / 3;
                const glm::dvec3 out = axes_.north * std::cos(turn) + axes_.east * std::sin(turn);
                add_frustum(mesh_, foot_ + out * (kGuyReach * share * height_m_), at(share * height_m_), kGuy_m, kGuy_m, 3,
                            axes_.up);
            }
    }

    /// A tower and three blades, one of them straight up: its tip is the top. The rotor faces west.
    void add_turbine() {
        constexpr double kHub = 1 - kRotorReach;
        const double hub_m = kHub * height_m_, blade_m = height_m_ - hub_m;
        paint(1);
        rod(0, hub_m, 0.016 * height_m_, 0.010 * height_m_, 8);
        const glm::dvec3 hub = at(hub_m), ahead = -axes_.east;
        const double reach_m = 0.03 * height_m_;
        add_box(mesh_, hub, axes_.east * reach_m, axes_.north * (0.4 * reach_m), axes_.up * (0.4 * reach_m));
        for (int n = 0; n < 3; ++n) {
            const double turn = 2 * base::kPi * n / 3;
            const glm::dvec3 out = axes_.up * std::cos(turn) + axes_.north * std::sin(turn);
            const glm::dvec3 root = hub + ahead * reach_m;
            paint(1);
            add_frustum(mesh_, root, root + out * (0.7 * blade_m), 0.012 * height_m_, 0.007 * height_m_, 4, ahead);
            paint(0);
            add_frustum(mesh_, root + out * (0.7 * blade_m), root + out * blade_m, 0.007 * height_m_, 0, 4, ahead);
        }
    }

    void add_crane() {
        const double half_m = crane_half_m(), jib_m = 0.9 * height_m_;
        add_banded(half_m, half_m, 4);
        paint(0);
        const double long_m = kJibReach * height_m_, short_m = 0.3 * height_m_;
        add_frustum(mesh_, at(jib_m) - axes_.east * short_m, at(jib_m) + axes_.east * long_m, half_m, 0.6 * half_m, 4, axes_.up);
        for (const double reach_m : {0.9 * long_m, -0.9 * short_m})
            add_frustum(mesh_, at(height_m_), at(jib_m) + axes_.east * reach_m, 0.1, 0.1, 3, axes_.north);
    }

    SolidMesh& mesh_;
    const Stand& stand_;
    double detail_;
    LocalAxes axes_;
    design::Color color_;
    scene::Uncertainty uncertainty_ = scene::Uncertainty::from_code(0);
    glm::dvec3 foot_;
    double height_m_;
};

bool is_rimmed(const ElementInput& input, const SolidLook& look) { return !look.is_mixed || input.element.halo_px > 0; }

/// The mesh, then its rim.
bool add_rimmed(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    SolidLook look = look_of(input);
    batch.set_look(look, input.layer.entry->data_time_ns);
    if (!mesh.add_to(batch)) return false;
    if (!is_rimmed(input, look)) return true;
    look.halo_px = std::max(kMinHalf_px, static_cast<float>(input.element.halo_px));
    batch.set_look(look, input.layer.entry->data_time_ns);
    return mesh.add_to(batch);
}

SolidLook wall_look(const ElementInput& input) {
    SolidLook look = look_of(input);
    look.opacity *= kWallShare;
    look.ghost = 0;
    look.is_mixed = true;
    look.is_thing = look.has_grid = false;
    return look;
}

class Cable {
public:
    Cable(SolidMesh& mesh, const ElementInput& input, std::uint32_t feature)
        : mesh_(mesh), input_(input), feature_(feature), run_(input.layer.points_of(feature)) {
        const double diameter_m = scene::value_or_nan(input.layer, "diameter", feature);
        radius_m_ = 0.5 * (diameter_m > 0 ? diameter_m : kCable_m);
        height_m_ = scene::value_or_nan(input.layer, "height", feature);
        stands_ = input.layer.entry->height_datum == scene::HeightDatum::ground;
        for (std::uint32_t n = 0; n < run_.count; ++n) stands_ = stands_ || std::isnan(point(n).height_m);
    }

    /// Poles and upper edge.
    bool build() {
        if (run_.count < 2 || !begin()) return false;
        Stand before = stand(0);
        add_pole(before);
        for (std::uint32_t n = 1; n < run_.count; ++n) {
            const Stand next = stand(n);
            if (!next.is_known()) return false;
            if (stands_ || n + 1 == run_.count) add_pole(next);
            add_edge(before, next);
            length_m_ += glm::distance(before.top(), next.top());
            before = next;
        }
        return true;
    }

    /// After build().
    void build_wall() {
        static_cast<void>(begin());
        const double step_m = std::max(kWallStep_m, length_m_ / kMaxWallSteps);
        for (std::uint32_t n = 1; n < run_.count; ++n) add_wall(stand(n - 1), stand(n), step_m);
    }

private:
    [[nodiscard]] const scene::ScenePoint& point(std::uint32_t n) const { return input_.layer.points[run_.first + n]; }
    [[nodiscard]] Stand stand(std::uint32_t n) const { return stand_of(input_, point(n), height_m_, scene::kPole_m); }

    void add_pole(const Stand& at) {
        const LocalAxes axes = local_axes(at.latitude_rad, at.longitude_rad);
        add_frustum(mesh_, at.at(at.foot_m), at.at(at.top_m), 0.25, 0.15, 6, axes.north);
    }

    [[nodiscard]] bool begin() {
        const Stand first = stand(0);
        if (!first.is_known()) return false;
        mesh_.begin(first.top());
        const design::Color own = encoded_color(input_, input_.element.by_color, feature_);
        mesh_.set_color(obstacle_color(input_, feature_, own), encoded_uncertainty(input_, feature_));
        return true;
    }

    void add_edge(const Stand& from, const Stand& to) {
        if (!(glm::distance(from.top(), to.top()) > 0)) return;
        const LocalAxes axes = local_axes(from.latitude_rad, from.longitude_rad);
        add_frustum(mesh_, from.top(), to.top(), radius_m_, radius_m_, kEdgeSides, axes.up);
    }

    /// A sheet without thickness, seen from both sides.
    void add_wall(const Stand& from, const Stand& to, double step_m) {
        const glm::dvec3 along = to.top() - from.top();
        if (!(glm::length(along) > 0)) return;
        const int parts = static_cast<int>(std::ceil(glm::length(along) / step_m));
        std::uint16_t low_before = 0, high_before = 0;
        for (int n = 0; n <= parts; ++n) {
            const double share = static_cast<double>(n) / parts;
            const glm::dvec3 top = from.top() + along * share;
            const std::uint16_t high = mesh_.vertex(top, glm::dvec3(0));
            const std::uint16_t low = mesh_.vertex(foot(top, from.foot_m + (to.foot_m - from.foot_m) * share), glm::dvec3(0));
            if (n > 0) {
                mesh_.triangle(low_before, low, high);
                mesh_.triangle(low_before, high, high_before);
            }
            low_before = low;
            high_before = high;
        }
    }

    /// Under a place of the edge.
    [[nodiscard]] glm::dvec3 foot(const glm::dvec3& top, double unknown_m) const {
        earth::Geodetic at = earth::from_ecef(top);
        const double ground_m = input_.ground.height_m(at.latitude_rad, at.longitude_rad);
        at.height.m = std::min(std::isfinite(ground_m) ? ground_m : unknown_m, at.height.m) - kWallRoot_m;
        return earth::to_ecef(at);
    }

    SolidMesh& mesh_;
    const ElementInput& input_;
    std::uint32_t feature_;
    scene::Run run_;
    double radius_m_ = 0, height_m_ = 0, length_m_ = 0;
    bool stands_ = false;  ///< its points are poles
};

}  // namespace

ElementCount add_obstacle_points(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    ElementCount count;
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        const Stand stand = stand_of(input, input.layer.points[feature], scene::value_or_nan(input.layer, "height", feature),
                                     scene::kUnknownObstacle_m);
        bool is_drawn = stand.is_known();
        if (is_drawn) {
            const design::Color own = stand.is_stated ? encoded_color(input, input.element.by_color, feature) : input.missing;
            Shape shape(mesh, stand, obstacle_color(input, feature, own), input.element.detail);
            shape.set_uncertainty(encoded_uncertainty(input, feature));
            shape.add(icon_of(input.layer, feature));
            is_drawn = add_rimmed(batch, mesh, input);
        }
        ++(is_drawn ? count.drawn : count.hidden);
    }
    return count;
}

ElementCount add_cables(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    ElementCount count;
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        Cable cable(mesh, input, feature);
        const bool is_drawn = cable.build() && add_rimmed(batch, mesh, input);
        ++(is_drawn ? count.drawn : count.hidden);
        if (!is_drawn) continue;
        cable.build_wall();
        batch.set_look(wall_look(input), input.layer.entry->data_time_ns);
        mesh.add_to(batch);
    }
    return count;
}

}  // namespace tedavis::draw
