#include "render_core/draw/data/ground_strips.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/feature_importance.hpp"
#include "render_core/draw/data/ground_section.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/polyline_weights.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

SolidLook look_on_ground(const ElementInput& input) {
    SolidLook look = look_of(input);
    look.raised_px = kStripRaised_px;
    return look;
}

double width_of(const ElementInput& input, std::uint32_t feature) {
    const double width = scene::value_or_nan(input.layer, "width", feature);
    if (width > 0) return width;
    if (input.element.size_m > 0) return input.element.size_m;
    return input.layer.entry->role == scene::LayerRole::river ? kRiverWidth_m : kRoadWidth_m;
}

/// A strip along a line, in as many meshes as it needs.
class Ribbon {
public:
    Ribbon(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, std::uint32_t feature)
        : batch_(batch), mesh_(mesh), input_(input), run_(input.layer.points_of(feature)), feature_(feature) {}

    bool build() {
        if (run_.count < 2) return false;
        half_m_ = 0.5 * width_of(input_, feature_);
        color_ = encoded_color(input_, input_.element.by_color, feature_);
        unsure_ = encoded_uncertainty(input_, feature_);
        glm::dvec2 in(0);
        for (Leg leg{0, next_kept(0)}; leg.from + 1 < run_.count;) {
            const Leg next{leg.to, next_kept(leg.to)};
            if (!add_leg(leg, half_at(in, way(leg)), half_at(way(leg), way(next)))) return false;
            in = way(leg);
            leg = next;
        }
        return vertices() == 0 || mesh_.add_to(batch_);
    }

private:
    static constexpr double kMaxSteps = 2000;  // of a leg: what is longer is cut into longer steps
    static constexpr double kMaxMitre = 2;
    static constexpr std::uint32_t kLongestLeg = 64;  // points of the line

    /// Between two points that are kept.
    struct Leg {
        std::uint32_t from, to;
    };

    [[nodiscard]] const scene::ScenePoint& point(std::uint32_t n) const { return input_.layer.points[run_.first + n]; }
    [[nodiscard]] glm::dvec2 way(const Leg& leg) const { return flat_offset(point(leg.from), point(leg.to)); }
    [[nodiscard]] std::uint32_t vertices() const { return has_begun_ ? mesh_.vertex_count() : 0; }

    /// The farthest point to which the way may be straight; the last one from itself.
    [[nodiscard]] std::uint32_t next_kept(std::uint32_t from) const {
        const double most_m = kMaxStraightened_m * (1 - input_.element.detail);
        const std::uint32_t end = std::min(run_.count, from + kLongestLeg);
        std::uint32_t to = std::min(from + 1, run_.count - 1);
        while (most_m > 0 && to + 1 < end && is_straight({from, to + 1}, most_m)) ++to;
        return to;
    }

    [[nodiscard]] bool is_straight(const Leg& leg, double most_m) const {
        const PolylineVertex begin{}, end{glm::dvec3(way(leg), 0)};
        for (std::uint32_t n = leg.from + 1; n < leg.to; ++n)
            if (distance_from_segment({glm::dvec3(way({leg.from, n}), 0)}, begin, end) > most_m) return false;
        return true;
    }

    /// Across the middle of both legs' directions, as wide as the legs.
    [[nodiscard]] glm::dvec2 half_at(const glm::dvec2& way_in, const glm::dvec2& way_out) const {
        const glm::dvec2 in = right_of(way_in), out = right_of(way_out), middle = in + out;
        const double square = glm::dot(middle, middle);
        if (!(square > 0)) return out * half_m_;
        const double mitre = glm::length(in) > 0 && glm::length(out) > 0 ? std::min(2 / std::sqrt(square), kMaxMitre) : 1;
        return middle * (half_m_ * mitre / std::sqrt(square));
    }

    bool add_leg(const Leg& leg, const glm::dvec2& half_from, const glm::dvec2& half_to) {
        const double length_m = glm::length(way(leg));
        if (!(length_m > 0)) return true;  // points on each other
        const double steps = std::clamp(std::ceil(length_m / kLongestStep_m), 1.0, kMaxSteps);
        const glm::dvec2 across = right_of(way(leg)) * half_m_;
        GroundSection from = ground_section(input_, point(leg.from), half_from);
        for (double step = 1; step <= steps; ++step) {
            const bool is_last = step == steps;
            const scene::ScenePoint middle = is_last ? point(leg.to) : between(point(leg.from), point(leg.to), step / steps);
            const GroundSection to = ground_section(input_, middle, is_last ? half_to : across);
            if (!from.is_known || !to.is_known || !add_part(from, to)) return false;
            from = to;
        }
        return true;
    }

    bool add_part(const GroundSection& from, const GroundSection& to) {
        constexpr std::uint32_t kPartVertices = 4;
        if (vertices() + kPartVertices > SolidMesh::kVertices) {
            if (!mesh_.add_to(batch_)) return false;
            has_begun_ = false;
        }
        if (!has_begun_) {
            mesh_.begin(from.at(0));
            mesh_.set_color(color_, unsure_);
            has_begun_ = true;
        }
        const Edges a = edges(from), b = edges(to);
        mesh_.triangle(a.left, a.right, b.right);
        mesh_.triangle(a.left, b.right, b.left);
        return true;
    }

    struct Edges {
        std::uint16_t left = 0, right = 0;
    };
    [[nodiscard]] Edges edges(const GroundSection& at) {
        const SectionEnds ends = section_ends(at);
        return {mesh_.vertex(ends.left, ends.left_normal), mesh_.vertex(ends.right, ends.right_normal)};
    }

    SolidBatch& batch_;
    SolidMesh& mesh_;
    const ElementInput& input_;
    scene::Run run_;
    std::uint32_t feature_;
    double half_m_ = 0;
    design::Color color_;
    scene::Uncertainty unsure_;
    bool has_begun_ = false;
};

}  // namespace

ElementCount add_ribbons(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    ElementCount count;
    batch.set_look(look_on_ground(input), input.layer.entry->data_time_ns);
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        const bool is_left_out = is_unimportant(input, "width", feature) || look_of_feature(input, feature).is_hidden;
        const bool is_drawn = !is_left_out && Ribbon(batch, mesh, input, feature).build();
        ++(is_drawn ? count.drawn : count.hidden);
    }
    return count;
}

}  // namespace tedavis::draw
