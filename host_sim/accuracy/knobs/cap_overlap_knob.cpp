#include "host_sim/accuracy/knobs/cap_overlap_knob.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/accuracy/knobs/traced_square.hpp"
#include "host_sim/scenario/seeded_random.hpp"
#include "render_core/base/units.hpp"
#include "render_core/raytrace/shading/aperture_light.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kCapPairs = 4096, kCapSamples = 32, kQuickCapSamples = 8;
constexpr double kMinAperture_rad = 0.05, kMaxAperture_rad = 1.55;
constexpr double kEdgeShare = 1e-3;  // pairs nearer to touching or containing each other are trivial
constexpr std::size_t kExactLevel = 1;

KnobFacts cap_overlap_facts() {
    return {"cap_overlap",
            "Overlap of sun and sky aperture",
            "raytrace::OverlapKind of aperture_light(); pictures with `ambient = apertures` use the smoothstep",
            "difference of the visible part of the sun",
            "share of the sun",
            {"the area of both circular segments with three arc cosines in long double", 1e-9,
             "a test integrates the ring segments of the sun numerically and finds the same within this bound"},
            "numeric integration over rings of the sun (tests/host_sim/accuracy); random points (tests/render_core/raytrace)",
            "Cast shadows are rays at every level; only the light through apertures changes.",
            "no scale: two forms of the same area",
            std::nullopt,
            {{"smoothstep", 0}, {"exact", 0}}};
}

/// The sun and an aperture whose circles cross.
struct CrossingCaps {
    double aperture_rad, distance_rad;
};

class CapOverlapKnob final : public Knob {
public:
    explicit CapOverlapKnob(const KnobGround& ground) : Knob(cap_overlap_facts()) {
        SeededRandom numbers(11);
        const std::size_t count = kCapPairs * (ground.is_quick ? kQuickCapSamples : kCapSamples);
        for (std::size_t n = 0; n < count; ++n) {
            const double aperture_rad = numbers.between(kMinAperture_rad, kMaxAperture_rad);
            const double from = aperture_rad - raytrace::kSunRadius_rad, width = 2 * raytrace::kSunRadius_rad;
            pairs_.push_back({aperture_rad, from + width * numbers.between(kEdgeShare, 1 - kEdgeShare)});
        }
    }

    [[nodiscard]] std::size_t samples() const override { return pairs_.size() / kCapPairs; }
    void run(std::size_t level, std::size_t sample) override {
        for (std::size_t n = 0; n < kCapPairs; ++n) seen_ += overlap(level, pairs_[sample * kCapPairs + n]);
    }
    void find_errors(std::size_t level, std::size_t sample, std::vector<double>& errors) override {
        const double sun = raytrace::cap_area(raytrace::kSunRadius_rad);
        for (std::size_t n = 0; n < kCapPairs; ++n) {
            const CrossingCaps& caps = pairs_[sample * kCapPairs + n];
            const double exact = overlap_by_arc_cosines(caps.aperture_rad, raytrace::kSunRadius_rad, caps.distance_rad);
            errors.push_back(std::abs(overlap(level, caps) - exact) / sun);
        }
    }
    [[nodiscard]] std::string place_of(std::size_t sample, std::size_t error) const override {
        const CrossingCaps& caps = pairs_[sample * kCapPairs + error];
        char text[100];
        std::snprintf(text, sizeof text, "an aperture of %.3f degrees, the sun %.4f degrees from its axis",
                      base::degrees(caps.aperture_rad), base::degrees(caps.distance_rad));
        return text;
    }

private:
    [[nodiscard]] static double overlap(std::size_t level, const CrossingCaps& caps) {
        return level == kExactLevel
                   ? raytrace::cap_overlap(caps.aperture_rad, raytrace::kSunRadius_rad, caps.distance_rad)
                   : raytrace::smooth_cap_overlap(caps.aperture_rad, raytrace::kSunRadius_rad, caps.distance_rad);
    }

    std::vector<CrossingCaps> pairs_;
    double seen_ = 0;  ///< so that no compiler leaves the overlaps out
};

}  // namespace

double overlap_by_arc_cosines(double radius_a_rad, double radius_b_rad, double distance_rad) {
    constexpr long double kHalfTurn = 3.14159265358979323846264338327950288L;
    const long double a = radius_a_rad, b = radius_b_rad, d = distance_rad;
    const long double cos_a = std::cos(a), cos_b = std::cos(b), cos_d = std::cos(d);
    const long double sin_a = std::sin(a), sin_b = std::sin(b), sin_d = std::sin(d);
    const auto angle = [](long double cosine) { return std::acos(std::clamp(cosine, -1.0L, 1.0L)); };
    return static_cast<double>(2 * (kHalfTurn - angle((cos_d - cos_a * cos_b) / (sin_a * sin_b)) -
                                    cos_a * angle((cos_b - cos_a * cos_d) / (sin_a * sin_d)) -
                                    cos_b * angle((cos_a - cos_b * cos_d) / (sin_b * sin_d))));
}

std::unique_ptr<Knob> make_cap_overlap_knob(const KnobGround& ground) { return std::make_unique<CapOverlapKnob>(ground); }

}  // namespace tedavis::host_sim
