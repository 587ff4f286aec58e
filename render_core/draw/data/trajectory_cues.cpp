#include "render_core/draw/data/trajectory_cues.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/draw/data/ground_section.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/data/line_places.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/draw/data/tube_solids.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr std::uint32_t kMeshVertices = 128;  // what is mixed is put in order by meshes, and there is one for so many vertices
constexpr double kMaxSteps = 2000;            // of a leg: what is longer is cut into longer steps
constexpr double kLineShare = 0.12;           // half a line's width, of the tube's radius
constexpr float kLineRaised_px = 0.6f;
constexpr double kShadowShare = 0.45;  // what the ground below keeps of the colour

design::Color darker(const design::Color& color) {
    const auto part = [](std::uint8_t value) { return static_cast<std::uint8_t>(std::lround(kShadowShare * value)); };
    return {part(color.red), part(color.green), part(color.blue), color.alpha};
}

/// A place of the way, and the ground below it.
struct Station {
    glm::dvec3 place{0};  ///< ECEF
    LocalAxes axes;
    double radius_m = 0;
    std::uint32_t point = 0;  ///< the layer's number of the nearest
    earth::Geodetic over;
    double ground_m = 0;  ///< NaN: not known

    [[nodiscard]] bool is_on_ground() const { return over.height.m - ground_m < kFloating_m; }
    [[nodiscard]] bool floats() const { return over.height.m - ground_m >= kFloating_m; }
    /// Not over the way.
    [[nodiscard]] glm::dvec3 foot() const {
        return earth::to_ecef({over.latitude_rad, over.longitude_rad, {std::min(ground_m, over.height.m)}});
    }
};

/// One end's two vertices of a stretch.
struct CrossSection {
    glm::dvec3 left{0}, right{0}, left_normal{0}, right_normal{0};
    TubeColor color;
};

/// What is built of one element: meshes are begun and handed over as they fill.
class CueBuilder {
public:
    CueBuilder(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, Cue cue)
        : batch_(batch), mesh_(mesh), input_(input), cue_(cue), worst_(worst_accuracy(input.layer)) {}

    void set_look(double radius_m) {
        const design::ElementCues& cues = input_.element.cues;
        SolidLook look = look_of(input_);
        look.ghost = 0;
        look.is_thing = false;
        look.has_grid = look.has_grid && cue_ != Cue::vertical_lines;
        look.near_m = cue_ == Cue::projection ? 0 : kNearRadii * static_cast<float>(radius_m);
        if (cue_ != Cue::vertical_lines)
            look.opacity *= static_cast<float>(cue_ == Cue::curtain ? cues.curtain : cues.projection);
        if (is_widened()) look.opacity *= kMarginShare * static_cast<float>(input_.element.uncertainty_strength);
        look.is_mixed = look.is_mixed || look.opacity < 1 || cue_ == Cue::curtain;
        look.is_hollow = cue_ == Cue::projection;
        look.raised_px = cue_ == Cue::projection ? kStripRaised_px : cue_ == Cue::vertical_lines ? kLineRaised_px : 0;
        batch_.set_look(look, input_.layer.entry->data_time_ns);
    }

    /// Points of a line, all of which have a place.
    void add_polyline(std::uint32_t feature, base::Span<const scene::TubePoint> points, base::Span<const std::uint32_t> numbers) {
        feature_ = feature;
        points_ = points;
        numbers_ = numbers;
        if (points.size() < 2) return;
        if (cue_ == Cue::vertical_lines)
            add_lines();
        else
            add_stretches();
        flush();
    }

    [[nodiscard]] const CueCount& count() const { return count_; }

private:
    [[nodiscard]] bool is_widened() const { return input_.element.uncertainty == design::ElementUncertainty::widening; }

    [[nodiscard]] double length_m(std::size_t leg) const {
        return earth::surface_distance_m(earth::from_ecef(points_[leg].position), earth::from_ecef(points_[leg + 1].position));
    }

    [[nodiscard]] Station station(std::size_t leg, double share) const {
        const scene::TubePoint &a = points_[leg], &b = points_[leg + 1];
        Station at;
        at.place = a.position + (b.position - a.position) * share;
        at.radius_m = static_cast<double>(a.radius_m) + share * static_cast<double>(b.radius_m - a.radius_m);
        at.point = numbers_[share < 0.5 ? leg : leg + 1];
        at.over = earth::from_ecef(at.place);
        at.axes = local_axes(at.over.latitude_rad, at.over.longitude_rad);
        at.ground_m = input_.ground.height_m(at.over.latitude_rad, at.over.longitude_rad);
        return at;
    }

    [[nodiscard]] TubeColor color_at(const Station& at) const {
        const scene::PointOfFeature of{feature_, at.point};
        const design::ColorEncoding& by = input_.element.by_color;
        return {encoded_color(input_, by, of), encoded_uncertainty(input_, by, of)};
    }

    void add_lines() {
        const design::ElementCues& cues = input_.element.cues;
        PolylineMeasure way;
        for (std::size_t leg = 0; leg + 1 < points_.size(); ++leg)
            way.add_leg(length_m(leg), points_[leg].position - input_.eye, points_[leg + 1].position - input_.eye);
        const bool grows = input_.element.own != design::OwnData::none || input_.layer.entry->role == scene::LayerRole::traffic;
        const LinePlaces places(cues, way, grows, input_.time_ns);
        double from_m = 0;
        for (std::size_t leg = 0; leg + 1 < points_.size(); ++leg) {
            const double long_m = length_m(leg);
            const bool is_last = leg + 2 == points_.size();
            places.visit(from_m, from_m + long_m, is_last, [&](double along_m) {
                add_line(leg, long_m > 0 ? std::clamp((along_m - from_m) / long_m, 0.0, 1.0) : 0);
            });
            from_m += long_m;
        }
    }

    void add_line(std::size_t leg, double share) {
        if (is_full_) {
            ++count_.hidden;
            return;
        }
        const Station at = station(leg, share);
        if (at.is_on_ground()) return;
        begin_part(at.place, 8);
        const double reach_m = kTickRadii * at.radius_m;
        const double over_ground_m = at.floats() ? at.over.height.m - at.ground_m : reach_m;
        const double down_m = input_.element.cues.lines_to_ground ? over_ground_m : std::min(reach_m, over_ground_m);
        add_post(at, at.place - down_m * at.axes.up, at.place + reach_m * at.axes.up);
        ++parts_;
    }

    /// Upright, four sides, closed. Normals lean outwards, so that what raises it widens it.
    void add_post(const Station& at, const glm::dvec3& low, const glm::dvec3& high) {
        const glm::dvec3 out[4] = {at.axes.east, at.axes.north, -at.axes.east, -at.axes.north};
        const TubeColor shown = color_at(at);
        mesh_.set_color(shown.color, shown.uncertainty);
        std::uint16_t foot[4], top[4];
        for (std::size_t n = 0; n < 4; ++n) {
            const glm::dvec3 beside = kLineShare * at.radius_m * out[n];
            foot[n] = mesh_.vertex(low + beside, out[n]);
            top[n] = mesh_.vertex(high + beside, out[n]);
        }
        for (std::size_t n = 0; n < 4; ++n) {
            const std::size_t next = (n + 1) % 4;
            mesh_.triangle(foot[n], foot[next], top[next]);
            mesh_.triangle(foot[n], top[next], top[n]);
        }
        for (const std::size_t n : {std::size_t{1}, std::size_t{2}}) {
            mesh_.triangle(top[0], top[n], top[n + 1]);
            mesh_.triangle(foot[0], foot[n + 1], foot[n]);
        }
    }

    void add_stretches() {
        Station from = station(0, 0);
        CrossSection begin = cross_section(from, tangent(0, true));
        goes_on_ = false;
        for (std::size_t leg = 0; leg + 1 < points_.size(); ++leg) {
            const double steps = std::clamp(std::ceil(length_m(leg) / kLongestStep_m), 1.0, kMaxSteps);
            for (double step = 1; step <= steps; ++step) {
                const bool is_end = step == steps;
                const Station to = station(leg, step / steps);
                const CrossSection end = cross_section(to, tangent(is_end ? leg + 1 : leg, is_end));
                add_stretch(from, begin, to, end);
                from = to;
                begin = end;
            }
        }
    }

    /// Along the way at a point, between what comes and what goes there, or in the leg from there on.
    [[nodiscard]] glm::dvec3 tangent(std::size_t point, bool is_point) const {
        const std::size_t last = points_.size() - 1;
        const auto way = [&](std::size_t leg) {
            const glm::dvec3 by = points_[leg + 1].position - points_[leg].position;
            const double length = glm::length(by);
            return length > 0 ? by / length : glm::dvec3(0);
        };
        if (point == last) return way(last - 1);
        return is_point && point > 0 ? way(point - 1) + way(point) : way(point);
    }

    [[nodiscard]] CrossSection cross_section(const Station& at, const glm::dvec3& along) const {
        TubeColor shown = color_at(at);
        if (!std::isfinite(at.ground_m)) return {};
        if (cue_ == Cue::curtain) {
            const glm::dvec3 normal = kUnshaded * across(at, along);
            return {at.foot(), at.place, normal, normal, shown};
        }
        shown.color = darker(shown.color);
        const SectionEnds ends = section_ends(ground_section(input_, middle_of(at), half_of(at, along)));
        return {ends.left, ends.right, ends.left_normal, ends.right_normal, shown};
    }

    [[nodiscard]] static scene::ScenePoint middle_of(const Station& at) {
        return {at.over.latitude_rad, at.over.longitude_rad, std::numeric_limits<float>::quiet_NaN(), 0, scene::kNoTime};
    }

    /// Level, to the right of the way; none where it climbs straight up.
    [[nodiscard]] static glm::dvec3 across(const Station& at, const glm::dvec3& along) {
        const glm::dvec2 right = right_of({glm::dot(along, at.axes.east), glm::dot(along, at.axes.north)});
        return right.x * at.axes.east + right.y * at.axes.north;
    }

    [[nodiscard]] glm::dvec2 half_of(const Station& at, const glm::dvec3& along) const {
        const glm::dvec2 level(glm::dot(along, at.axes.east), glm::dot(along, at.axes.north));
        glm::dvec2 right = right_of(level);
        if (!(glm::length(right) > 0)) right = {1, 0};  // it climbs straight up
        const double off_m = is_widened() ? cautious_accuracy(input_.layer, {feature_, at.point}, worst_).level_m : 0;
        return right * (at.radius_m + off_m);
    }

    void add_stretch(const Station& from, const CrossSection& begin, const Station& to, const CrossSection& end) {
        if (!(from.floats() || to.floats()) || !std::isfinite(from.ground_m + to.ground_m)) {
            goes_on_ = false;
            return;
        }
        if (is_full_) {
            ++count_.hidden;
            return;
        }
        if (begin_part(begin.left, 4)) goes_on_ = false;
        if (!goes_on_) last_ = add_cross_section(begin);
        const Edges next = add_cross_section(end);
        mesh_.triangle(last_.left, last_.right, next.right);
        mesh_.triangle(last_.left, next.right, next.left);
        last_ = next;
        goes_on_ = true;
        ++parts_;
    }

    struct Edges {
        std::uint16_t left = 0, right = 0;
    };
    [[nodiscard]] Edges add_cross_section(const CrossSection& at) {
        mesh_.set_color(at.color.color, at.color.uncertainty);
        return {mesh_.vertex(at.left, at.left_normal), mesh_.vertex(at.right, at.right_normal)};
    }

    /// Room in the mesh for so many vertices round a place. True where it is a new one.
    bool begin_part(const glm::dvec3& place, std::uint32_t vertices) {
        const bool is_far = glm::distance(place, mesh_.origin()) > SolidBatch::kFarthestFromAnchor_m;
        if (parts_ > 0 && (is_far || mesh_.vertex_count() + vertices > kMeshVertices)) flush();
        if (parts_ > 0) return false;
        mesh_.begin(place);
        return true;
    }

    void flush() {
        if (parts_ == 0) return;
        is_full_ = is_full_ || !mesh_.add_to(batch_);
        (is_full_ ? count_.hidden : count_.drawn) += parts_;
        parts_ = 0;
    }

    SolidBatch& batch_;
    SolidMesh& mesh_;
    const ElementInput& input_;
    Cue cue_;
    PlaceAccuracy worst_;
    CueCount count_;
    std::uint32_t feature_ = 0, parts_ = 0;
    base::Span<const scene::TubePoint> points_;
    base::Span<const std::uint32_t> numbers_;
    Edges last_;
    bool goes_on_ = false, is_full_ = false;
};

}  // namespace

bool asks_for(const design::ElementCues& cues, Cue cue) {
    switch (cue) {
        case Cue::vertical_lines: return cues.line_spacing_m > 0;
        case Cue::projection: return cues.projection > 0;
        case Cue::curtain: return cues.curtain > 0;
        case Cue::count: break;
    }
    return false;
}

std::uint64_t TrajectoryCues::bytes_needed(std::uint32_t points) {
    return TubePath::bytes_needed() + TubeLine::bytes_needed(points);
}

bool TrajectoryCues::start(base::Arena& arena, std::uint32_t points) { return way_.start(arena) && line_.start(arena, points); }

CueCount TrajectoryCues::add(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, Cue cue) {
    way_.plan(input, line_.capacity());
    CueBuilder builder(batch, mesh, input, cue);
    builder.set_look(way_.radius_m());
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        if (look_of_feature(input, feature).is_hidden) continue;
        way_.read(feature, line_);
        const auto points = line_.points();
        for (std::size_t first = 0, end = 0; first < points.size(); first = end + 1) {
            for (end = first; end < points.size() && std::isfinite(points[end].position.x);) ++end;
            builder.add_polyline(feature, points.subspan(first, end - first), line_.numbers().subspan(first, end - first));
        }
    }
    return builder.count();
}

}  // namespace tedavis::draw
