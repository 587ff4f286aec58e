// What the colours mean: above, the values of the palette with samples of sea, missing data and the outside of the database;
// below, the warning bands with the heights relative to the own ship at which they begin and by how much they are lowered for the
// vertical uncertainty. Stacked at the foot of its box; the layout gives it room on every screen, since the bar of values
// becomes shorter where the bands need room.
#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"
#include "render_core/draw/symbology/key_legend.hpp"
#include "render_core/draw/symbology/legend_numbers.hpp"
#include "render_core/draw/symbology/legend_sample.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/draw/symbology/terrain_scale.hpp"

namespace tedavis::draw {
namespace {

using design::Color;

// In texts.
constexpr float kTitle = 1.2f;
constexpr float kPad = 0.55f;  // half a number stands beyond the ends of a scale
constexpr float kSample = 1.0f, kTightSample = 0.85f;
constexpr float kBand = 1.0f;
constexpr float kTallestBar = 7, kShortestBar = 2;
constexpr float kInset = 0.3f;
constexpr float kNumberSize = 0.75f;
constexpr float kNumberPitch = 1.0f;  // numbers on the bar stand at least so far apart

// Unknown ground as unknown_ground.frag hatches it: bright and dark stripes of equal width, this many pixels apart along a row.
constexpr float kHatchPitch_px = 8;
constexpr double kHatchDark = 0.5;

constexpr int kBandSlices = 5;

/// The least of 1, 2, 5, 10, 20, ... that is not below `least`.
double round_step(double least) {
    double step = std::pow(10, std::floor(std::log10(std::max(least, 1.0))));
    for (const double times : {2.0, 2.5, 2.0}) {
        if (step >= least) break;
        step *= times;
    }
    return step;
}

/// Pieces of the legend from the top of its plate down.
class LegendBuilder {
public:
    LegendBuilder(const Painter& painter, const LegendInput& legend)
        : painter_(painter), legend_(legend), scale_(terrain_scale(legend)), t_(painter.text_px()) {}

    /// In texts, with a bar and samples so high.
    [[nodiscard]] static float height(const LegendInput& legend, float bar, float sample) {
        float sum = 3 * sample + 2 * kInset;
        if (legend.tint) sum += kTitle + 2 * kPad - kInset + bar;
        return sum + bands_of(legend, sample);
    }

    void build() {
        const Rect& box = painter_.layout().legend;
        constexpr float kRounding = 0.01f;
        sample_ = box.height >= (height(legend_, kShortestBar, kSample) - kRounding) * t_ ? kSample : kTightSample;
        const float bar = std::min(kTallestBar * t_, box.height - height(legend_, 0, sample_) * t_);
        const float whole = height(legend_, 0, sample_) * t_ + (legend_.tint ? bar : 0);
        plate_ = {box.x, box.bottom() - whole, box.width, whole};
        y_ = plate_.y;
        painter_.batch().box(plate_, painter_.color(SymbolRole::tape_ground));
        if (legend_.tint) build_tint(bar);
        build_samples();
        if (legend_.bands) build_bands();
    }

private:
    [[nodiscard]] static float bands_of(const LegendInput& legend, float sample_height) {
        if (!legend.bands) return 0;
        const float notes = legend.bands_lowered_m <= 0 ? 0.0f : legend.accuracy_assumed ? 2.0f : 1.0f;
        return kTitle + 2 * kPad + kBand * static_cast<float>(legend.warning_bands.size()) + sample_height * notes;
    }
    [[nodiscard]] Rect sample(float y, float height) const { return {plate_.x + kInset * t_, y, kSampleWidth * t_, height}; }

    void title(std::string_view name, std::string_view unit) {
        const Rect row{plate_.x, y_, plate_.width, kTitle * t_};
        base::FixedString<31> text(name);
        if (!unit.empty()) text.append(" ");
        text.append(unit);
        painter_.plate(row, text.view(), 0.8f, painter_.color(SymbolRole::scale));
        y_ += row.height;
    }

    /// Text right of a sample, its middle at `y`.
    void note(std::string_view text, float y) const {
        const float left = sample(0, 0).right() + 0.15f * t_;
        painter_.fitted_text(text, {left, y - 0.5f * t_, plate_.right() - left, t_}, TextAnchor::left, kNumberSize,
                             painter_.color(SymbolRole::scale));
    }

    void build_tint(float bar_height) {
        title(legend_.palette.title.view(), scale_.unit);
        y_ += kPad * t_;
        const Rect bar = sample(y_, bar_height);
        build_bar(bar);
        build_numbers(bar);
        y_ = bar.bottom() + (kPad - kInset) * t_;
    }

    void build_samples() {
        y_ += kInset * t_;
        build_sample("SEA", legend_.sea);
        hatch(build_sample("NO DATA", legend_.unknown));
        hatch(build_sample("OUTSIDE", legend_.unknown));
        y_ += kInset * t_;
    }

    /// Each slice reaches under the next one, so that no seam shows between two.
    void build_bar(const Rect& bar) const {
        const float slice = bar.height / kBarSlices;
        for (int n = 0; n < kBarSlices; ++n) {
            const double share = 1 - (n + 0.5) / kBarSlices;
            const float top = bar.y + slice * static_cast<float>(n);
            painter_.batch().box({bar.x, top, bar.width, std::min(slice + kUnder_px, bar.bottom() - top)},
                                 color_of_value(legend_.palette, scale_.low + (scale_.high - scale_.low) * share));
        }
        painter_.batch().frame(bar, painter_.stroke_px(), painter_.color(SymbolRole::scale));
    }

    void build_numbers(const Rect& bar) const {
        const double low = scale_.low * scale_.factor, high = scale_.high * scale_.factor;
        const double step = round_step((high - low) * static_cast<double>(kNumberPitch * t_ / bar.height));
        constexpr double kRounding = 1e-6;  // of a step: an end that is a round number is written
        const double first = std::ceil(low / step - kRounding);
        for (int n = 0; n < kMaxNumbers && (first + n) * step <= high + kRounding * step; ++n) {
            const double value = (first + n) * step;
            const float y = bar.bottom() - bar.height * static_cast<float>((value - low) / (high - low));
            painter_.batch().box({bar.right() - 0.4f * t_, y - painter_.stroke_px() / 2, 0.4f * t_, painter_.stroke_px()},
                                 painter_.color(SymbolRole::scale));
            note(whole_number(value).view(), y);
        }
    }

    /// Returns where the sample stands.
    Rect build_sample(std::string_view name, Color color) {
        const Rect at = sample(y_ + 0.1f * sample_ * t_, 0.8f * sample_ * t_);
        painter_.batch().box(at, color);
        painter_.batch().frame(at, painter_.stroke_px(), painter_.color(SymbolRole::scale));
        note(name, at.center().y);
        y_ += sample_ * t_;
        return at;
    }

    /// Dark stripes down to the right, inside the frame.
    void hatch(const Rect& at) const {
        constexpr float kHalfRoot = 0.70710678f;
        const Rect inside = at.shrunk(painter_.stroke_px());
        painter_.batch().set_clip(inside);
        for (float x = inside.x - inside.height; x < inside.right() + kHatchPitch_px; x += kHatchPitch_px)
            painter_.batch().line({x, inside.y}, {x + inside.height, inside.bottom()}, kHatchPitch_px / 2 * kHalfRoot,
                                  blended({0, 0, 0}, legend_.unknown, kHatchDark));
        painter_.batch().lift_clip();
    }

    void build_bands() {
        title("RELATIVE", base::height_unit(legend_.units).text);
        y_ += kPad * t_;
        const Rect whole = sample(y_, kBand * t_ * static_cast<float>(legend_.warning_bands.size()));
        for (const design::WarningBand& band : legend_.warning_bands) {
            build_band(sample(y_, std::min(kBand * t_ + kUnder_px, whole.bottom() - y_)), band);
            y_ += kBand * t_;
            painter_.batch().box({whole.x, y_ - painter_.stroke_px() / 2, whole.width, painter_.stroke_px()},
                                 painter_.color(SymbolRole::scale));
            note(signed_number(band.lower_m * base::height_unit(legend_.units).of(1)).view(), y_);
        }
        painter_.batch().frame(whole, painter_.stroke_px(), painter_.color(SymbolRole::scale));
        y_ += kPad * t_;
        if (legend_.bands_lowered_m <= 0) return;
        base::FixedString<31> uncertainty("VERT ERR ");
        uncertainty.append(whole_number(legend_.bands_lowered_m * base::height_unit(legend_.units).of(1)).view());
        remark(uncertainty.view());
        if (legend_.accuracy_assumed) remark("ASSUMED");
    }

    void remark(std::string_view text) {
        const Rect row{plate_.x, y_, plate_.width, sample_ * t_};
        painter_.fitted_text(text, row, TextAnchor::center, kNumberSize, painter_.color(SymbolRole::scale));
        y_ += row.height;
    }

    /// As it is displayed over the terrain's colours, from the lowest on the left to the highest.
    void build_band(const Rect& at, const design::WarningBand& band) const {
        const float slice = at.width / kBandSlices;
        for (int n = 0; n < kBandSlices; ++n) {
            const double value = scale_.low + (scale_.high - scale_.low) * n / (kBandSlices - 1);
            const float left = at.x + slice * static_cast<float>(n);
            painter_.batch().box(
                {left, at.y, std::min(slice + kUnder_px, at.right() - left), at.height},
                blended(legend_.tint ? color_of_value(legend_.palette, value) : legend_.plain, band.color, band.strength));
        }
    }

    const Painter& painter_;
    const LegendInput& legend_;
    TerrainScale scale_;
    float t_;
    Rect plate_;
    float y_ = 0, sample_ = kSample;
};

}  // namespace

LegendNeed legend_need(const SymbologyInput& input) noexcept {
    LegendNeed need;
    const bool shows_whole = input.legend_show == flight::LegendShow::whole;
    need.keeps_column = input.shown.legend && shows_whole;
    if (input.decisions.unusual_attitude) return need;
    need.adjacent = adjacent_need(input.adjacent);
    if (!input.shown.legend) return need;
    need.key_entries = key_entries(input).size();
    if (!shows_whole) return need;
    if (input.legend.ground) {
        need.terrain_most = LegendBuilder::height(input.legend, kTallestBar, kSample);
        need.terrain_least = LegendBuilder::height(input.legend, kShortestBar, kTightSample);
    }
    need.data = data_legend_need(input.data_legends);
    return need;
}

void build_legend(const Painter& painter, const SymbologyInput& input) {
    if (input.decisions.unusual_attitude) return;
    if (!painter.layout().has_legend_rows) return build_key(painter, input);
    if (input.legend.ground) LegendBuilder(painter, input.legend).build();
    build_data_legends(painter, input.data_legends);
}

}  // namespace tedavis::draw
