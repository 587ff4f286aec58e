#include "render_core/draw/data/ground_strips.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/feature_importance.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/draw/data/way_weights.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kSlab_m = 4;  // from a runway's surface down
constexpr design::Color kPaint{245, 245, 245};
constexpr float kRaised_px = 2.5f;  // the ground is drawn a pixel or so above or below the true one

SolidLook look_on_ground(const ElementInput& input) {
    SolidLook look = look_of(input);
    look.raised_px = kRaised_px;
    return look;
}

glm::dvec2 metres_per_rad(double latitude_rad) {
    return {std::cos(latitude_rad) * earth::prime_vertical_radius_m(latitude_rad), earth::meridian_radius_m(latitude_rad)};
}

/// Metres east and north from one point to another.
glm::dvec2 flat(const scene::ScenePoint& from, const scene::ScenePoint& to) {
    const glm::dvec2 metres = metres_per_rad(from.latitude_rad);
    return {std::remainder(to.longitude_rad - from.longitude_rad, 2 * base::kPi) * metres.x,
            (to.latitude_rad - from.latitude_rad) * metres.y};
}

scene::ScenePoint moved(const scene::ScenePoint& from, const glm::dvec2& by_m) {
    const glm::dvec2 metres = metres_per_rad(from.latitude_rad);
    scene::ScenePoint result = from;
    result.longitude_rad += by_m.x / metres.x;
    result.latitude_rad += by_m.y / metres.y;
    return result;
}

/// A line across the strip: level, over the ground.
struct Section {
    scene::ScenePoint middle{};
    glm::dvec2 half{0};  ///< metres east and north to its right end
    double height_m = 0;
    bool is_known = false;

    [[nodiscard]] glm::dvec3 at(double share, double down_m = 0) const {
        const scene::ScenePoint point = moved(middle, half * share);
        return earth::to_ecef({point.latitude_rad, point.longitude_rad, {height_m - down_m}});
    }
};

/// Heights of points between which nothing is stated lie on a line.
Section section(const ElementInput& input, const scene::ScenePoint& middle, const glm::dvec2& half) {
    Section result{middle, half};
    double highest = -1e9;
    for (const double share : {-1.0, 0.0, 1.0}) {
        const scene::ScenePoint at = moved(middle, half * share);
        const double ground_m = input.ground.height_m(at.latitude_rad, at.longitude_rad);
        if (ground_m > highest) highest = ground_m;
    }
    const bool has_ground = highest > -1e9;
    const Placed stated = placed(input, middle);
    result.is_known = has_ground || stated.is_known;
    result.height_m = (has_ground ? highest : stated.height_m) + kStripLift_m;
    return result;
}

scene::ScenePoint between(const scene::ScenePoint& from, const scene::ScenePoint& to, double share) {
    scene::ScenePoint result = moved(from, flat(from, to) * share);
    result.height_m = from.height_m + (to.height_m - from.height_m) * static_cast<float>(share);
    return result;
}

double width_of(const ElementInput& input, std::uint32_t feature) {
    const double width = value_or_nan(input.layer, "width", feature);
    if (width > 0) return width;
    if (input.element.size_m > 0) return input.element.size_m;
    switch (input.layer.entry->role) {
        case scene::LayerRole::runway: return kRunwayWidth_m;
        case scene::LayerRole::river: return kRiverWidth_m;
        default: return kRoadWidth_m;
    }
}

/// The right end of a section of unit half width, for a way east and north.
glm::dvec2 right_of(const glm::dvec2& way) {
    const double length = glm::length(way);
    return length > 0 ? glm::dvec2(way.y, -way.x) / length : glm::dvec2(0);
}

/// A slab from threshold to threshold. Along: a margin, stripes, then dashes of the centre line and gaps in turn, to the middle
/// and likewise back; across: cells between the edges of its stripes.
class Runway {
public:
    Runway(SolidMesh& mesh, const ElementInput& input, std::uint32_t feature)
        : mesh_(mesh), input_(input), run_(input.layer.points_of(feature)), feature_(feature) {}

    bool build() {
        if (run_.count < 2) return false;
        first_ = input_.layer.points[run_.first];
        last_ = input_.layer.points[run_.first + run_.count - 1];
        const glm::dvec2 way = flat(first_, last_);
        length_m_ = glm::length(way);
        if (!(length_m_ > 4 * kStripes_m) || length_m_ > kLongest_m) return false;
        half_ = right_of(way) * (0.5 * width_of(input_, feature_));
        surface_ = encoded_color(input_, input_.element.by_color, feature_);
        unsure_ = encoded_uncertainty(input_, feature_);
        const Section begin = at(0);
        if (!begin.is_known) return false;
        mesh_.begin(begin.at(0));
        return add_parts(begin);
    }

private:
    static constexpr double kMargin_m = 6, kStripes_m = 30, kLongest_m = 8000;
    static constexpr double kDash_m = 30, kPeriod_m = 50, kMostPeriods = 48;

    [[nodiscard]] Section at(double along_m) const { return section(input_, between(first_, last_, along_m / length_m_), half_); }

    bool add_parts(const Section& begin) {
        const double inner_m = length_m_ - 2 * (kMargin_m + kStripes_m);
        const double periods = std::clamp(std::round(inner_m / kPeriod_m), 1.0, kMostPeriods);
        const double period_m = inner_m / periods, gap_m = period_m * (1 - kDash_m / kPeriod_m);
        cap(begin, false);
        Section from = begin;
        double along = 0;
        const auto go = [&](double by_m, Paint paint) {
            along += by_m;
            const Section to = at(along);
            if (!to.is_known) return false;
            part(from, to, paint);
            from = to;
            return true;
        };
        bool is_known = go(kMargin_m, Paint::none) && go(kStripes_m, Paint::stripes);
        for (double n = 0; n < periods && is_known; ++n)
            is_known = go(gap_m / 2, Paint::none) && go(period_m - gap_m, Paint::dash) && go(gap_m / 2, Paint::none);
        is_known = is_known && go(kStripes_m, Paint::stripes) && go(kMargin_m, Paint::none);
        cap(from, true);
        return is_known;
    }

    enum class Paint : std::uint8_t { none, dash, stripes };

    void part(const Section& from, const Section& to, Paint paint) {
        constexpr int kCells = 15;  // a stripe, a gap, ...
        if (paint == Paint::stripes)
            for (int n = 0; n < kCells; ++n)
                cell(from, to, 2.0 * n / kCells - 1, 2.0 * (n + 1) / kCells - 1, n % 2 == 1 && n != kCells / 2);
        else {
            const double line = std::min(0.2, 0.45 / glm::length(half_));
            cell(from, to, -1, -line, false);
            cell(from, to, -line, line, paint == Paint::dash);
            cell(from, to, line, 1, false);
        }
        set_paint(false);
        mesh_.quad(from.at(-1, kSlab_m), from.at(-1), to.at(-1), to.at(-1, kSlab_m));
        mesh_.quad(from.at(1), from.at(1, kSlab_m), to.at(1, kSlab_m), to.at(1));
        mesh_.quad(from.at(-1, kSlab_m), to.at(-1, kSlab_m), to.at(1, kSlab_m), from.at(1, kSlab_m));
    }

    void cell(const Section& from, const Section& to, double left, double right, bool painted) {
        set_paint(painted);
        mesh_.quad(from.at(left), from.at(right), to.at(right), to.at(left));
    }

    void cap(const Section& end, bool faces_on) {
        set_paint(false);
        if (faces_on)
            mesh_.quad(end.at(-1), end.at(1), end.at(1, kSlab_m), end.at(-1, kSlab_m));
        else
            mesh_.quad(end.at(-1, kSlab_m), end.at(1, kSlab_m), end.at(1), end.at(-1));
    }

    void set_paint(bool painted) {
        mesh_.set_color(painted ? design::Color{kPaint.red, kPaint.green, kPaint.blue, surface_.alpha} : surface_, unsure_);
    }

    SolidMesh& mesh_;
    const ElementInput& input_;
    scene::Run run_;
    std::uint32_t feature_;
    scene::ScenePoint first_{}, last_{};
    glm::dvec2 half_{0};
    double length_m_ = 0;
    design::Color surface_;
    scene::Uncertainty unsure_;
};

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
    static constexpr double kMostSteps = 2000;  // of a leg: what is longer is cut into longer steps
    static constexpr double kMostMitre = 2;
    static constexpr std::uint32_t kLongestLeg = 64;  // points of the line

    /// Between two points that are kept.
    struct Leg {
        std::uint32_t from, to;
    };

    [[nodiscard]] const scene::ScenePoint& point(std::uint32_t n) const { return input_.layer.points[run_.first + n]; }
    [[nodiscard]] glm::dvec2 way(const Leg& leg) const { return flat(point(leg.from), point(leg.to)); }
    [[nodiscard]] std::uint32_t vertices() const { return has_begun_ ? mesh_.vertex_count() : 0; }

    /// The farthest point to which the way may be straight; the last one from itself.
    [[nodiscard]] std::uint32_t next_kept(std::uint32_t from) const {
        const double most_m = kMostStraightened_m * (1 - input_.element.detail);
        const std::uint32_t end = std::min(run_.count, from + kLongestLeg);
        std::uint32_t to = std::min(from + 1, run_.count - 1);
        while (most_m > 0 && to + 1 < end && is_straight({from, to + 1}, most_m)) ++to;
        return to;
    }

    [[nodiscard]] bool is_straight(const Leg& leg, double most_m) const {
        const WayPoint begin{}, end{glm::dvec3(way(leg), 0)};
        for (std::uint32_t n = leg.from + 1; n < leg.to; ++n)
            if (distance_from_way({glm::dvec3(way({leg.from, n}), 0)}, begin, end) > most_m) return false;
        return true;
    }

    /// Across the middle of both legs' directions, as wide as the legs.
    [[nodiscard]] glm::dvec2 half_at(const glm::dvec2& way_in, const glm::dvec2& way_out) const {
        const glm::dvec2 in = right_of(way_in), out = right_of(way_out), middle = in + out;
        const double square = glm::dot(middle, middle);
        if (!(square > 0)) return out * half_m_;
        const double mitre = glm::length(in) > 0 && glm::length(out) > 0 ? std::min(2 / std::sqrt(square), kMostMitre) : 1;
        return middle * (half_m_ * mitre / std::sqrt(square));
    }

    bool add_leg(const Leg& leg, const glm::dvec2& half_from, const glm::dvec2& half_to) {
        const double length_m = glm::length(way(leg));
        if (!(length_m > 0)) return true;  // points on each other
        const double steps = std::clamp(std::ceil(length_m / kLongestStep_m), 1.0, kMostSteps);
        const glm::dvec2 across = right_of(way(leg)) * half_m_;
        Section from = section(input_, point(leg.from), half_from);
        for (double step = 1; step <= steps; ++step) {
            const bool is_last = step == steps;
            const scene::ScenePoint middle = is_last ? point(leg.to) : between(point(leg.from), point(leg.to), step / steps);
            const Section to = section(input_, middle, is_last ? half_to : across);
            if (!from.is_known || !to.is_known || !add_part(from, to)) return false;
            from = to;
        }
        return true;
    }

    bool add_part(const Section& from, const Section& to) {
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
    /// Normals lean outwards: what raises the strip also widens it, so that it is never too narrow to be seen.
    [[nodiscard]] Edges edges(const Section& at) {
        const glm::dvec3 left = at.at(-1), right = at.at(1), up = earth::up_at(left), out = glm::normalize(right - left);
        return {mesh_.vertex(left, glm::normalize(up - out)), mesh_.vertex(right, glm::normalize(up + out))};
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

ElementCount add_runways(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    ElementCount count;
    batch.set_look(look_on_ground(input), input.layer.entry->data_time_ns);
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        const bool is_drawn = Runway(mesh, input, feature).build() && mesh.add_to(batch);
        ++(is_drawn ? count.drawn : count.hidden);
    }
    return count;
}

ElementCount add_ribbons(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    ElementCount count;
    batch.set_look(look_on_ground(input), input.layer.entry->data_time_ns);
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        const bool is_drawn = !is_unimportant(input, "width", feature) && Ribbon(batch, mesh, input, feature).build();
        ++(is_drawn ? count.drawn : count.hidden);
    }
    return count;
}

}  // namespace tedavis::draw
