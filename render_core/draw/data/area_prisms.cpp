#include "render_core/draw/data/area_prisms.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/feature_importance.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/area_limits.hpp"
#include "render_core/scene/outer_outline.hpp"
#include "render_core/scene/polygon_triangles.hpp"

namespace tedavis::draw {
namespace {

constexpr double kMaxWidened = 2;  // of the widening, where a corner is sharp

struct Corner {
    double latitude_rad, longitude_rad;
};

/// One area: its corners on the ellipsoid, what it reaches from and to.
class Prism {
public:
    Prism(SolidMesh& mesh, const ElementInput& input, std::uint32_t feature) : mesh_(mesh), input_(input), feature_(feature) {}

    /// False where it cannot be placed.
    bool build(double widened_m) {
        const scene::Run run = input_.layer.points_of(feature_);
        if (run.count < 3) return false;
        first_ = input_.layer.points[run.first];
        moved_ = scene::drift_m(input_.layer, feature_, input_.time_ns, input_.has_date);
        axes_ = local_axes(first_.latitude_rad, first_.longitude_rad);
        metres_ = {std::cos(first_.latitude_rad) * earth::prime_vertical_radius_m(first_.latitude_rad),
                   earth::meridian_radius_m(first_.latitude_rad)};
        if (!take_corners(run)) return false;
        if (widened_m > 0) widen(widened_m);
        take_limits();
        const Placed base = over(Corner{first_.latitude_rad, first_.longitude_rad}, floor_);
        if (!base.is_known) return false;
        mesh_.begin(base.place);
        mesh_.set_color(encoded_color(input_, input_.element.by_color, feature_), encoded_uncertainty(input_, feature_));
        return add_sides() && add_cap(ceiling_, true) && add_cap(floor_, false);
    }

    /// After build(): the foremost place of the outline.
    [[nodiscard]] CellFront front(double toward_rad) {
        const glm::dvec2 way(std::sin(toward_rad), std::cos(toward_rad));
        glm::dvec2 middle(0);
        for (std::size_t n = 0; n < count_; ++n) middle += mesh_.corners()[n] / static_cast<double>(count_);
        const Corner at = on_ellipsoid(middle + way * reach_m(middle, way));
        const Placed low = over(at, floor_), seen = over(on_ellipsoid(middle), floor_);
        CellFront front{at.latitude_rad, at.longitude_rad, low.height_m, toward_rad, 0, 0, low.is_known && seen.is_known};
        const earth::Geodetic eye = earth::from_ecef(input_.eye);
        const glm::dvec2 sight = middle - flat(Corner{eye.latitude_rad, eye.longitude_rad});
        const double level_m = glm::length(sight);
        const glm::dvec2 across = level_m > 0 ? glm::dvec2(sight.y, -sight.x) / level_m : glm::dvec2(way.y, -way.x);
        front.width_m = reach_m(middle, across) + reach_m(middle, -across);
        front.seen_rad = 2 * std::atan2(front.width_m / 2, glm::distance(seen.place, input_.eye));
        return front;
    }

private:
    bool take_corners(const scene::Run& run) {
        const base::Span<glm::dvec2> corners = mesh_.corners();
        if (run.count > corners.size()) return false;
        for (std::uint32_t n = 0; n < run.count; ++n) corners[n] = flat(input_.layer.points[run.first + n]);
        count_ = scene::simplify_outwards({corners.data(), run.count}, kMaxOutlineGrowth * (1 - input_.element.detail));
        return cut_sides();
    }

    static double parts_of(const glm::dvec2& from, const glm::dvec2& to) {
        return std::max(1.0, std::ceil(glm::distance(from, to) / kLongestSide_m));
    }

    /// From the last to the first, for there are never fewer corners than before.
    bool cut_sides() {
        const base::Span<glm::dvec2> corners = mesh_.corners();
        const glm::dvec2 first = corners[0];
        double all = 0;
        for (std::size_t n = 0; n < count_; ++n) all += parts_of(corners[n], n + 1 < count_ ? corners[n + 1] : first);
        if (!(all <= static_cast<double>(corners.size()))) return false;
        auto end = static_cast<std::size_t>(all);
        glm::dvec2 to = first;
        for (std::size_t n = count_; n-- > 0;) {
            const glm::dvec2 from = corners[n];
            const double parts = parts_of(from, to);
            for (double part = parts - 1; part >= 0; --part) corners[--end] = from + (to - from) * (part / parts) + moved_;
            to = from;
        }
        count_ = static_cast<std::size_t>(all);
        return true;
    }

    [[nodiscard]] glm::dvec2 flat(const Corner& at) const {
        const double east = std::remainder(at.longitude_rad - first_.longitude_rad, 2 * base::kPi);
        return {east * metres_.x, (at.latitude_rad - first_.latitude_rad) * metres_.y};
    }
    [[nodiscard]] glm::dvec2 flat(const scene::ScenePoint& point) const {
        return flat(Corner{point.latitude_rad, point.longitude_rad});
    }
    /// How far the outline reaches from a place within it.
    [[nodiscard]] double reach_m(const glm::dvec2& from, const glm::dvec2& way) const {
        double farthest_m = 0;
        for (std::size_t n = 0; n < count_; ++n) farthest_m = std::max(farthest_m, glm::dot(mesh_.corners()[n] - from, way));
        return farthest_m;
    }

    [[nodiscard]] Corner on_ellipsoid(const glm::dvec2& at) const {
        return {first_.latitude_rad + at.y / metres_.y, first_.longitude_rad + at.x / metres_.x};
    }
    [[nodiscard]] Corner corner(std::size_t n) const { return on_ellipsoid(mesh_.corners()[n % count_]); }

    /// Every side goes outwards; corners go along the middle of their two sides' normals.
    void widen(double by_m) {
        const base::Span<glm::dvec2> all = mesh_.corners();
        const double turn = scene::twice_area({all.data(), count_}) < 0 ? -1 : 1;
        const glm::dvec2 first = all[0];
        glm::dvec2 before = all[count_ - 1];
        for (std::size_t n = 0; n < count_; ++n) {
            const glm::dvec2 here = all[n], next = n + 1 < count_ ? all[n + 1] : first;
            all[n] = here + outward(here - before, next - here) * (turn * by_m);
            before = here;
        }
    }

    [[nodiscard]] static glm::dvec2 outward(glm::dvec2 in, glm::dvec2 out) {
        const double in_length = glm::length(in), out_length = glm::length(out);
        if (!(in_length > 0) || !(out_length > 0)) return glm::dvec2(0);
        const glm::dvec2 sum(in.y / in_length + out.y / out_length, -in.x / in_length - out.x / out_length);
        const double half = 0.5 * glm::dot(sum, sum);  // 1 + cosine of the turn
        return half > 0 ? sum * std::min(1 / half, kMaxWidened) : glm::dvec2(0);
    }

    void take_limits() {
        const scene::Layer& layer = input_.layer;
        const scene::AreaLimits stated = scene::area_limits(layer, feature_);
        floor_ = stated.floor;
        ceiling_ = stated.ceiling;
        if (const scene::Attribute* const size = layer.find(input_.element.size_attribute.view()); size != nullptr) {
            const double value = scene::value_or_nan(layer, input_.element.size_attribute.view(), feature_);
            const double largest = static_cast<double>(size->entry->maximum);
            const double bottom = std::isnan(floor_.m) ? 0 : floor_.m;
            ceiling_ = {largest > 0 ? bottom + std::max(value, 0.0) / largest * input_.element.size_m : bottom, floor_.datum};
        }
        if (std::isnan(floor_.m)) floor_ = {0, scene::HeightDatum::ground};
        if (std::isnan(ceiling_.m)) ceiling_ = {kUnknownCeiling_m, scene::HeightDatum::msl};
    }

    [[nodiscard]] Placed over(const Corner& at, const scene::HeightLimit& limit) {
        scene::Ground& ground = input_.ground;
        Placed result;
        result.height_m = limit.m;
        if (limit.datum == scene::HeightDatum::ground)
            result.height_m += ground.height_m(at.latitude_rad, at.longitude_rad);
        else if (limit.datum == scene::HeightDatum::msl)
            result.height_m += ground.undulation_m(at.latitude_rad, at.longitude_rad);
        result.is_known = std::isfinite(result.height_m);
        if (result.is_known) result.place = earth::to_ecef({at.latitude_rad, at.longitude_rad, {result.height_m}});
        return result;
    }

    bool add_sides() {
        const bool is_clockwise = scene::twice_area({mesh_.corners().data(), count_}) < 0;
        Placed low = over(corner(0), floor_), high = over(corner(0), ceiling_);
        for (std::size_t n = 0; n < count_; ++n) {
            const Placed next_low = over(corner(n + 1), floor_), next_high = over(corner(n + 1), ceiling_);
            if (!low.is_known || !high.is_known || !next_low.is_known || !next_high.is_known) return false;
            if (is_clockwise)
                mesh_.quad(next_low.place, low.place, high.place, next_high.place);
            else
                mesh_.quad(low.place, next_low.place, next_high.place, high.place);
            low = next_low;
            high = next_high;
        }
        return true;
    }

    bool add_cap(const scene::HeightLimit& limit, bool faces_up) {
        const std::uint32_t first = mesh_.vertex_count();
        for (std::size_t n = 0; n < count_; ++n) {
            const Placed at = over(corner(n), limit);
            if (!at.is_known) return false;
            static_cast<void>(mesh_.vertex(at.place, faces_up ? axes_.up : -axes_.up));
        }
        const base::Span<std::uint16_t> cut = mesh_.corner_indices();
        const std::size_t indices = scene::triangulate({mesh_.corners().data(), count_}, cut);
        for (std::size_t n = 0; n < indices; n += 3) {
            const auto at = [&](std::size_t k) { return static_cast<std::uint16_t>(first + cut[n + k]); };
            mesh_.triangle(at(0), at(faces_up ? 1 : 2), at(faces_up ? 2 : 1));
        }
        return true;
    }

    SolidMesh& mesh_;
    const ElementInput& input_;
    std::uint32_t feature_;
    scene::ScenePoint first_{};
    LocalAxes axes_;
    glm::dvec2 metres_{1}, moved_{0};
    std::size_t count_ = 0;
    scene::HeightLimit floor_, ceiling_;
};

/// Where the area may reach to as well.
void add_margin(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, std::uint32_t feature) {
    const double accuracy_m = static_cast<double>(input.layer.entry->position_accuracy_m);
    if (input.element.uncertainty != design::ElementUncertainty::widening || !(accuracy_m > 0)) return;
    SolidLook look = look_of(input);
    look.opacity *= kMarginShare * static_cast<float>(input.element.uncertainty_strength);
    look.is_mixed = true;
    look.is_thing = look.has_grid = false;
    batch.set_look(look, input.layer.entry->data_time_ns);
    if (Prism(mesh, input, feature).build(accuracy_m)) mesh.add_to(batch);
}

/// Buildings alone: nothing that must not be entered is ever left out.
bool is_left_out(const ElementInput& input, std::uint32_t feature) {
    const bool is_small = input.layer.entry->role == scene::LayerRole::building && is_unimportant(input, "height", feature);
    return is_small || look_of_feature(input, feature).is_hidden;
}

}  // namespace

ElementCount add_area_prisms(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    ElementCount count;
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        batch.set_look(look_of(input), input.layer.entry->data_time_ns);
        Prism prism(mesh, input, feature);
        const bool is_drawn = !is_left_out(input, feature) && prism.build(0) && mesh.add_to(batch);
        ++(is_drawn ? count.drawn : count.hidden);
        if (!is_drawn) continue;
        const double toward_rad = scene::value_or_nan(input.layer, "toward", feature);
        if (prisms_move(input.layer) && has_motion(input, feature))
            add_motion_line(batch, mesh, input, feature, prism.front(toward_rad));
        add_margin(batch, mesh, input, feature);
    }
    return count;
}

CellFront cell_front(SolidMesh& mesh, const ElementInput& input, std::uint32_t feature) {
    Prism prism(mesh, input, feature);
    return prism.build(0) ? prism.front(scene::value_or_nan(input.layer, "toward", feature)) : CellFront{};
}

bool prisms_move(const scene::Layer& layer) { return layer.entry->role == scene::LayerRole::storm_cell; }

}  // namespace tedavis::draw
