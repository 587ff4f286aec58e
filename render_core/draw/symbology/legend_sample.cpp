#include "render_core/draw/symbology/legend_sample.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/draw/symbology/painter.hpp"

namespace tedavis::draw {
namespace {

using design::Color;

// As ground_data.frag cuts and marks data.
constexpr float kStripePitch_px = 9, kStripe_px = 3;
constexpr float kGridPitch_px = 5;
constexpr float kDotPitch_px = 12, kDot_px = 3;
constexpr float kGrain_px = 3, kStrokePitch_px = 8;
constexpr float kHalfRoot = 0.70710678f;
constexpr int kMax = 64;  // pieces of a pattern across a box

/// Lines down to the right, `pitch` pixels apart along a row.
void diagonals(QuadBatch& batch, const Rect& in, float pitch, float width, Color color) {
    float x = in.x - in.height;
    for (int n = 0; n < kMax && x < in.right() + pitch; ++n, x += pitch)
        batch.line({x, in.y}, {x + in.height, in.bottom()}, width * kHalfRoot, color);
}

void grid(QuadBatch& batch, const Rect& in, float pitch, float width, Color color) {
    float x = in.x + pitch / 2;
    for (int n = 0; n < kMax && x < in.right(); ++n, x += pitch) batch.box({x, in.y, width, in.height}, color);
    float y = in.y + pitch / 2;
    for (int n = 0; n < kMax && y < in.bottom(); ++n, y += pitch) batch.box({in.x, y, in.width, width}, color);
}

void dots(QuadBatch& batch, const Rect& in, Color color) {
    float x = in.x + kDotPitch_px / 4;
    for (int n = 0; n < kMax && x + kDot_px < in.right(); ++n, x += kDotPitch_px)
        batch.box({x, in.center().y - kDot_px / 2, kDot_px, kDot_px}, color);
}

/// The share of the cells that a scattered order names first; cells grow with the box, so that their number is bounded.
void grains(QuadBatch& batch, const Rect& in, double share, Color color) {
    constexpr int kAcross = 8, kDown = 4;
    const float width = std::max(in.width / kAcross, kGrain_px), height = std::max(in.height / kDown, kGrain_px);
    for (int n = 0; n < kAcross * kDown; ++n) {
        const int across = n % kAcross, down = n / kAcross;
        const int order = n * 13 % (kAcross * kDown);  // every number once
        if (order >= share * kAcross * kDown) continue;
        batch.box({in.x + width * static_cast<float>(across), in.y + height * static_cast<float>(down), width, height}, color);
    }
}

/// Light and dark facets.
void rough(QuadBatch& batch, const Rect& in, double share, Color color) {
    constexpr int kFacets = 8;
    const float width = in.width / kFacets;
    for (int n = 0; n < kFacets; ++n) {
        const Rect at{in.x + width * static_cast<float>(n), in.y + (n % 4 < 2 ? 0 : in.height / 2), width, in.height / 2};
        batch.box(at, blended(color, n % 2 == 0 ? Color{0, 0, 0} : Color{255, 255, 255}, 0.5 * share));
    }
}

/// The left half runs into the right one over `share` of the width.
void washed(QuadBatch& batch, const Rect& in, double share, Color color, Color other) {
    constexpr int kSteps = 9;
    const auto run = static_cast<float>(std::max(share, 0.01)) * in.width;
    batch.box({in.x, in.y, in.width, in.height}, color);
    for (int n = 0; n < kSteps; ++n) {
        const float left = in.center().x - run / 2 + run * static_cast<float>(n) / kSteps;
        batch.box({left, in.y, in.right() - left, in.height}, blended(color, other, (n + 1.0) / kSteps));
    }
}

void sign(QuadBatch& batch, const LegendSample& sample, const Rect& in) {
    const float half = in.height / 2;
    const Point middle = in.center();
    if (sample.look == SampleLook::dashed_rim)
        static_cast<void>(draw_dashed_rim(batch, middle, 0.8f * half, sample.color, static_cast<float>(sample.share)));
    else
        static_cast<void>(draw_icon(batch, sample.icon, middle, 0.85f * half, sample.color));
    if (sample.look == SampleLook::crossed_icon)
        batch.line({middle.x - half, middle.y + half}, {middle.x + half, middle.y - half}, 2, sample.color);
}

void question(const Painter& painter, const Rect& in) {
    const TextStyle style{in.height, painter.color(SymbolRole::scale), 1, painter.color(SymbolRole::rim)};
    painter.batch().text("?", in.center(), TextAnchor::center, style);
}

/// Of looks that stand on something else than the data's colour.
Color ground_of(const LegendSample& sample) {
    switch (sample.look) {
        case SampleLook::margin:
        case SampleLook::icon:
        case SampleLook::crossed_icon:
        case SampleLook::dashed_rim: return sample.under;
        default: return sample.color;
    }
}

void fill(const Painter& painter, const LegendSample& sample, const Rect& in) {
    QuadBatch& batch = painter.batch();
    const float stroke_px = painter.stroke_px();
    const auto share = static_cast<float>(sample.share);
    switch (sample.look) {
        case SampleLook::plain: break;
        case SampleLook::cut_stripes: diagonals(batch, in, kStripePitch_px, kStripe_px, sample.under); break;
        case SampleLook::question: question(painter, in); break;
        case SampleLook::cut_grid: grid(batch, in, kGridPitch_px, 1, sample.under); break;
        case SampleLook::dots: dots(batch, in, sample.under); break;
        case SampleLook::grains: grains(batch, in, sample.share, sample.under); break;
        case SampleLook::strokes: diagonals(batch, in, kStrokePitch_px, kStrokePitch_px * share, sample.under); break;
        case SampleLook::rough: rough(batch, in, sample.share, sample.color); break;
        case SampleLook::washed: washed(batch, in, sample.share, sample.color, sample.under); break;
        case SampleLook::mesh: grid(batch, in, in.height * (0.4f + 0.6f * share), stroke_px, sample.under); break;
        case SampleLook::rim: batch.frame(in.shrunk(stroke_px), 2 * stroke_px, sample.under); break;
        case SampleLook::margin: batch.box(in.shrunk(in.height / 4), sample.color); break;
        case SampleLook::icon:
        case SampleLook::crossed_icon:
        case SampleLook::dashed_rim: sign(batch, sample, in); break;
        case SampleLook::words: break;
    }
}

}  // namespace

void build_sample(const Painter& painter, const LegendSample& sample, const Rect& box) {
    QuadBatch& batch = painter.batch();
    batch.box(box, ground_of(sample));
    const Rect inside = box.shrunk(painter.stroke_px());
    batch.set_clip(inside);
    fill(painter, sample, inside);
    batch.lift_clip();
    batch.frame(box, painter.stroke_px(), painter.color(SymbolRole::scale));
}

}  // namespace tedavis::draw
