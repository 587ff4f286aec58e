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

bool may_be_given_up(const EffectSet& effects) {
    for (std::size_t n = 0; n < kEffectCount; ++n)
        if (effects.has(static_cast<Effect>(n)) && !row_of(static_cast<Effect>(n)).may_be_given_up) return false;
    return true;
}

}  // namespace

bool dominates(const QualityLevel& level, const QualityLevel& other) noexcept {
    const bool is_no_worse = level.ms <= other.ms && level.error_px <= other.error_px && level.error_color <= other.error_color;
    const bool is_better = level.ms < other.ms || level.error_px < other.error_px || level.error_color < other.error_color;
    return is_no_worse && is_better;
}

std::string_view fault_of(const QualityLevels& levels, std::size_t n) noexcept {
    const QualityLevel& level = levels.at[n];
    if (!may_be_given_up(level.given_up)) return "this level gives up an effect that may not be traded for time";
    const bool is_whole = level.tau_factor == 1 && level.detail_factor == 1 && level.given_up.is_empty();
    if (n == 0 && !(is_whole && level.error_color == 0))
        return "the first quality level must be the design's own picture: both factors 1, nothing given up, error_color 0";
    if (n == 0) return {};
    const QualityLevel& before = levels.at[n - 1];
    if (level.tau_factor < before.tau_factor || level.detail_factor > before.detail_factor ||
        !level.given_up.has_all(before.given_up))
        return "a quality level must keep no more than the one before it";
    for (std::size_t k = 0; k < n; ++k)
        if (dominates(levels.at[k], level) || dominates(level, levels.at[k]))
            return "of two quality levels one is at least as accurate and at least as quick as the other, which must be left out";
    return level.ms < before.ms ? std::string_view() : "a quality level must take less time than the one before it";
}

double tau_px_on(const QualityLevel& level, double design_px, double coarse_px) noexcept {
    return std::fmax(design_px, std::fmin(design_px * level.tau_factor, coarse_px));
}

FrameCounters counters_at(const FrameCounters& counters, const Quality& from, const Quality& to) noexcept {
    FrameCounters at = counters;
    const double ratio = from.tau_px / to.tau_px;
    at.triangles *= std::pow(ratio, ratio > 1 ? kFinerPower : kCoarserPower);
    at.glyphs *= glyph_share(to.detail) / glyph_share(from.detail);
    return at;
}

}  // namespace tedavis::effects
