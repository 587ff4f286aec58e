#include "render_core/effects/quality_level.hpp"

#include <cmath>

#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::effects {
namespace {

// Triangles fall with a power of the error: measured over six views of two databases, from an error of 1 to 4 pixels, 0.1 (no
// finer data) to 1.
constexpr double kFinerPower = 1, kCoarserPower = 0.3;

/// Glyphs on a screen: by the square of the spacing that scene::GlyphSettings::detail says.
double glyph_share(double detail) { return std::pow(scene::kCoarsestGlyphs, -2 * (1 - detail)); }

}  // namespace

EffectSet given_up_on(std::size_t quality_level) noexcept {
    EffectSet effects;
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        const EffectRow& row = row_of(static_cast<Effect>(n));
        if (row.given_up_from <= quality_level) effects.add(row.effect);
    }
    return effects;
}

double tau_px_on(std::size_t quality_level, double design_px, double coarse_px) noexcept {
    return std::fmax(design_px, std::fmin(design_px * kQualityLevels[quality_level].tau_factor, coarse_px));
}

FrameCounters counters_at(const FrameCounters& counters, const Quality& from, const Quality& to) noexcept {
    FrameCounters at = counters;
    const double ratio = from.tau_px / to.tau_px;
    at.triangles *= std::pow(ratio, ratio > 1 ? kFinerPower : kCoarserPower);
    at.glyphs *= glyph_share(to.detail) / glyph_share(from.detail);
    return at;
}

}  // namespace tedavis::effects
