#include "host_sim/accuracy/knobs/vertex_knob.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iterator>

#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/base/units.hpp"
#include "render_core/draw/drawers/view_projection.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kVerticesOfView = 512, kVertexViews = 64, kQuickVertexViews = 16;
constexpr std::uint32_t kViewWidth_px = 1920, kViewHeight_px = 1080;
constexpr double kViewWidth_deg = 60;
constexpr double kNearestVertex_m = 10, kFarthestVertex_m = 400'000;
// Of a vertex from the centre of its chunk: a small chunk where it is near, at most half of its distance where it is far.
constexpr double kMinReach_m = 200, kMaxNearReach_m = 3000, kMaxReach_m = 20'000;
constexpr double kQuantum_m = 1.0 / 16384, kFloats = 1 << 24;  // of positions, as the terrain builder has them

constexpr std::size_t kOffsetLevel = 0, kEcefLevel = 1, kPairLevel = 2;
constexpr const char* kVertexLevelNames[] = {"floats from the chunk's centre", "floats of ECEF", "two floats a coordinate",
                                             "doubles"};

KnobFacts vertex_precision_facts() {
    std::vector<KnobLevel> levels;
    for (const char* const name : kVertexLevelNames) levels.push_back({name, 0});
    return {
        "vertex_precision",
        "Numbers that a terrain vertex is placed with",
        "render_core/draw/shaders/terrain_place.vert, here by the same sums of floats on the processor",
        "distance on the screen from the vertex's true place, 1920 px over 60 degrees, before the rasterizer rounds to its own "
        "parts of pixels",
        "px",
        {"the same projection of the true place in long double", 1e-9,
         "19 digits of 6,400 km are far below a nanometre, which is 2e-7 px at 10 m"},
        "the sum by hand of a vertex (tests/host_sim/accuracy)",
        "Vertices that two chunks share have the same place at every level that draws terrain.",
        "no scale: four kinds of numbers",
        std::nullopt,
        std::move(levels),
        "shaders of OpenGL ES have floats only, and one sum of them does where the chunk's centre is near"};
}

using FloatRow = std::array<float, 4>;

/// A matrix as a uniform: of floats, by columns.
struct FloatMatrix {
    std::array<FloatRow, 4> column;

    explicit FloatMatrix(const glm::dmat4& matrix) : column() {
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r)
                column[static_cast<std::size_t>(c)][static_cast<std::size_t>(r)] = static_cast<float>(matrix[c][r]);
    }
    /// In floats, column by column as GLSL's product of matrix and vector.
    [[nodiscard]] float row(std::size_t r, const glm::vec3& place) const {
        return column[0][r] * place.x + column[1][r] * place.y + column[2][r] * place.z + column[3][r];
    }
};

struct ScreenPlace {
    double x_px = 0, y_px = 0;
};

/// A vertex as each level has it.
struct PlacedVertex {
    glm::dvec3 place;     ///< ECEF, true
    glm::vec3 position;   ///< on its binary grid, from the chunk's centre
    glm::vec3 offset;     ///< of the chunk's centre from the eye's whole metres
    glm::vec3 ecef;       ///< in floats
    glm::vec3 high, low;  ///< in two floats a coordinate
};

/// ECEF in half metres, exact in floats, and the rest. Floats are not widened again to find it: GCC 12 leaves such a conversion
/// there and back out where it vectorizes.
glm::dvec3 half_metres(const glm::dvec3& place) { return glm::round(2.0 * place) / 2.0; }
glm::vec3 high_part(const glm::dvec3& place) { return glm::vec3(half_metres(place)); }
glm::vec3 low_part(const glm::dvec3& place) { return glm::vec3(place - half_metres(place)); }

class VertexView {
public:
    explicit VertexView(SeededRandom& numbers) : view_(made_view(numbers)), of_eye_(matrix(eye_fraction())), of_ecef_(ecef()) {
        eye_high_ = high_part(view_.eye);
        eye_low_ = low_part(view_.eye);
        for (std::size_t n = 0; n < kVerticesOfView; ++n) vertices_.push_back(made_vertex(numbers));
    }

    [[nodiscard]] ScreenPlace on_screen(std::size_t level, std::size_t number) const {
        const PlacedVertex& vertex = vertices_[number];
        if (level == kOffsetLevel) return floats(of_eye_, vertex.position + vertex.offset);
        if (level == kEcefLevel) return floats(of_ecef_, vertex.ecef);
        if (level == kPairLevel) return floats(from_eye_, (vertex.high - eye_high_) + (vertex.low - eye_low_));
        const glm::dvec3 ray = vertex.place - view_.eye;
        const double depth = dot<double>(view_.forward, ray);
        return {view_.focal_px * dot<double>(view_.right, ray) / depth, view_.focal_px * dot<double>(view_.down, ray) / depth};
    }
    [[nodiscard]] double pixels_off(std::size_t level, std::size_t number) const {
        using Exact = long double;
        const glm::vec<3, Exact> ray = glm::vec<3, Exact>(vertices_[number].place) - glm::vec<3, Exact>(view_.eye);
        const Exact depth = dot<Exact>(view_.forward, ray), focal = view_.focal_px;
        const ScreenPlace found = on_screen(level, number);
        const Exact x = static_cast<Exact>(found.x_px) - focal * dot<Exact>(view_.right, ray) / depth;
        const Exact y = static_cast<Exact>(found.y_px) - focal * dot<Exact>(view_.down, ray) / depth;
        return static_cast<double>(std::hypot(x, y));
    }
    [[nodiscard]] double distance_m(std::size_t number) const { return glm::length(vertices_[number].place - view_.eye); }

private:
    template <class Real>
    [[nodiscard]] static Real dot(const glm::dvec3& axis, const glm::vec<3, Real>& ray) {
        return static_cast<Real>(axis.x) * ray.x + static_cast<Real>(axis.y) * ray.y + static_cast<Real>(axis.z) * ray.z;
    }
    static terrain::View made_view(SeededRandom& numbers) {
        const double latitude = base::radians(numbers.within(0, 89)), longitude = numbers.within(0, base::kPi);
        const glm::dmat3 body = earth::body_axes(latitude, longitude, numbers.within(0, base::kPi),
                                                 base::radians(numbers.within(-10, 20)), base::radians(numbers.within(0, 30)));
        terrain::View view;
        view.eye = earth::to_ecef({latitude, longitude, {numbers.between(0, 12'000)}});
        view.forward = body[0];
        view.right = body[1];
        view.down = body[2];
        view.width = kViewWidth_px;
        view.height = kViewHeight_px;
        view.focal_px = 0.5 * kViewWidth_px / std::tan(base::radians(0.5 * kViewWidth_deg));
        return view;
    }
    [[nodiscard]] PlacedVertex made_vertex(SeededRandom& numbers) const {
        const double away_m = kNearestVertex_m * std::pow(kFarthestVertex_m / kNearestVertex_m, numbers.unit());
        const double most_m = std::clamp(0.5 * away_m, kMaxNearReach_m, kMaxReach_m);
        const double reach_m = kMinReach_m * std::pow(most_m / kMinReach_m, numbers.unit());
        const double quantum_m = std::fmax(kQuantum_m, std::exp2(std::ceil(std::log2(reach_m / kFloats))));
        const glm::dvec3 ray = view_.forward + numbers.within(0, view_.half_width_tangent()) * view_.right +
                               numbers.within(0, view_.half_height_tangent()) * view_.down;
        PlacedVertex vertex;
        vertex.place = view_.eye + away_m * ray;
        const glm::dvec3 reach(numbers.within(0, reach_m), numbers.within(0, reach_m), numbers.within(0, reach_m));
        const glm::dvec3 centre = glm::round(vertex.place + reach);
        vertex.position = glm::vec3(glm::round((vertex.place - centre) / quantum_m) * quantum_m);
        vertex.offset = glm::vec3(centre - glm::round(view_.eye));
        vertex.ecef = glm::vec3(vertex.place);
        vertex.high = high_part(vertex.place);
        vertex.low = low_part(vertex.place);
        return vertex;
    }
    [[nodiscard]] glm::dvec3 eye_fraction() const { return view_.eye - glm::round(view_.eye); }
    [[nodiscard]] FloatMatrix matrix(const glm::dvec3& eye) const {
        return FloatMatrix(draw::view_projection(view_, {view_.near_m, view_.far_m}, eye));
    }
    [[nodiscard]] FloatMatrix ecef() const { return matrix(view_.eye); }
    [[nodiscard]] static ScreenPlace floats(const FloatMatrix& matrix, const glm::vec3& place) {
        const float depth = matrix.row(3, place);
        const float x = 0.5f * kViewWidth_px * (matrix.row(0, place) / depth);
        const float y = -0.5f * kViewHeight_px * (matrix.row(1, place) / depth);
        return {static_cast<double>(x), static_cast<double>(y)};
    }

    terrain::View view_;
    FloatMatrix of_eye_, of_ecef_, from_eye_ = matrix(glm::dvec3(0));
    glm::vec3 eye_high_{0}, eye_low_{0};
    std::vector<PlacedVertex> vertices_;
};

class VertexPrecisionKnob final : public Knob {
public:
    explicit VertexPrecisionKnob(const KnobGround& ground) : Knob(vertex_precision_facts()) {
        SeededRandom numbers(7);
        for (std::size_t n = 0; n < (ground.is_quick ? kQuickVertexViews : kVertexViews); ++n) views_.emplace_back(numbers);
    }

    [[nodiscard]] std::size_t samples() const override { return views_.size(); }
    void run(std::size_t level, std::size_t sample) override {
        for (std::size_t n = 0; n < kVerticesOfView; ++n) {
            const ScreenPlace place = views_[sample].on_screen(level, n);
            seen_ += place.x_px + place.y_px;
        }
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        for (std::size_t n = 0; n < kVerticesOfView; ++n) errors.push_back(views_[sample].pixels_off(level, n));
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        char text[60];
        std::snprintf(text, sizeof text, "view %zu, a vertex %.1f m away", sample, views_[sample].distance_m(error));
        return text;
    }

private:
    std::vector<VertexView> views_;
    double seen_ = 0;  ///< so that no compiler leaves the places out
};

}  // namespace

std::unique_ptr<Knob> make_vertex_precision_knob(const KnobGround& ground) {
    return std::make_unique<VertexPrecisionKnob>(ground);
}

}  // namespace tedavis::host_sim
