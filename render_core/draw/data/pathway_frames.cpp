#include "render_core/draw/data/pathway_frames.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/draw/data/focus_place.hpp"
#include "render_core/draw/data/pathway_legs.hpp"
#include "render_core/draw/data/planned_track.hpp"

namespace tedavis::draw {
namespace {

constexpr double kNearFrames = kFinal_m / kNearSpacing_m;
constexpr double kMinLevel = 1e-3;  // of a unit vector, below which a path has no direction on the ground

/// Spacings from the path's end to a place so far from it, and back.
double spacings(double from_end_m) {
    return from_end_m < kFinal_m ? from_end_m / kNearSpacing_m : kNearFrames + (from_end_m - kFinal_m) / kSpacing_m;
}
double from_end_m(double spacings) {
    return spacings < kNearFrames ? spacings * kNearSpacing_m : kFinal_m + (spacings - kNearFrames) * kSpacing_m;
}

/// Frames that are shown, in spacings ahead of the own ship.
double reach(const ElementInput& input) {
    const double asked = std::round(input.element.detail * static_cast<double>(kMaxPathwayFrames));
    return std::clamp(asked, static_cast<double>(kMinPathwayFrames), static_cast<double>(kMaxPathwayFrames));
}

double fading_frames(double reach) { return std::min(kFadingFrames, reach / 2); }

/// Height above the ground; NaN where it is unknown.
double over_ground_m(const ElementInput& input, const earth::Geodetic& at) {
    return at.height.m - input.ground.height_m(at.latitude_rad, at.longitude_rad);
}

/// Whether the ground leaves room for a frame.
bool may_stand(const ElementInput& input, const Pathway& pathway, const glm::dvec3& middle) {
    const double over_m = over_ground_m(input, earth::from_ecef(middle));
    const double from_ends_m = std::fmin(glm::distance(middle, pathway.begin), glm::distance(middle, pathway.end));
    return !(over_m < (from_ends_m <= kFinal_m ? kLowest_m : 0));
}

/// False where the path has no direction on the ground.
bool make_frame(const ElementInput& input, const Pathway& pathway, const PathwayLeg& leg, double along_m, PathwayFrame& frame) {
    frame.middle = leg.at(along_m);
    const earth::Geodetic at = earth::from_ecef(frame.middle);
    frame.up = local_axes(at.latitude_rad, at.longitude_rad).up;
    const glm::dvec3 across = glm::cross(glm::normalize(leg.to - leg.from), frame.up);
    if (!(glm::length(across) > kMinLevel)) return false;
    frame.right = glm::normalize(across);
    frame.half_width_m = (input.element.size_m > 0 ? input.element.size_m : kFrameWidth_m) / 2;
    frame.half_height_m = kFrameHeightShare * frame.half_width_m;
    frame.along_m = along_m;
    const bool is_nearer_first = along_m - leg.from_m < leg.to_m - along_m;
    frame.point = {pathway.feature, leg.from_point + (is_nearer_first ? 0u : 1u)};
    return true;
}

}  // namespace

Pathway planned_pathway(const ElementInput& input) {
    Pathway pathway;
    if (!input.own_ship.is_valid) return pathway;
    const PlannedTrack way = track_beside(input.layer, input.own_ship.place, input.time_ns, input.has_date, kFarthestTrack_m);
    if (way.layer == nullptr) return pathway;
    bool is_first = true;
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature)
        if (input.layer.points_of(feature).first == way.run.first) pathway.feature = feature;
    visit_legs(input, pathway.feature, [&](const PathwayLeg& leg) {
        if (is_first) pathway.begin = leg.from;
        is_first = false;
        pathway.end = leg.to;
        pathway.length_m = leg.to_m;
        if (leg.leg < way.leg) pathway.own_m = leg.to_m;
        if (leg.leg == way.leg) pathway.own_m = leg.from_m + way.part * (leg.to_m - leg.from_m);
    });
    return pathway;
}

double faded_from_m(const ElementInput& input, const Pathway& pathway) {
    const double shown = reach(input), own = spacings(pathway.length_m - pathway.own_m);
    return pathway.length_m - from_end_m(std::fmax(own - (shown - fading_frames(shown)), 0));
}

PathwayFrames pathway_frames(const ElementInput& input, const Pathway& pathway) {
    PathwayFrames frames;
    if (pathway.feature == Pathway::kNone) return frames;
    const double shown = reach(input), own = spacings(pathway.length_m - pathway.own_m);
    visit_legs(input, pathway.feature, [&](const PathwayLeg& leg) {
        const double first = spacings(pathway.length_m - leg.from_m), last = spacings(std::fmax(pathway.length_m - leg.to_m, 0));
        for (double n = std::ceil(std::fmin(first, own)) - 1; n >= last && n > own - shown; --n) {
            const double along_m = pathway.length_m - from_end_m(n);
            PathwayFrame frame;
            if (!make_frame(input, pathway, leg, along_m, frame) || !may_stand(input, pathway, frame.middle)) continue;
            frame.opacity = std::fmin((shown - (own - n)) / fading_frames(shown), 1) * shown_ahead(along_m - pathway.own_m);
            if (frame.opacity > 0) static_cast<void>(frames.try_push_back(frame));
        }
    });
    return frames;
}

LowerEdge lower_edge(const ElementInput& input, const PathwayFrame& frame) {
    LowerEdge edge{};
    for (std::size_t n = 0; n < edge.size(); ++n) {
        const double beside_m = (static_cast<double>(n) - 1) * frame.half_width_m;
        const double over_m = over_ground_m(input, earth::from_ecef(frame.middle + beside_m * frame.right));
        const double low_m = over_m < frame.half_height_m ? -over_m : -frame.half_height_m;
        edge[n] = std::min(low_m, frame.half_height_m);
    }
    return edge;
}

double shown_ahead(double ahead_m) { return std::clamp((ahead_m - kGone_m) / (kWhole_m - kGone_m), 0.0, 1.0); }

}  // namespace tedavis::draw
