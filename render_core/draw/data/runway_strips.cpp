#include "render_core/draw/data/runway_strips.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/data/ground_section.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/data/papi.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/runway_marks.hpp"
#include "render_core/draw/data/runway_surface.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr design::Color kPaint{245, 245, 245}, kWhiteLight{255, 255, 255}, kRedLight{235, 30, 30}, kLightRim{16, 16, 16};
constexpr double kMinGrazing = 0.03, kFarthestEnd_m = 60, kFarthestTick_m = 200;
constexpr int kDim = 150;  // alpha of the extended centre line

design::Color with_alpha(design::Color color, double share) {
    color.alpha = static_cast<std::uint8_t>(std::lround(color.alpha * std::clamp(share, 0.0, 1.0)));
    return color;
}

double width_of(const ElementInput& input, std::uint32_t feature) {
    const double width = scene::value_or_nan(input.layer, "width", feature);
    if (width > 0) return width;
    return input.element.size_m > 0 ? input.element.size_m : kRunwayWidth_m;
}

/// A runway and what belongs to it, in a mesh.
class RunwayStrip {
public:
    RunwayStrip(SolidMesh& mesh, const ElementInput& input, const ApproachFrame& frame, std::uint32_t feature)
        : mesh_(mesh), input_(input), frame_(frame), feature_(feature) {}

    /// False where there is nothing to draw.
    bool find() {
        const scene::Run run = input_.layer.points_of(feature_);
        if (run.count < 2) return false;
        first_ = input_.layer.points[run.first];
        last_ = input_.layer.points[run.first + run.count - 1];
        const glm::dvec3 at = earth::to_ecef({first_.latitude_rad, first_.longitude_rad, {0}});
        return glm::distance(at, input_.eye) < kFarthestRunway_m &&
               surface_.build(input_, first_, last_, width_of(input_, feature_));
    }

    void build(bool is_whole, bool has_line) {
        mesh_.begin(surface_.at(0, 0));
        color_ = encoded_color(input_, input_.element.by_color, feature_);
        unsure_ = encoded_uncertainty(input_, feature_);
        paint_ = {kPaint.red, kPaint.green, kPaint.blue, color_.alpha};
        if (has_line) add_line();
        add_surface();
        if (!is_whole) return;
        add_marks();
        add_papi();
    }

private:
    [[nodiscard]] double px_at(const glm::dvec3& place) const {
        return std::max(glm::distance(place, input_.eye), 1.0) * frame_.metres_per_px_m;
    }
    /// How much of a length along the ground is seen, by the angle at which the eye looks down on it.
    [[nodiscard]] double grazing(const glm::dvec3& place) const {
        const glm::dvec3 to_eye = input_.eye - place;
        return std::clamp(glm::dot(to_eye, surface_.up()) / std::max(glm::length(to_eye), 1.0), kMinGrazing, 1.0);
    }
    [[nodiscard]] double outline_m(double along_m) const {
        return std::max(kMinOutline_px * px_at(surface_.at(along_m, 0)), kOutline_m);
    }

    std::uint16_t vertex(double along_m, double aside_m) {
        return mesh_.vertex(surface_.at(along_m, aside_m), surface_.up() * kUnshaded);
    }
    void quad(std::uint16_t a, std::uint16_t b, std::uint16_t c, std::uint16_t d) {
        mesh_.triangle(a, b, c);
        mesh_.triangle(a, c, d);
    }
    void rectangle(const RunwayMark& mark, design::Color color) {
        mesh_.set_color(color, unsure_);
        const std::uint16_t a = vertex(mark.from_m, mark.left_m), b = vertex(mark.from_m, mark.right_m),
                            c = vertex(mark.to_m, mark.right_m), d = vertex(mark.to_m, mark.left_m);
        quad(a, b, c, d);
    }

    /// Rim, outline and surface, from the left to the right.
    void add_surface() {
        for (const bool is_last : {false, true}) add_end(is_last);
        constexpr std::size_t kColumns = 8, kParts = 5;
        constexpr std::size_t kLeft[kParts] = {0, 1, 3, 5, 6};
        std::uint16_t before[kColumns], here[kColumns];
        for (std::size_t n = 0; n < surface_.sections(); ++n) {
            const double along_m = surface_.along_m(n), half = surface_.half_width_m(), px = px_at(surface_.at(along_m, 0));
            const double out = half + outline_m(along_m);
            const double aside_m[kColumns] = {-out - px, -out, -half, -half, half, half, out, out + px};
            for (std::size_t k = 0; k < kColumns; ++k) {
                const bool is_rim = k == 0 || k == kColumns - 1, is_surface = k == 3 || k == 4;
                mesh_.set_color(is_rim ? with_alpha(paint_, 0) : (is_surface ? color_ : paint_), unsure_);
                here[k] = vertex(along_m, aside_m[k]);
            }
            for (const std::size_t left : kLeft)
                if (n > 0) quad(before[left], before[left + 1], here[left + 1], here[left]);
            std::copy(std::begin(here), std::end(here), std::begin(before));
        }
    }

    void add_end(bool is_last) {
        const double end_m = is_last ? surface_.length_m() : 0, out = surface_.half_width_m() + outline_m(end_m);
        const glm::dvec3 place = surface_.at(end_m, 0);
        const double deep_m = std::clamp(kMinOutline_px * px_at(place) / grazing(place), kOutline_m, kFarthestEnd_m);
        rectangle({is_last ? end_m : end_m - deep_m, is_last ? end_m + deep_m : end_m, -out, out}, paint_);
    }

    void add_marks() {
        const RunwayNumbers numbers = runway_numbers(input_.layer.name_of(feature_), surface_.bearing_rad());
        for (const RunwayMark& mark : runway_marks(surface_.length_m(), 2 * surface_.half_width_m(), numbers)) {
            const glm::dvec3 middle = surface_.at(0.5 * (mark.from_m + mark.to_m), 0.5 * (mark.left_m + mark.right_m));
            const double across_px = (mark.right_m - mark.left_m) / px_at(middle),
                         along_px = (mark.to_m - mark.from_m) * grazing(middle) / px_at(middle);
            const double shown = (std::min(across_px, along_px) - kMinMark_px) / (kWholeMark_px - kMinMark_px);
            if (shown > 0) rectangle(mark, with_alpha(paint_, shown));
        }
    }

    /// Seen from the end at the first point, or at the last one: before the threshold, and to the right.
    [[nodiscard]] glm::dvec2 before_and_aside(bool is_last) const {
        const glm::dvec2 at = along_and_aside(first_, last_, frame_.own_ship);
        return is_last ? glm::dvec2(at.x - surface_.length_m(), -at.y) : glm::dvec2(-at.x, at.y);
    }
    [[nodiscard]] double along_from(bool is_last, double from_end_m) const {
        return is_last ? surface_.length_m() - from_end_m : from_end_m;
    }

    void add_papi() {
        if (!frame_.has_own_ship) return;
        const double aiming_m = aiming_point_m(surface_.length_m()),
                     from_m = aiming_m > 0 ? aiming_m : 0.25 * surface_.length_m();
        for (const bool is_last : {false, true}) {
            const glm::dvec2 own = before_and_aside(is_last);
            if (is_papi_seen(own.x + from_m, own.y)) add_lights(along_from(is_last, from_m), is_last ? 1 : -1);
        }
    }

    void add_lights(double along_m, double side) {
        const double px = px_at(surface_.at(along_m, 0)), half = surface_.half_width_m();
        const double size_m = std::max(0.5 * kMinLight_px * px, 0.75);
        const double spacing_m = std::max(kPapiSpacing_m, 2 * size_m + 2.5 * px);
        const double first_m = half + std::max(kPapiFree_m, outline_m(along_m) + size_m + 3 * px);
        const double path_rad = scene::value_or_nan(input_.layer, "glide_path", feature_);
        const PapiLights lights =
            papi_lights(angle_deg(surface_.at(along_m, side * first_m)), path_rad > 0 ? base::degrees(path_rad) : kPapiPath_deg);
        for (std::size_t n = 0; n < kPapiLights; ++n) {
            const double aside_m = side * (first_m + spacing_m * static_cast<double>(n));
            const glm::dvec3 place = surface_.at(along_m, aside_m) + surface_.up() * (size_m + px);
            facing({place, size_m + px, (lights[n] ? size_m : 0.5 * size_m) + px}, kLightRim);
            facing({place, size_m, lights[n] ? size_m : 0.5 * size_m}, lights[n] ? kWhiteLight : kRedLight);
        }
    }

    /// Elevation of the own ship.
    [[nodiscard]] double angle_deg(const glm::dvec3& light) const {
        const glm::dvec3 way = earth::to_ecef(frame_.own_ship) - light;
        return base::degrees(std::asin(std::clamp(glm::dot(way, surface_.up()) / glm::length(way), -1.0, 1.0)));
    }

    /// A rectangle that faces the eye, with half its width and height.
    struct Facing {
        glm::dvec3 middle;
        double half_width_m, half_height_m;
    };
    void facing(const Facing& of, design::Color color) {
        const glm::dvec3 away = of.middle - input_.eye, across = glm::cross(away, surface_.up());
        if (!(glm::length(across) > 0)) return;
        const glm::dvec3 right = glm::normalize(across) * of.half_width_m;
        const glm::dvec3 up = glm::normalize(glm::cross(across, away)) * of.half_height_m;
        mesh_.set_color({color.red, color.green, color.blue, color_.alpha});
        const std::uint16_t a = mesh_.vertex(of.middle - right - up, {}), b = mesh_.vertex(of.middle + right - up, {}),
                            c = mesh_.vertex(of.middle + right + up, {}), d = mesh_.vertex(of.middle - right + up, {});
        quad(a, b, c, d);
    }

    /// A place on the extended centre line, on the drawn ground.
    struct LinePlace {
        glm::dvec3 middle{0}, up{0};
        double px = 0;
        bool is_known = false;
    };
    [[nodiscard]] LinePlace line_place(bool is_last, double out_m) const {
        const scene::ScenePoint at = moved(is_last ? last_ : first_, surface_.way() * (is_last ? out_m : -out_m));
        LinePlace place;
        const double height_m = seat_height_m(input_, at);
        place.is_known = !std::isnan(height_m);
        if (!place.is_known) return place;
        place.middle = earth::to_ecef({at.latitude_rad, at.longitude_rad, {height_m + kRunwayLift_m}});
        place.up = earth::up_at(place.middle);
        place.px = px_at(place.middle);
        return place;
    }

    void add_line() {
        const bool is_last = before_and_aside(true).x > before_and_aside(false).x;
        const glm::dvec3 right = is_last ? -surface_.right() : surface_.right();
        mesh_.set_color(with_alpha(paint_, kDim / 255.0), unsure_);
        constexpr double kStep_m = base::kMetresPerNauticalMile / kExtendedSteps;
        LinePlace before = line_place(is_last, 0);
        for (int n = 1; n <= kExtendedNm * kExtendedSteps && before.is_known; ++n) {
            const LinePlace here = line_place(is_last, n * kStep_m);
            if (!here.is_known) return;
            const glm::dvec3 a = right * (0.5 * kExtended_px * before.px), b = right * (0.5 * kExtended_px * here.px);
            flat(here.middle - b, here.middle + b, before.middle + a, before.middle - a, here.up);
            if (n % kExtendedSteps == 0)
                add_tick(here, right, glm::normalize(here.middle - before.middle), n == kExtendedNm * kExtendedSteps);
            before = here;
        }
    }

    void add_tick(const LinePlace& at, const glm::dvec3& right, const glm::dvec3& out, bool is_long) {
        const glm::dvec3 reach = right * (is_long ? 2 * kTick_m : kTick_m);
        const double deep_m = std::min(kExtended_px * at.px / grazing(at.middle), kFarthestTick_m);
        const glm::dvec3 half = out * (0.5 * deep_m);
        flat(at.middle - reach + half, at.middle + reach + half, at.middle + reach - half, at.middle - reach - half, at.up);
    }

    /// Near left, near right, far right, far left, as the approaching pilot sees them.
    void flat(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d, const glm::dvec3& up) {
        const glm::dvec3 normal = up * kUnshaded;
        const std::uint16_t first = mesh_.vertex(a, normal), second = mesh_.vertex(b, normal), third = mesh_.vertex(c, normal),
                            last = mesh_.vertex(d, normal);
        quad(first, second, third, last);
    }

    SolidMesh& mesh_;
    const ElementInput& input_;
    const ApproachFrame& frame_;
    std::uint32_t feature_;
    scene::ScenePoint first_{}, last_{};
    RunwaySurface surface_;
    design::Color color_, paint_;
    scene::Uncertainty unsure_;
};

SolidLook runway_look(const ElementInput& input) {
    SolidLook look = look_of(input);
    look.raised_px = kRunwayRaised_px / static_cast<float>(kUnshaded);
    look.nearer_m = kRunwayNearer_m;
    look.is_last = true;
    look.is_thing = false;
    return look;
}

}  // namespace

ElementCount add_runways(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, const ApproachFrame& frame) {
    ElementCount count;
    batch.set_look(runway_look(input), input.layer.entry->data_time_ns);
    const Approach approach = approach_of(input, frame);
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        RunwayStrip strip(mesh, input, frame, feature);
        bool is_drawn = false;
        if (strip.find())
            for (const bool is_whole : {true, false}) {
                strip.build(is_whole, is_whole && approach.is_any && approach.feature == feature);
                is_drawn = mesh.add_to(batch);
                if (is_drawn) break;
            }
        ++(is_drawn ? count.drawn : count.hidden);
    }
    return count;
}

}  // namespace tedavis::draw
