#include "render_core/draw/symbology/tape_marks.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/draw/font_atlas.hpp"

namespace tedavis::draw {
namespace {

using policy::ElementShow;

constexpr double kFarthest_px = 1e5;  // far outside of every screen, and exact enough in a float
constexpr float kNotchReach = 0.4f;   // of a bug, up and down from its value, in texts
constexpr float kNotchInset = 0.1f;   // where the notch ends, from the edge
constexpr float kFlagHeight = 0.9f;
constexpr float kFlagInset = 0.15f;    // of its letters, from the edge outwards
constexpr float kBandRim = 2.0f;       // strokes; the line along the edge takes half a one
constexpr float kStripeHeight = 0.5f;  // of a pole
constexpr int kMaxStripes = 100;       // over the height of a screen

/// One half of a bug, from its value upwards (`way` -1) or downwards (1), as far as the scale goes.
class BugHalf {
public:
    BugHalf(const Painter& painter, const TapeScale& scale, float y, float way)
        : painter_(painter), scale_(scale), y_(y), way_(way), t_(painter.text_px()) {
        const float room = way < 0 ? y - scale.box.y : scale.box.bottom() - y;
        reach_ = std::min(kBugReach * t_, room);
        notch_ = std::min(kNotchReach * t_, reach_);
    }

    [[nodiscard]] bool empty() const { return !(reach_ > 0); }
    void fill(design::Color color) const {
        const Point at_edge = corner(0, 0), notch_end = corner(kNotchInset, 0), far_edge = corner(0, notch_),
                    shoulder = corner(shoulder_inset(), notch_);
        painter_.batch().triangle(at_edge, notch_end, shoulder, color);
        painter_.batch().triangle(at_edge, shoulder, far_edge, color);
        if (!(reach_ > notch_)) return;
        constexpr float kOverlap_px = 0.5f;  // the edge of a box fades out
        const Point a = corner(0, notch_ - kOverlap_px), b = corner(kBugWidth, reach_);
        painter_.batch().box({std::min(a.x, b.x), std::min(a.y, b.y), std::fabs(b.x - a.x), std::fabs(b.y - a.y)}, color);
    }
    /// Between the bug and what lies beside the scale.
    void edge(design::Color color) const {
        const Point a = corner(0, 0), b = corner(painter_.stroke_px() / t_, reach_);
        painter_.batch().box({std::min(a.x, b.x), std::min(a.y, b.y), std::fabs(b.x - a.x), std::fabs(b.y - a.y)}, color);
    }
    /// Hollow, with a dark rim; or the rim alone, around what is filled.
    void outline(design::Color color, float strokes) const {
        const Point corners[5] = {corner(kNotchInset, 0), corner(shoulder_inset(), notch_),
                                  corner(reach_ > notch_ ? kBugWidth : shoulder_inset(), reach_), corner(0, reach_),
                                  corner(0, 0)};
        painter_.batch().polyline(corners, strokes * painter_.stroke_px(), color);
    }

private:
    /// Within the box, however the sum is rounded: the batch leaves out triangles that reach beyond it.
    [[nodiscard]] Point corner(float inset, float along) const {
        const float x = scale_.x_of(inset, painter_), y = y_ + way_ * along;
        return {std::clamp(x, scale_.box.x, scale_.box.right()), std::clamp(y, scale_.box.y, scale_.box.bottom())};
    }
    [[nodiscard]] float shoulder_inset() const { return kNotchInset + (kBugWidth - kNotchInset) * notch_ / (kNotchReach * t_); }

    const Painter& painter_;
    const TapeScale& scale_;
    float y_, way_, t_;
    float reach_ = 0, notch_ = 0;
};

/// White stripes that move with the scale: every second one from the lower end of a band.
void build_stripes(const Painter& painter, const TapeScale& scale, const Rect& band) {
    const float height = kStripeHeight * painter.text_px();
    const float below_box = std::max(0.0f, band.bottom() - scale.box.bottom());
    const float first = std::floor(below_box / (2 * height));
    for (int i = 0; i < kMaxStripes; ++i) {
        const float bottom = band.bottom() - (2 * (first + static_cast<float>(i)) + 1) * height;
        if (bottom <= band.y) return;
        const float top = std::max(bottom - height, band.y);
        const Rect stripe{band.x, top, band.width, bottom - top};
        // Half of the rim lies within the stripe, so that red and white stay as high.
        const float rim = std::max(painter.stroke_px() / 2, 1.0f);
        painter.batch().box({stripe.x, stripe.y - rim, stripe.width, stripe.height + 2 * rim}, painter.color(SymbolRole::rim));
        painter.batch().box({stripe.x, stripe.y + rim, stripe.width, stripe.height - 2 * rim}, painter.color(SymbolRole::scale));
    }
}

}  // namespace

float TapeScale::y_of(double unit) const noexcept {
    const double down = limited((middle - unit) * px_per_unit, -kFarthest_px, kFarthest_px);
    return box.center().y + static_cast<float>(down);
}

void build_tape_bands(const Painter& painter, const TapeScale& scale, base::Span<const TapeBand> bands) {
    for (const TapeBand& band : bands) {
        if (!(band.high > band.low)) continue;
        const float width = (band.look == TapeBandLook::half ? 0.5f : 1.0f) * kBandWidth * painter.text_px();
        // A rim stands between the band and the line along the edge, and at the ends of the scale.
        const float rim = kBandRim * painter.stroke_px();
        const float x = scale.inwards > 0 ? scale.edge + rim : scale.edge - rim - width;
        const float top = std::max(scale.y_of(band.high), scale.box.y + rim),
                    bottom = std::min(scale.y_of(band.low), scale.box.bottom() - rim);
        if (!(bottom > top)) continue;
        const Rect box{x, top, width, bottom - top};
        // Half a band leaves the other half of the whole one to be seen.
        const float inner = band.look == TapeBandLook::half ? 1.0f : rim, outer = rim;
        const float left = scale.inwards > 0 ? outer : inner, right = scale.inwards > 0 ? inner : outer;
        painter.batch().box({box.x - left, box.y - rim, box.width + left + right, box.height + 2 * rim},
                            painter.color(SymbolRole::rim));
        painter.batch().box(box, band.color);
        if (band.look == TapeBandLook::pole) build_stripes(painter, scale, box);
    }
}

void build_tape_flags(const Painter& painter, const TapeScale& scale, base::Span<const TapeFlag> flags) {
    base::FixedVector<float, kMaxTapeFlags> taken;
    for (const TapeFlag& flag : flags) {
        if (!std::isfinite(flag.at) || flag.letters.empty()) continue;
        const float y = scale.y_of(flag.at), apart = kFlagHeight * painter.text_px();
        const bool is_covered =
            std::any_of(taken.begin(), taken.end(), [&](float other) { return std::fabs(other - y) < apart; });
        if (is_covered || !taken.try_push_back(y)) continue;
        painter.line({scale.edge, y}, {scale.x_of(-0.12f, painter), y}, flag.color);
        const float t = painter.text_px(), room = (kFlagWidth - kFlagInset - 0.05f) * t,
                    wanted = text_width_px(flag.letters.view(), painter.em_px(kTapeTextSize));
        const float size = painter.em_px(kTapeTextSize) / t * std::min(1.0f, room / wanted);
        if (size * t < kMinText_px - 0.5f) continue;  // the line alone is left
        painter.text(flag.letters.view(), {scale.x_of(-kFlagInset, painter), y},
                     scale.inwards > 0 ? TextAnchor::right : TextAnchor::left, size, flag.color);
    }
}

void build_tape_bug(const Painter& painter, const TapeScale& scale, const TapeBug& bug) {
    if (!shows_value(bug.show) || !std::isfinite(bug.at)) return;
    const float y = std::clamp(scale.y_of(bug.at), scale.box.y, scale.box.bottom());
    for (const float way : {-1.0f, 1.0f}) {
        const BugHalf half(painter, scale, y, way);
        if (half.empty()) continue;
        if (bug.show == ElementShow::flagged) {
            half.outline(painter.color(SymbolRole::rim), 2);
            half.outline(painter.color(SymbolRole::caution), 1);
        } else {
            half.outline(painter.color(SymbolRole::rim), 2);
            half.fill(painter.color(SymbolRole::selected));
            half.edge(painter.color(SymbolRole::rim));
        }
    }
}

void build_tape_trend(const Painter& painter, const TapeScale& scale, const TapeTrend& trend) {
    if (!trend.is_shown || !(std::fabs(trend.to - scale.middle) >= trend.threshold)) return;
    const float x = scale.x_of(kTrendInset, painter), from = scale.y_of(scale.middle), to = scale.y_of(trend.to);
    const float half_bar = 0.22f * painter.text_px();
    painter.line({x, from}, {x, to}, painter.color(SymbolRole::scale), 1.5f);
    painter.line({x - half_bar, to}, {x + half_bar, to}, painter.color(SymbolRole::scale), 1.5f);
}

void build_tape_minimum(const Painter& painter, const TapeScale& scale, const TapeMinimum& minimum) {
    if (!shows_value(minimum.show) || !std::isfinite(minimum.at)) return;
    const float y = scale.y_of(minimum.at), half = 0.45f * painter.text_px();
    if (y - half < scale.box.y || y + half > scale.box.bottom()) return;
    const Point corners[3] = {
        {scale.x_of(0.1f, painter), y}, {scale.x_of(0.95f, painter), y - half}, {scale.x_of(0.95f, painter), y + half}};
    const bool is_hollow = minimum.show == ElementShow::flagged;
    painter.batch().polyline(corners, 2 * painter.stroke_px(), painter.color(SymbolRole::rim), true);
    if (is_hollow)
        painter.batch().polyline(corners, painter.stroke_px(), painter.color(SymbolRole::caution), true);
    else
        painter.batch().triangle(corners[0], corners[1], corners[2], minimum.color);
}

void build_tape_row(const Painter& painter, const Rect& box, const TapeRow& row) {
    const Words text{row.text, row.short_text.empty() ? row.text : row.short_text};
    switch (row.show) {
        case ElementShow::absent: return;
        case ElementShow::flagged: return painter.framed_plate(box, text, kTapeTextSize, painter.color(SymbolRole::caution));
        case ElementShow::failed: break;
        case ElementShow::normal:
        case ElementShow::substituted: return painter.plate(box, text, kTapeTextSize, row.color);
    }
    const Rect cross = box.shrunk(1.5f * painter.stroke_px());
    painter.batch().box(box, painter.color(SymbolRole::readout_ground));
    painter.line({cross.x, cross.y}, {cross.right(), cross.bottom()}, painter.color(SymbolRole::warning));
    painter.line({cross.x, cross.bottom()}, {cross.right(), cross.y}, painter.color(SymbolRole::warning));
    painter.fitted_text({row.name, row.name.substr(row.name.rfind(' ') + 1)}, box, TextAnchor::center, kTapeTextSize,
                        painter.color(SymbolRole::caution));
}

}  // namespace tedavis::draw
