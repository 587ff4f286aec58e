#include "host_sim/accuracy/knobs/tube_knobs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/draw/data/tube_path.hpp"
#include "render_core/scene/tube_mesh.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint32_t kTubeSides[] = {3, 4, 6, 8, 12, 16, 24};
constexpr double kTubeDetails[] = {0, 0.25, 0.5, 0.75, 1};
constexpr double kTubeRadius_m = draw::kDefaultTubeRadius_m;
constexpr std::uint32_t kFlownPoints = draw::kTubeWindow;
constexpr std::uint32_t kCurveParts = 4;  // of the way between two points, where a curve is compared with its tube
constexpr std::size_t kFlownCurves = 24, kQuickFlownCurves = 4;
constexpr double kFlownStep_m = 60;
constexpr const char* kTubesNeverTrade = "Widened hulls keep the radius of the stated accuracy at every level.";

/// A flight whose turn and climb change like waves, by a formula; metres in a local frame. Its speed over the ground is not
/// constant, which no figure here needs.
class FlownCurve {
public:
    explicit FlownCurve(SeededRandom& numbers) {
        for (Wave& wave : waves_)
            wave = {numbers.between(2000, 6000), numbers.between(1500, 5000), numbers.between(0, 6.28),
                    numbers.between(100, 400)};
    }
    /// After `way_m` along the axis x.
    [[nodiscard]] glm::dvec3 at(double way_m) const {
        glm::dvec3 place(way_m, 0, 0);
        for (const Wave& wave : waves_) {
            const double angle = way_m / wave.length_m + wave.phase;
            place += glm::dvec3(0, wave.aside_m * std::sin(angle), wave.up_m * std::cos(angle));
        }
        return place;
    }
    [[nodiscard]] glm::dvec3 point(double number) const { return at(number * kFlownStep_m); }

private:
    struct Wave {
        double length_m, aside_m, phase, up_m;
    };
    Wave waves_[2]{};
};

std::vector<scene::TubePoint> recorded_points(const FlownCurve& curve) {
    std::vector<scene::TubePoint> points;
    for (std::uint32_t n = 0; n < kFlownPoints; ++n)
        points.push_back({curve.point(n), base::Time{} + base::Duration::seconds(n), static_cast<float>(kTubeRadius_m)});
    return points;
}

/// Rings and triangles of a tube, with room for all.
class MadeTube {
public:
    MadeTube()
        : rings_(2 * kFlownPoints),
          vertices_(2 * scene::kMaxTubeSides * (kFlownPoints + 2)),
          indices_(6 * scene::kMaxTubeSides * (kFlownPoints + 2)) {}

    void make_rings(const std::vector<scene::TubePoint>& points) {
        ring_count_ = scene::make_tube({points.data(), points.size()}, {0, 0, 1}, {rings_.data(), rings_.size()}).rings;
    }
    void make_triangles(std::uint32_t sides) {
        scene::TubeChunk chunk;
        vertex_count_ = scene::mesh_tube(rings(), sides, rings_.front().centre,
                                         {{vertices_.data(), vertices_.size()}, {indices_.data(), indices_.size()}, {&chunk, 1}})
                            .vertices;
    }
    [[nodiscard]] base::Span<const scene::TubeRing> rings() const { return {rings_.data(), ring_count_}; }
    [[nodiscard]] base::Span<const scene::TubeVertex> vertices() const { return {vertices_.data(), vertex_count_}; }

private:
    std::vector<scene::TubeRing> rings_;
    std::vector<scene::TubeVertex> vertices_;
    std::vector<std::uint16_t> indices_;
    std::uint32_t ring_count_ = 0, vertex_count_ = 0;
};

std::vector<KnobLevel> levels_of_tube_sides() {
    std::vector<KnobLevel> levels;
    for (const std::uint32_t sides : kTubeSides) levels.push_back({std::to_string(sides) + " sides", static_cast<double>(sides)});
    return levels;
}

KnobFacts tube_sides_facts() {
    return {"tube_sides",
            "Sides of a trajectory's tube",
            "scene::mesh_tube(); the display draws tubes with 6 sides (kDefaultTubeSides), hulls of accuracy with 12",
            "distance of the middle of a side from the round tube of 40 m radius",
            "m",
            {"a circle of the tube's radius round the ring's centre", 0.01,
             "it is exact; corners are floats from the first ring's centre, which is at most 40 km away, where a float has 4 mm"},
            "the closed form radius (1 - cos(pi / sides)) (tests/host_sim/accuracy)",
            kTubesNeverTrade,
            "sides",
            ExpectedLaw{-2, 0.1, "NUMERICS K17: chord sag; radius (1 - cos(pi / sides)) ~ sides^-2"},
            levels_of_tube_sides()};
}

class TubeSidesKnob final : public Knob {
public:
    explicit TubeSidesKnob(const KnobGround& ground) : Knob(tube_sides_facts()) {
        SeededRandom numbers(13);
        const std::size_t count = ground.is_quick ? kQuickFlownCurves : kFlownCurves;
        for (std::size_t n = 0; n < count; ++n) tubes_.emplace_back().make_rings(recorded_points(FlownCurve(numbers)));
    }

    [[nodiscard]] std::size_t samples() const override { return tubes_.size(); }
    void run(std::size_t level, std::size_t sample) override { tubes_[sample].make_triangles(kTubeSides[level]); }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        MadeTube& tube = tubes_[sample];
        tube.make_triangles(kTubeSides[level]);
        const glm::dvec3 origin = tube.rings()[0].centre;
        for (std::size_t n = 0; n + 1 < tube.vertices().size(); ++n) {
            const scene::TubeVertex &corner = tube.vertices()[n], &next = tube.vertices()[n + 1];
            if (corner.side == scene::kTubeEndSide || corner.side != next.side || corner.source != next.source) continue;
            const glm::dvec3 middle = origin + 0.5 * (glm::dvec3(corner.position) + glm::dvec3(next.position));
            errors.push_back(std::abs(kTubeRadius_m - glm::length(middle - tube.rings()[corner.source].centre)));
        }
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        return "tube " + std::to_string(sample) + ", side " + std::to_string(error) + " of all rings";
    }

private:
    std::vector<MadeTube> tubes_;
};

/// As draw::TubePath has them.
double tube_tolerance_m(std::size_t level) { return kTubeRadius_m * std::pow(10.0, 1 - 2 * kTubeDetails[level]); }

/// Points of a flight, and those that a level keeps.
class ThinnedTube {
public:
    explicit ThinnedTube(const FlownCurve& curve)
        : curve_(curve), points_(recorded_points(curve)), weights_(kFlownPoints), waiting_(kFlownPoints) {
        for (const scene::TubePoint& point : points_) {
            constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
            vertices_.push_back({point.position, {kNone, kNone, kNone}});
        }
    }

    const std::vector<std::uint32_t>& keep(double tolerance_m) {
        draw::weigh_vertices({vertices_.data(), vertices_.size()}, {weights_.data(), weights_.size()},
                             {waiting_.data(), waiting_.size()});
        kept_.clear();
        for (std::uint32_t n = 0; n < kFlownPoints; ++n)
            if (static_cast<double>(weights_[n]) > tolerance_m) kept_.push_back(n);
        return kept_;
    }
    void make_tube(double tolerance_m, MadeTube& tube) {
        kept_points_.clear();
        for (const std::uint32_t number : keep(tolerance_m)) kept_points_.push_back(points_[number]);
        tube.make_rings(kept_points_);
        tube.make_triangles(scene::kDefaultTubeSides);
    }
    /// Distances of the curve from the middle of the tube.
    void add_distances(double tolerance_m, std::vector<double>& distances) {
        keep(tolerance_m);
        for (std::size_t n = 0; n + 1 < kept_.size(); ++n)
            for (std::uint32_t part = kCurveParts * kept_[n]; part < kCurveParts * kept_[n + 1]; ++part) {
                const draw::PolylineVertex on_curve = {curve_.point(part / double{kCurveParts}), vertices_[0].values};
                distances.push_back(draw::distance_from_segment(on_curve, vertices_[kept_[n]], vertices_[kept_[n + 1]]));
            }
    }

private:
    FlownCurve curve_;
    std::vector<scene::TubePoint> points_, kept_points_;
    std::vector<draw::PolylineVertex> vertices_;
    std::vector<float> weights_;
    std::vector<draw::PolylineStretch> waiting_;
    std::vector<std::uint32_t> kept_;
};

std::vector<ThinnedTube> thinned_tubes(bool is_quick) {
    SeededRandom numbers(14);
    std::vector<ThinnedTube> tubes;
    for (std::size_t n = 0; n < (is_quick ? kQuickFlownCurves : kFlownCurves); ++n) tubes.emplace_back(FlownCurve(numbers));
    return tubes;
}

/// The amount of a level is what it keeps, which is found by doing it.
KnobFacts tube_points_facts(std::vector<ThinnedTube>& tubes) {
    std::vector<KnobLevel> levels;
    for (std::size_t level = 0; level < std::size(kTubeDetails); ++level) {
        std::size_t kept = 0;
        for (ThinnedTube& tube : tubes) kept += tube.keep(tube_tolerance_m(level)).size();
        char name[40];
        std::snprintf(name, sizeof name, "detail %.2f", kTubeDetails[level]);
        levels.push_back({name, static_cast<double>(kept) / static_cast<double>(tubes.size())});
    }
    return {"tube_points",
            "Points along a trajectory's tube",
            "`detail` of a data element with technique `tube`: points within 400 m (0) to 4 m (1) of a tube of 40 m radius are "
            "left out",
            "distance of the flown curve from the middle of the tube",
            "m",
            {"the formula of the flown curve, at four places between two recorded points", 0.02,
             "the curve itself is exact; its greatest distance may lie between two of the places, 15 m apart"},
            "the tolerance, which no error may exceed by more than the sag between recorded points (tests/host_sim/accuracy)",
            kTubesNeverTrade,
            "points kept of 512",
            ExpectedLaw{-2, 0.3, "NUMERICS K17: the sag of a chord goes with the square of its length"},
            std::move(levels)};
}

class TubePointsKnob final : public Knob {
public:
    explicit TubePointsKnob(std::vector<ThinnedTube> tubes) : Knob(tube_points_facts(tubes)), tubes_(std::move(tubes)) {}

    [[nodiscard]] std::size_t samples() const override { return tubes_.size(); }
    void run(std::size_t level, std::size_t sample) override { tubes_[sample].make_tube(tube_tolerance_m(level), tube_); }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        tubes_[sample].add_distances(tube_tolerance_m(level), errors);
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        char text[80];
        std::snprintf(text, sizeof text, "flight %zu, %.0f m along it", sample,
                      static_cast<double>(error) * kFlownStep_m / kCurveParts);
        return text;
    }

private:
    std::vector<ThinnedTube> tubes_;
    MadeTube tube_;
};

}  // namespace

std::unique_ptr<Knob> make_tube_sides_knob(const KnobGround& ground) { return std::make_unique<TubeSidesKnob>(ground); }
std::unique_ptr<Knob> make_tube_points_knob(const KnobGround& ground) {
    return std::make_unique<TubePointsKnob>(thinned_tubes(ground.is_quick));
}

}  // namespace tedavis::host_sim
