#include "render_core/draw/data/pathway_solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/data/pathway_frames.hpp"
#include "render_core/draw/data/pathway_legs.hpp"
#include "render_core/draw/data/solid_look.hpp"

namespace tedavis::draw {
namespace {

constexpr double kBeside = 0.34;    // of a vertex's normal across its line: with as much along it, it is too short to be shaded
constexpr double kLineShare = 0.7;  // what a line along the path has of the opacity of frames
constexpr double kMinStep_m = 50, kStepShare = 0.02;  // between places of a line; of the distance from the eye
constexpr std::uint32_t kMeshVertices = 256;          // what is mixed is put in order by meshes
constexpr std::size_t kOutlinePlaces = 5;
constexpr std::array<int, kOutlinePlaces> kDashedParts{7, 3, 3, 3, 3};  // dashes and gaps of each side
constexpr design::Color kRimColor{16, 16, 20, 255};

/// Corners from the upper left one, clockwise, and the middle of the lower edge.
std::array<glm::dvec3, kOutlinePlaces> outline(const ElementInput& input, const PathwayFrame& frame) {
    const LowerEdge low_m = lower_edge(input, frame);
    const auto at = [&](double side, double up_m) {
        return frame.middle + side * frame.half_width_m * frame.right + up_m * frame.up;
    };
    return {at(-1, frame.half_height_m), at(1, frame.half_height_m), at(1, low_m[2]), at(0, low_m[1]), at(-1, low_m[0])};
}

/// All lines of an element, or the rims of all of them.
class PathwayBuilder {
public:
    PathwayBuilder(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, double rim_px)
        : batch_(batch), mesh_(mesh), input_(input), rim_px_(rim_px), worst_(worst_accuracy(input.layer)) {
        SolidLook look = look_of(input);
        look.is_mixed = true;
        look.is_thing = look.has_grid = false;
        if (is_rim()) look.ghost = 0;
        look.raised_px = static_cast<float>((kFrameLine_px / 2 + rim_px) / kBeside);
        batch_.set_look(look, input.layer.entry->data_time_ns);
    }

    void add_frames(const PathwayFrames& frames) {
        const double strength = std::clamp(input_.element.uncertainty_strength, 0.0, 1.0);
        const double of_accuracy = shows_accuracy() ? std::ceil(strength * static_cast<double>(frames.size())) : 0;
        for (std::size_t n = 0; n < frames.size(); ++n) {
            mesh_.begin(frames[n].middle);
            add_frame(frames[n]);
            if (static_cast<double>(n) < of_accuracy) add_accuracy(frames[n]);
            flush();
        }
    }

    void add_line(std::uint32_t feature, double from_m, double own_m, double length_m) {
        const double step_m = std::fmax(kMinStep_m, length_m / static_cast<double>(kMaxPathPoints));
        visit_legs(input_, feature, [&](const PathwayLeg& leg) {
            if (leg.to_m <= from_m) return;
            if (!leg.goes_on || leg.from_m <= from_m) begin_at(feature, leg, std::fmax(leg.from_m, from_m), own_m);
            const bool is_last = leg.to_m >= length_m;
            const double least_m = std::fmax(step_m, kStepShare * glm::distance(leg.to, input_.eye));
            if (is_last || glm::distance(leg.to, last_.place) >= least_m) go_on_to(feature, leg, own_m);
        });
        flush();
    }

    [[nodiscard]] std::uint32_t drawn() const { return drawn_; }
    [[nodiscard]] bool is_full() const { return is_full_; }

private:
    struct Station {
        glm::dvec3 place{0};
        double opacity = 0;  ///< 0: no line
        scene::PointOfFeature point{};
    };

    [[nodiscard]] bool is_rim() const { return rim_px_ > 0; }
    /// Length of a normal across a line so wide: the look raises by the widest.
    [[nodiscard]] double beside(double line_px) const {
        return kBeside * (line_px / 2 + rim_px_) / (kFrameLine_px / 2 + rim_px_);
    }

    void set_color(const scene::PointOfFeature& point, double opacity) {
        const design::ColorEncoding& by = input_.element.by_color;
        design::Color color = encoded_color(input_, by, point);
        const double alpha = opacity * color.alpha;
        if (is_rim()) color = kRimColor;
        color.alpha = static_cast<std::uint8_t>(std::lround(std::clamp(alpha, 0.0, 255.0)));
        mesh_.set_color(color, encoded_uncertainty(input_, by, point));
    }

    void add_frame(const PathwayFrame& frame) {
        set_color(frame.point, frame.opacity);
        const auto corners = outline(input_, frame);
        for (std::size_t n = 0; n < kOutlinePlaces; ++n) add_bar(corners[n], corners[(n + 1) % kOutlinePlaces], kFrameLine_px);
    }

    [[nodiscard]] bool shows_accuracy() const {
        return input_.element.uncertainty == design::ElementUncertainty::widening && states_accuracy(input_.layer);
    }

    /// In the color of the frame, which was set.
    void add_accuracy(const PathwayFrame& frame) {
        const PlaceAccuracy off = cautious_accuracy(input_.layer, frame.point, worst_);
        PathwayFrame wide = frame;
        wide.half_width_m += off.level_m;
        wide.half_height_m += off.height_m;
        const auto far = outline(input_, wide);
        for (std::size_t n = 0; n < kOutlinePlaces; ++n) add_dashes(far[n], far[(n + 1) % kOutlinePlaces], kDashedParts[n]);
    }

    /// Of so many parts every second one, with both ends.
    void add_dashes(const glm::dvec3& from, const glm::dvec3& to, int parts) {
        const glm::dvec3 part = (to - from) / static_cast<double>(parts);
        for (int n = 0; n < parts; n += 2)
            add_bar(from + part * static_cast<double>(n), from + part * static_cast<double>(n + 1), kThinLine_px);
    }

    /// Unit vector across a line as the eye sees it; none where it is seen from its end.
    [[nodiscard]] glm::dvec3 across(const glm::dvec3& place, const glm::dvec3& along) const {
        const glm::dvec3 side = glm::cross(along, place - input_.eye);
        const double length = glm::length(side);
        return length > 0 ? side / length : glm::dvec3(0);
    }

    void add_bar(const glm::dvec3& from, const glm::dvec3& to, double line_px) {
        const double long_m = glm::distance(from, to);
        if (!(long_m > 0)) return;
        const glm::dvec3 along = (to - from) / long_m, side = across((from + to) / 2.0, along);
        const double by = beside(line_px);
        const std::uint16_t a = mesh_.vertex(from, by * (-along - side)), b = mesh_.vertex(to, by * (along - side)),
                            c = mesh_.vertex(to, by * (along + side)), d = mesh_.vertex(from, by * (side - along));
        mesh_.triangle(a, b, c);
        mesh_.triangle(a, c, d);
    }

    [[nodiscard]] Station station(const scene::PointOfFeature& point, const glm::dvec3& place, double ahead_m) const {
        const earth::Geodetic at = earth::from_ecef(place);
        const double over_m = at.height.m - input_.ground.height_m(at.latitude_rad, at.longitude_rad);
        // A part that leads back close to the eye, as the landing after a circuit, would be a wedge over the picture.
        const double near_share = std::clamp((glm::distance(place, input_.eye) - kGone_m) / (kWhole_m - kGone_m), 0.0, 1.0);
        return {place, over_m < kFloating_m ? 0 : kLineShare * near_share * shown_ahead(ahead_m), point};
    }

    void begin_at(std::uint32_t feature, const PathwayLeg& leg, double along_m, double own_m) {
        last_ = station({feature, leg.from_point}, leg.at(along_m), along_m - own_m);
        goes_on_ = false;
    }

    void go_on_to(std::uint32_t feature, const PathwayLeg& leg, double own_m) {
        const Station next = station({feature, leg.from_point + 1}, leg.to, leg.to_m - own_m);
        const bool is_shown = last_.opacity > 0 || next.opacity > 0;
        const glm::dvec3 along = glm::normalize(next.place - last_.place);
        if (is_shown) {
            make_room(last_.place);
            if (!goes_on_) edges_ = add_edges(last_, along);
            const Edges to = add_edges(next, along);
            mesh_.triangle(edges_.right, to.right, to.left);
            mesh_.triangle(edges_.right, to.left, edges_.left);
            edges_ = to;
        }
        goes_on_ = is_shown;
        last_ = next;
    }

    struct Edges {
        std::uint16_t left = 0, right = 0;
    };
    [[nodiscard]] Edges add_edges(const Station& at, const glm::dvec3& along) {
        set_color(at.point, at.opacity);
        const glm::dvec3 side = beside(kThinLine_px) * across(at.place, along);
        return {mesh_.vertex(at.place, side), mesh_.vertex(at.place, -side)};
    }

    /// For a part of a line from a place on: where the mesh is full or far away another one begins.
    void make_room(const glm::dvec3& place) {
        constexpr std::uint32_t kPartVertices = 4;
        const bool is_far = glm::distance(place, mesh_.origin()) > SolidBatch::kFarthestFromAnchor_m;
        if (has_line_ && !is_far && mesh_.vertex_count() + kPartVertices <= kMeshVertices) return;
        if (has_line_) flush();
        mesh_.begin(place);
        has_line_ = true;
        goes_on_ = false;
    }

    void flush() {
        if (mesh_.vertex_count() > 0) {
            const bool is_added = mesh_.add_to(batch_);
            drawn_ += is_added ? 1 : 0;
            is_full_ = is_full_ || !is_added;
        }
        mesh_.begin(glm::dvec3(0));
        has_line_ = goes_on_ = false;
    }

    SolidBatch& batch_;
    SolidMesh& mesh_;
    const ElementInput& input_;
    double rim_px_;
    PlaceAccuracy worst_;
    Station last_;
    Edges edges_;
    std::uint32_t drawn_ = 0;  ///< meshes
    bool goes_on_ = false, has_line_ = false, is_full_ = false;
};

double length_of(const ElementInput& input, std::uint32_t feature) {
    double length_m = 0;
    visit_legs(input, feature, [&](const PathwayLeg& leg) { length_m = leg.to_m; });
    return length_m;
}

/// Lines, or their rims. True where something is drawn, and nothing is left out for want of room.
bool add_feature(PathwayBuilder& builder, const ElementInput& input, const Pathway& planned, std::uint32_t feature) {
    const std::uint32_t drawn_before = builder.drawn();
    if (feature == planned.feature) {
        builder.add_line(feature, std::fmax(faded_from_m(input, planned), planned.own_m), planned.own_m, planned.length_m);
        builder.add_frames(pathway_frames(input, planned));
    } else {
        builder.add_line(feature, 0, -kWhole_m, length_of(input, feature));
    }
    return !builder.is_full() && builder.drawn() > drawn_before;
}

}  // namespace

bool shows_pathways(const scene::Layer& layer) {
    return layer.entry->shape == scene::LayerShape::lines && layer.entry->role == scene::LayerRole::trajectory;
}

ElementCount add_pathway(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    ElementCount count;
    const Pathway planned = planned_pathway(input);
    const auto add_all = [&](double rim_px, bool counts) {
        PathwayBuilder builder(batch, mesh, input, rim_px);
        for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
            const bool is_drawn = !look_of_feature(input, feature).is_hidden && add_feature(builder, input, planned, feature);
            if (counts) ++(is_drawn ? count.drawn : count.hidden);
        }
    };
    if (input.element.halo_px > 0) add_all(input.element.halo_px, false);
    add_all(0, true);
    return count;
}

}  // namespace tedavis::draw
