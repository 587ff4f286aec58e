#include "host_sim/accuracy/knobs/isosurface_knob.hpp"

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>

#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/scene/isosurface.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint32_t kPostSteps[] = {8, 4, 2, 1};
constexpr const char* kPostStepNames[] = {"every 8th post", "every 4th post", "every 2nd post", "every post"};
constexpr std::uint32_t kPostsAlong = 65;
constexpr double kPostSpacing_m = 300;
constexpr std::size_t kRingFields = 6, kQuickRingFields = 1;
constexpr std::size_t kSurfaceRoom = 1 << 17;

KnobFacts isosurface_step_facts() {
    std::vector<KnobLevel> levels;
    for (std::size_t n = 0; n < std::size(kPostSteps); ++n)
        levels.push_back({kPostStepNames[n], static_cast<double>(kPostSteps[n])});
    return {
        "isosurface_step",
        "Posts of a field that its isosurface is made of",
        "draw::IsosurfaceSolids: the smallest step whose posts and triangles find room, 1 to 64; here of 65 posts 300 m apart",
        "distance of the surface's vertices and of its triangles' middles from the ring that the field describes",
        "m",
        {"the distance from a torus by its formula", 0.02,
         "values are floats of up to 20 km (1 mm) and vertices floats of grid coordinates (2 mm)"},
        "volume and area of a ball (tests/render_core/scene)",
        "Terrain alerts and warned-of areas are not drawn from isosurfaces.",
        "posts between two that are used",
        ExpectedLaw{2, 0.3, "NUMERICS K15: step^2"},
        std::move(levels)};
}

/// A torus by the distance from it, in grid coordinates of all posts; tilted, so that no axis is preferred.
struct RingField {
    glm::dvec3 middle, axis;
    double radius, thickness;

    explicit RingField(SeededRandom& numbers) {
        const double half = (kPostsAlong - 1) / 2.0;
        middle = glm::dvec3(half) + glm::dvec3(numbers.between(-1, 1), numbers.between(-1, 1), numbers.between(-1, 1));
        axis = glm::normalize(glm::dvec3(numbers.between(-1, 1), numbers.between(-1, 1), numbers.between(0.3, 1)));
        radius = numbers.between(15, 17);
        thickness = numbers.between(9, 11);
    }
    /// Above 0 within the ring.
    [[nodiscard]] double depth(const glm::dvec3& place) const {
        const glm::dvec3 from = place - middle;
        const double up = glm::dot(from, axis), along = glm::length(from - up * axis) - radius;
        return thickness - std::sqrt(along * along + up * up);
    }
};

/// A field at every step's posts.
class SampledField {
public:
    explicit SampledField(const RingField& ring) : ring_(ring) {
        for (const std::uint32_t step : kPostSteps) {
            std::vector<float>& values = values_.emplace_back();
            for (std::uint32_t z = 0; z < kPostsAlong; z += step)
                for (std::uint32_t y = 0; y < kPostsAlong; y += step)
                    for (std::uint32_t x = 0; x < kPostsAlong; x += step)
                        values.push_back(static_cast<float>(ring.depth({x, y, z}) * kPostSpacing_m));
        }
    }
    [[nodiscard]] scene::VolumeView view(std::size_t level) const {
        const std::uint32_t along = (kPostsAlong - 1) / kPostSteps[level] + 1;
        return {{values_[level].data(), values_[level].size()}, along, along, along};
    }
    [[nodiscard]] double distance_m(const glm::dvec3& place) const { return std::abs(ring_.depth(place)) * kPostSpacing_m; }

private:
    RingField ring_;
    std::vector<std::vector<float>> values_;  ///< by level
};

class IsosurfaceStepKnob final : public Knob {
public:
    explicit IsosurfaceStepKnob(const KnobGround& ground)
        : Knob(isosurface_step_facts()),
          memory_(scene::IsosurfaceBuilder::bytes_needed(kPostsAlong, kPostsAlong)),
          vertices_(kSurfaceRoom),
          indices_(6 * kSurfaceRoom) {
        base::Arena arena(memory_.data(), memory_.size());
        if (!builder_.start(arena, kPostsAlong, kPostsAlong)) throw UserError("no memory for an isosurface");
        SeededRandom numbers(15);
        for (std::size_t n = 0; n < (ground.is_quick ? kQuickRingFields : kRingFields); ++n)
            fields_.emplace_back(RingField(numbers));
    }

    [[nodiscard]] std::size_t samples() const override { return fields_.size(); }
    void run(std::size_t level, std::size_t sample) override {
        const scene::IsosurfaceOutput output = {{vertices_.data(), vertices_.size()}, {indices_.data(), indices_.size()}};
        const bool is_begun = builder_.begin(fields_[sample].view(level), 0, output) == scene::IsosurfaceError::none;
        if (!is_begun || builder_.step(std::numeric_limits<std::uint64_t>::max()) != scene::IsosurfaceProgress::done)
            throw UserError("the measured isosurface finds no room");
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        run(level, sample);
        const double step = kPostSteps[level];
        for (std::uint32_t n = 0; n < builder_.counts().vertices; ++n)
            errors.push_back(fields_[sample].distance_m(step * place(n)));
        for (std::uint32_t n = 0; n + 2 < builder_.counts().indices; n += 3) {
            const glm::dvec3 sum = place(indices_[n]) + place(indices_[n + 1]) + place(indices_[n + 2]);
            errors.push_back(fields_[sample].distance_m(step / 3 * sum));
        }
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        return "ring " + std::to_string(sample) + ", place " + std::to_string(error) + " of vertices and middles";
    }
    [[nodiscard]] std::uint64_t bytes(std::size_t level) const override {
        return fields_.front().view(level).values.size() * sizeof(float);
    }

private:
    [[nodiscard]] glm::dvec3 place(std::uint32_t vertex) const { return glm::dvec3(vertices_[vertex].position); }

    std::vector<unsigned char> memory_;
    scene::IsosurfaceBuilder builder_;
    std::vector<scene::IsosurfaceVertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<SampledField> fields_;
};

}  // namespace

std::unique_ptr<Knob> make_isosurface_step_knob(const KnobGround& ground) { return std::make_unique<IsosurfaceStepKnob>(ground); }

}  // namespace tedavis::host_sim
