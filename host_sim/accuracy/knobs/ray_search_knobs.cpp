#include "host_sim/accuracy/knobs/ray_search_knobs.hpp"

#include <cmath>
#include <iterator>

#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/raytrace/search/search_surface.hpp"

namespace tedavis::host_sim {
namespace {

using raytrace::HitSide;
using raytrace::SurfaceHit;

const std::vector<std::uint32_t> kSteps = {64, 128, 256, 512, 1024, 2048, 4096};
const std::vector<std::uint32_t> kControlSteps = {16, 4096};
constexpr std::uint32_t kHalvings[] = {0, 3, 6, 9, 12, 15};
constexpr std::uint32_t kEnoughHalvings = 20, kStepsOfCell = 8;
constexpr std::size_t kRaysOfSample = 64, kSamples = 64, kQuickSamples = 8;
constexpr double kSameHit_cells = 1;
constexpr double kBound_cells = 1e-7;

KnobReference exact_crossing() {
    return {"the exact crossing of the ray with the bilinear surface, by the maximum mipmap", kBound_cells,
            "it is computed in doubles, not searched; a test finds the ray on both sides of the surface within this distance"};
}

constexpr const char* kOracle = "Embree 3.13 over the same heights (tests/render_core/raytrace)";
constexpr const char* kNeverTrades = "Terrain alerts and heights below the aircraft come from exact queries at every level.";

std::vector<KnobLevel> levels_of(const std::vector<std::uint32_t>& all_steps) {
    std::vector<KnobLevel> levels;
    for (const std::uint32_t steps : all_steps) levels.push_back({std::to_string(steps) + " steps", static_cast<double>(steps)});
    return levels;
}

std::vector<KnobLevel> levels_of_halvings() {
    std::vector<KnobLevel> levels;
    for (const std::uint32_t halvings : kHalvings)
        levels.push_back({std::to_string(halvings) + " halvings", std::ldexp(1.0, static_cast<int>(halvings))});
    return levels;
}

/// Rays over the bilinear surface of the ground, with their exact hits.
class RaySearchKnob : public Knob {
public:
    RaySearchKnob(KnobFacts facts, const KnobGround& ground)
        : Knob(std::move(facts)),
          square_(ground.ground),
          surface_(square_, {}),
          rays_(rays_over(square_, kRaysOfSample * (ground.is_quick ? kQuickSamples : kSamples), 1)) {
        for (const raytrace::Ray& ray : rays_) exact_.push_back(trace_surface(surface_.maxima(), surface_.settings(), ray));
    }

    [[nodiscard]] std::size_t samples() const override { return rays_.size() / kRaysOfSample; }
    void run(std::size_t level, std::size_t sample) override {
        for (std::size_t n = 0; n < kRaysOfSample; ++n) found_ += found(level, ray(sample, n)).t;
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        return ray_text(ray(sample, error));
    }

protected:
    [[nodiscard]] virtual SurfaceHit found(std::size_t level, const raytrace::Ray& ray) const = 0;
    [[nodiscard]] const raytrace::Ray& ray(std::size_t sample, std::size_t n) const { return rays_[sample * kRaysOfSample + n]; }
    [[nodiscard]] const SurfaceHit& exact(std::size_t sample, std::size_t n) const { return exact_[sample * kRaysOfSample + n]; }
    [[nodiscard]] const TracedSquare& square() const { return square_; }
    [[nodiscard]] const BoundedSurface& surface() const { return surface_; }
    [[nodiscard]] double cells_off(std::size_t level, const raytrace::Ray& ray, const SurfaceHit& exact) const {
        return std::abs(cells_along(ray, found(level, ray)) - cells_along(ray, exact));
    }
    /// Leaves out the rays whose hit a level passes over, and those that then make no whole sample.
    void keep_rays_found_by(std::size_t level) {
        std::size_t kept = 0;
        for (std::size_t n = 0; n < rays_.size(); ++n) {
            if (!(cells_off(level, rays_[n], exact_[n]) < kSameHit_cells)) continue;
            rays_[kept] = rays_[n];
            exact_[kept++] = exact_[n];
        }
        kept -= kept % kRaysOfSample;
        if (kept == 0) throw UserError("too few rays meet the terrain; name another --terrain");
        rays_.resize(kept);
        exact_.resize(kept);
    }

private:
    /// How far along the ray, in cells of its way over the ground; who meets nothing is at the end of the square.
    [[nodiscard]] double cells_along(const raytrace::Ray& ray, const SurfaceHit& hit) const {
        const double t = hit.side == HitSide::none ? end_over(square_, ray) : hit.t;
        return t * std::hypot(double{ray.direction.x}, double{ray.direction.y});
    }

    TracedSquare square_;
    BoundedSurface surface_;
    std::vector<raytrace::Ray> rays_;
    std::vector<SurfaceHit> exact_;
    double found_ = 0;  ///< so that no compiler leaves the search out
};

class RaySteps final : public RaySearchKnob {
public:
    RaySteps(const KnobGround& ground, const std::vector<std::uint32_t>& steps)
        : RaySearchKnob(
              {"ray_steps", "Uniform steps of a ray over the terrain", "raytrace::UniformSearch::steps of search_ray()",
               "distance along the ray from the exact hit", "cells of the grid", exact_crossing(), kOracle, kNeverTrades,
               "steps of a ray", ExpectedLaw{-1, 0.4, "NUMERICS A23: wrong rays ~ step^0.8 to step^1.05"}, levels_of(steps)},
              ground),
          steps_(steps) {}

    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        for (std::size_t n = 0; n < kRaysOfSample; ++n) errors.push_back(cells_off(level, ray(sample, n), exact(sample, n)));
    }

private:
    [[nodiscard]] SurfaceHit found(std::size_t level, const raytrace::Ray& ray) const override {
        return search_ray(square().grid(), surface().settings(), ray, {steps_[level], kEnoughHalvings});
    }

    std::vector<std::uint32_t> steps_;
};

class RayHalvings final : public RaySearchKnob {
public:
    explicit RayHalvings(const KnobGround& ground)
        : RaySearchKnob({"ray_halvings", "Halvings of the step in which a ray meets the terrain",
                         "raytrace::UniformSearch::halvings of search_cells(), 8 steps in a cell",
                         "distance along the ray from the exact hit, of rays that find it within a cell", "cells of the grid",
                         exact_crossing(), kOracle, kNeverTrades, "parts of a step, 2^halvings",
                         ExpectedLaw{-1, 0.1, "bisection; NUMERICS K5: step * 2^-k"}, levels_of_halvings()},
                        ground) {
        keep_rays_found_by(std::size(kHalvings) - 1);
    }

    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        for (std::size_t n = 0; n < kRaysOfSample; ++n) errors.push_back(cells_off(level, ray(sample, n), exact(sample, n)));
    }

private:
    [[nodiscard]] SurfaceHit found(std::size_t level, const raytrace::Ray& ray) const override {
        return search_cells(surface().maxima(), surface().settings(), ray, {kStepsOfCell, kHalvings[level]});
    }
};

}  // namespace

std::unique_ptr<Knob> make_ray_steps_knob(const KnobGround& ground) { return std::make_unique<RaySteps>(ground, kSteps); }
std::unique_ptr<Knob> make_ray_control(const KnobGround& ground) { return std::make_unique<RaySteps>(ground, kControlSteps); }
std::unique_ptr<Knob> make_ray_halvings_knob(const KnobGround& ground) { return std::make_unique<RayHalvings>(ground); }

}  // namespace tedavis::host_sim
