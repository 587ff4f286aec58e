#include "render_core/effects/quality_ladder.hpp"

#include <cmath>

#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::effects {
namespace {

/// What embellishes goes first, what tells forms apart last. Haze stays: it is cheap, and the terrain's errors are judged by what
/// it hides.
struct GivenUp {
    Effect effect;
    std::uint8_t from;
};
constexpr GivenUp kGivenUp[] = {{Effect::depth_of_field, 1}, {Effect::focus_blur, 1},   {Effect::volumetric_light, 1},
                                {Effect::saliency, 1},       {Effect::antialiasing, 2}, {Effect::soft_shadows, 2},
                                {Effect::silhouettes, 4}};

// Triangles fall with a power of the error: measured over six views of two databases, from an error of 1 to 4 pixels, 0.1 (no
// finer data) to 1.
constexpr double kFinerPower = 1, kCoarserPower = 0.3;

/// Glyphs on a screen: by the square of the spacing that scene::GlyphSettings::detail says.
double glyph_share(double detail) { return std::pow(scene::kCoarsestGlyphs, -2 * (1 - detail)); }

}  // namespace

std::uint8_t given_up_from(Effect effect) noexcept {
    for (const GivenUp& entry : kGivenUp)
        if (entry.effect == effect) return entry.from;
    return kNever;
}

EffectSet given_up_on(std::size_t rung) noexcept {
    EffectSet effects;
    for (const GivenUp& entry : kGivenUp)
        if (entry.from <= rung) effects.add(entry.effect);
    return effects;
}

double tau_px_on(std::size_t rung, double design_px, double coarse_px) noexcept {
    return std::fmax(design_px, std::fmin(design_px * kLadder[rung].tau_factor, coarse_px));
}

FrameCounters counters_at(const FrameCounters& counters, const Quality& from, const Quality& to) noexcept {
    FrameCounters at = counters;
    const double ratio = from.tau_px / to.tau_px;
    at.triangles *= std::pow(ratio, ratio > 1 ? kFinerPower : kCoarserPower);
    at.glyphs *= glyph_share(to.detail) / glyph_share(from.detail);
    return at;
}

}  // namespace tedavis::effects
