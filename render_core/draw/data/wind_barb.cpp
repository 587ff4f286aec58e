#include "render_core/draw/data/wind_barb.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/units.hpp"

namespace tedavis::draw {
namespace {

constexpr double kKnot_mps = 1852.0 / 3600.0;
constexpr float kBarbRim_px = 1.2f, kBarbStroke = 0.05f, kMinBarbStroke_px = 1.5f;
constexpr float kRing = 0.09f, kCalmRing = 0.2f;               // of the staff
constexpr float kFlag = 0.42f, kSlant = 0.16f, kStep = 0.13f;  // length, lean to the tip, from one to the next
constexpr int kRingSides = 10;

class Barb {
public:
    Barb(QuadBatch& batch, Point ring, Point from, const BarbStyle& style, float widen_px, design::Color color)
        : batch_(batch), ring_(ring), from_(from), style_(style), color_(color) {
        // On the screen y is down: turning the way to the tip by a right angle to its right gives the left of the wind.
        side_ = {-from.y, from.x};
        if (style.is_southern) side_ = {from.y, -from.x};
        width_px_ = std::max(kMinBarbStroke_px, kBarbStroke * style.staff_px) + 2 * widen_px;
    }

    bool draw(const scene::Wind& wind) {
        const bool is_steady = wind.state == scene::WindState::steady;
        const bool is_lettered = wind.state == scene::WindState::variable || wind.state == scene::WindState::unknown;
        circle(is_lettered ? kCalmRing : kRing);
        if (wind.state == scene::WindState::calm) circle(kCalmRing);
        if (is_steady) add_staff(barb_flags(wind.speed_mps));
        return fits_;
    }

private:
    [[nodiscard]] Point at(float along, float aside) const {
        const float x = along * style_.staff_px, y = aside * style_.staff_px;
        return {ring_.x + from_.x * x + side_.x * y, ring_.y + from_.y * x + side_.y * y};
    }
    void line(Point from, Point to) { fits_ = batch_.line(from, to, width_px_, color_) && fits_; }

    void circle(float radius) {
        Point corners[kRingSides];
        for (int n = 0; n < kRingSides; ++n) {
            const float angle = 2 * static_cast<float>(base::kPi) * static_cast<float>(n) / kRingSides;
            corners[n] = {ring_.x + radius * style_.staff_px * std::cos(angle),
                          ring_.y + radius * style_.staff_px * std::sin(angle)};
        }
        fits_ = batch_.polyline(corners, width_px_, color_, true) && fits_;
    }

    /// From the tip inwards: pennants, barbs, the half one, which never stands at the tip alone.
    void add_staff(const BarbFlags& flags) {
        line(at(kRing, 0), at(1, 0));
        const int steps = 2 * flags.pennants + flags.barbs + flags.halves;
        const float step = steps > 0 ? std::min(kStep, (1 - 2 * kRing) / static_cast<float>(steps)) : kStep;
        float along = 1;
        for (int n = 0; n < flags.pennants; ++n) {
            add_pennant(along, 1.6f * step);
            along -= 2 * step;
        }
        for (int n = 0; n < flags.barbs; ++n) {
            line(at(along, 0), at(along + kSlant, kFlag));
            along -= step;
        }
        if (flags.halves == 0) return;
        if (along == 1) along -= step;
        line(at(along, 0), at(along + 0.5f * kSlant, 0.5f * kFlag));
    }

    void add_pennant(float along, float foot) {
        const Point outer = at(along, 0), tip = at(along, kFlag), inner = at(along - foot, 0);
        line(outer, tip);
        line(tip, inner);
        fits_ = batch_.triangle(outer, tip, inner, color_) && fits_;
    }

    QuadBatch& batch_;
    Point ring_, from_, side_;
    const BarbStyle& style_;
    design::Color color_;
    float width_px_ = 1;
    bool fits_ = true;
};

}  // namespace

BarbFlags barb_flags(double speed_mps) noexcept {
    constexpr double kMax = 50;  // fives: 250 knots
    const double fives = std::round(speed_mps / kKnot_mps / 5);
    const int count = fives > 0 ? static_cast<int>(std::min(fives, kMax)) : 0;
    return {count / 10, count % 10 / 2, count % 2};
}

bool draw_wind_barb(QuadBatch& batch, Point ring, Point from, const scene::Wind& wind, const BarbStyle& style) {
    const design::Color rim{0, 0, 0, style.color.alpha};
    bool fits = Barb(batch, ring, from, style, kBarbRim_px, rim).draw(wind);
    fits = Barb(batch, ring, from, style, 0, style.color).draw(wind) && fits;
    const bool is_variable = wind.state == scene::WindState::variable;
    if (!is_variable && wind.state != scene::WindState::unknown) return fits;
    const TextStyle text{2 * kCalmRing * style.staff_px * 0.8f, style.text, kBarbRim_px, rim};
    return batch.text(is_variable ? "V" : "M", ring, TextAnchor::center, text) && fits;
}

}  // namespace tedavis::draw
